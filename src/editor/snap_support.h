// What snapping a piece and measuring around it share: which pieces and walls count as its surroundings.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "editor/snap.h"

namespace idap {

// Half of what a piece covers along a direction of the plan.
inline double halfExtent(const Piece& piece, Vec2 direction) {
  const Vec2 right = rotated(Vec2{1, 0}, piece.angle);
  return (std::abs(dot(right, direction)) * piece.size.x +
          std::abs(dot(perpendicular(right), direction)) * piece.size.y) /
         2;
}
inline Vec2 planOf(const Piece& piece) { return {piece.position.x, piece.position.y}; }
inline double topOf(const Piece& piece) { return piece.position.z + piece.size.z; }
inline bool heightsMeet(const Piece& a, const Piece& b) {
  return a.position.z < topOf(b) - 1e-6 && b.position.z < topOf(a) - 1e-6;
}
// The angle between two pieces is a multiple of a right angle.
inline bool squareTo(const Piece& a, const Piece& b) {
  return std::abs(std::remainder(a.angle - b.angle, kPi / 2)) < 0.009;
}

// Calls f(piece) for each piece of furniture of a level that is shown, not ignored, and whose middle is
// nearer on the plan than its half diagonal and reach.
template <class F>
void forPiecesAround(const Home& home, LevelId level, Vec2 at, double reach, const Elements& ignored, F&& f) {
  for (const auto& [id, piece] : home.furniture) {
    if (piece->level != level) continue;
    const double near = reach + std::hypot(piece->size.x, piece->size.y) / 2;
    const Vec2 off = planOf(*piece) - at;
    if (dot(off, off) > near * near || contains(ignored, id) || !isShown(home, *piece)) continue;
    if (piece->group && contains(ignored, outermost(home, piece->group))) continue;
    f(*piece);
  }
}

}  // namespace idap
