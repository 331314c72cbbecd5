// The lower level of the acceleration structure: a mesh's BVH, its triangles parted into those that stop
// every ray (geometry 0) and those that light may get through (geometry 1, which has filters).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/transform.h"
#include "render/accel/embree_handles.h"

namespace idap::render {

inline constexpr unsigned kOpaqueGeometry = 0;
inline constexpr unsigned kSieveGeometry = 1;

// What a hit needs to know of its triangle, in one place.
struct HitTriangle {
  std::array<std::uint32_t, 3> corners;
  std::uint32_t slotAndBend;

  std::uint32_t slot() const { return slotAndBend >> 1; }
  // Whether its corners' normals are anything but its own.
  bool bent() const { return (slotAndBend & 1u) != 0; }
};

// What Embree calls for hits on geometry that light may get through.
struct SieveFilters {
  RTCFilterFunctionN shadow;   // of shadow rays
  RTCFilterFunctionN nearest;  // of all others
};

class MeshAccel {
 public:
  // sieve[slot]: light may get through triangles of that slot.
  MeshAccel(std::shared_ptr<const Mesh> mesh, std::vector<bool> sieve);

  // Builds the BVH of the lower level; may run inside a TBB task.
  void build(RTCDevice device, const SieveFilters& filters);
  // Adds the triangles of an instance, in world space, to a scene of one level. firstId: its geometries'.
  // Returns its vertices, which are the scene's.
  const Vec3f* attachTo(RTCDevice device, RTCScene scene, const Transformf& transform, unsigned firstId,
                        unsigned mask, const SieveFilters& filters) const;

  // Null before build().
  RTCScene scene() const { return scene_.get(); }
  bool has(unsigned part) const { return !parts_[part].empty(); }
  const Mesh& mesh() const { return *mesh_; }
  const Box3f& bounds() const { return bounds_; }
  const HitTriangle* hitTriangles() const { return hitTriangles_.data(); }
  // Embree's primitive number -> the mesh's triangle; null where they are equal.
  const std::uint32_t* triangleMap(unsigned geometry) const {
    return geometry < 2 && !maps_[geometry].empty() ? maps_[geometry].data() : nullptr;
  }

 private:
  using Corners = std::array<std::uint32_t, 3>;
  // transform: to world space; null where the vertices stay as they are. Returns vertices in world space.
  const Vec3f* attach(RTCDevice device, RTCScene scene, unsigned part, unsigned id, unsigned mask,
                      const Transformf* transform, const SieveFilters& filters) const;

  std::shared_ptr<const Mesh> mesh_;
  Box3f bounds_;
  SceneHandle scene_;
  std::vector<Vec3f> paddedPositions_;
  std::span<const Corners> parts_[2];  // of the mesh, or of those below
  std::vector<Corners> sorted_[2];
  std::vector<std::uint32_t> maps_[2];
  std::vector<HitTriangle> hitTriangles_;
};

}  // namespace idap::render
