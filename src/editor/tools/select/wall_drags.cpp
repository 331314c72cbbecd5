#include "editor/tools/select/wall_drags.h"

#include <algorithm>

#include "model/edits/wall_shape_edits.h"
#include "model/wall_path.h"

namespace idap {

namespace {

constexpr const char* kCorner = QT_TRANSLATE_NOOP("idap", "Move corner");
constexpr const char* kBend = QT_TRANSLATE_NOOP("idap", "Bend wall");
constexpr const char* kHeight = QT_TRANSLATE_NOOP("idap", "Change height");
constexpr double kSamePlace = 1e-3;    // m
constexpr double kLeastHeight = 0.05;  // m

// The sweep of the arc through three points, from first to last; positive turns left.
double sweepThrough(Vec2 start, Vec2 end, Vec2 through) {
  const Vec2 chord = end - start;
  const double half = length(chord) / 2;
  const double rise = cross(chord, through - start) / (2 * half);
  // The middle of the chord and the height of the arc over it: tan(a/4) = height / half chord.
  return -4 * std::atan2(rise, half);
}

}  // namespace

WallEndDrag::WallEndDrag(Editor& editor, const PointerEvent& press, WallId id, WallEnd end)
    : WallDrag(editor, kCorner, press, Cursor::Move, id),
      corner_(end == WallEnd::Start ? wall_.start : wall_.end),
      fixed_(end == WallEnd::Start ? wall_.end : wall_.start),
      to_(corner_),
      offset_(corner_ - press.at) {
  for (const auto& [otherId, other] : before().walls)
    if (other->level == wall_.level &&
        (length(other->start - corner_) <= kSamePlace || length(other->end - corner_) <= kSamePlace)) {
      add(ignored_, otherId);
      marks_.push_back(length(other->start - corner_) <= kSamePlace ? other->end : other->start);
    }
  const Vec2 line = corner_ - fixed_;
  fields_.define({{.label = QT_TRANSLATE_NOOP("idap", "Length"), .value = length(line), .active = true},
                  {.label = QT_TRANSLATE_NOOP("idap", "Angle"),
                   .kind = Field::Kind::Angle,
                   .value = std::atan2(line.y, line.x)}});
}

void WallEndDrag::aim(const Editor& editor, const PointerEvent& event) {
  const Vec2 was = corner_ - fixed_;
  to_ = snapped(editor, event.at + offset_, ignored_, false, fixed_, std::atan2(was.y, was.x), marks_).at;
  const Vec2 line = to_ - fixed_;
  double span = length(line), angle = span > 0 ? std::atan2(line.y, line.x) : std::atan2(was.y, was.x);
  fields_.show(0, span);
  fields_.show(1, angle);
  const auto typedSpan = fields_.value(0), typedAngle = fields_.value(1);
  if (!typedSpan && !typedAngle) return;
  if (typedSpan) span = *typedSpan;
  if (typedAngle) angle = *typedAngle;
  to_ = fixed_ + rotated(Vec2{span, 0}, angle);
}

Home WallEndDrag::change(const Home& before) { return moveCorner(before, wall_.level, corner_, to_); }

void WallEndDrag::show(const Editor& editor, Overlay& overlay, double) const {
  overlay.handles.push_back({HandleKind::WallEnd, to_, 0, true});
  // The lengths of all walls that meet there.
  for (const WallId id : ignored_.walls)
    if (const Wall* wall = editor.home().walls.find(id))
      overlay.measures.push_back({wall->start, wall->end, id == id_});
}

Text WallEndDrag::hint() const {
  return QT_TRANSLATE_NOOP(
      "idap",
      "Walls that meet here follow. Type a length, Tab for the angle, Enter to apply; Alt "
      "stops snapping.");
}

WallArcDrag::WallArcDrag(Editor& editor, const PointerEvent& press, WallId id)
    : WallDrag(editor, kBend, press, Cursor::Move, id), through_(press.at) {
  fields_.define({{.label = QT_TRANSLATE_NOOP("idap", "Arc"),
                   .kind = Field::Kind::Angle,
                   .value = wall_.arcExtent,
                   .active = true}});
}

void WallArcDrag::aim(const Editor& editor, const PointerEvent& event) {
  const Vec2 middle = (wall_.start + wall_.end) / 2;
  const Vec2 aside = perpendicular(normalized(wall_.end - wall_.start));
  double rise = dot(event.at - middle, aside);
  const double half = length(wall_.end - wall_.start) / 2;
  if (!event.modifiers.alt && editor.settings().snapping) {
    // Straight, and in steps of 15 degrees where they are near.
    if (std::abs(rise) <= tolerance(event)) rise = 0;
    const double sweep = stepped(-4 * std::atan2(rise, half), false);
    const double near = half * std::tan(-sweep / 4);
    if (std::abs(near - rise) <= tolerance(event) / 2) rise = near;
  }
  through_ = middle + aside * rise;
  fields_.show(0, sweepThrough(wall_.start, wall_.end, through_));
  if (const auto typed = fields_.value(0)) {
    const double sweep = std::clamp(*typed, -1.9 * kPi, 1.9 * kPi);
    through_ = middle + aside * (half * std::tan(-sweep / 4));
  }
}

Home WallArcDrag::change(const Home& before) { return bendWall(before, id_, through_); }

Text WallArcDrag::hint() const {
  return QT_TRANSLATE_NOOP("idap",
                           "Bends the wall; back on its line it is straight. Or type the angle of the arc.");
}

WallHeightDrag::WallHeightDrag(Editor& editor, const PointerEvent& press, WallId id, bool start, bool end)
    : WallDrag(editor, kHeight, press, Cursor::SizeVertical, id),
      start_(start),
      end_(end),
      height_(start ? wall_.heightAtStart : wall_.heightAtEnd) {
  fields_.define({{.label = QT_TRANSLATE_NOOP("idap", "Height"), .value = height_, .active = true}});
}

void WallHeightDrag::aim(const Editor& editor, const PointerEvent& event) {
  const double floor = elevationOf(before(), wall_.level);
  height_ = std::max(kLeastHeight, snapped(editor, event.at, only(id_)).at.y - floor);
  fields_.show(0, height_);
  if (const auto typed = fields_.value(0)) height_ = std::max(kLeastHeight, *typed);
}

Home WallHeightDrag::change(const Home& before) {
  Wall wall = wall_;
  const bool both = last().modifiers.shift;
  if (start_ || both) wall.heightAtStart = height_;
  if (end_ || both) wall.heightAtEnd = height_;
  return replaceWall(before, id_, wall);
}

Text WallHeightDrag::hint() const {
  return QT_TRANSLATE_NOOP("idap",
                           "The wall's height at this end; with Shift at both. Or type it and press Enter.");
}

}  // namespace idap
