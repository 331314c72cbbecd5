// Boxes and cylinders: a rectangle in any plane, from corner to corner, and how far it goes across.
#include <algorithm>
#include <cmath>

#include "editor/snap.h"
#include "editor/tools/drawn_point.h"
#include "editor/tools/solid_piece.h"
#include "editor/tools/tool_list.h"
#include "editor/tools/unseen.h"

namespace idap {

namespace {

std::vector<ToolKey> blockKeys() {
  return {
      {"0-9", QT_TRANSLATE_NOOP("idap", "type a side")}, {"Tab", QT_TRANSLATE_NOOP("idap", "the next side")},
      {"Enter", QT_TRANSLATE_NOOP("idap", "take it")},   {"Shift", QT_TRANSLATE_NOOP("idap", "equal sides")},
      {"Alt", QT_TRANSLATE_NOOP("idap", "no snapping")}, {"Esc", QT_TRANSLATE_NOOP("idap", "stop")}};
}

const ToolInfo kBox{
    "solid-box",
    QT_TRANSLATE_NOOP("idap", "Box"),
    QT_TRANSLATE_NOOP("idap", "Draw boxes in any plane: pillars, steps, built-in furniture"),
    QT_TRANSLATE_NOOP("idap", "Press at one corner and drag to the opposite one, in any plane"),
    "B",
    blockKeys()};
const ToolInfo kCylinder{
    "solid-cylinder",
    QT_TRANSLATE_NOOP("idap", "Cylinder"),
    QT_TRANSLATE_NOOP("idap", "Draw cylinders and cones; their round is seen in the plane they are drawn in"),
    QT_TRANSLATE_NOOP("idap", "Press at one corner of the round and drag to the opposite one, in any plane"),
    "Y",
    blockKeys()};

class BlockTool : public Tool {
 public:
  BlockTool(const ToolInfo& info, const char* catalogId) : info_(info), catalogId_(catalogId) {}

  const ToolInfo& info() const override { return info_; }
  Text hint() const override {
    if (across_.active()) return kAcrossHint;
    return first_ ? QT_TRANSLATE_NOOP("idap", "Click the opposite corner, or type the sides") : info_.hint;
  }

  bool cancel(Editor& editor) override {
    const bool begun = first_ || across_.active();
    preview_.drop(editor);
    forget();
    return begun;
  }

  Response pointer(Editor& editor, const PointerEvent& event) override {
    if (event.kind == PointerEvent::Kind::Press && event.button == PointerEvent::Button::Right) {
      if (!cancel(editor)) return {.used = false};
      return {};
    }
    if (across_.active()) {
      answer(editor, across_.pointer(editor, event));
      return {};
    }
    if (first_ && event.plane != plane_) return {};
    switch (event.kind) {
      case PointerEvent::Kind::Press:
        if (first_) {
          follow(editor, event);
          turnAcross(editor);
          return {};
        }
        start(editor, event);
        return {};
      case PointerEvent::Kind::Move:
        follow(editor, event);
        return {};
      case PointerEvent::Kind::Release:
        if (!first_ || !pressedAt_) return {};
        if (length(event.at - *std::exchange(pressedAt_, std::nullopt)) < kDragPixels * event.pixel)
          return {};  // a click: the other corner is clicked too
        follow(editor, event);
        turnAcross(editor);
        return {};
      default:
        return {};
    }
  }

  Response key(Editor& editor, const KeyEvent& event) override {
    if (across_.active()) {
      const AcrossStep::Answer got = across_.key(editor, event);
      answer(editor, got);
      return {.used = got != AcrossStep::Answer::None};
    }
    if (!first_) return {.used = false};
    switch (fields_.key(event, editor.settings().unit)) {
      case TypedFields::Answer::Changed:
        show(editor);
        return {};
      case TypedFields::Answer::Wrong:
        return {};
      case TypedFields::Answer::Apply:
        // A side alone goes on to the next.
        if (fields_.active() == 0 && !fields_.value(1))
          fields_.activate(1);
        else
          turnAcross(editor);
        return {};
      case TypedFields::Answer::Unused:
        break;
    }
    if (event.key == Key::Enter) {
      turnAcross(editor);
      return {};
    }
    return {.used = false};
  }

  Overlay overlay(const Editor&, Plane plane, double) const override {
    Overlay overlay;
    if (across_.active()) {
      across_.into(overlay, plane);
      return overlay;
    }
    if (plane != plane_ || !known_) return overlay;
    overlay.guides = snapped_.guides;
    overlay.handles.push_back({HandleKind::Point, first_ ? corner() : snapped_.at, 0, true});
    if (!first_) return overlay;
    const Box2 box = drawn();
    overlay.measures.push_back({box.min, {box.max.x, box.min.y}, fields_.active() == 0});
    overlay.measures.push_back({{box.max.x, box.min.y}, box.max, fields_.active() == 1});
    fields_.into(overlay, corner());
    return overlay;
  }

 private:
  void forget() {
    first_.reset();
    pressedAt_.reset();
    across_.end();
    snapped_.guides.clear();
    fields_.clear();
  }

  void start(Editor& editor, const PointerEvent& event) {
    follow(editor, event);
    first_ = snapped_.at;
    pressedAt_ = event.at;
    unseen_ = unseenCoordinate(editor, plane_, event.at);
    const char* first =
        plane_ == Plane::YZ ? QT_TRANSLATE_NOOP("idap", "Depth") : QT_TRANSLATE_NOOP("idap", "Width");
    const char* second =
        plane_ == Plane::XY ? QT_TRANSLATE_NOOP("idap", "Depth") : QT_TRANSLATE_NOOP("idap", "Height");
    fields_.define({{first, Field::Kind::Length}, {second, Field::Kind::Length}});
  }

  void follow(Editor& editor, const PointerEvent& event) {
    plane_ = event.plane;
    known_ = true;
    SnapRequest request;
    request.plane = plane_;
    request.at = event.at;
    request.tolerance = kSnapPixels * event.pixel;
    request.ignored = preview_.elements();
    request.wallFaces = true;
    snapped_ = snapPoint(editor, request, event.modifiers.alt);
    equal_ = event.modifiers.shift;
    if (!first_) return;
    // Sides that nothing else gives are round ones, as fine as the pointer can be moved.
    if (snapped_.to == SnappedPoint::To::Nothing && !event.modifiers.alt) {
      const double step = gridStep(event.pixel * 0.999, editor.settings().unit);
      const Vec2 by = snapped_.at - *first_;
      snapped_.at = *first_ + Vec2{std::round(by.x / step) * step, std::round(by.y / step) * step};
    }
    show(editor);
  }

  // The far corner, with what was typed.
  Vec2 corner() const {
    Vec2 by = snapped_.at - *first_;
    if (equal_) {
      const double side = std::max(std::abs(by.x), std::abs(by.y));
      by = {std::copysign(side, by.x), std::copysign(side, by.y)};
    }
    if (const auto typed = fields_.value(0)) by.x = std::copysign(std::abs(*typed), by.x);
    if (const auto typed = fields_.value(1)) by.y = std::copysign(std::abs(*typed), by.y);
    return *first_ + by;
  }

  Box2 drawn() const {
    Box2 box;
    box.add(*first_);
    box.add(corner());
    return box;
  }

  bool flat() const {
    const Vec2 size = drawn().max - drawn().min;
    return size.x < kThinnestSolid || size.y < kThinnestSolid;
  }

  void show(Editor& editor) {
    const Box2 box = drawn();
    fields_.show(0, box.max.x - box.min.x);
    fields_.show(1, box.max.y - box.min.y);
    if (flat()) {
      preview_.drop(editor);
      return;
    }
    Furniture piece = solidPiece(editor, catalogId_, boxOver(editor, plane_, box, unseen_, across_.value()));
    if (&info_ == &kCylinder) piece.model.parameters["axis"] = axisAcross(plane_);
    preview_.show(editor, piece);
  }

  void turnAcross(Editor& editor) {
    if (flat() || fields_.wrong()) return;
    across_.begin(plane_, drawn(), unseen_);
    show(editor);
  }

  void answer(Editor& editor, AcrossStep::Answer answer) {
    if (answer == AcrossStep::Answer::None) return;
    show(editor);
    if (answer != AcrossStep::Answer::Done) return;
    preview_.commit(editor);
    forget();
  }

  const ToolInfo& info_;
  const char* catalogId_;
  Plane plane_ = Plane::XY;
  bool known_ = false, equal_ = false;
  std::optional<Vec2> first_, pressedAt_;
  double unseen_ = 0;
  SnappedPoint snapped_;
  TypedFields fields_;
  AcrossStep across_;
  SolidPreview preview_;
};

}  // namespace

ToolEntry solidBoxTool() {
  return {&kBox, [] { return std::make_unique<BlockTool>(kBox, "idap/solid-box"); }};
}

ToolEntry solidCylinderTool() {
  return {&kCylinder, [] { return std::make_unique<BlockTool>(kCylinder, "idap/solid-cylinder"); }};
}

}  // namespace idap
