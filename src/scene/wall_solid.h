// The walls that are shown, with what their faces, the rooms and the openings need to know of them. World
// heights, plan outlines, metres.
#pragma once

#include <vector>

#include "model/wall_outline.h"

namespace idap {

// A level as the builder sees it; homes without levels have one.
struct Storey {
  LevelId id;
  double elevation = 0;       // of its floor
  double floorThickness = 0;  // of the slab below
  double height = 0;          // floor to ceiling
};

// The storeys that are shown, from below: those the home lets be viewed, with or without the ones that are
// hidden at the moment (Level::visible). A home without levels has one at 0.
std::vector<Storey> shownStoreys(const Home& home, bool hiddenToo);
// The storey of that level; storeys.size() for none.
std::size_t storeyOf(const std::vector<Storey>& storeys, LevelId level);
// True for a piece on one of the storeys that is not hidden itself or with its group.
bool isShownOn(const Home& home, const std::vector<Storey>& storeys, const Piece& piece);

struct WallSolid {
  WallId id;
  std::shared_ptr<const Wall> wall;
  std::size_t storey = 0;
  double floor = 0;   // world height of its level's floor
  double bottom = 0;  // reaches through the floor slab
  double raised = 0;  // added to its top to close a gap under the slab above
  WallOutline outline;
  Polygon polygon;
  Box2 box;

  double topAt(Vec2 p) const { return floor + raised + wallHeightAt(*wall, p); }
  bool flatTop() const { return wall->heightAtStart == wall->heightAtEnd; }
};

std::vector<WallSolid> wallSolids(const Home& home, const std::vector<Storey>& storeys);

}  // namespace idap
