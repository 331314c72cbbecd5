#include "editor/tools/select/point_drags.h"

#include "editor/hit_test_shapes.h"

namespace idap {

PointDrag::PointDrag(Editor& editor, const PointerEvent& press, Source source)
    : EditDrag(editor, source.name, press, Cursor::Move),
      source_(std::move(source)),
      offset_(source_.point - press.at),
      to_(source_.point) {
  if (!source_.from) return;
  const Vec2 line = source_.point - *source_.from;
  fields_.define({{.label = QT_TRANSLATE_NOOP("idap", "Length"), .value = length(line), .active = true},
                  {.label = QT_TRANSLATE_NOOP("idap", "Angle"),
                   .kind = Field::Kind::Angle,
                   .value = std::atan2(line.y, line.x)}});
}

void PointDrag::aim(const Editor& editor, const PointerEvent& event) {
  to_ = snapped(editor, event.at + offset_, source_.ignored, source_.faces,
                source_.angles ? source_.from : std::nullopt, {}, source_.marks)
            .at;
  if (!source_.from) return;
  const Vec2 line = to_ - *source_.from;
  double span = length(line), angle = std::atan2(line.y, line.x);
  fields_.show(0, span);
  fields_.show(1, angle);
  const auto typedSpan = fields_.value(0), typedAngle = fields_.value(1);
  if (!typedSpan && !typedAngle) return;
  if (typedSpan) span = *typedSpan;
  if (typedAngle) angle = *typedAngle;
  to_ = *source_.from + rotated(Vec2{span, 0}, angle);
}

Home PointDrag::change(const Home& before) { return source_.place(before, to_); }

void PointDrag::show(const Editor&, Overlay& overlay, double) const {
  overlay.handles.push_back({HandleKind::Point, to_, 0, true});
  if (source_.from) overlay.measures.push_back({*source_.from, to_, fields_.active() == 0});
}

Text PointDrag::hint() const {
  if (!source_.from)
    return QT_TRANSLATE_NOOP("idap", "Snaps to ends, corners and lines; Alt stops snapping.");
  return QT_TRANSLATE_NOOP("idap", "Type a length, Tab for the angle, Enter to apply; Alt stops snapping.");
}

OffsetDrag::OffsetDrag(Editor& editor, const PointerEvent& press, DimensionId id)
    : EditDrag(editor, QT_TRANSLATE_NOOP("idap", "Move dimension"), press, Cursor::Move),
      id_(id),
      offset_(before().dimensions.find(id)->offset) {
  fields_.define({{.label = QT_TRANSLATE_NOOP("idap", "Offset"), .value = offset_, .active = true}});
}

void OffsetDrag::aim(const Editor& editor, const PointerEvent& event) {
  const Dimension& dimension = *before().dimensions.find(id_);
  const auto line = dimensionLine(plane(), dimension, elevationOf(before(), dimension.level));
  if (!line) return;
  const Vec2 along = normalized(line->end - line->start);
  const Vec2 to = snapped(editor, event.at, only(id_)).at;
  offset_ = cross(along, to - line->start);
  fields_.show(0, offset_);
  if (const auto typed = fields_.value(0)) offset_ = *typed;
}

Home OffsetDrag::change(const Home& before) {
  Home next = before;
  Dimension dimension = *before.dimensions.find(id_);
  dimension.offset = offset_;
  next.dimensions.set(id_, dimension);
  return next;
}

Text OffsetDrag::hint() const {
  return QT_TRANSLATE_NOOP("idap",
                           "How far the line stands off what it measures. Or type it and press Enter.");
}

}  // namespace idap
