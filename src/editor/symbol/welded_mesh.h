// A model's triangles turned to the eye, with the corners at the same place made one, so that edges know the
// faces on both sides. x right, y up, z towards the eye, metres.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace idap {

struct WeldedMesh {
  std::vector<Vec3f> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> slots;  // of each triangle
  std::vector<Vec3f> normals;        // of each triangle, unit
  Box3f bounds() const;
};

// Meshes of very many triangles are made coarser on the way.
WeldedMesh weld(const Mesh& mesh, const Transformf& toEye);

}  // namespace idap
