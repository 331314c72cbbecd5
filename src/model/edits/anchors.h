// Points of the plan that drawings hold on to (corners, ends and faces of walls, corners of pieces and rooms)
// and where they went in an edit.
#pragma once

#include <optional>
#include <vector>

#include "model/diff.h"
#include "model/home.h"

namespace idap {

class Anchors {
 public:
  Anchors(const Home& before, const Home& after);

  // Where a corner or an end of a wall that was here (within 1 mm) is now; nothing where none moved.
  std::optional<Vec2> wallCorner(LevelId level, Vec2 point) const;
  // The same of walls' corners and faces, pieces and rooms.
  std::optional<Vec2> any(LevelId level, Vec2 point) const;
  bool empty() const { return walls_.empty() && corners_.empty() && wallCorners_.empty(); }

 private:
  struct Moved {
    LevelId level;
    Vec2 from, to;
  };
  struct MovedWall {
    Wall before, after;
  };
  static std::optional<Vec2> nearest(const std::vector<Moved>& points, LevelId level, Vec2 point);
  void addWalls(const Home& before, const Home& after, const std::vector<WallId>& changed);

  std::vector<Moved> wallCorners_, corners_;
  std::vector<MovedWall> walls_;
};

}  // namespace idap
