#include "formats/sh3d/opening_hosts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace idap {

namespace {

struct Segment {
  Vec2 a, b;
};

double distanceTo(Vec2 p, const Segment& s) {
  const Vec2 along = s.b - s.a;
  const double squared = dot(along, along);
  const double t = squared > 0 ? std::clamp(dot(p - s.a, along) / squared, 0.0, 1.0) : 0;
  return length(p - (s.a + along * t));
}

bool cross(const Segment& s, const Segment& t) {
  const auto side = [](const Segment& of, Vec2 p) { return idap::cross(of.b - of.a, p - of.a); };
  return side(s, t.a) * side(s, t.b) < 0 && side(t, s.a) * side(t, s.b) < 0;
}

double distanceBetween(const Segment& s, const Segment& t) {
  if (cross(s, t)) return 0;
  return std::min({distanceTo(s.a, t), distanceTo(s.b, t), distanceTo(t.a, s), distanceTo(t.b, s)});
}

// The centre line of a wall; an arc as chords of at most 10 degrees.
std::vector<Segment> centreLine(const Wall& wall) {
  if (wall.arcExtent == 0) return {{wall.start, wall.end}};
  const Vec2 chord = wall.end - wall.start;
  const double half = wall.arcExtent / 2;
  // Seen from the chord's middle the centre lies to its left when the arc turns left by less than half a
  // turn.
  const Vec2 centre = (wall.start + wall.end) * 0.5 + perpendicular(chord) * (0.5 / std::tan(half));
  const int count = std::max(2, int(std::ceil(std::abs(wall.arcExtent) / (kPi / 18))));
  std::vector<Segment> line;
  Vec2 before = wall.start;
  for (int i = 1; i <= count; ++i) {
    const Vec2 at = centre + rotated(wall.start - centre, wall.arcExtent * i / count);
    line.push_back({before, at});
    before = at;
  }
  return line;
}

}  // namespace

WallId hostOf(const Home& home, const Opening& opening) {
  const Vec2 centre{opening.position.x, opening.position.y};
  const double depth = opening.size.y;
  const double partDepth = std::clamp(opening.wallThickness, 0.0, 1.0) * depth;
  const double partBack = depth / 2 - opening.wallDistance * depth;  // from the centre towards the back
  const Vec2 right = rotated(Vec2{1, 0}, opening.angle);
  const Vec2 middle = centre + perpendicular(right) * (partBack - partDepth / 2);
  // The outer tenths do not count: at a corner they reach into the next wall.
  const Segment axis{middle - right * (0.4 * opening.size.x), middle + right * (0.4 * opening.size.x)};

  WallId best;
  double bestScore = std::numeric_limits<double>::infinity();
  for (const auto& [id, wall] : home.walls) {
    if (wall->level != opening.level) continue;
    if (opening.position.z >= std::max(wall->heightAtStart, wall->heightAtEnd)) continue;
    for (const Segment& segment : centreLine(*wall)) {
      const double gap = distanceBetween(axis, segment);
      if (gap > wall->thickness / 2 + partDepth / 2) continue;
      const Vec2 along = segment.b - segment.a;
      const double span = length(along);
      const double skew =
          span > 0 ? std::abs(idap::cross(right, along)) / span : 1;  // sine of the angle between
      const double score = skew + (gap + distanceTo(middle, segment)) / (wall->thickness + partDepth + 0.01);
      if (score < bestScore) {
        bestScore = score;
        best = id;
      }
    }
  }
  return best;
}

}  // namespace idap
