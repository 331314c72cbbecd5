// Everything in the scene that shines from a place: lamps and emissive triangles, and the tree that chooses
// among them.
#pragma once

#include <vector>

#include "render/accel/interaction.h"
#include "render/accel/ray.h"
#include "render/emitter/light_sample.h"
#include "render/emitter/light_tree.h"
#include "render/scene.h"

namespace idap::render {

class CompiledScene;

class LocalLights {
 public:
  explicit LocalLights(const CompiledScene& scene);

  bool empty() const { return tree_.empty(); }
  std::size_t size() const { return lampCount_ + triangles_.size(); }

  // False where nothing can reach the receiver.
  bool sample(const Receiver& at, float choice, Vec2f u, LightSample& sample) const;

  // One sample a lane for those that the mask has; the lanes that found one.
  LaneMask sample(LaneMask active, const LaneReceiver& at, Floats choice, const LaneVec2& u,
                  LightSampleT<Floats>& sample) const;

  // The density, per steradian at the receiver, with which sample() would have found this point of an
  // emissive triangle or of a lamp's sphere, seen from the receiver along the ray.
  float pdfTriangle(const Receiver& at, const Ray& ray, const Hit& hit, bool frontFace) const;
  float pdfLamp(const Receiver& at, std::uint32_t lamp) const;

  // Radiance that a lamp's sphere sends against the direction of a ray that hits it from outside.
  Rgb lampRadiance(std::uint32_t lamp, Vec3f rayDirection) const;

 private:
  struct Triangle {
    Vec3f corner, edge1, edge2;
    Vec3f normal;  // unit, front
    float inverseArea = 0.0f;
    Rgb radiance{};
    std::uint32_t instance = 0, triangle = 0, surface = 0;
    std::uint16_t lightGroup = 0;
    bool mayPass = false;    // has gaps, through which it does not shine
    bool frontOnly = false;  // part of a closed shell: its back is never seen from outside
  };
  // What sampling needs of a lamp or triangle. F: float, or Floats for a light a lane.
  template <class F>
  struct RowT {
    Vec3T<F> position, edge1, edge2;  // of a triangle its corner; edges 0 for lamps
    Vec3T<F> radiance;                // of a lamp its intensity
    F inverseArea, radius;            // of a triangle, of a lamp; else 0
    F front;  // of triangles that shine to one side 1, or -1 where the edges turn the other way; else 0
    F group;
  };
  struct alignas(64) Row : RowT<float> {};
  void addTriangles(const CompiledScene& scene, std::uint32_t instance, std::vector<LightBounds>& bounds);
  float opacityAt(const Triangle& light, Vec2f barycentric) const;

  const CompiledScene& scene_;
  std::size_t lampCount_ = 0;
  std::vector<Row> rows_;  // lamps, then triangles
  std::vector<Triangle> triangles_;
  std::vector<std::vector<std::uint32_t>> lightOfTriangle_;  // by instance, then by triangle; kNone: dark
  LightTree tree_;
};

// For every triangle: is it part of a closed shell whose front is outside? Corners at one place count as one.
std::vector<bool> outsideOfClosedShells(const Mesh& mesh);

}  // namespace idap::render
