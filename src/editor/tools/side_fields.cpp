#include "editor/tools/side_fields.h"

#include <algorithm>
#include <cmath>

namespace idap {

namespace {

constexpr std::array<const char*, 4> kLabels{
    QT_TRANSLATE_NOOP("idap", "Left"), QT_TRANSLATE_NOOP("idap", "Right"),
    QT_TRANSLATE_NOOP("idap", "Bottom"), QT_TRANSLATE_NOOP("idap", "Top")};
constexpr double kTouching = 1e-6;  // m

}  // namespace

void SideFields::show(const std::vector<MeasureLine>& measures, Vec2 middle) {
  if (typing()) return;
  std::vector<Measured> found;
  for (const MeasureLine& line : measures) {
    Vec2 by = line.to - line.from;
    const double distance = length(by);
    // Touching: the line has no direction of its own, but lies to one side of the middle.
    if (distance < kTouching) by = line.from - middle;
    if (length(by) < kTouching) continue;
    const bool across = std::abs(by.x) >= std::abs(by.y);
    const Side side = across ? (by.x < 0 ? Left : Right) : (by.y < 0 ? Bottom : Top);
    found.push_back({side, line, normalized(by)});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Measured& a, const Measured& b) { return a.side < b.side; });
  const bool same = found.size() == measured_.size() &&
                    std::equal(found.begin(), found.end(), measured_.begin(),
                               [](const Measured& a, const Measured& b) { return a.side == b.side; });
  measured_ = std::move(found);
  if (!same) {
    std::vector<Field> fields;
    for (const Measured& m : measured_) fields.push_back({kLabels[m.side], Field::Kind::Length});
    fields_.define(std::move(fields));
  }
  for (std::size_t i = 0; i < measured_.size(); ++i)
    fields_.show(i, length(measured_[i].line.to - measured_[i].line.from));
}

void SideFields::clear() {
  measured_.clear();
  fields_.define({});
}

TypedFields::Answer SideFields::key(const KeyEvent& event, LengthUnit unit) {
  const TypedFields::Answer answer = fields_.key(event, unit);
  // Two opposite distances cannot both hold: the one typed last does.
  if (answer == TypedFields::Answer::Changed && fields_.value(fields_.active()))
    for (std::size_t i = 0; i < measured_.size(); ++i)
      if (i != fields_.active() && dot(measured_[i].outward, measured_[fields_.active()].outward) < -0.5)
        fields_.clear(i);
  return answer;
}

Vec2 SideFields::shift() const {
  Vec2 sum;
  for (std::size_t i = 0; i < measured_.size(); ++i)
    if (const auto typed = fields_.value(i))
      sum += measured_[i].outward * (length(measured_[i].line.to - measured_[i].line.from) - *typed);
  return sum;
}

void SideFields::into(Overlay& overlay, Vec2 at) const {
  const Vec2 by = shift();
  for (std::size_t i = 0; i < measured_.size(); ++i) {
    MeasureLine line = measured_[i].line;
    // The piece's end of the line goes along with it; the other slides sideways only.
    const double along = dot(by, measured_[i].outward);
    line.from += by;
    line.to += by - measured_[i].outward * along;
    line.strong = i == fields_.active() && fields_.typing();
    overlay.measures.push_back(line);
  }
  fields_.into(overlay, at);
}

}  // namespace idap
