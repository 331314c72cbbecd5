// Draws chains of walls on the plan, straight or round, to typed lengths and angles.
#include <algorithm>
#include <cmath>

#include "editor/tools/drawn_point.h"
#include "editor/tools/tool_list.h"
#include "model/edits/level_edits.h"
#include "model/edits/wall_edits.h"
#include "model/edits/wall_shape_edits.h"
#include "model/wall_path.h"

namespace idap {

namespace {

constexpr double kShortest = 0.01;          // m: a shorter wall is a slip of the hand
constexpr double kSamePlace = 1e-3;         // m
constexpr double kLargestArc = 1.75 * kPi;  // radians: beyond it the ends of a round wall run into each other
constexpr double kArcStep = kPi / 12;       // 15 degrees,
constexpr double kArcSnap = kPi / 60;       // within 3 of them
constexpr std::size_t kThickness = DrawnPoint::kMore, kArc = kThickness + 1;

const ToolInfo kInfo{
    "wall",
    QT_TRANSLATE_NOOP("idap", "Wall"),
    QT_TRANSLATE_NOOP("idap", "Draw walls one after the other; where they close, they make a room"),
    QT_TRANSLATE_NOOP("idap", "Click where the first wall starts"),
    "W",
    {{"0-9", QT_TRANSLATE_NOOP("idap", "type the length")},
     {"Tab", QT_TRANSLATE_NOOP("idap", "angle, thickness, arc")},
     {"Enter", QT_TRANSLATE_NOOP("idap", "place it, or end")},
     {"Shift", QT_TRANSLATE_NOOP("idap", "round wall")},
     {"Backspace", QT_TRANSLATE_NOOP("idap", "take the last one back")},
     {"Alt", QT_TRANSLATE_NOOP("idap", "no snapping")}}};

// The sweep of the arc from start to end through a point; positive turns left.
double arcThrough(Vec2 start, Vec2 end, Vec2 through) {
  const Vec2 toStart = start - through, toEnd = end - through;
  if (length(toStart) < kSamePlace || length(toEnd) < kSamePlace) return 0;
  const double inscribed = std::abs(std::atan2(cross(toStart, toEnd), dot(toStart, toEnd)));
  const double sweep = std::min(2 * kPi - 2 * inscribed, kLargestArc);
  return cross(end - start, through - start) < 0 ? sweep : -sweep;
}

// The direction in which a wall arrives at its end.
double arrival(const Wall& wall) {
  const WallPath path(wall);
  const Vec2 direction = path.direction(path.length());
  return std::atan2(direction.y, direction.x);
}

class WallTool : public Tool {
 public:
  const ToolInfo& info() const override { return kInfo; }

  Text hint() const override {
    switch (stage_) {
      case Stage::Drawing:
        return QT_TRANSLATE_NOOP(
            "idap", "Click where the wall ends, or type its length; double-click or right-click to stop");
      case Stage::Bending:
        return QT_TRANSLATE_NOOP("idap", "Click where the round wall passes, or type its arc");
      default:
        return kInfo.hint;
    }
  }

  bool cancel(Editor& editor) override {
    if (stage_ == Stage::Idle) return false;
    stop(editor);
    return true;
  }

  Response pointer(Editor& editor, const PointerEvent& event) override {
    if (event.plane != Plane::XY) return {.used = false};
    switch (event.kind) {
      case PointerEvent::Kind::Move:
        follow(editor, event);
        return {};
      case PointerEvent::Kind::Press:
        if (event.button == PointerEvent::Button::Right) return {.used = cancel(editor)};
        follow(editor, event);
        pressedAt_ = event.at;
        click(editor, event.modifiers.shift);
        return {};
      case PointerEvent::Kind::Release: {
        const std::optional<Vec2> from = std::exchange(pressedAt_, std::nullopt);
        if (event.button != PointerEvent::Button::Left || stage_ == Stage::Idle || !from ||
            length(event.at - *from) < kDragPixels * event.pixel)
          return {};
        follow(editor, event);  // a wall drawn with the button held
        click(editor, event.modifiers.shift && stage_ == Stage::Drawing);
        return {};
      }
      case PointerEvent::Kind::DoubleClick:
        stop(editor);
        return {};
      default:
        return {};
    }
  }

  Response key(Editor& editor, const KeyEvent& event) override {
    if (stage_ == Stage::Idle) return {.used = false};
    switch (point_.key(event, editor.settings().unit)) {
      case TypedFields::Answer::Changed:
        show(editor);
        return {};
      case TypedFields::Answer::Apply:
        applyTyped(editor);
        return {};
      case TypedFields::Answer::Wrong:
        return {};
      case TypedFields::Answer::Unused:
        break;
    }
    if (event.key == Key::Enter) {
      if (stage_ == Stage::Bending)
        place(editor);
      else
        stop(editor);
      return {};
    }
    if (event.key == Key::Backspace) {
      takeBack(editor);
      return {};
    }
    return {.used = false};
  }

  Overlay overlay(const Editor& editor, Plane plane, double pixel) const override {
    Overlay overlay;
    if (plane != Plane::XY) {
      if (editor.lastPointer().plane == plane)
        overlay.note = QT_TRANSLATE_NOOP("idap", "Walls are drawn on the plan X-Y");
      return overlay;
    }
    if (stage_ == Stage::Bending) {
      overlay.handles.push_back({HandleKind::WallArc, pointer_, 0, true});
      overlay.measures.push_back({*point_.from(), end_, false});
      point_.fields().into(overlay, pointer_);
    } else {
      point_.into(overlay, pixel);
    }
    if (refused_) overlay.note = QT_TRANSLATE_NOOP("idap", "There is a wall already");
    return overlay;
  }

  Cursor cursor(const Editor&, Plane plane) const override {
    return plane == Plane::XY ? Cursor::Cross : Cursor::Forbidden;
  }

 private:
  enum class Stage { Idle, Drawing, Bending };

  Vec2 end() const { return stage_ == Stage::Bending ? end_ : point_.at(); }

  double arc() const {
    if (const auto typed = point_.fields().value(kArc)) return std::clamp(*typed, -kLargestArc, kLargestArc);
    return stage_ == Stage::Bending ? arc_ : 0;
  }

  Wall wall(const Editor& editor) const {
    Wall wall;
    wall.level = editor.level();
    wall.start = *point_.from();
    wall.end = end();
    wall.arcExtent = arc();
    wall.thickness = point_.fields().value(kThickness).value_or(thickness(editor));
    wall.heightAtStart = wall.heightAtEnd = editor.settings().wallHeight > 0
                                                ? editor.settings().wallHeight
                                                : newWallHeight(editor.home(), editor.level());
    wall.pattern = editor.settings().wallPattern;
    return wall;
  }

  double thickness(const Editor& editor) const {
    return thickness_.value_or(editor.settings().wallThickness);
  }

  void follow(Editor& editor, const PointerEvent& event) {
    last_ = event;
    pointer_ = event.at;
    if (stage_ == Stage::Bending) {
      arc_ = arcThrough(*point_.from(), end_, event.at);
      const double step = std::round(arc_ / kArcStep) * kArcStep;
      if (!event.modifiers.alt && editor.settings().snapping && std::abs(arc_ - step) < kArcSnap) arc_ = step;
    } else {
      DrawnPoint::Line line;
      if (stage_ == Stage::Drawing) {
        line.from = point_.from();
        line.along = along_;
        if (chain_.size() > 1) line.own.push_back(first_);
        if (preview_) line.ignored.walls.push_back(preview_);
      }
      point_.follow(editor, event, line);
    }
    show(editor);
  }

  // Draws the wall as it would be.
  void show(Editor& editor) {
    if (stage_ == Stage::Idle) return;
    const Wall next = wall(editor);
    point_.fields().show(kThickness, next.thickness);
    point_.fields().show(kArc, next.arcExtent);
    if (length(next.end - next.start) < kShortest) {
      refused_ = false;
      if (editor.document().inTransaction()) editor.preview([](const Home& home) { return home; });
      return;
    }
    if (!editor.document().inTransaction()) editor.document().begin(QT_TRANSLATE_NOOP("idap", "Add wall"));
    refused_ = !editor.preview([&](const Home& home) {
      WallEdit edit = addWall(home, next);
      preview_ = edit.wall;
      return std::move(edit.home);
    });
  }

  void click(Editor& editor, bool round) {
    if (stage_ == Stage::Idle) {
      first_ = point_.at();
      start(first_);
      show(editor);
    } else if (stage_ == Stage::Drawing && round && length(end() - *point_.from()) >= kShortest) {
      end_ = end();
      arc_ = 0;
      stage_ = Stage::Bending;
      point_.fields().clear(DrawnPoint::kLength);
      point_.fields().clear(DrawnPoint::kAngle);
      point_.fields().activate(kArc);
    } else {
      place(editor);
    }
  }

  void applyTyped(Editor& editor) {
    const TypedFields& fields = point_.fields();
    const bool onlyThickness = fields.value(kThickness) && !fields.value(DrawnPoint::kLength) &&
                               !fields.value(DrawnPoint::kAngle) && !fields.value(kArc);
    if (!onlyThickness) {
      place(editor);
      if (stage_ == Stage::Drawing) follow(editor, last_);  // on from there to the pointer
      return;
    }
    if (*fields.value(kThickness) > 0) thickness_ = fields.value(kThickness);
    point_.fields().clear();
    point_.fields().activate(DrawnPoint::kLength);
    show(editor);
  }

  // The wall as it is shown becomes one undo step, and the next one starts at its end.
  void place(Editor& editor) {
    const Wall placed = wall(editor);
    if (length(placed.end - placed.start) < kShortest) return;
    show(editor);
    if (refused_) return;
    const WallId id = preview_;
    if (editor.settings().roomAreas)
      editor.preview([&](const Home& home) {
        return followWalls(home, addWall(home, placed).home, placed.level, true);
      });
    editor.document().commit();
    preview_ = {};
    if (const auto typed = point_.fields().value(kThickness)) thickness_ = typed;
    chain_.push_back(id);
    along_ = arrival(placed);
    if (closes(editor.home(), id)) return stop(editor);
    start(placed.end);
  }

  // The end of the chain has come to another wall.
  bool closes(const Home& home, WallId id) const {
    const Wall* placed = home.walls.find(id);
    if (!placed) return true;
    for (const auto& [otherId, other] : home.walls) {
      if (otherId == id || other->level != placed->level) continue;
      const WallPath path(*other);
      if (length(path.point(path.nearest(placed->end)) - placed->end) < kSamePlace) return true;
    }
    return false;
  }

  void start(Vec2 from) {
    stage_ = Stage::Drawing;
    refused_ = false;
    point_.startFrom(from, along_);
  }

  void takeBack(Editor& editor) {
    if (stage_ == Stage::Bending) {
      start(*point_.from());
      return follow(editor, last_);
    }
    if (chain_.empty()) return stop(editor);
    editor.document().cancel();
    preview_ = {};
    const Wall* last = editor.home().walls.find(chain_.back());
    const Vec2 from = last ? last->start : first_;
    chain_.pop_back();
    editor.document().undo();
    const Wall* before = chain_.empty() ? nullptr : editor.home().walls.find(chain_.back());
    along_ = before ? std::optional(arrival(*before)) : std::nullopt;
    start(from);
    follow(editor, last_);
  }

  void stop(Editor& editor) {
    editor.document().cancel();
    stage_ = Stage::Idle;
    chain_.clear();
    preview_ = {};
    along_.reset();
    pressedAt_.reset();
    refused_ = false;
    point_.forget();
  }

  Stage stage_ = Stage::Idle;
  DrawnPoint point_{{{QT_TRANSLATE_NOOP("idap", "Thickness"), Field::Kind::Length},
                     {QT_TRANSLATE_NOOP("idap", "Arc"), Field::Kind::Angle}}};
  Vec2 first_, end_, pointer_;
  double arc_ = 0;
  std::optional<double> along_, thickness_;
  std::vector<WallId> chain_;
  WallId preview_;
  std::optional<Vec2> pressedAt_;
  PointerEvent last_;
  bool refused_ = false;
};

}  // namespace

ToolEntry wallTool() {
  return {&kInfo, [] { return std::make_unique<WallTool>(); }};
}

}  // namespace idap
