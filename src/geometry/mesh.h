// An indexed triangle mesh whose triangles carry a material slot. Metres, float; front faces
// counter-clockwise.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/box.h"
#include "geometry/transform.h"
#include "geometry/vec.h"

namespace idap {

struct Mesh {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;  // unit, one a position; empty: every triangle is flat
  std::vector<Vec2f> uvs;      // one a position; empty: no texture coordinates. v runs up, (0,0) bottom left
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> slots;  // material slot of each triangle; empty: all 0

  bool empty() const { return triangles.empty(); }
  std::uint32_t slotOf(std::size_t triangle) const { return slots.empty() ? 0 : slots[triangle]; }
  Box3f bounds() const {
    Box3f box;
    for (const Vec3f& p : positions) box.add(p);
    return box;
  }
};

// Appends b to a, moved by t (which may mirror: winding is kept outward), its slots shifted by slotOffset.
// Where one side has normals or uvs and the other has not, the missing ones are made (face normals, zero
// uvs).
void append(Mesh& a, const Mesh& b, const Transformf& t = {}, std::uint32_t slotOffset = 0);

// Gives every vertex the area-weighted mean normal of the triangles around it that lie within creaseAngle
// (radians) of each other; vertices on a crease are split. Vertices at the same place count as one.
void computeSmoothNormals(Mesh& mesh, float creaseAngle);

}  // namespace idap
