// Where the home stands, when it is seen, and what is around it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "geometry/vec.h"
#include "model/finish.h"

namespace idap {

struct Site {
  double latitude = 0.8528;           // radians, north positive (Paris)
  double longitude = 0.0407;          // radians, east positive
  double north = 0;                   // radians counter-clockwise from the plan's +y to true north
  std::string timeZone = "UTC";       // IANA name
  std::int64_t time = 1750503600000;  // ms since 1970 (UTC): the home's own time of day for pictures
  Vec2 compassPosition;
  double compassDiameter = 1;
  bool compassVisible = true;
  friend bool operator==(const Site&, const Site&) = default;
};

struct Environment {
  Finish ground = plain(Color{0.66f, 0.66f, 0.66f});
  std::optional<Color> skyColor;  // none: the physical sky. Kept for exchange; pictures use the physical sky
  std::optional<TextureRef> skyTexture;
  double cloudiness = 0;        // 0 clear .. 1 overcast: the weather of pictures
  double wallTransparency = 0;  // of a view from above, 0..1
  friend bool operator==(const Environment&, const Environment&) = default;
};

}  // namespace idap
