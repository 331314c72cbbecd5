// Stone, fired clay and what is cast or pressed: marble, granite, terrazzo, concrete, tiles, bricks, cork.
#include <algorithm>

#include "catalog/procedural_noise.h"
#include "catalog/procedural_pattern.h"

namespace idap::pattern {

namespace {

std::uint32_t asId(int a, int b) {
  return mixHash(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
}

Color mixed(Color a, Color b, float t) {
  return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b)};
}

std::array<std::uint8_t, 3> encoded(Color c, float scale) {
  const auto byte = [scale](float v) {
    return static_cast<std::uint8_t>(std::clamp(v * scale, 0.0f, 1.0f) * 255.0f + 0.5f);
  };
  return {byte(c.r), byte(c.g), byte(c.b)};
}

// Veins: thin lines where noise crosses zero in a warped plane. 1 on a vein, 0 away from it.
class Veins {
 public:
  Veins(int cells, std::uint32_t seed, float sharpness)
      : warpX_(cells, cells, 3, seed),
        warpY_(cells, cells, 3, seed + 7),
        line_(cells, cells, 3, seed + 19),
        mask_(cells, cells, seed + 31),
        sharpness_(sharpness) {}

  float operator()(float u, float v) const {
    const float x = u + 0.13f * warpX_(u, v), y = v + 0.13f * warpY_(u, v);
    const float ridge = 1.0f - std::fmin(1.0f, std::fabs(line_(x, y)) * sharpness_);
    return ridge * ridge * ridge * smoothStep(-0.35f, 0.45f, mask_(u, v));
  }

 private:
  PeriodicFbm warpX_, warpY_, line_;
  PeriodicNoise mask_;
  float sharpness_;
};

}  // namespace

// Colours: vein, shade, ground.
ProceduralTexture marble(const TextureRecipe& r) {
  const std::vector<Color> colors =
      colorsOr(r, {{0.55f, 0.55f, 0.56f}, {0.84f, 0.84f, 0.84f}, {0.94f, 0.94f, 0.93f}});
  const Ramp ground({colors[1 % colors.size()], colors.back()});
  const Ramp ramp(colors);
  const Veins bold(2, r.seed, 9.0f), fine(4, r.seed + 100, 13.0f);
  const PeriodicFbm cloud(3, 3, 5, r.seed + 200);
  const auto veins = static_cast<float>(r.number("veins", 0.75));
  return paint(r, false, [&, veins](float u, float v) {
    const float base = 0.72f + 0.55f * cloud(u, v);
    const float vein = std::min(1.0f, veins * (bold(u, v) + 0.5f * fine(u, v)));
    const auto& a = ground(base);
    const auto& b = ramp(0);
    Texel t;
    for (std::size_t i = 0; i < 3; ++i)
      t.color[i] =
          static_cast<std::uint8_t>(static_cast<float>(a[i]) * (1 - vein) + static_cast<float>(b[i]) * vein);
    return t;
  });
}

// Colours: the minerals, each a share of the grains.
ProceduralTexture granite(const TextureRecipe& r) {
  const std::vector<Color> colors =
      colorsOr(r, {{0.2f, 0.2f, 0.21f}, {0.45f, 0.44f, 0.44f}, {0.62f, 0.6f, 0.59f}, {0.74f, 0.72f, 0.7f}});
  const int n = std::max(8, static_cast<int>(std::lround(r.size.x / r.number("grain", 0.005))));
  const PeriodicCells grains(n, n, r.seed);
  const PeriodicFbm cloud(4, 4, 4, r.seed + 3);
  return paint(r, false, [&](float u, float v) {
    const PeriodicCells::Sample s = grains(u, v);
    const float pick = std::clamp(randomAt(s.id, r.seed, 9) + 0.35f * cloud(u, v), 0.0f, 0.999f);
    const float place = pick * static_cast<float>(colors.size());
    const auto i = static_cast<std::size_t>(place);
    const Color soft =
        mixed(colors[i], colors[std::min(i + 1, colors.size() - 1)], 0.5f * (place - std::floor(place)));
    return Texel{encoded(soft, 0.93f + 0.14f * randomAt(s.id, r.seed, 4)), 0};
  });
}

// Colours: the cement, then those of the chips.
ProceduralTexture terrazzo(const TextureRecipe& r) {
  const std::vector<Color> colors =
      colorsOr(r, {{0.86f, 0.85f, 0.82f}, {0.45f, 0.44f, 0.43f}, {0.7f, 0.6f, 0.5f}, {0.95f, 0.94f, 0.92f}});
  const auto chipSize = static_cast<float>(r.number("chip", 0.014));
  const auto side = static_cast<float>(r.size.x);
  const int n = std::max(4, static_cast<int>(std::lround(side / (chipSize * 1.35f))));
  const PeriodicCells large(n, n, r.seed, 0.8f), small(n * 3, n * 3, r.seed + 5, 0.9f);
  const PeriodicFbm cloud(6, 6, 4, r.seed + 9);
  // A chip is the cut of a few half-planes about its point.
  const auto chip = [&](const PeriodicCells::Sample& s, float reach, std::uint32_t salt) {
    const float size = reach * (0.45f + 0.55f * randomAt(s.id, r.seed, salt));
    float outside = 0;
    for (std::uint32_t k = 0; k < 5; ++k) {
      const float a = 1.2566f * (static_cast<float>(k) + 0.75f * randomAt(s.id, salt, k));
      outside = std::max(outside, (s.offset.x * std::cos(a) + s.offset.y * std::sin(a)) /
                                      (0.7f + 0.5f * randomAt(s.id, salt + 1, k)));
    }
    return 1.0f - smoothStep(size * 0.94f, size * 1.06f, outside);
  };
  return paint(r, false, [&](float u, float v) {
    const auto pickColor = [&](std::uint32_t id) {
      return colors.size() < 2 ? colors[0] : colors[1 + mixHash(id, r.seed, 3) % (colors.size() - 1)];
    };
    Color c = colors[0];
    const PeriodicCells::Sample b = small(u, v);
    if (randomAt(b.id, 8) < 0.6f) c = mixed(c, pickColor(b.id), chip(b, 0.34f, 50));
    const PeriodicCells::Sample a = large(u, v);
    if (randomAt(a.id, 7) < 0.85f) c = mixed(c, pickColor(a.id), chip(a, 0.4f, 40));
    return Texel{encoded(c, 1.0f + 0.05f * cloud(u, v)), 0};
  });
}

// Colours: dark to light.
ProceduralTexture concrete(const TextureRecipe& r) {
  const Ramp ramp(colorsOr(r, {{0.46f, 0.46f, 0.45f}, {0.6f, 0.6f, 0.59f}, {0.7f, 0.7f, 0.69f}}));
  const PeriodicFbm cloud(3, 3, 6, r.seed), stain(2, 2, 3, r.seed + 40);
  const PeriodicNoise grit(220, 220, r.seed + 50);
  const PeriodicCells pores(26, 26, r.seed + 60);
  const auto contrast = static_cast<float>(r.number("contrast", 1));
  return paint(r, true, [&, contrast](float u, float v) {
    const PeriodicCells::Sample p = pores(u, v);
    const float radius = randomAt(p.id, r.seed, 3) < 0.3f ? 0.05f + 0.06f * randomAt(p.id, r.seed, 4) : 0.0f;
    const float pore = radius > 0 ? 1.0f - smoothStep(radius * 0.6f, radius, p.nearest) : 0.0f;
    const float tone =
        0.55f + contrast * (0.38f * cloud(u, v) + 0.22f * stain(u, v) + 0.07f * grit(u, v)) - 0.5f * pore;
    return Texel{ramp(tone), 0.00005f * grit(u, v) - 0.0006f * pore};
  });
}

// Colours: grout, then the glaze from dark to light. columns and rows a picture; grout m wide; offset: how
// far every other row is shifted, in tiles.
ProceduralTexture tiles(const TextureRecipe& r) {
  std::vector<Color> colors =
      colorsOr(r, {{0.7f, 0.69f, 0.67f}, {0.86f, 0.86f, 0.85f}, {0.92f, 0.92f, 0.91f}});
  const Ramp grout({mixed(colors[0], {0, 0, 0}, 0.12f), colors[0]});
  const Ramp glaze(colors.size() > 1 ? std::vector<Color>(colors.begin() + 1, colors.end()) : colors);
  const int columns = std::max(1, static_cast<int>(r.number("columns", 4)));
  const int rows = std::max(1, static_cast<int>(r.number("rows", 4)));
  const auto joint = static_cast<float>(r.number("grout", 0.003));
  const auto bevel = static_cast<float>(r.number("bevel", 0.0015));
  const auto variation = static_cast<float>(r.number("variation", 0.25));
  const auto mottle = static_cast<float>(r.number("mottle", 0.25));
  const auto offset = static_cast<float>(r.number("offset", 0));
  const float tileX = static_cast<float>(r.size.x) / static_cast<float>(columns);
  const float tileY = static_cast<float>(r.size.y) / static_cast<float>(rows);
  const PeriodicFbm cloud(5, 5, 5, r.seed);
  const PeriodicNoise grit(250, 250, r.seed + 2);
  return paint(r, true, [&](float u, float v) {
    const float y = v * static_cast<float>(rows);
    const int row = std::min(static_cast<int>(y), rows - 1);
    const float x =
        fractionOf(u + (row % 2 ? offset / static_cast<float>(columns) : 0)) * static_cast<float>(columns);
    const int column = std::min(static_cast<int>(x), columns - 1);
    const float fx = x - static_cast<float>(column), fy = y - static_cast<float>(row);
    const float d = std::min(std::min(fx, 1 - fx) * tileX, std::min(fy, 1 - fy) * tileY) - joint / 2;
    const float g = grit(u, v);
    if (d <= 0) return Texel{grout(0.7f + 0.5f * g), -0.0012f + 0.0001f * g};
    const std::uint32_t id = asId(column, row);
    // Each tile is cut from another place of the cloud.
    const float c = cloud(u + randomAt(id, r.seed, 1), v + randomAt(id, r.seed, 2));
    const float tone = 0.6f + variation * (randomAt(id, r.seed, 3) - 0.5f) * 2 + mottle * c;
    const float rim = smoothStep(0, bevel, d);
    Texel t{glaze(tone - 0.15f * (1 - rim)), -0.0012f * (1 - rim)};
    return t;
  });
}

// Colours: mortar, then the bricks from dark to light. A running bond.
ProceduralTexture brick(const TextureRecipe& r) {
  std::vector<Color> colors =
      colorsOr(r, {{0.72f, 0.69f, 0.64f}, {0.4f, 0.2f, 0.15f}, {0.6f, 0.31f, 0.22f}, {0.71f, 0.42f, 0.31f}});
  const Ramp mortar({mixed(colors[0], {0, 0, 0}, 0.25f), colors[0]});
  const Ramp clay(colors.size() > 1 ? std::vector<Color>(colors.begin() + 1, colors.end()) : colors);
  const int columns = std::max(1, static_cast<int>(std::lround(r.size.x / r.number("length", 0.25))));
  const int rows = 2 * std::max(1, static_cast<int>(std::lround(r.size.y / r.number("height", 0.075) / 2)));
  const float brickX = static_cast<float>(r.size.x) / static_cast<float>(columns);
  const float brickY = static_cast<float>(r.size.y) / static_cast<float>(rows);
  const auto joint = static_cast<float>(r.number("joint", 0.011));
  const PeriodicFbm cloud(12, 12, 4, r.seed), edge(40, 40, 2, r.seed + 1);
  const PeriodicNoise grit(256, 256, r.seed + 2);
  return paint(r, true, [&](float u, float v) {
    const float y = v * static_cast<float>(rows);
    const int row = std::min(static_cast<int>(y), rows - 1);
    const float x =
        fractionOf(u + (row % 2 ? 0.5f / static_cast<float>(columns) : 0)) * static_cast<float>(columns);
    const int column = std::min(static_cast<int>(x), columns - 1);
    const float fx = x - static_cast<float>(column), fy = y - static_cast<float>(row);
    const float g = grit(u, v);
    const float d = std::min(std::min(fx, 1 - fx) * brickX, std::min(fy, 1 - fy) * brickY) - joint / 2 +
                    0.0025f * edge(u, v);
    if (d <= 0) return Texel{mortar(0.65f + 0.4f * g + 0.2f * cloud(u, v)), -0.005f + 0.0006f * g};
    const std::uint32_t id = asId(column, row);
    const float tone = 0.5f + 0.75f * (randomAt(id, r.seed, 3) - 0.5f) + 0.35f * cloud(u, v) + 0.16f * g;
    const float rim = smoothStep(0, 0.006f, d);
    return Texel{clay(tone - 0.12f * (1 - rim)), -0.005f * (1 - rim) + 0.0005f * g + 0.0008f * cloud(u, v)};
  });
}

// Colours: dark to light.
ProceduralTexture cork(const TextureRecipe& r) {
  const Ramp ramp(colorsOr(r, {{0.38f, 0.24f, 0.14f}, {0.68f, 0.5f, 0.33f}, {0.8f, 0.63f, 0.45f}}));
  const int n = std::max(8, static_cast<int>(std::lround(r.size.x / r.number("grain", 0.005))));
  const PeriodicCells grains(n, n, r.seed);
  const PeriodicFbm cloud(8, 8, 4, r.seed + 1);
  return paint(r, true, [&](float u, float v) {
    const PeriodicCells::Sample s = grains(u, v);
    const float rim = smoothStep(0.0f, 0.22f, s.second - s.nearest);
    const float dark = randomAt(s.id, r.seed, 2) < 0.07f ? 0.45f : 0.0f;
    const float tone =
        0.62f + 0.45f * (randomAt(s.id, r.seed, 3) - 0.5f) + 0.2f * cloud(u, v) - dark - 0.16f * (1 - rim);
    return Texel{ramp(tone), 0.0003f * rim};
  });
}

}  // namespace idap::pattern
