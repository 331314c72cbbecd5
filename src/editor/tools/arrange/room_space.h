// A room as somebody sees it who carries a piece in: its walls, what stands in it, where doors swing.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "editor/editor.h"
#include "editor/tools/arrange/manner.h"

namespace idap {

using Corners = std::array<Vec2, 4>;  // of a rectangle at any angle, counter-clockwise

// They share more than a centimetre of each other.
bool overlaps(const Corners& a, const Corners& b);
inline constexpr double kBeforeIt = 0.6;  // m in front of a piece that one needs to use it
// The place before a piece.
Corners placeBefore(Vec2 middle, Vec3 size, double angle);
// A rectangle from its middle, size and angle.
Corners rectangle(Vec2 middle, Vec2 size, double angle);

struct RoomSpace {
  LevelId level;
  Polygon area;        // counter-clockwise, by the inner faces of its walls
  bool closed = true;  // false: there is no room here, and its edges are no walls

  struct Standing {
    FurnitureId id;
    const Furniture* piece;
    Corners corners;
    Box2 box;
    Manner manner;
    std::string words;              // of its name and id
    std::optional<Corners> before;  // where somebody stands who opens or uses it
  };
  std::vector<Standing> furniture;  // of the level, shown, in or near the area
  struct Hole {
    OpeningId id;
    const Opening* opening;
    bool way;       // people walk through
    Corners swing;  // what a leaf sweeps, or what one needs to pass or to open a window
    Corners step;   // the first step before it
  };
  std::vector<Hole> openings;
  std::vector<Corners> walls;  // straight ones, for what stands in the way inside the room

  // The rectangle lies inside the room.
  bool holds(const Corners& corners) const;
  // Nothing of the height range low..high, m above the level, is in the way; the given piece does not count.
  bool free(const Corners& corners, double low, double high, FurnitureId except = {}) const;
  // The same for a thing on a table: what stands lower than its top (a chair's back) makes room.
  bool freeOnTop(const Corners& corners, double low, double high, FurnitureId table) const;
  // A door opens here, for what reaches down into its height; and likewise windows, for what covers them.
  bool blocksWay(const Corners& corners, double low, double high) const;
  bool blocksDoorstep(const Corners& corners, double low, double high) const;
  bool coversWindow(const Corners& corners, double low, double high) const;
};

// The room around a point, or the largest of the level; one of 8 m about the point where there is none. Lives
// as long as the home.
RoomSpace roomSpace(const Home& home, LevelId level, std::optional<Vec2> near);

}  // namespace idap
