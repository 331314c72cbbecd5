// A scene made ready for tracing: Embree's acceleration structures, surfaces and light samplers. Tracing is
// safe from many threads; changing is not.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/accel/lane_rays.h"
#include "render/scene.h"

struct RTCSceneTy;  // Embree's RTCScene points to it

namespace idap::render {

class Lights;

// How instances are held. Two: one BVH a mesh and opacity pattern and one over the instances; quick to build
// anew after an edit, which shares the meshes', and small. One: all triangles in world space in one BVH;
// takes longer to build and is traced faster, for pictures that take longer than that. Scenes of very many
// triangles have two in any case.
enum class BvhLevels { One, Two };

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
                         const CompiledScene* previous = nullptr, BvhLevels levels = BvhLevels::Two);
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

  // Whether primary rays see the instance, after commit(); light meets it all the same.
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

  // The same for the rays of those lanes that the mask has. Rays that go the same way are quickest.
  void intersect(LaneMask active, const LaneRays& rays, LaneHits& hits, Words masks) const;
  // The nearest thing but clear sheets (SurfaceData::clearSheet), and what part of each colour those before
  // it let by. A ray that meets very many ends at one of them.
  void look(LaneMask active, const LaneRays& rays, LaneHits& hits, LaneVec& through) const;
  LaneVec transmittance(LaneMask active, const LaneRays& rays) const;
  void points(LaneMask active, const LaneRays& rays, const LaneHits& hits, LanePoints& points) const;

  // For measuring and debugging. Every ray traced is appended to the log until it is null again; with a log,
  // trace from one thread only. The top level is for nearest hits, and for shadow rays where nothing lets
  // light through.
  void setLog(std::vector<LoggedRay>* log) { log_ = log; }
  RTCSceneTy* embreeScene() const;
  // Of one level only. Without them every triangle stops every ray, and any context may trace them.
  void setFilters(bool on);

  struct Accel;

 private:
  std::shared_ptr<const Scene> scene_;
  std::unique_ptr<Accel> accel_;
  std::unique_ptr<Lights> lights_;
  CompileStats stats_;
  std::vector<LoggedRay>* log_ = nullptr;
  Vec3f centre_;
  float radius_ = 1.0f;
};

}  // namespace idap::render
