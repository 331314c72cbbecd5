// Balls: from the centre to the radius, in any plane. In the plan they lie on the floor.
#include <algorithm>
#include <cmath>

#include "editor/tools/drawn_point.h"
#include "editor/tools/solid_piece.h"
#include "editor/tools/tool_list.h"
#include "editor/tools/unseen.h"

namespace idap {

namespace {

const ToolInfo kInfo{"solid-sphere",
                     QT_TRANSLATE_NOOP("idap", "Ball"),
                     QT_TRANSLATE_NOOP("idap", "Draw balls; in the plan they lie on the floor"),
                     QT_TRANSLATE_NOOP("idap", "Press at the centre and drag to the border, in any plane"),
                     "U",
                     {{"0-9", QT_TRANSLATE_NOOP("idap", "type the radius")},
                      {"Enter", QT_TRANSLATE_NOOP("idap", "take it")},
                      {"Alt", QT_TRANSLATE_NOOP("idap", "no snapping")},
                      {"Esc", QT_TRANSLATE_NOOP("idap", "stop")}}};

class SphereTool : public Tool {
 public:
  SphereTool() { fields_.define({{QT_TRANSLATE_NOOP("idap", "Radius"), Field::Kind::Length}}); }

  const ToolInfo& info() const override { return kInfo; }
  Text hint() const override {
    return centre_ ? QT_TRANSLATE_NOOP("idap", "Click on the border, or type the radius") : kInfo.hint;
  }

  bool cancel(Editor& editor) override {
    const bool begun = centre_.has_value();
    preview_.drop(editor);
    centre_.reset();
    pressedAt_.reset();
    fields_.clear();
    return begun;
  }

  Response pointer(Editor& editor, const PointerEvent& event) override {
    if (event.kind == PointerEvent::Kind::Press && event.button == PointerEvent::Button::Right) {
      if (!cancel(editor)) return {.used = false};
      return {};
    }
    if (centre_ && event.plane != plane_) return {};
    switch (event.kind) {
      case PointerEvent::Kind::Press:
        follow(editor, event);
        if (centre_) {
          finish(editor);
        } else {
          centre_ = snapped_.at;
          pressedAt_ = event.at;
          unseen_ = unseenCoordinate(editor, plane_, event.at);
        }
        return {};
      case PointerEvent::Kind::Move:
        follow(editor, event);
        return {};
      case PointerEvent::Kind::Release:
        if (!centre_ || !pressedAt_) return {};
        if (length(event.at - *std::exchange(pressedAt_, std::nullopt)) < kDragPixels * event.pixel)
          return {};
        follow(editor, event);
        finish(editor);
        return {};
      default:
        return {};
    }
  }

  Response key(Editor& editor, const KeyEvent& event) override {
    if (!centre_) return {.used = false};
    switch (fields_.key(event, editor.settings().unit)) {
      case TypedFields::Answer::Changed:
        show(editor);
        return {};
      case TypedFields::Answer::Wrong:
        return {};
      case TypedFields::Answer::Apply:
        finish(editor);
        return {};
      case TypedFields::Answer::Unused:
        break;
    }
    if (event.key != Key::Enter) return {.used = false};
    finish(editor);
    return {};
  }

  Overlay overlay(const Editor&, Plane plane, double) const override {
    Overlay overlay;
    if (plane != plane_ || !known_) return overlay;
    overlay.guides = snapped_.guides;
    overlay.handles.push_back({HandleKind::Point, snapped_.at, 0, true});
    if (!centre_) return overlay;
    const Vec2 by = snapped_.at - *centre_;
    const Vec2 direction = length(by) > 1e-9 ? normalized(by) : Vec2{1, 0};
    overlay.measures.push_back({*centre_, *centre_ + direction * radius(), true});
    fields_.into(overlay, snapped_.at);
    return overlay;
  }

 private:
  void follow(Editor& editor, const PointerEvent& event) {
    plane_ = event.plane;
    known_ = true;
    SnapRequest request;
    request.plane = plane_;
    request.at = event.at;
    request.tolerance = kSnapPixels * event.pixel;
    request.ignored = preview_.elements();
    snapped_ = snapPoint(editor, request, event.modifiers.alt);
    if (!centre_) return;
    pointed_ = length(snapped_.at - *centre_);
    if (snapped_.to == SnappedPoint::To::Nothing && !event.modifiers.alt) {
      const double step = gridStep(event.pixel * 0.999, editor.settings().unit);
      pointed_ = std::round(pointed_ / step) * step;
    }
    show(editor);
  }

  double radius() const {
    const std::optional<double> typed = fields_.value(0);
    return typed ? std::abs(*typed) : pointed_;
  }

  void show(Editor& editor) {
    fields_.show(0, radius());
    if (2 * radius() < kThinnestSolid) {
      preview_.drop(editor);
      return;
    }
    Box2 drawn;
    drawn.add(*centre_ - Vec2{radius(), radius()});
    drawn.add(*centre_ + Vec2{radius(), radius()});
    preview_.show(editor, solidPiece(editor, "idap/solid-sphere",
                                     boxOver(editor, plane_, drawn, unseen_, 2 * radius())));
  }

  void finish(Editor& editor) {
    if (!preview_.shown() || fields_.wrong()) return;
    preview_.commit(editor);
    cancel(editor);
  }

  Plane plane_ = Plane::XY;
  bool known_ = false;
  std::optional<Vec2> centre_, pressedAt_;
  double unseen_ = 0, pointed_ = 0;
  SnappedPoint snapped_;
  TypedFields fields_;
  SolidPreview preview_;
};

}  // namespace

ToolEntry solidSphereTool() {
  return {&kInfo, [] { return std::make_unique<SphereTool>(); }};
}

}  // namespace idap
