#include "scene/ground_builder.h"

#include <algorithm>
#include <cmath>

#include "catalog/procedural_noise.h"

namespace idap {

namespace {

constexpr double kNear = 25;          // m around the home without haze
constexpr double kHorizon = 6000;     // m from the home to the edge of the land
constexpr double kVisibility = 900;   // m at which 63 % of the contrast is lost
constexpr std::uint32_t kRings = 24;  // of haze; each step must be too small to see
constexpr double kTile = 17;          // m that a copy of the mottle covers
constexpr int kPixels = 256;
constexpr float kDepth = 0.22f;     // of the mottle, about its mean
constexpr float kBrightest = 1.6f;  // its lightest tone, in depths over the mean

// A rectangle with round corners, so that rings show no mitres; counter-clockwise.
Polygon rounded(const Box2& around, double reach) {
  constexpr int kSteps = 12;
  const Vec2 corners[] = {{around.max.x, around.max.y},
                          {around.min.x, around.max.y},
                          {around.min.x, around.min.y},
                          {around.max.x, around.min.y}};
  Polygon points;
  for (int c = 0; c < 4; ++c) {
    for (int i = 0; i <= kSteps; ++i) {
      const double angle = kPi / 2 * (c + double(i) / kSteps);
      points.push_back(corners[c] + Vec2{std::cos(angle), std::sin(angle)} * reach);
    }
  }
  return points;
}

}  // namespace

Rgb meanReflectance(const render::Texture& picture) {
  const std::size_t texels = picture.rgba.size() / 4, step = std::max<std::size_t>(1, texels / 1021);
  Vec3 sum;
  double count = 0;
  for (std::size_t i = 0; i < texels; i += step, ++count) {
    for (int k = 0; k < 3; ++k) {
      const float v = float(picture.rgba[4 * i + static_cast<std::size_t>(k)]) / 255;
      sum[k] += double(picture.srgb ? srgbToLinear(v) : v);
    }
  }
  return count > 0 ? toFloat(sum / count) : Rgb{1, 1, 1};
}

namespace {

render::TexturePtr makeMottle() {
  // Tufts, patches and a slow change of tone, in that order of fineness.
  const PeriodicFbm tufts(48, 48, 3, 5), patches(7, 7, 4, 6), slow(2, 2, 2, 7);
  auto texture = std::make_shared<render::Texture>();
  texture->width = texture->height = kPixels;
  texture->rgba.resize(std::size_t{4} * kPixels * kPixels);
  constexpr float brightest = 1 + kBrightest * kDepth;
  std::size_t out = 0;
  for (int y = 0; y < kPixels; ++y) {
    for (int x = 0; x < kPixels; ++x) {
      const float u = (float(x) + 0.5f) / kPixels, v = (float(y) + 0.5f) / kPixels;
      const float tone = 1 + kDepth * (0.9f * tufts(u, v) + 1.3f * patches(u, v) + 0.8f * slow(u, v));
      const float dry = 0.25f * kDepth * slow(v, u);  // a little yellower here and there
      const auto encode = [&](float reflectance) {
        return static_cast<std::uint8_t>(
            std::lround(255 * linearToSrgb(std::clamp(reflectance / brightest, 0.0f, 1.0f))));
      };
      texture->rgba[out++] = encode(tone * (1 + dry));
      texture->rgba[out++] = encode(tone);
      texture->rgba[out++] = encode(tone * (1 - dry));
      texture->rgba[out++] = 255;
    }
  }
  return texture;
}

}  // namespace

render::TexturePtr mottle() {
  static const render::TexturePtr made = makeMottle();
  return made;
}

Ground buildGround(render::Surface soil, const Regions& open, const Box2& around, double height,
                   const Rgb& horizon, Vec3 centre) {
  Rgb mean{1, 1, 1};
  if (soil.baseColorMap) {
    mean = meanReflectance(*soil.baseColorMap);
  } else if (const float brightest = 1 + kBrightest * kDepth; maxComponent(soil.baseColor) * brightest < 1) {
    soil.baseColorMap = mottle();
    soil.uvScale = {static_cast<float>(1 / kTile), static_cast<float>(1 / kTile)};
    soil.baseColor = soil.baseColor * brightest;
    mean = Rgb{1, 1, 1} / brightest;
  }
  Ground ground;
  MeshSink sink(centre);
  const Regions close{{rounded(around, kNear), {}}};
  sink.horizontal(open.empty() ? close : subtract(close, open), height, true, 0);
  ground.surfaces.push_back(soil);
  double inner = kNear;
  for (std::uint32_t i = 1; i <= kRings; ++i) {
    const double outer = kNear * std::pow(kHorizon / kNear, double(i) / kRings);
    const Polygon a = rounded(around, inner), b = rounded(around, outer);
    for (std::size_t k = 0; k < a.size(); ++k) {
      const std::size_t next = (k + 1) % a.size();
      const auto at = [&](Vec2 p) { return Vec3{p.x, p.y, height}; };
      sink.quad({at(a[k]), at(b[k]), at(b[next]), at(a[next])}, {a[k], b[k], b[next], a[next]}, i);
    }
    // The haze in front of the middle of the ring.
    const auto haze = static_cast<float>(1 - std::exp(-std::sqrt(inner * outer) / kVisibility));
    render::Surface surface = soil;
    for (int k = 0; k < 3; ++k) {
      surface.baseColor[k] =
          std::min(1.0f, soil.baseColor[k] * (1 - haze) + horizon[k] * haze / std::max(mean[k], 0.02f));
    }
    ground.surfaces.push_back(std::move(surface));
    inner = outer;
  }
  if (!sink.empty()) ground.mesh = sink.take();
  return ground;
}

}  // namespace idap
