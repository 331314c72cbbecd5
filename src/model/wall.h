// A wall: a straight or arc centre line with a thickness, standing on its level. Plan space, metres.
#pragma once

#include <optional>
#include <string>

#include "geometry/vec.h"
#include "model/finish.h"
#include "model/ids.h"

namespace idap {

struct Baseboard {
  double thickness = 0.01;  // m, out of the wall
  double height = 0.07;     // m
  Finish finish;            // empty: the wall side's
  friend bool operator==(const Baseboard&, const Baseboard&) = default;
};

struct WallSide {
  Finish finish;
  std::optional<Baseboard> baseboard;
  friend bool operator==(const WallSide&, const WallSide&) = default;
};

struct Wall {
  LevelId level;
  Vec2 start, end;  // centre line; left is to the left hand going from start to end
  double arcExtent =
      0;  // radians of a round wall's sweep, positive: the arc turns left (counter-clockwise); 0: straight
  double thickness = 0.1;                         // m
  double heightAtStart = 2.5, heightAtEnd = 2.5;  // m above the level
  WallSide left, right;
  Finish top;
  WallId neighbourAtStart, neighbourAtEnd;  // walls joined with a mitre; none: a square end
  std::string pattern;                      // hatch on the plan
  friend bool operator==(const Wall&, const Wall&) = default;
};

}  // namespace idap
