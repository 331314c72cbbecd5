// The centre line of a wall, straight or arc, measured by distance from its start. Plan space, metres.
#pragma once

#include <vector>

#include "model/wall.h"

namespace idap {

class WallPath {
 public:
  explicit WallPath(const Wall& wall);

  double length() const { return length_; }
  Vec2 point(double distance) const;      // beyond the ends it goes on, straight or round
  Vec2 direction(double distance) const;  // unit, from start to end; left is perpendicular() of it

  // The distance of the point of the line nearest to p, within 0..length().
  double nearest(Vec2 p) const;

  // The face at this offset to the left (negative: right) as points from start to end; chords of a round face
  // stay within tolerance.
  std::vector<Vec2> face(double offset, double tolerance = 0.001) const;

 private:
  Vec2 start_, end_, along_;
  double length_ = 0, arc_ = 0;
  Vec2 centre_;        // of an arc
  double radius_ = 0;  // of an arc
};

}  // namespace idap
