#include "editor/tools/drawn_point.h"

#include <cmath>

namespace idap {

double fullTurn(double angle) {
  const double turned = std::fmod(angle, 2 * kPi);
  const double positive = turned < 0 ? turned + 2 * kPi : turned;
  return positive > 2 * kPi - 1e-9 ? 0 : positive;
}

DrawnPoint::DrawnPoint(const std::vector<Field>& more) {
  std::vector<Field> fields{{QT_TRANSLATE_NOOP("idap", "Length"), Field::Kind::Length},
                            {QT_TRANSLATE_NOOP("idap", "Angle"), Field::Kind::Angle}};
  fields.insert(fields.end(), more.begin(), more.end());
  fields_.define(std::move(fields));
}

void DrawnPoint::follow(const Editor& editor, const PointerEvent& event, const Line& line) {
  SnapRequest request;
  request.plane = event.plane;
  request.at = event.at;
  request.tolerance = kSnapPixels * event.pixel;
  request.from = line.from;
  request.along = line.along;
  request.own = line.own;
  request.ignored = line.ignored;
  request.wallFaces = line.wallFaces;
  snapped_ = snapPoint(editor, request, event.modifiers.alt);
  if (line.from && !event.modifiers.alt && editor.settings().snapping) roundLength(editor, event, *line.from);
  from_ = line.from;
  along_ = line.along;
  known_ = true;
  showValues();
}

// A length that nothing else gives is a round one, as fine as the pointer can be moved.
void DrawnPoint::roundLength(const Editor& editor, const PointerEvent& event, Vec2 from) {
  const bool free = snapped_.to == SnappedPoint::To::Nothing ||
                    (snapped_.to == SnappedPoint::To::Angle && snapped_.guides.size() < 2);
  const double drawn = length(snapped_.at - from);
  const double step = gridStep(event.pixel * 0.999, editor.settings().unit);
  if (!free || drawn < step) return;
  snapped_.at = from + (snapped_.at - from) * (std::round(drawn / step) * step / drawn);
  for (GuideLine& guide : snapped_.guides) guide.to = snapped_.at;
}

void DrawnPoint::startFrom(Vec2 from, std::optional<double> along) {
  from_ = from;
  along_ = along;
  snapped_ = {};
  snapped_.at = from;
  fields_.clear();
  fields_.activate(kLength);
  showValues();
}

void DrawnPoint::forget() {
  from_.reset();
  snapped_.guides.clear();
  fields_.clear();
  fields_.activate(kLength);
}

Vec2 DrawnPoint::at() const {
  if (!from_) return snapped_.at;
  const std::optional<double> typedLength = fields_.value(kLength), typedAngle = fields_.value(kAngle);
  if (!typedLength && !typedAngle) return snapped_.at;
  const Vec2 by = snapped_.at - *from_;
  const double pointed = length(by) < 1e-6 ? along_.value_or(0) : std::atan2(by.y, by.x);
  const double angle = typedAngle.value_or(pointed);
  const Vec2 direction{std::cos(angle), std::sin(angle)};
  // Without a length the point stays beside the pointer.
  return *from_ + direction * typedLength.value_or(typedAngle ? std::abs(dot(by, direction)) : length(by));
}

SnappedPoint::To DrawnPoint::snappedTo() const {
  return fields_.value(kLength) || fields_.value(kAngle) ? SnappedPoint::To::Nothing : snapped_.to;
}

TypedFields::Answer DrawnPoint::key(const KeyEvent& event, LengthUnit unit) {
  if (!from_) return TypedFields::Answer::Unused;
  const TypedFields::Answer answer = fields_.key(event, unit);
  if (answer != TypedFields::Answer::Unused) showValues();
  return answer;
}

void DrawnPoint::showValues() {
  if (!from_) return;
  const Vec2 by = at() - *from_;
  fields_.show(kLength, length(by));
  fields_.show(kAngle, fields_.value(kAngle).value_or(fullTurn(std::atan2(by.y, by.x))));
}

void DrawnPoint::into(Overlay& overlay, double pixel) const {
  if (!known_) return;
  const Vec2 point = at();
  if (snappedTo() != SnappedPoint::To::Nothing)
    overlay.guides.insert(overlay.guides.end(), snapped_.guides.begin(), snapped_.guides.end());
  overlay.handles.push_back({HandleKind::Point, point, 0, true});
  if (!from_) return;
  const Vec2 by = point - *from_;
  if (length(by) > 2 * pixel) {
    overlay.measures.push_back({*from_, point, fields_.active() == kLength});
    overlay.angles.push_back({*from_, 0, fullTurn(std::atan2(by.y, by.x))});
  }
  fields_.into(overlay, point);
}

}  // namespace idap
