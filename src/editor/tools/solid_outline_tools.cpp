// Solids with an outline of one's own: drawn in any plane and extruded across it, or half a profile turned
// about the axis that its first point stands on.
#include <algorithm>
#include <cmath>

#include "catalog/parametric/outline_parameter.h"
#include "editor/tools/outline_tool.h"
#include "editor/tools/solid_piece.h"
#include "editor/tools/tool_list.h"
#include "editor/tools/unseen.h"

namespace idap {

namespace {

std::vector<ToolKey> outlineKeys() {
  return {{"0-9", QT_TRANSLATE_NOOP("idap", "type the length")},
          {"Tab", QT_TRANSLATE_NOOP("idap", "angle")},
          {"Enter", QT_TRANSLATE_NOOP("idap", "place the point, or end")},
          {"Backspace", QT_TRANSLATE_NOOP("idap", "take the last point back")},
          {"Alt", QT_TRANSLATE_NOOP("idap", "no snapping")}};
}

const ToolInfo kExtrusion{
    "solid-extrusion",
    QT_TRANSLATE_NOOP("idap", "Outline"),
    QT_TRANSLATE_NOOP("idap",
                      "Draw an outline in any plane and give it a thickness: worktops, gables, steps"),
    QT_TRANSLATE_NOOP("idap", "Click the first corner of the outline, in any plane"),
    "X",
    outlineKeys()};
const ToolInfo kTurned{
    "solid-turned",
    QT_TRANSLATE_NOOP("idap", "Turned"),
    QT_TRANSLATE_NOOP("idap", "Draw half a profile and turn it about its axis: vases, bowls, columns"),
    QT_TRANSLATE_NOOP("idap", "Click where the axis stands and the profile begins, in any plane"),
    "Shift+X",
    outlineKeys()};

Box2 boxOf(const std::vector<Vec2>& points) {
  Box2 box;
  for (const Vec2 p : points) box.add(p);
  return box;
}

class ExtrusionTool : public OutlineTool {
 public:
  ExtrusionTool()
      : OutlineTool(
            {true,
             QT_TRANSLATE_NOOP("idap",
                               "Click the next corner; click the first one, double-click or Enter to close"),
             "", true}) {}
  const ToolInfo& info() const override { return kExtrusion; }
  Text hint() const override { return across_.active() ? Text(kAcrossHint) : OutlineTool::hint(); }

  bool cancel(Editor& editor) override {
    const bool across = across_.active();
    preview_.drop(editor);
    across_.end();
    return OutlineTool::cancel(editor) || across;
  }

  Response pointer(Editor& editor, const PointerEvent& event) override {
    if (!across_.active()) return OutlineTool::pointer(editor, event);
    if (event.kind == PointerEvent::Kind::Press && event.button == PointerEvent::Button::Right)
      cancel(editor);
    else
      answer(editor, across_.pointer(editor, event));
    return {};
  }

  Response key(Editor& editor, const KeyEvent& event) override {
    if (!across_.active()) return OutlineTool::key(editor, event);
    const AcrossStep::Answer got = across_.key(editor, event);
    answer(editor, got);
    return {.used = got != AcrossStep::Answer::None};
  }

  Overlay overlay(const Editor& editor, Plane plane, double pixel) const override {
    if (!across_.active()) return OutlineTool::overlay(editor, plane, pixel);
    Overlay overlay;
    across_.into(overlay, plane);
    return overlay;
  }

 protected:
  Elements ignored() const override { return preview_.elements(); }

  void drawn(Editor& editor, const std::vector<Vec2>& points) override {
    if (points.size() == 1) unseen_ = unseenCoordinate(editor, plane(), points.front());
    if (points.size() < 3 || !hasArea(points))
      preview_.drop(editor);
    else
      show(editor, points);
  }

  void finish(Editor& editor, std::vector<Vec2> points, bool) override {
    if (!hasArea(points)) {
      editor.say(QT_TRANSLATE_NOOP("idap", "This outline holds no area: draw at least three corners apart"),
                 Editor::Severity::Warning);
      return;
    }
    outline_ = std::move(points);
    across_.begin(plane(), boxOf(outline_), unseen_);
    show(editor, outline_);
  }

 private:
  static bool hasArea(const std::vector<Vec2>& points) {
    const Vec2 size = boxOf(points).max - boxOf(points).min;
    return size.x > kThinnestSolid && size.y > kThinnestSolid && std::abs(signedArea(points)) > 1e-6;
  }

  void show(Editor& editor, const std::vector<Vec2>& points) {
    const Box2 box = boxOf(points);
    const Vec2 size = box.max - box.min;
    std::vector<Vec2> shares;
    for (const Vec2 p : points) shares.push_back({(p.x - box.min.x) / size.x, (p.y - box.min.y) / size.y});
    Furniture piece =
        solidPiece(editor, "idap/solid-extrusion", boxOver(editor, plane(), box, unseen_, across_.value()));
    piece.model.parameters = parametric::outlineParameters(shares);
    piece.model.parameters["axis"] = axisAcross(plane());
    preview_.show(editor, piece);
  }

  void answer(Editor& editor, AcrossStep::Answer answer) {
    if (answer == AcrossStep::Answer::None) return;
    show(editor, outline_);
    if (answer != AcrossStep::Answer::Done) return;
    preview_.commit(editor);
    across_.end();
  }

  std::vector<Vec2> outline_;
  double unseen_ = 0;
  AcrossStep across_;
  SolidPreview preview_;
};

class TurnedTool : public OutlineTool {
 public:
  TurnedTool()
      : OutlineTool(
            {false,
             QT_TRANSLATE_NOOP("idap", "Click the next point of the profile; double-click or Enter to end"),
             "", true}) {}
  const ToolInfo& info() const override { return kTurned; }

  bool cancel(Editor& editor) override {
    preview_.drop(editor);
    axis_.reset();
    return OutlineTool::cancel(editor);
  }

  Overlay overlay(const Editor& editor, Plane plane, double pixel) const override {
    Overlay overlay = OutlineTool::overlay(editor, plane, pixel);
    constexpr double kBeyond = 30;  // pixels that the axis is drawn beyond the profile
    if (axis_ && plane == this->plane())
      overlay.guides.push_back({{axis_->x, low_ - kBeyond * pixel}, {axis_->x, high_ + kBeyond * pixel}});
    return overlay;
  }

 protected:
  Elements ignored() const override { return preview_.elements(); }

  void drawn(Editor& editor, const std::vector<Vec2>& points) override {
    if (points.empty()) return;
    if (points.size() == 1 || !axis_) unseen_ = unseenCoordinate(editor, plane(), points.front());
    axis_ = points.front();
    low_ = boxOf(points).min.y, high_ = boxOf(points).max.y;
    if (!show(editor, points)) preview_.drop(editor);
  }

  void finish(Editor& editor, std::vector<Vec2> points, bool) override {
    if (show(editor, points)) {
      preview_.commit(editor);
    } else {
      preview_.drop(editor);
      editor.say(QT_TRANSLATE_NOOP("idap", "This profile has no width or no height: draw it beside the axis"),
                 Editor::Severity::Warning);
    }
    axis_.reset();
  }

 private:
  // False where there is nothing to turn yet.
  bool show(Editor& editor, const std::vector<Vec2>& points) {
    const double axis = points.front().x;
    const Box2 box = boxOf(points);
    double radius = 0;
    for (const Vec2 p : points) radius = std::max(radius, std::abs(p.x - axis));
    const double height = box.max.y - box.min.y;
    if (radius < kThinnestSolid || height < kThinnestSolid) return false;
    std::vector<Vec2> profile;
    for (const Vec2 p : points)
      profile.push_back({std::abs(p.x - axis) / radius, (p.y - box.min.y) / height});
    Box2 around;
    around.add(Vec2{axis - radius, box.min.y});
    around.add(Vec2{axis + radius, box.max.y});
    Furniture piece =
        solidPiece(editor, "idap/solid-turned", boxOver(editor, plane(), around, unseen_, 2 * radius));
    piece.model.parameters = parametric::outlineParameters(profile);
    // Up the plane: upright, and in the plan from front to back.
    piece.model.parameters["axis"] = plane() == Plane::XY ? 2 : 0;
    preview_.show(editor, piece);
    return true;
  }

  std::optional<Vec2> axis_;
  double unseen_ = 0, low_ = 0, high_ = 0;
  SolidPreview preview_;
};

}  // namespace

ToolEntry solidExtrusionTool() {
  return {&kExtrusion, [] { return std::make_unique<ExtrusionTool>(); }};
}

ToolEntry solidTurnedTool() {
  return {&kTurned, [] { return std::make_unique<TurnedTool>(); }};
}

}  // namespace idap
