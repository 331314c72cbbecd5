// Short names for the two ends of a wall, for the edits of this folder.
#pragma once

#include "model/edits/wall_edits.h"

namespace idap {

inline constexpr double kSamePlace = 1e-3;  // m: ends this near are one corner

inline bool samePlace(Vec2 a, Vec2 b) { return length(a - b) <= kSamePlace; }

inline WallEnd otherEnd(WallEnd end) { return end == WallEnd::Start ? WallEnd::End : WallEnd::Start; }
inline Vec2 endPoint(const Wall& wall, WallEnd end) { return end == WallEnd::Start ? wall.start : wall.end; }
inline Vec2& endPoint(Wall& wall, WallEnd end) { return end == WallEnd::Start ? wall.start : wall.end; }
inline WallId neighbour(const Wall& wall, WallEnd end) {
  return end == WallEnd::Start ? wall.neighbourAtStart : wall.neighbourAtEnd;
}
inline WallId& neighbour(Wall& wall, WallEnd end) {
  return end == WallEnd::Start ? wall.neighbourAtStart : wall.neighbourAtEnd;
}

// An opening taken from a wall to a distance along what the wall has become: it keeps its offset from the
// centre line and its angle to it.
class WallPath;
Opening carried(const Opening& opening, const WallPath& from, const WallPath& to, double distance);

}  // namespace idap
