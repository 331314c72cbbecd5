#include "render/emitter/lamp.h"

#include <algorithm>

namespace idap::render {

float spotExponent(const Lamp& lamp) {
  if (!(lamp.beamAngle > 0)) return 0;
  const float half = std::clamp(0.5f * lamp.beamAngle, 0.01f, 1.55f);
  return std::log(0.5f) / std::log(std::cos(half));
}

float lampFallOff(const Lamp& lamp, Vec3f direction) {
  if (!lamp.lambertian && !(lamp.beamAngle > 0)) return 1;
  const float cosine = dot(lamp.axis, direction);
  if (cosine <= 0) return 0;
  const float fall = lamp.beamAngle > 0 ? std::pow(cosine, spotExponent(lamp)) : 1.0f;
  return lamp.lambertian ? fall * cosine : fall;
}

Rgb lampIntensity(const Lamp& lamp, Vec3f direction) { return lamp.intensity * lampFallOff(lamp, direction); }

Rgb lampFlux(const Lamp& lamp) {
  const float pi = static_cast<float>(kPi);
  if (!lamp.lambertian && !(lamp.beamAngle > 0)) return lamp.intensity * (4 * pi);
  const float exponent = spotExponent(lamp) + (lamp.lambertian ? 1.0f : 0.0f);
  return lamp.intensity * (2 * pi / (exponent + 1));
}

}  // namespace idap::render
