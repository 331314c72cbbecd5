// Texture coordinates for models that bring none, or none that fit: a picture in metres projected along the
// axis that each face looks along most.
#pragma once

#include <vector>

#include "geometry/mesh.h"

namespace idap {

// A copy whose triangles of the marked slots have box-mapped coordinates in metres; scale is from the mesh's
// space to metres.
Mesh boxMapped(const Mesh& mesh, const std::vector<bool>& slots, Vec3 scale);

}  // namespace idap
