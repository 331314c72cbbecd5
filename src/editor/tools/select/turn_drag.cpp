#include "editor/tools/select/turn_drag.h"

#include <algorithm>

#include "model/edits/element_edits.h"
#include "model/edits/piece_edits.h"

namespace idap {

namespace {

constexpr const char* kRotate = QT_TRANSLATE_NOOP("idap", "Rotate");
constexpr const char* kTilt = QT_TRANSLATE_NOOP("idap", "Tilt");
constexpr const char* kRaise = QT_TRANSLATE_NOOP("idap", "Raise");

double turnBetween(Vec2 centre, Vec2 from, Vec2 to) {
  const Vec2 a = from - centre, b = to - centre;
  return std::atan2(cross(a, b), dot(a, b));
}
bool free(const Editor& editor, const PointerEvent& event) {
  return event.modifiers.alt || !editor.settings().snapping;
}
double around(double angle) { return std::remainder(angle, 2 * kPi); }
Field angleField(const char* label, double value) {
  return {.label = label, .kind = Field::Kind::Angle, .value = value, .active = true};
}

}  // namespace

TurnDrag::TurnDrag(Editor& editor, const PointerEvent& press, Elements elements, Vec2 about, double angle)
    : EditDrag(editor, kRotate, press, Cursor::Rotate),
      elements_(std::move(elements)),
      about_(about),
      from_(angle),
      to_(angle) {
  fields_.define({angleField(QT_TRANSLATE_NOOP("idap", "Angle"), from_)});
}

void TurnDrag::aim(const Editor& editor, const PointerEvent& event) {
  to_ = around(stepped(from_ + turnBetween(about_, press().at, event.at), free(editor, event)));
  fields_.show(0, to_);
  if (const auto typed = fields_.value(0)) to_ = *typed;
}

Home TurnDrag::change(const Home& before) {
  return turnElements(before, elements_, about_, around(to_ - from_));
}

void TurnDrag::show(const Editor&, Overlay& overlay, double) const {
  overlay.handles.push_back({HandleKind::Rotate, last().at, 0, true});
  const double turn = around(to_ - from_);
  const Vec2 start = press().at - about_;
  const double base = std::atan2(start.y, start.x);
  overlay.angles.push_back({about_, base, base + turn});
}

Text TurnDrag::hint() const {
  return QT_TRANSLATE_NOOP("idap",
                           "Turns in steps of 15°; Alt turns freely. Or type the angle and press Enter.");
}

TiltDrag::TiltDrag(Editor& editor, const PointerEvent& press, AnyId piece, Tilt tilt)
    : EditDrag(editor, kTilt, press, Cursor::Rotate),
      piece_(piece),
      angle_(tilt == Tilt::Pitch ? &Piece::pitch : &Piece::roll) {
  const Piece was = *pieceOf(before(), piece);
  const double floor = elevationOf(before(), was.level);
  centre_ = project(plane(), was.position + Vec3{0, 0, floor + was.size.z / 2});
  from_ = to_ = was.*angle_;
  // Which way the piece turns on this plane is seen by turning it a little.
  Piece turned = was;
  turned.*angle_ += 0.01;
  const Vec3 top{was.size.x / 2, -was.size.y / 2, was.size.z};
  const auto seen = [&](const Piece& p) {
    return project(plane(), placement(p).point(top) + Vec3{0, 0, floor});
  };
  sign_ = turnBetween(centre_, seen(was), seen(turned)) >= 0 ? 1 : -1;
  fields_.define({angleField(
      tilt == Tilt::Pitch ? QT_TRANSLATE_NOOP("idap", "Pitch") : QT_TRANSLATE_NOOP("idap", "Roll"), from_)});
}

void TiltDrag::aim(const Editor& editor, const PointerEvent& event) {
  const double turn = sign_ * turnBetween(centre_, press().at, event.at);
  to_ = around(stepped(from_ + turn, free(editor, event)));
  fields_.show(0, to_);
  if (const auto typed = fields_.value(0)) to_ = *typed;
}

Home TiltDrag::change(const Home& before) {
  return changePieces(before, only(piece_), [this](Piece& piece) { piece.*angle_ = to_; });
}

void TiltDrag::show(const Editor&, Overlay& overlay, double) const {
  const Vec2 start = press().at - centre_;
  const double base = std::atan2(start.y, start.x);
  overlay.angles.push_back({centre_, base, base + sign_ * around(to_ - from_)});
}

Text TiltDrag::hint() const {
  return QT_TRANSLATE_NOOP("idap",
                           "Tilts in steps of 15°; Alt tilts freely. Or type the angle and press Enter.");
}

RaiseDrag::RaiseDrag(Editor& editor, const PointerEvent& press, AnyId piece)
    : EditDrag(editor, kRaise, press, Cursor::SizeVertical),
      id_(piece),
      piece_(*pieceOf(before(), piece)),
      to_(piece_.position.z) {
  fields_.define({{.label = QT_TRANSLATE_NOOP("idap", "Elevation"), .value = to_, .active = true}});
}

void RaiseDrag::aim(const Editor& editor, const PointerEvent& event) {
  Piece raised = piece_;
  raised.position.z = std::max(0.0, piece_.position.z + event.at.y - press().at.y);
  // Floor, ceiling and tops hold it as they do from the side.
  PieceSnapRequest request;
  request.plane = Plane::XZ;
  request.piece = raised;
  request.tolerance = std::clamp(tolerance(event), 0.02, 0.2);
  request.ignored = only(id_);
  to_ = snapPiece(editor, request, event.modifiers.alt).position.z;
  fields_.show(0, to_);
  if (const auto typed = fields_.value(0)) to_ = *typed;
}

Home RaiseDrag::change(const Home& before) {
  return changePieces(before, only(id_), [this](Piece& piece) { piece.position.z = to_; });
}

Text RaiseDrag::hint() const {
  return QT_TRANSLATE_NOOP("idap",
                           "Drag up or down to lift or lower. Or type the elevation and press Enter.");
}

}  // namespace idap
