#include "editor/tools/select/size_drag.h"

#include <algorithm>
#include <cmath>

#include "model/edits/piece_edits.h"

namespace idap {

namespace {

constexpr const char* kResize = QT_TRANSLATE_NOOP("idap", "Resize");
constexpr double kLeast = 0.005, kMost = 100;  // m, where the catalog says nothing
constexpr const char* kAxes[]{QT_TRANSLATE_NOOP("idap", "Width"), QT_TRANSLATE_NOOP("idap", "Depth"),
                              QT_TRANSLATE_NOOP("idap", "Height")};

void scaleTop(Home& home, AnyId id, double ratio) {
  const auto* furniture = std::get_if<FurnitureId>(&id);
  if (!furniture) return;
  Furniture piece = *home.furniture.find(*furniture);
  if (!piece.dropOnTopHeight || *piece.dropOnTopHeight <= 0) return;
  *piece.dropOnTopHeight *= ratio;
  home.furniture.set(*furniture, std::move(piece));
}

}  // namespace

SizeLimits sizeLimits(const Catalog& catalog, const Piece& piece) {
  SizeLimits limits{{kLeast, kLeast, kLeast}, {kMost, kMost, kMost}};
  if (piece.model.catalogId.empty()) return limits;
  const CatalogPiecePtr known = catalog.find(piece.model.catalogId);
  if (!known) return limits;
  for (const int axis : {0, 1, 2}) {
    // What a file says goes before the catalog: a piece is never made to jump.
    if (known->minSize[axis] > 0) limits.min[axis] = std::min(known->minSize[axis], piece.size[axis]);
    if (known->maxSize[axis] > 0) limits.max[axis] = std::max(known->maxSize[axis], piece.size[axis]);
  }
  return limits;
}

SizeDrag::SizeDrag(Editor& editor, const PointerEvent& press, AnyId piece, std::array<int, 3> side,
                   Cursor cursor)
    : EditDrag(editor, kResize, press, cursor),
      id_(piece),
      piece_(*pieceOf(before(), piece)),
      side_(side),
      floor_(elevationOf(before(), piece_.level)),
      limits_(sizeLimits(editor.catalog(), piece_)),
      size_(piece_.size) {
  std::vector<Field> fields;
  for (const int axis : {0, 1, 2})
    if (side_[static_cast<std::size_t>(axis)] != 0) {
      axes_.push_back(axis);
      fields.push_back({.label = kAxes[axis], .value = size_[axis], .active = fields.empty()});
    }
  fields_.define(std::move(fields));
  offset_ = seen(piece_, local(piece_.size, 1)) - press.at;
}

Vec3 SizeDrag::local(const Vec3& size, int towards) const {
  return {side_[0] * towards * size.x / 2, side_[1] * towards * size.y / 2,
          side_[2] == 0            ? size.z / 2
          : side_[2] * towards > 0 ? size.z
                                   : 0};
}

Vec2 SizeDrag::seen(const Piece& piece, Vec3 at) const {
  return project(plane(), placement(piece).point(at) + Vec3{0, 0, floor_});
}

void SizeDrag::aim(const Editor& editor, const PointerEvent& event) {
  const Vec2 to = snapped(editor, event.at + offset_, only(id_)).at;
  const Transform place = placement(piece_);
  const auto axisOn = [&](int axis) {
    const Vec3 unit{axis == 0 ? 1.0 : 0, axis == 1 ? 1.0 : 0, axis == 2 ? 1.0 : 0};
    return project(plane(), place.vector(unit)) * static_cast<double>(side_[static_cast<std::size_t>(axis)]);
  };
  const Vec2 from = seen(piece_, local(piece_.size, -1));
  const Vec2 span = to - from;
  Vec3 size = piece_.size;
  if (axes_.size() == 1) {
    const Vec2 a = axisOn(axes_[0]);
    size[axes_[0]] = dot(span, a) / dot(a, a);
  } else if (axes_.size() == 2) {
    const Vec2 a = axisOn(axes_[0]), b = axisOn(axes_[1]);
    const double d = cross(a, b);
    if (std::abs(d) > 1e-6) {
      size[axes_[0]] = cross(span, b) / d;
      size[axes_[1]] = cross(a, span) / d;
    }
  }
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    size[axes_[i]] = std::clamp(size[axes_[i]], limits_.min[axes_[i]], limits_.max[axes_[i]]);
    fields_.show(i, size[axes_[i]]);
    if (const auto typed = fields_.value(i))
      size[axes_[i]] = std::clamp(*typed, limits_.min[axes_[i]], limits_.max[axes_[i]]);
  }
  if (event.modifiers.shift) {
    double ratio = 0;
    for (const int axis : axes_) ratio = std::max(ratio, size[axis] / piece_.size[axis]);
    // No side may leave its limits, so that the proportions hold.
    for (const int axis : {0, 1, 2})
      ratio = std::clamp(ratio, limits_.min[axis] / piece_.size[axis], limits_.max[axis] / piece_.size[axis]);
    size = piece_.size * ratio;
    for (std::size_t i = 0; i < axes_.size(); ++i) fields_.show(i, size[axes_[i]]);
  }
  size_ = size;
}

Piece SizeDrag::sized() const {
  Piece next = piece_;
  next.size = size_;
  Vec3 before = local(piece_.size, -1), after = local(size_, -1);
  if (side_[2] == 0) before.z = after.z = 0;  // it stays on what it stands on
  next.position += placement(piece_).point(before) - placement(next).point(after);
  return next;
}

Home SizeDrag::change(const Home& before) {
  const Piece next = sized();
  Home home = changePieces(before, only(id_), [&next](Piece& piece) {
    piece.size = next.size;
    piece.position = next.position;
  });
  if (size_.z != piece_.size.z) scaleTop(home, id_, size_.z / piece_.size.z);
  return home;
}

void SizeDrag::show(const Editor&, Overlay& overlay, double) const {
  const Piece next = sized();
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    Vec3 from = local(size_, -1), to = from;
    to[axes_[i]] = local(size_, 1)[axes_[i]];
    overlay.measures.push_back({seen(next, from), seen(next, to), fields_.active() == i});
  }
}

Text SizeDrag::hint() const {
  return QT_TRANSLATE_NOOP(
      "idap", "Shift keeps the proportions, Alt stops snapping. Or type the size and press Enter.");
}

ScaleDrag::ScaleDrag(Editor& editor, const PointerEvent& press, Elements pieces, Vec3 fixed, Vec2 corner,
                     Cursor cursor)
    : EditDrag(editor, kResize, press, cursor),
      elements_(std::move(pieces)),
      fixed_(fixed),
      diagonal_(corner - project(press.plane, fixed)),
      width_(std::abs(diagonal_.x)) {
  const Elements all = withGroups(before(), elements_);
  for (const FurnitureId id : all.furniture) {
    const Piece& piece = *before().furniture.find(id);
    const SizeLimits limits = sizeLimits(editor.catalog(), piece);
    for (const int axis : {0, 1, 2}) {
      least_ = std::max(least_, limits.min[axis] / piece.size[axis]);
      most_ = std::min(most_, limits.max[axis] / piece.size[axis]);
    }
  }
  fields_.define({{.label = kAxes[plane() == Plane::YZ ? 1 : 0], .value = width_, .active = true}});
}

void ScaleDrag::aim(const Editor& editor, const PointerEvent& event) {
  const Vec2 to = snapped(editor, event.at, elements_).at - project(plane(), fixed_);
  ratio_ = dot(to, diagonal_) / dot(diagonal_, diagonal_);
  ratio_ = std::clamp(ratio_, least_, most_);
  fields_.show(0, width_ * ratio_);
  if (const auto typed = fields_.value(0); typed && width_ > 0)
    ratio_ = std::clamp(*typed / width_, least_, most_);
}

Home ScaleDrag::change(const Home& before) {
  return changePieces(before, elements_, [&](Piece& piece) {
    const Vec3 fixed = fixed_ - Vec3{0, 0, elevationOf(before, piece.level)};
    piece.position = fixed + (piece.position - fixed) * ratio_;
    piece.size *= ratio_;
  });
}

Text ScaleDrag::hint() const {
  return QT_TRANSLATE_NOOP("idap", "Resizes all together. Or type the width of all and press Enter.");
}

}  // namespace idap
