// A scene made ready for tracing: Embree acceleration in two levels (one BVH a mesh and opacity pattern,
// instances on top), surfaces and light samplers. Tracing is safe from many threads; changing is not.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/accel/interaction.h"
#include "render/accel/ray.h"
#include "render/material/surface_data.h"
#include "render/scene.h"

struct RTCSceneTy;  // Embree's RTCScene points to it

namespace idap::render {

class Lights;

struct CompileStats {
  double seconds = 0.0;
  std::uint64_t uniqueTriangles = 0;     // in the meshes that are used
  std::uint64_t instancedTriangles = 0;  // as if every instance had its own mesh
  std::uint64_t embreeBytes = 0;
};

class CompiledScene {
 public:
  // threads: how many to build with; 0: all. Throws RenderError for indices out of range.
  // previous: a scene that this one is an edit of; the acceleration structures of meshes that both have are
  // shared. It may go afterwards.
  explicit CompiledScene(std::shared_ptr<const Scene> scene, int threads = 0,
                         const CompiledScene* previous = nullptr);
  ~CompiledScene();
  CompiledScene(const CompiledScene&) = delete;
  CompiledScene& operator=(const CompiledScene&) = delete;

  const Scene& scene() const { return *scene_; }
  const CompileStats& stats() const { return stats_; }
  const Lights& lights() const { return *lights_; }
  const SurfaceData& surface(std::uint32_t index) const;
  std::size_t surfaceCount() const;
  Transformf transform(std::uint32_t instance) const;
  // The surface index of an instance's material slot.
  std::uint32_t surfaceOfSlot(std::uint32_t instance, std::uint32_t slot) const;
  float radius() const { return radius_; }  // of a sphere around everything, m
  Vec3f centre() const { return centre_; }

  // Moves one instance; rays see it after commit(), which rebuilds the top level only (and the light samplers
  // if the instance shines).
  void setTransform(std::uint32_t instance, const Transformf& transform);
  // Whether primary rays see the instance; light meets it all the same.
  void setVisibleToCamera(std::uint32_t instance, bool visible);
  void commit();

  // The nearest thing the mask (RayMask) lets the ray see in (tMin, tMax). coherent: neighbouring rays go the
  // same way (primary rays).
  bool intersect(const Ray& ray, Hit& hit, std::uint32_t mask, bool coherent = false) const;

  // True when anything solid lies in between; glass, opacity and cut-outs count as solid only if they let no
  // light by at all.
  bool occluded(const Ray& ray) const;

  // What part of each colour gets along the ray between tMin and tMax: 0 behind something solid, the product
  // of all sheets of glass, partial opacities and cut-outs otherwise. Lamps' spheres block nothing.
  Rgb transmittance(const Ray& ray) const;

  // The surface point of a hit on an instance (not on a lamp).
  Interaction interaction(const Ray& ray, const Hit& hit) const;

  // For measuring and debugging. Every ray traced is appended to the log until it is null again; with a log,
  // trace from one thread only. The top level is for nearest hits, and for shadow rays where nothing lets
  // light through.
  void setLog(std::vector<LoggedRay>* log) { log_ = log; }
  RTCSceneTy* embreeScene() const;

 private:
  struct Accel;
  std::shared_ptr<const Scene> scene_;
  std::unique_ptr<Accel> accel_;
  std::unique_ptr<Lights> lights_;
  CompileStats stats_;
  std::vector<LoggedRay>* log_ = nullptr;
  Vec3f centre_;
  float radius_ = 1.0f;
};

}  // namespace idap::render
