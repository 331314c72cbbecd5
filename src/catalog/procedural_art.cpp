// Paintings for picture frames: overlapping cut-out shapes, and hills in the haze.
#include <algorithm>
#include <array>

#include "catalog/procedural_noise.h"
#include "catalog/procedural_pattern.h"

namespace idap::pattern {

namespace {

std::array<std::uint8_t, 3> encoded(Color c, float scale) {
  const auto byte = [scale](float v) {
    return static_cast<std::uint8_t>(std::clamp(v * scale, 0.0f, 1.0f) * 255.0f + 0.5f);
  };
  return {byte(c.r), byte(c.g), byte(c.b)};
}

Color mixed(Color a, Color b, float t) {
  return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b)};
}

// The canvas shows through the paint.
float canvas(const PeriodicNoise& weave, const PeriodicFbm& brush, float u, float v) {
  return 1.0f + 0.03f * weave(u, v) + 0.05f * brush(u, v);
}

}  // namespace

// Colours: the ground, then those of the shapes.
ProceduralTexture abstractArt(const TextureRecipe& r) {
  const std::vector<Color> colors = colorsOr(r, {{0.92f, 0.89f, 0.83f},
                                                 {0.73f, 0.36f, 0.24f},
                                                 {0.87f, 0.68f, 0.42f},
                                                 {0.25f, 0.33f, 0.36f},
                                                 {0.6f, 0.64f, 0.56f},
                                                 {0.16f, 0.15f, 0.15f}});
  struct Shape {
    float x, y, rx, ry, cosine, sine;
    int kind;  // 0 ellipse, 1 arch, 2 ring, 3 bar
    Color color;
  };
  std::vector<Shape> shapes;
  for (std::uint32_t i = 0; i < 7; ++i) {
    const auto rnd = [&](std::uint32_t k) { return randomAt(i, r.seed, k); };
    const float turn = (rnd(1) - 0.5f) * 0.5f, size = 0.26f - 0.022f * static_cast<float>(i);
    shapes.push_back({0.5f + 0.5f * (rnd(2) - 0.5f), 0.5f + 0.6f * (rnd(3) - 0.5f),
                      size * (0.75f + 0.5f * rnd(4)), size * (0.75f + 0.6f * rnd(5)), std::cos(turn),
                      std::sin(turn), static_cast<int>(4 * rnd(6)),
                      colors[1 + i % (colors.size() > 1 ? colors.size() - 1 : 1)]});
    if (colors.size() < 2) shapes.back().color = colors[0];
  }
  const PeriodicNoise weave(160, 160, r.seed);
  const PeriodicFbm brush(5, 24, 4, r.seed + 1), edge(9, 9, 3, r.seed + 2);
  return paint(r, false, [&](float u, float v) {
    Color c = colors[0];
    const float wobble = 0.035f * edge(u, v);
    for (const Shape& s : shapes) {
      const float dx = u - s.x, dy = v - s.y;
      const float x = (dx * s.cosine + dy * s.sine) / s.rx, y = (dy * s.cosine - dx * s.sine) / s.ry;
      float d = 0;  // under 1 inside
      if (s.kind == 0) d = std::sqrt(x * x + y * y);
      if (s.kind == 1) d = y > 0 ? std::sqrt(x * x + y * y) : std::fmax(std::fabs(x), -y);
      if (s.kind == 2) d = 1 + 3.2f * (std::fabs(std::sqrt(x * x + y * y) - 0.86f) - 0.14f);
      if (s.kind == 3) d = std::fmax(std::fabs(x) * 5.0f, std::fabs(y) * 0.8f);
      c = mixed(c, s.color, 0.93f * (1 - smoothStep(0.985f, 1.015f, d + wobble)));
    }
    return Texel{encoded(c, canvas(weave, brush, u, v)), 0};
  });
}

// Colours: upper sky, lower sky, sun, far hills, near hills.
ProceduralTexture landscape(const TextureRecipe& r) {
  const std::vector<Color> given = colorsOr(r, {{0.55f, 0.67f, 0.76f},
                                                {0.9f, 0.87f, 0.78f},
                                                {0.98f, 0.93f, 0.77f},
                                                {0.62f, 0.69f, 0.69f},
                                                {0.2f, 0.29f, 0.24f}});
  const auto color = [&](std::size_t i) { return given[std::min(i, given.size() - 1)]; };
  constexpr std::size_t kLayers = 6;
  std::vector<PeriodicFbm> ridges;
  for (std::uint32_t i = 0; i < kLayers; ++i) ridges.emplace_back(2, 1, 6, r.seed * 17 + i * 5);
  const PeriodicNoise weave(160, 160, r.seed);
  const PeriodicFbm brush(6, 30, 4, r.seed + 1), cloud(3, 9, 5, r.seed + 3);
  const auto aspect = static_cast<float>(r.size.x / r.size.y);
  const float sunX = 0.3f + 0.4f * randomAt(r.seed, 1), sunY = 0.68f + 0.1f * randomAt(r.seed, 2);
  // How high the layers reach at each column of pixels.
  std::vector<std::array<float, kLayers>> heights(static_cast<std::size_t>(r.width));
  for (std::size_t x = 0; x < heights.size(); ++x) {
    const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(r.width);
    for (std::size_t i = 0; i < kLayers; ++i) {
      const float depth = static_cast<float>(i) / (kLayers - 1);
      heights[x][i] =
          0.58f - 0.1f * static_cast<float>(i) + (0.16f - 0.08f * depth) * ridges[i](u * 0.9f, 0.37f);
    }
  }
  return paint(r, false, [&](float u, float v) {
    const auto& reach = heights[static_cast<std::size_t>(u * static_cast<float>(r.width))];
    Color c = mixed(color(1), color(0), smoothStep(0.45f, 1.0f, v));
    c = mixed(c, color(1), 0.5f * smoothStep(0.0f, 0.5f, cloud(u, v)));
    const float sun = std::sqrt((u - sunX) * (u - sunX) * aspect * aspect + (v - sunY) * (v - sunY));
    c = mixed(c, color(2),
              std::fmax(1 - smoothStep(0.05f, 0.056f, sun), 0.5f * (1 - smoothStep(0.0f, 0.3f, sun))));
    for (std::size_t i = 0; i < kLayers; ++i) {
      const float depth = static_cast<float>(i) / (kLayers - 1), height = reach[i];
      if (v > height + 0.002f) continue;
      // Haze gathers at each foot.
      const float haze = smoothStep(0.0f, 0.16f, height - v) * (1 - depth);
      c = mixed(mixed(color(3), color(4), depth * depth * 0.4f + 0.6f * depth), color(1),
                0.4f * haze + 0.12f * (1 - depth));
    }
    return Texel{encoded(c, canvas(weave, brush, u, v)), 0};
  });
}

}  // namespace idap::pattern
