#include "catalog/light_power.h"

#include <algorithm>
#include <cmath>

namespace idap {

namespace {

constexpr double kLumensOfWhite = 6000;  // at power 1
constexpr double kDefaultLumens = 806;   // of a lamp without bulbs

double levelOf(const Color& c) { return 0.2126 * double(c.r) + 0.7152 * double(c.g) + 0.0722 * double(c.b); }

Color hueOf(const Color& c) {
  const float brightest = std::max({c.r, c.g, c.b});
  return brightest > 0 ? Color{c.r / brightest, c.g / brightest, c.b / brightest} : Color{1, 1, 1};
}

}  // namespace

Lamp lampOf(double power, const std::vector<Sh3dLightSource>& sources) {
  power = std::isfinite(power) ? std::clamp(power, 0.0, 1.0) : 0.5;
  Lamp lamp;
  lamp.on = power > 0;
  if (!lamp.on) power = 0.5;  // switched off; what it would give is kept
  if (sources.empty()) {
    lamp.lumens = kDefaultLumens * power * power / 0.25;
    return lamp;
  }
  double total = 0;
  for (const Sh3dLightSource& source : sources) total += levelOf(source.color);
  lamp.lumens = kLumensOfWhite * power * power * total;
  lamp.color = hueOf(sources.front().color);
  for (const Sh3dLightSource& source : sources) {
    LightSource& to = lamp.sources.emplace_back();
    to.position = source.position;
    to.diameter = source.diameter.value_or(0);
    to.share = total > 0 ? levelOf(source.color) : 1;
    if (const Color hue = hueOf(source.color); !(hue == *lamp.color)) to.color = hue;
  }
  return lamp;
}

}  // namespace idap
