// A room: an area of the plan with a floor, a ceiling and a name.
#pragma once

#include <string>

#include "geometry/polygon.h"
#include "model/finish.h"
#include "model/ids.h"
#include "model/text_style.h"

namespace idap {

struct Room {
  LevelId level;
  std::string name;
  Polygon points;  // simple ring, either orientation
  Finish floor, ceiling;
  bool floorVisible = true, ceilingVisible = true, ceilingFlat = false;
  bool areaVisible = true;      // show the area on the plan
  Vec2 nameOffset, areaOffset;  // m from the room's centre
  double nameAngle = 0, areaAngle = 0;
  TextStyle nameStyle, areaStyle;
  friend bool operator==(const Room&, const Room&) = default;
};

}  // namespace idap
