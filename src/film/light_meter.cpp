#include "film/light_meter.h"

#include <algorithm>
#include <cmath>

namespace idap {

void LightCurve::smooth(double frames) {
  std::vector<Key> smoothed = keys_;
  for (Key& key : smoothed) {
    double weight = 0, ev = 0;
    Vec3 illuminant;
    for (const Key& other : keys_) {
      const double far = (static_cast<double>(other.frame) - static_cast<double>(key.frame)) / frames;
      const double w = std::exp(-0.5 * far * far);
      weight += w;
      ev += w * static_cast<double>(other.light.ev);
      illuminant += toDouble(other.light.illuminant) * w;
    }
    key.light = {static_cast<float>(ev / weight), toFloat(illuminant / weight)};
  }
  keys_ = std::move(smoothed);
}

void LightCurve::makeConstant() {
  if (keys_.empty()) return;
  std::vector<Key> sorted = keys_;
  std::sort(sorted.begin(), sorted.end(), [](const Key& a, const Key& b) { return a.light.ev < b.light.ev; });
  // Rather a little dark in the evening than burnt out at noon.
  const MeteredLight light = sorted[sorted.size() * 2 / 3].light;
  keys_ = {{0, light}};
}

MeteredLight LightCurve::at(std::size_t frame) const {
  if (keys_.empty()) return {};
  const auto after =
      std::find_if(keys_.begin(), keys_.end(), [&](const Key& key) { return key.frame >= frame; });
  if (after == keys_.end()) return keys_.back().light;
  if (after == keys_.begin()) return after->light;
  const Key &a = *(after - 1), &b = *after;
  const float t = static_cast<float>(frame - a.frame) / static_cast<float>(b.frame - a.frame);
  return {a.light.ev + (b.light.ev - a.light.ev) * t,
          a.light.illuminant + (b.light.illuminant - a.light.illuminant) * t};
}

}  // namespace idap
