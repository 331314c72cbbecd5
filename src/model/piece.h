// What furniture and openings have in common: a model from the catalog or a file, put somewhere in a size.
// Object space of every model: x to its right, y to its back (its front faces -y), z up, origin in the middle
// of its base. World: rotated (roll about y first, then pitch about x, then angle about z), then moved to
// position.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include "geometry/transform.h"
#include "geometry/vec.h"
#include "model/finish.h"
#include "model/ids.h"

namespace idap {

struct ModelRef {
  std::string catalogId;  // a catalog piece; empty: own model
  std::string
      asset;  // path of the model file in Home::assets, its textures beside it; empty: the catalog's model
  std::map<std::string, double>
      parameters;  // of a parametric piece, by name; missing ones take their defaults
  std::array<Vec3, 3> rotation{Vec3{1, 0, 0}, Vec3{0, 1, 0},
                               Vec3{0, 0, 1}};  // images of the axes, applied to a model file before it is
                                                // fitted to size, in object space (already Z up)
  bool backFacesShown = false;
  bool smoothed = true;  // false: flat shading where the file has no normals
  friend bool operator==(const ModelRef&, const ModelRef&) = default;
};

struct Piece {
  LevelId level;
  GroupId group;  // none: not in a group
  std::string name;
  std::string description;
  ModelRef model;
  Vec3 position;              // m: middle of the base; z relative to the level
  Vec3 size{1, 1, 1};         // m along the piece's own x, y, z before rotation
  double angle = 0;           // radians about z, counter-clockwise seen from above
  double pitch = 0;           // radians about the piece's x: positive lifts its back
  double roll = 0;            // radians about the piece's y
  bool mirrored = false;      // left and right exchanged
  Finish finish;              // for the whole piece
  SlotFinishes slotFinishes;  // by material slot; over finish
  bool visible = true;
  bool nameVisible = false;
  bool locked = false;
  std::optional<double> price;                    // in the home's currency
  std::map<std::string, std::string> properties;  // anything else a file said of it: creator, licence, …
  friend bool operator==(const Piece&, const Piece&) = default;
};

// The piece's object space (metres, at its size) -> its level's space (add the level's elevation for the
// world). Pitch and roll turn about the middle of the piece's box, so that its centre stays where it is.
// Mirroring is part of it: a mirrored piece's determinant is -1.
Transform placement(const Piece& piece);

// The four corners of the piece's box on the plan, counter-clockwise from front left, ignoring pitch and
// roll.
std::array<Vec2, 4> footprint(const Piece& piece);

}  // namespace idap
