// What a compiled scene holds of Embree and beside it.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <vector>

#include "render/accel/compiled_scene.h"
#include "render/accel/hit_instance.h"
#include "render/accel/mesh_accel.h"
#include "render/accel/surface_row.h"

namespace idap::render {

struct CompiledScene::Accel {
  struct Device {
    std::atomic<std::int64_t> bytes{0};  // before the device, which counts in it to its end
    DeviceHandle handle;
  };
  using MeshKey = std::pair<const Mesh*, std::vector<bool>>;

  std::shared_ptr<Device> device;
  std::vector<SurfaceData> surfaces;
  std::vector<SurfaceRow> surfaceRows;  // of the same
  std::vector<HitInstance> instances;
  std::vector<GeometryHandle> geometries;  // one an instance; null where there is nothing to hit
  std::vector<std::shared_ptr<MeshAccel>> meshes;
  std::map<MeshKey, std::shared_ptr<MeshAccel>> meshByKey;
  std::map<const Mesh*, std::uint32_t> slotCounts;  // of meshes that were checked; meshes hold them
  std::vector<std::uint32_t> meshOfInstance;
  std::vector<std::uint32_t> sphereLamps;  // Embree's sphere -> lamp
  unsigned lampGeometry = kNone;
  SceneHandle top;
  // One level: every instance's triangles in world space. Quicker to trace, slower to build and to change.
  bool flat = false;
  std::vector<bool> inOneLevel;  // instances

  // What Embree has hit; kNone: a lamp's sphere.
  std::uint32_t instanceOf(unsigned geometry, unsigned instance) const {
    if (!flat) return instance;
    return geometry == lampGeometry ? kNone : geometry / 2;
  }

  // The same with all that is known of it; t: along the ray.
  Hit hitOf(float t, const RTCHit& hit) const {
    Hit h{.t = t, .u = hit.u, .v = hit.v, .instance = instanceOf(hit.geomID, hit.instID[0])};
    (h.instance == kNone ? h.lamp : h.triangle) = indexOf(h.instance, hit.geomID, hit.primID);
    return h;
  }
  // Of the triangle in the instance's mesh, or of the lamp.
  std::uint32_t indexOf(std::uint32_t instance, unsigned geometry, unsigned primitive) const {
    return instance == kNone ? sphereLamps[primitive] : instances[instance].triangleOf(geometry, primitive);
  }

  // Whether the one level has such a geometry.
  bool hasPart(std::uint32_t instance, unsigned part) const {
    return meshOfInstance[instance] != kNone && inOneLevel[instance] &&
           meshes[meshOfInstance[instance]]->has(part);
  }

  void place(std::uint32_t instance, const Transformf& transform);
};

// The surface points of the hits on instances; see CompiledScene::points().
void fetchPoints(const CompiledScene::Accel& accel, LaneMask active, const LaneRays& rays,
                 const LaneHits& hits, LanePoints& points);

// For the geometry that light may get through: weakens shadow rays rather than ending them, and lets looks
// through clear sheets.
extern const SieveFilters kSieveFilters;

}  // namespace idap::render
