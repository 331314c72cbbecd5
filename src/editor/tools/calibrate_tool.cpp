#include "editor/tools/calibrate_tool.h"

#include "editor/snap.h"
#include "editor/tools/drawn_point.h"

namespace idap {

namespace {

constexpr double kFewestPixels = 5;  // between the two points: less is too rough to measure by

const ToolInfo kCalibrateInfo{
    "calibrate",
    QT_TRANSLATE_NOOP("idap", "Set the scale of the background"),
    QT_TRANSLATE_NOOP("idap", "Give a length on the scanned plan, and it gets its true size"),
    QT_TRANSLATE_NOOP("idap", "Click one end of a length that you know on the picture"),
    "",
    {{"0-9", QT_TRANSLATE_NOOP("idap", "type the true length")},
     {"Enter", QT_TRANSLATE_NOOP("idap", "done")}}};

const ToolInfo kMoveInfo{"move-background",
                         QT_TRANSLATE_NOOP("idap", "Move the background"),
                         QT_TRANSLATE_NOOP("idap", "Drag the scanned plan to where it belongs"),
                         QT_TRANSLATE_NOOP("idap", "Drag a point of the picture to where it belongs"),
                         "",
                         {{"Alt", QT_TRANSLATE_NOOP("idap", "no snapping")}}};

void sayNone(Editor& editor) {
  editor.say(QT_TRANSLATE_NOOP("idap", "This level has no background picture"), Editor::Severity::Warning);
}

bool hasBackground(const Home& home, LevelId level) { return home.backgrounds.contains(level); }

class CalibrateTool : public Tool {
 public:
  explicit CalibrateTool(LevelId level) : level_(level) {}
  const ToolInfo& info() const override { return kCalibrateInfo; }

  void begin(Editor& editor) override {
    if (!hasBackground(editor.home(), level_)) sayNone(editor);
  }

  Text hint() const override {
    switch (points_.size()) {
      case 0:
        return kCalibrateInfo.hint;
      case 1:
        return QT_TRANSLATE_NOOP("idap", "Click its other end");
      default:
        return QT_TRANSLATE_NOOP("idap", "Type the true length between them, then press Enter");
    }
  }

  bool cancel(Editor&) override {
    const bool begun = !points_.empty();
    points_.clear();
    length_.clear();
    return begun;
  }

  Response pointer(Editor& editor, const PointerEvent& event) override {
    if (event.plane != Plane::XY) return {.used = false};
    if (!hasBackground(editor.home(), level_)) return {.finished = true};
    if (event.kind == PointerEvent::Kind::Press && event.button == PointerEvent::Button::Right)
      return {.used = cancel(editor)};
    pointer_ = event.at;
    if (event.kind != PointerEvent::Kind::Press) return {};
    if (points_.size() == 2) {  // not right yet: measure again
      points_.clear();
      length_.clear();
    }
    if (points_.size() == 1 && length(event.at - points_[0]) < kFewestPixels * event.pixel) return {};
    points_.push_back(event.at);
    if (points_.size() == 2) length_.show(0, length(points_[1] - points_[0]));
    return {};
  }

  Response key(Editor& editor, const KeyEvent& event) override {
    if (points_.size() < 2) return {.used = false};
    const TypedFields::Answer answer = length_.key(event, editor.settings().unit);
    if (answer != TypedFields::Answer::Apply) return {.used = answer != TypedFields::Answer::Unused};
    const double factor = *length_.value(0) / length(points_[1] - points_[0]);
    if (!(factor > 0)) {
      editor.say(QT_TRANSLATE_NOOP("idap", "The length must be more than nothing"),
                 Editor::Severity::Warning);
      return {};
    }
    const Vec2 fixed = points_[0];
    const bool done =
        editor.apply(QT_TRANSLATE_NOOP("idap", "Set the scale of the background"), [&](const Home& home) {
          Home next = home;
          if (const auto found = next.backgrounds.find(level_); found != next.backgrounds.end()) {
            found->second.scale *= factor;
            found->second.origin = fixed + (found->second.origin - fixed) * factor;
          }
          return next;
        });
    return {.finished = done};
  }

  Overlay overlay(const Editor&, Plane plane, double) const override {
    Overlay overlay;
    if (plane != Plane::XY || points_.empty()) return overlay;
    const Vec2 last = points_.size() == 2 ? points_[1] : pointer_;
    for (const Vec2 p : {points_[0], last}) overlay.handles.push_back({HandleKind::Point, p, 0, true});
    overlay.shapes.push_back({{points_[0], last}, false, false});
    if (points_.size() == 2) length_.into(overlay, last);
    return overlay;
  }

 private:
  LevelId level_;
  std::vector<Vec2> points_;
  Vec2 pointer_;
  TypedFields length_{{{QT_TRANSLATE_NOOP("idap", "True length"), Field::Kind::Length}}};
};

class MoveBackgroundTool : public Tool {
 public:
  explicit MoveBackgroundTool(LevelId level) : level_(level) {}
  const ToolInfo& info() const override { return kMoveInfo; }

  void begin(Editor& editor) override {
    if (!hasBackground(editor.home(), level_)) sayNone(editor);
  }

  bool cancel(Editor& editor) override {
    if (!from_) return false;
    from_.reset();
    guides_.clear();
    editor.document().cancel();
    return true;
  }

  Response pointer(Editor& editor, const PointerEvent& event) override {
    if (event.plane != Plane::XY) return {.used = false};
    if (!hasBackground(editor.home(), level_)) return {.finished = true};
    switch (event.kind) {
      case PointerEvent::Kind::Press:
        if (event.button == PointerEvent::Button::Right) return {.used = cancel(editor)};
        if (from_) return {};
        from_ = event.at;
        editor.document().begin(QT_TRANSLATE_NOOP("idap", "Move the background"));
        return {};
      case PointerEvent::Kind::Move:
        if (from_) drag(editor, event);
        return {};
      case PointerEvent::Kind::Release:
        if (!from_ || event.button != PointerEvent::Button::Left) return {};
        drag(editor, event);
        from_.reset();
        guides_.clear();
        editor.document().commit();
        return {};
      default:
        return {};
    }
  }

  Overlay overlay(const Editor&, Plane plane, double) const override {
    Overlay overlay;
    if (plane == Plane::XY) overlay.guides = guides_;
    return overlay;
  }

  Cursor cursor(const Editor&, Plane plane) const override {
    return plane == Plane::XY ? Cursor::Move : Cursor::Forbidden;
  }

 private:
  void drag(Editor& editor, const PointerEvent& event) {
    SnapRequest request;
    request.at = event.at;
    request.tolerance = kSnapPixels * event.pixel;
    request.wallFaces = true;
    const SnappedPoint to = snapPoint(editor, request, event.modifiers.alt);
    guides_ = to.guides;
    const Vec2 by = to.at - *from_;
    editor.preview([&](const Home& home) {
      Home next = home;
      if (const auto found = next.backgrounds.find(level_); found != next.backgrounds.end())
        found->second.origin += by;
      return next;
    });
  }

  LevelId level_;
  std::optional<Vec2> from_;
  std::vector<GuideLine> guides_;
};

}  // namespace

std::unique_ptr<Tool> makeCalibrateTool(LevelId level) { return std::make_unique<CalibrateTool>(level); }
std::unique_ptr<Tool> makeMoveBackgroundTool(LevelId level) {
  return std::make_unique<MoveBackgroundTool>(level);
}

}  // namespace idap
