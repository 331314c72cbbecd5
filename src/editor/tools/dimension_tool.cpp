// Dimensions: from one point to another, then how far beside them the line is drawn. On the plan lengths, in
// the upright planes heights and widths.
#include <cmath>

#include "editor/tools/drawn_point.h"
#include "editor/tools/tool_list.h"
#include "editor/tools/unseen.h"

namespace idap {

namespace {

constexpr double kShortest = 0.001;   // m
constexpr double kOffsetStep = 0.05;  // m: lines drawn one after the other come to lie in a row

const ToolInfo kInfo{"dimension",
                     QT_TRANSLATE_NOOP("idap", "Dimension"),
                     QT_TRANSLATE_NOOP("idap", "Write a length on the plan, or a height beside it"),
                     QT_TRANSLATE_NOOP("idap", "Click where the measure starts"),
                     "M",
                     {{"0-9", QT_TRANSLATE_NOOP("idap", "type how far beside it is drawn")},
                      {"Alt", QT_TRANSLATE_NOOP("idap", "no snapping")}}};

class DimensionTool : public Tool {
 public:
  const ToolInfo& info() const override { return kInfo; }

  Text hint() const override {
    switch (stage_) {
      case Stage::End:
        return QT_TRANSLATE_NOOP("idap", "Click where the measure ends");
      case Stage::Offset:
        return QT_TRANSLATE_NOOP("idap", "Click where the line is to be drawn");
      default:
        return kInfo.hint;
    }
  }

  bool cancel(Editor& editor) override {
    if (stage_ == Stage::Start) return false;
    editor.document().cancel();
    stage_ = Stage::Start;
    preview_ = {};
    pressedAt_.reset();
    point_.forget();
    offset_.clear();
    return true;
  }

  Response pointer(Editor& editor, const PointerEvent& event) override {
    if (stage_ != Stage::Start && event.plane != plane_) return {.used = false};
    switch (event.kind) {
      case PointerEvent::Kind::Move:
        follow(editor, event);
        return {};
      case PointerEvent::Kind::Press:
      case PointerEvent::Kind::DoubleClick:
        if (event.button == PointerEvent::Button::Right) return {.used = cancel(editor)};
        follow(editor, event);
        pressedAt_ = event.at;
        click(editor);
        return {};
      case PointerEvent::Kind::Release: {
        const std::optional<Vec2> from = std::exchange(pressedAt_, std::nullopt);
        if (!from || stage_ == Stage::Start || length(event.at - *from) < kDragPixels * event.pixel)
          return {};
        follow(editor, event);
        click(editor);
        return {};
      }
      default:
        return {};
    }
  }

  Response key(Editor& editor, const KeyEvent& event) override {
    if (stage_ != Stage::Offset) return {.used = false};
    switch (offset_.key(event, editor.settings().unit)) {
      case TypedFields::Answer::Changed:
        show(editor);
        return {};
      case TypedFields::Answer::Apply:
        click(editor);
        return {};
      case TypedFields::Answer::Wrong:
        return {};
      case TypedFields::Answer::Unused:
        break;
    }
    if (event.key != Key::Enter) return {.used = false};
    click(editor);
    return {};
  }

  Overlay overlay(const Editor&, Plane plane, double) const override {
    Overlay overlay;
    if (plane != plane_ || !point_.known()) return overlay;
    if (stage_ != Stage::Offset) {
      // The length and angle of walls' fields are of no use here: what is measured is what is there.
      point_.into(overlay, 0);
      overlay.fields.clear();
      overlay.angles.clear();
      for (Handle& handle : overlay.handles) handle.at = stage_ == Stage::End ? end_ : point_.at();
      for (MeasureLine& measure : overlay.measures) measure.to = end_;
    } else {
      overlay.handles.push_back({HandleKind::Offset, pointer_, 0, true});
      offset_.into(overlay, pointer_);
    }
    return overlay;
  }

 private:
  enum class Stage { Start, End, Offset };

  void follow(Editor& editor, const PointerEvent& event) {
    pointer_ = event.at;
    plane_ = event.plane;
    free_ = event.modifiers.alt;
    if (stage_ != Stage::Offset) {
      DrawnPoint::Line line;
      line.wallFaces = true;
      if (stage_ == Stage::End) line.from = start_;
      if (preview_) line.ignored.dimensions.push_back(preview_);
      point_.follow(editor, event, line);
      end_ = point_.at();
      // Upright: heights and widths, never a slope.
      if (stage_ == Stage::End && plane_ != Plane::XY) {
        if (std::abs(end_.x - start_.x) > std::abs(end_.y - start_.y))
          end_.y = start_.y;
        else
          end_.x = start_.x;
      }
    }
    show(editor);
  }

  double offset() const {
    if (const auto typed = offset_.value(0)) return *typed;
    const Vec2 along = normalized(end_ - start_);
    const double distance = dot(pointer_ - start_, perpendicular(along));
    return free_ ? distance : std::round(distance / kOffsetStep) * kOffsetStep;
  }

  Dimension dimension(const Editor& editor) const {
    Dimension made;
    made.level = editor.level();
    const double beside = stage_ == Stage::Offset ? offset() : 0;
    if (plane_ == Plane::XY) {
      made.start = start_;
      made.end = end_;
      made.offset = beside;
      return made;
    }
    const double depth = unseen_;
    const Vec3 from = inSpace(plane_, start_, depth), to = inSpace(plane_, end_, depth);
    made.start = {from.x, from.y};
    made.end = {to.x, to.y};
    made.startElevation = from.z - editor.elevation();
    made.endElevation = to.z - editor.elevation();
    const Vec2 along = normalized(end_ - start_);
    // The offset counts to the left on this plane; the pitch says the same to who looks from elsewhere: of a
    // level line how far the offset is tilted up from the plan, of an upright one the direction on the plan
    // that the offset is left of.
    made.offset = beside;
    if (std::abs(along.x) > 0.5)
      made.pitch = along.x > 0 ? kPi / 2 : -kPi / 2;
    else if (plane_ == Plane::XZ)
      made.pitch = along.y > 0 ? kPi / 2 : -kPi / 2;
    else
      made.pitch = along.y > 0 ? kPi : 0;
    return made;
  }

  void show(Editor& editor) {
    if (stage_ == Stage::Start || length(end_ - start_) < kShortest) return;
    if (stage_ == Stage::Offset) offset_.show(0, offset());
    if (!editor.document().inTransaction())
      editor.document().begin(QT_TRANSLATE_NOOP("idap", "Add dimension"));
    const Dimension made = dimension(editor);
    editor.preview([&](const Home& home) {
      Home next = home;
      preview_ = next.newId<DimensionId>();
      next.dimensions.set(preview_, made);
      return next;
    });
  }

  void click(Editor& editor) {
    if (stage_ == Stage::Start) {
      start_ = end_ = point_.at();
      unseen_ = unseenCoordinate(editor, plane_, start_);
      stage_ = Stage::End;
      point_.startFrom(start_);
    } else if (length(end_ - start_) < kShortest) {
      return;
    } else if (stage_ == Stage::End) {
      stage_ = Stage::Offset;
      show(editor);
    } else {
      show(editor);
      const DimensionId id = preview_;
      editor.document().commit();
      cancel(editor);
      editor.select(only(id));
    }
  }

  Stage stage_ = Stage::Start;
  DrawnPoint point_;
  TypedFields offset_{{{QT_TRANSLATE_NOOP("idap", "Offset"), Field::Kind::Length}}};
  Plane plane_ = Plane::XY;
  Vec2 start_, end_, pointer_;
  double unseen_ = 0;
  bool free_ = false;
  DimensionId preview_;
  std::optional<Vec2> pressedAt_;
};

}  // namespace

ToolEntry dimensionTool() {
  return {&kInfo, [] { return std::make_unique<DimensionTool>(); }};
}

}  // namespace idap
