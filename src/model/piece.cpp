#include "model/piece.h"

namespace idap {

Transform placement(const Piece& piece) {
  const Vec3 middle{0, 0, piece.size.z / 2};
  Transform t = Transform::translation(piece.position) * Transform::rotationZ(piece.angle);
  if (piece.pitch != 0 || piece.roll != 0)
    t = t * Transform::translation(middle) * Transform::rotationX(piece.pitch) *
        Transform::rotationY(piece.roll) * Transform::translation(-middle);
  if (piece.mirrored) t = t * Transform::scaling({-1, 1, 1});
  return t;
}

std::array<Vec2, 4> footprint(const Piece& piece) {
  const Vec2 centre{piece.position.x, piece.position.y};
  const Vec2 right = rotated(Vec2{piece.size.x / 2, 0}, piece.angle);
  const Vec2 back = rotated(Vec2{0, piece.size.y / 2}, piece.angle);
  return {centre - right - back, centre + right - back, centre + right + back, centre - right + back};
}

}  // namespace idap
