// What a reader of polygon models collects, and the way from there to a SurfaceModel: polygons become
// triangles, missing normals are made, and the whole is turned Z up and fitted to the unit box.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "catalog/surface_model.h"
#include "geometry/vec.h"

namespace idap {

// Polygons as the file has them, Y up, its front facing +z.
struct PolygonModel {
  static constexpr std::int32_t kNone = -1;
  struct Corner {
    std::int32_t position = kNone, uv = kNone, normal = kNone;  // indices
  };
  struct Face {
    std::uint32_t first = 0, count = 0;  // its corners
    std::uint32_t slot = 0;
    std::uint32_t smoothing = 0;  // faces of one group share normals; 0: flat
  };
  std::vector<Vec3f> positions, normals;
  std::vector<Vec2f> uvs;
  std::vector<Corner> corners;
  std::vector<Face> faces;
  std::vector<SurfaceModel::Slot> slots;
};

// Faces with indices that point nowhere, non-finite positions or no area are dropped; the result's mesh is
// empty when nothing is left. rotation as in ModelFileOptions.
SurfaceModel surfaceModelOf(PolygonModel model, const std::array<Vec3, 3>& rotation, bool smoothed);

// Fits a mesh in the file's axes (Y up) to the unit box of SurfaceModel, turning it Z up on the way. Gives
// the size of the box it had, turned but not yet fitted.
Vec3f fitToUnitBox(Mesh& mesh, const std::array<Vec3, 3>& rotation);

}  // namespace idap
