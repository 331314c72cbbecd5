#include "render/film/tone_map.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace idap::render {

namespace {

Rgb clamped(Rgb c) {
  return {std::clamp(c.x, 0.0f, 1.0f), std::clamp(c.y, 0.0f, 1.0f), std::clamp(c.z, 0.0f, 1.0f)};
}

Rgb pbrNeutral(Rgb c) {
  constexpr float kF90 =
      0.04f;  // the specular reflection of a usual dielectric, taken out of the base colour
  constexpr float kStart = 0.8f - kF90;
  constexpr float kDesaturation = 0.15f;
  const float low = std::min({c.x, c.y, c.z});
  const float offset = low < 2 * kF90 ? low - low * low / (4 * kF90) : kF90;
  c = c - Rgb{offset, offset, offset};
  const float peak = maxComponent(c);
  if (peak < kStart) return c;
  const float d = 1 - kStart;
  const float newPeak = 1 - d * d / (peak + d - kStart);
  c *= newPeak / peak;
  const float white = 1 - 1 / (kDesaturation * (peak - newPeak) + 1);
  return c * (1 - white) + Rgb{newPeak, newPeak, newPeak} * white;
}

// AgX's sigmoid: a line of slope kSlope through the pivot, bent into 0 and 1 by a toe and a shoulder.
struct AgxCurve {
  static constexpr float kMinStop = -12.47393f,
                         kMaxStop = 4.026069f;  // about middle grey 0.18, log2 of linear
  static constexpr float kPivotX = 10.0f / 16.5f, kPivotY = 0.5f;
  static constexpr float kSlope = 2.0f, kToe = 3.0f, kShoulder = 3.25f;

  static float scale(float x, float y, float power) {
    return std::pow(std::pow(kSlope * x, -power) * (std::pow(kSlope * x / y, power) - 1), -1 / power);
  }
  static float bend(float t, float power) { return t / std::pow(1 + std::pow(t, power), 1 / power); }

  float toeScale = scale(kPivotX, kPivotY, kToe);
  float shoulderScale = scale(1 - kPivotX, 1 - kPivotY, kShoulder);

  float operator()(float linear) const {
    const float stop = std::log2(std::max(linear, 1e-10f));
    const float x = std::clamp((stop - kMinStop) / (kMaxStop - kMinStop), 0.0f, 1.0f);
    const float t = kSlope * std::fabs(x - kPivotX);
    return x < kPivotX ? kPivotY - toeScale * bend(t / toeScale, kToe)
                       : kPivotY + shoulderScale * bend(t / shoulderScale, kShoulder);
  }
};

Rgb agx(Rgb c) {
  static const AgxCurve curve;
  // The inset mixes the channels so that bright saturated colours can go to white; the outset is its inverse.
  const Rgb in{0.842479062f * c.x + 0.0784336f * c.y + 0.0792237451f * c.z,
               0.0423282422f * c.x + 0.878468636f * c.y + 0.0791661275f * c.z,
               0.0423756549f * c.x + 0.0784336f * c.y + 0.879142974f * c.z};
  const Rgb e{curve(in.x), curve(in.y), curve(in.z)};
  const Rgb out{1.19687901f * e.x - 0.0980208811f * e.y - 0.0990297441f * e.z,
                -0.0528968518f * e.x + 1.15190313f * e.y - 0.0989611768f * e.z,
                -0.0529716355f * e.x - 0.0980434501f * e.y + 1.15107367f * e.z};
  const auto linear = [](float v) { return std::pow(std::max(v, 0.0f), 2.2f); };
  return {linear(out.x), linear(out.y), linear(out.z)};
}

float usable(float v) { return v > 0 ? std::min(v, 1e9f) : 0.0f; }  // NaN becomes 0

}  // namespace

std::string_view name(ToneMap toneMap) {
  switch (toneMap) {
    case ToneMap::PbrNeutral:
      return "neutral";
    case ToneMap::AgX:
      return "agx";
    case ToneMap::Classic:
      return "classic";
    case ToneMap::Linear:
      return "linear";
    case ToneMap::FalseColor:
      return "false";
  }
  return "";
}

Rgb falseColor(float luminance) {
  struct Mark {
    float stop;
    Rgb color;
  };
  constexpr Mark kMarks[] = {{-8, {0, 0, 0}},        {-6, {0.13f, 0, 0.25f}}, {-4, {0, 0.05f, 0.8f}},
                             {-2, {0, 0.6f, 0.75f}}, {0, {0.1f, 0.5f, 0.1f}}, {1, {0.9f, 0.85f, 0}},
                             {2, {1, 0.35f, 0}},     {2.5f, {0.9f, 0, 0}},    {3.5f, {1, 1, 1}}};
  const float stop = std::log2(std::max(luminance, 1e-10f) / 0.18f);
  if (stop <= kMarks[0].stop) return kMarks[0].color;
  for (std::size_t i = 1; i < std::size(kMarks); ++i) {
    const Mark &a = kMarks[i - 1], &b = kMarks[i];
    if (stop >= b.stop) continue;
    const float t = (stop - a.stop) / (b.stop - a.stop);
    return a.color * (1 - t) + b.color * t;
  }
  return {1, 1, 1};
}

Rgb toneMapped(Rgb color, ToneMap toneMap) {
  const Rgb c{usable(color.x), usable(color.y), usable(color.z)};
  switch (toneMap) {
    case ToneMap::PbrNeutral:
      return clamped(pbrNeutral(c));
    case ToneMap::AgX:
      return clamped(agx(c));
    case ToneMap::FalseColor:
      return falseColor(luminance(c));
    case ToneMap::Classic:
    case ToneMap::Linear:
      break;
  }
  return clamped(c);
}

}  // namespace idap::render
