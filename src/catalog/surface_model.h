// A model ready to be put in a scene: one mesh, its material slots, and where its light comes from.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "catalog/material.h"
#include "geometry/mesh.h"

namespace idap {

// Object space as in model/piece.h: x right, y to the back (the front faces -y), z up, origin in the middle
// of the base. Parametric models come at their final size in metres; models from files come with the bounding
// box -0.5..0.5, -0.5..0.5, 0..1 (fitted to size by the instance) unless the box is flat in an axis.
struct SurfaceModel {
  struct Slot {
    std::string name;
    Material material;
  };
  Mesh mesh;
  std::vector<Slot> slots;
  bool unitBox = false;  // true: fit to the piece's size by scaling
  Vec3 fileSize;         // of a model from a file: its box in the file's own unit, turned as asked
  bool backFacesShown = false;
  std::vector<Vec3> lightPositions;  // where a lamp's bulbs sit, in object space; empty: unknown
};
using SurfaceModelPtr = std::shared_ptr<const SurfaceModel>;

}  // namespace idap
