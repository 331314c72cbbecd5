#include <algorithm>

#include "editor/hit_test_shapes.h"
#include "editor/tools/select/handles.h"
#include "editor/tools/select/moving.h"
#include "editor/tools/select/size_drag.h"
#include "editor/tools/select/turn_drag.h"

namespace idap {

namespace {

// An axis seen shorter than this is not stretched on this plane; from the side width and depth only where the
// piece stands square to it, as its outline is not their length otherwise.
constexpr double kFaceOn = 0.7, kSquare = 0.98;

constexpr const char* kTurnTip = QT_TRANSLATE_NOOP("idap", "Drag to turn.");
constexpr const char* kSizeTip = QT_TRANSLATE_NOOP("idap", "Drag to resize; Shift keeps the proportions.");
constexpr const char* kRaiseTip = QT_TRANSLATE_NOOP("idap", "Drag up or down to lift or lower.");
constexpr const char* kTiltTip = QT_TRANSLATE_NOOP("idap", "Drag to tilt.");

double directionOf(Vec2 v) { return std::atan2(v.y, v.x); }

// The turn about the line of sight, where one of the piece's own axes runs along it.
std::optional<TiltDrag::Tilt> tiltOn(Plane plane, const Piece& piece) {
  const double quarter = piece.angle / (kPi / 2);
  if (plane == Plane::XY || std::abs(quarter - std::round(quarter)) > 0.11) return {};
  const bool lengthwise = std::lround(quarter) % 2 == 0;
  return lengthwise == (plane == Plane::XZ) ? TiltDrag::Tilt::Roll : TiltDrag::Tilt::Pitch;
}

class PieceHandles {
 public:
  PieceHandles(const Editor& editor, Plane plane, double pixel, AnyId id)
      : plane_(plane),
        pixel_(pixel),
        id_(id),
        piece_(*pieceOf(editor.home(), id)),
        place_(placement(piece_)),
        floor_(elevationOf(editor.home(), piece_.level)) {
    if (const auto* opening = std::get_if<OpeningId>(&id)) {
      const Opening& found = *editor.home().openings.find(*opening);
      inWall_ = editor.home().walls.contains(found.wall);
      door_ = found.kind == OpeningKind::Door;
    }
  }

  SelectHandles all() {
    for (const int axis : {0, 1, 2}) {
      const Vec3 unit{axis == 0 ? 1.0 : 0, axis == 1 ? 1.0 : 0, axis == 2 ? 1.0 : 0};
      const Vec2 seen = project(plane_, place_.vector(unit));
      const double least = plane_ != Plane::XY && axis != 2 ? kSquare : kFaceOn;
      if (length(seen) > least && !(inWall_ && axis == 1)) axes_.push_back(axis);
      shown_[axis] = length(seen) * piece_.size[axis] / pixel_;
    }
    const double widest = axes_.empty() ? 0 : std::max(shown_[axes_.front()], shown_[axes_.back()]);
    tiny_ = widest < kTiny;
    sides();
    corners();
    if (plane_ == Plane::XY) {
      if (!inWall_) turn();
      if (!tiny_ && !door_) raise();
    } else if (!inWall_ && !tiny_) {
      tilt();
    }
    return std::move(handles_);
  }

 private:
  Vec2 at(Vec3 share) const {
    const Vec3 local{share.x * piece_.size.x / 2, share.y * piece_.size.y / 2,
                     (share.z + 1) / 2 * piece_.size.z};
    return project(plane_, place_.point(local) + Vec3{0, 0, floor_});
  }
  Vec2 middle() const { return at({0, 0, 0}); }

  void size(HandleKind kind, std::array<int, 3> side) {
    const Vec2 p = at({double(side[0]), double(side[1]), double(side[2])});
    const double direction = directionOf(p - middle());
    const Cursor cursor = sizeCursor(direction);
    handles_.push_back(
        {{kind, p, direction, false},
         cursor,
         kSizeTip,
         [id = id_, side, cursor](Editor& editor, const PointerEvent& press) -> std::unique_ptr<Drag> {
           return std::make_unique<SizeDrag>(editor, press, id, side, cursor);
         }});
  }
  static bool standsBelow(int axis, int sign) { return axis == 2 && sign < 0; }

  void sides() {
    static constexpr HandleKind kKinds[]{HandleKind::ResizeWidth, HandleKind::ResizeDepth,
                                         HandleKind::ResizeHeight};
    for (const int axis : axes_) {
      // The handles of a side need the room beside those of its corners.
      double across = kTiny;
      for (const int other : axes_)
        if (other != axis) across = shown_[other];
      if (across < kTiny) continue;
      for (const int sign : {-1, 1}) {
        if (standsBelow(axis, sign)) continue;
        std::array<int, 3> side{};
        side[static_cast<std::size_t>(axis)] = sign;
        size(kKinds[axis], side);
      }
    }
  }

  void corners() {
    if (axes_.size() < 2) return;
    const int a = axes_[0], b = axes_[1];
    for (const int i : {-1, 1})
      for (const int j : {-1, 1}) {
        if (standsBelow(a, i) || standsBelow(b, j)) continue;
        if (tiny_ && (i < 0 || j < 0)) continue;
        std::array<int, 3> side{};
        side[static_cast<std::size_t>(a)] = i;
        side[static_cast<std::size_t>(b)] = j;
        size(HandleKind::ResizeCorner, side);
      }
  }

  // Outside of the front, so that it shows where the front is.
  void turn() {
    const Vec2 front = rotated(Vec2{0, -1}, piece_.angle);
    const Vec2 about{piece_.position.x, piece_.position.y};
    const Vec2 p = about + front * (piece_.size.y / 2 + kHandleOutside * pixel_);
    handles_.push_back({{HandleKind::Rotate, p, directionOf(front), false},
                        Cursor::Rotate,
                        kTurnTip,
                        [id = id_, about, angle = piece_.angle](
                            Editor& editor, const PointerEvent& press) -> std::unique_ptr<Drag> {
                          return std::make_unique<TurnDrag>(editor, press, only(id), about, angle);
                        }});
  }

  void raise() {
    const Vec2 corner = rotated(Vec2{-piece_.size.x / 2, piece_.size.y / 2}, piece_.angle);
    const Vec2 p = Vec2{piece_.position.x, piece_.position.y} + corner +
                   rotated(Vec2{-1, 1} * (kHandleOutside * 0.7 * pixel_), piece_.angle);
    handles_.push_back({{HandleKind::Raise, p, kPi / 2, false},
                        Cursor::SizeVertical,
                        kRaiseTip,
                        [id = id_](Editor& editor, const PointerEvent& press) -> std::unique_ptr<Drag> {
                          return std::make_unique<RaiseDrag>(editor, press, id);
                        }});
  }

  void tilt() {
    const std::optional<TiltDrag::Tilt> tilt = tiltOn(plane_, piece_);
    if (!tilt) return;
    const Box2 box = bounds(outline(plane_, piece_, floor_));
    const Vec2 p = box.max + Vec2{1, 1} * (kHandleOutside * 0.7 * pixel_);
    const HandleKind kind = *tilt == TiltDrag::Tilt::Pitch ? HandleKind::Pitch : HandleKind::Roll;
    handles_.push_back(
        {{kind, p, kPi / 4, false},
         Cursor::Rotate,
         kTiltTip,
         [id = id_, t = *tilt](Editor& editor, const PointerEvent& press) -> std::unique_ptr<Drag> {
           return std::make_unique<TiltDrag>(editor, press, id, t);
         }});
  }

  Plane plane_;
  double pixel_;
  AnyId id_;
  const Piece& piece_;
  Transform place_;
  double floor_;
  bool inWall_ = false, door_ = false, tiny_ = false;
  std::vector<int> axes_;
  double shown_[3]{};
  SelectHandles handles_;
};

}  // namespace

SelectHandles pieceHandles(const Editor& editor, Plane plane, double pixel, AnyId id) {
  if (pieceOf(editor.home(), id)->locked) return {};
  return PieceHandles(editor, plane, pixel, id).all();
}

SelectHandles boxHandles(const Editor& editor, Plane plane, double pixel) {
  const Home& home = editor.home();
  const Elements elements = movable(home, editor.selection());
  const Box3 box = bounds(home, elements);
  SelectHandles handles;
  if (box.empty()) return handles;
  const Vec2 low = project(plane, box.min), high = project(plane, box.max), middle = (low + high) / 2;
  if (plane == Plane::XY) {
    handles.push_back(
        {{HandleKind::Rotate, {middle.x, low.y - kHandleOutside * pixel}, -kPi / 2, false},
         Cursor::Rotate,
         kTurnTip,
         [elements, middle](Editor& editor_, const PointerEvent& press) -> std::unique_ptr<Drag> {
           return std::make_unique<TurnDrag>(editor_, press, elements, middle, 0);
         }});
  }
  const std::size_t pieces = elements.furniture.size() + elements.groups.size();
  if (pieces != count(elements) || std::max(high.x - low.x, high.y - low.y) < kTiny * pixel) return handles;
  const Elements all = withGroups(home, elements);
  // A door in a group keeps to the thickness of its wall.
  if (!all.openings.empty()) return handles;
  for (const bool right : {false, true})
    for (const bool upper : {false, true}) {
      if (plane != Plane::XY && !upper) continue;
      const Vec2 corner{right ? high.x : low.x, upper ? high.y : low.y};
      Vec3 fixed = box.centre();
      fixed.z = box.min.z;
      if (plane == Plane::XY) fixed.y = upper ? box.min.y : box.max.y;
      (plane == Plane::YZ ? fixed.y : fixed.x) =
          plane == Plane::YZ ? (right ? box.min.y : box.max.y) : (right ? box.min.x : box.max.x);
      const double direction = directionOf(corner - middle);
      const Cursor cursor = sizeCursor(direction);
      handles.push_back({{HandleKind::ResizeCorner, corner, direction, false},
                         cursor,
                         kSizeTip,
                         [elements, fixed, corner, cursor](
                             Editor& editor_, const PointerEvent& press) -> std::unique_ptr<Drag> {
                           return std::make_unique<ScaleDrag>(editor_, press, elements, fixed, corner,
                                                              cursor);
                         }});
    }
  return handles;
}

SelectHandles labelHandles(const Editor& editor, Plane plane, double pixel, LabelId id) {
  const Label* label = editor.home().labels.find(id);
  if (!label || plane != Plane::XY) return {};
  const Vec2 up = rotated(Vec2{0, 1}, label->angle);
  double top = 0;
  for (const Vec2 corner : labelBox(*label)) top = std::max(top, dot(corner - label->position, up));
  const Vec2 p = label->position + up * (top + kHandleOutside * pixel);
  return {{{HandleKind::Rotate, p, directionOf(up), false},
           Cursor::Rotate,
           kTurnTip,
           [id, about = label->position, angle = label->angle](
               Editor& editor_, const PointerEvent& press) -> std::unique_ptr<Drag> {
             return std::make_unique<TurnDrag>(editor_, press, only(id), about, angle);
           }}};
}

}  // namespace idap
