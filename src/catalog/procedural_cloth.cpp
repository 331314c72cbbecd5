// Cloth, pile, hide and wicker, and brushed metal.
#include <algorithm>

#include "catalog/procedural_noise.h"
#include "catalog/procedural_pattern.h"

namespace idap::pattern {

namespace {

struct Crossing {
  float height;      // 0..1, how far up the upper thread is
  std::uint32_t id;  // of the upper thread
  bool weft;         // the upper thread runs along u
  float along;       // place along it, threads
};

// float over `over` threads, shifted by one a row: 1 is plain weave, 2 a twill.
Crossing crossing(float x, float y, int threads, int over) {
  const int ix = std::min(static_cast<int>(x), threads - 1), iy = std::min(static_cast<int>(y), threads - 1);
  const bool weft = over == 1 ? (ix + iy) % 2 == 0 : wrapped(ix - iy, 2 * over) < over;
  const float fx = 2 * (x - static_cast<float>(ix)) - 1, fy = 2 * (y - static_cast<float>(iy)) - 1;
  const float across = weft ? fy : fx;
  float along = weft ? fx : fy;
  if (over > 1) {  // place along the whole float
    const int step = weft ? wrapped(ix - iy, 2 * over) : over - 1 - (wrapped(ix - iy, 2 * over) - over);
    along = (2 * static_cast<float>(step) + 1 + along) / static_cast<float>(over) - 1;
  }
  const float round = std::sqrt(std::fmax(0.0f, 1 - across * across));
  const float arch = 1 - 0.55f * along * along;
  return {round * arch, static_cast<std::uint32_t>(weft ? iy : 1000 + ix), weft, weft ? x : y};
}

}  // namespace

// Colours: the gap between threads, warp, weft. threads a picture's side, an even number.
ProceduralTexture weave(const TextureRecipe& r) {
  const std::vector<Color> colors = colorsOr(r, {{0.55f, 0.55f, 0.55f}, {0.93f, 0.93f, 0.93f}});
  const Ramp warp({colors[0], colors[1 % colors.size()]});
  const Ramp weft({colors[0], colors.back()});
  const int over = std::clamp(static_cast<int>(r.number("over", 1)), 1, 4);
  const int unit = 2 * over;
  const int threads = std::max(1, static_cast<int>(r.number("threads", 64)) / unit) * unit;
  const auto melange = static_cast<float>(r.number("melange", 0.18));
  const auto slubs = static_cast<float>(r.number("slubs", 0.15));
  const float thick = static_cast<float>(r.size.x) / static_cast<float>(threads);
  const PeriodicNoise fibreU(24, threads * 3, r.seed), fibreV(threads * 3, 24, r.seed + 1);
  const PeriodicNoise slubU(9, threads, r.seed + 2), slubV(threads, 9, r.seed + 3);
  const PeriodicFbm cloud(3, 3, 3, r.seed + 4);
  return paint(r, true, [&](float u, float v) {
    const float n = static_cast<float>(threads);
    const Crossing c = crossing(u * n, v * n, threads, over);
    const float fibre = c.weft ? fibreU(u, v) : fibreV(u, v);
    const float slub = c.weft ? slubU(u, v) : slubV(u, v);
    const float own = randomAt(c.id, r.seed, 6) - 0.5f;
    const float tone =
        0.3f + 0.62f * c.height + melange * own + 0.2f * fibre + slubs * slub + 0.05f * cloud(u, v);
    return Texel{(c.weft ? weft : warp)(tone), 0.28f * thick * c.height};
  });
}

// Colours: dark to light. tuft: m from loop to loop.
ProceduralTexture carpet(const TextureRecipe& r) {
  const Ramp ramp(colorsOr(r, {{0.5f, 0.5f, 0.5f}, {0.8f, 0.8f, 0.8f}, {0.95f, 0.95f, 0.95f}}));
  const int n = std::max(8, static_cast<int>(std::lround(r.size.x / r.number("tuft", 0.006))));
  const PeriodicCells tufts(n, n, r.seed, 0.75f);
  const PeriodicNoise fibre(200, 200, r.seed + 1);
  const PeriodicFbm sweep(3, 3, 4, r.seed + 2);
  const auto tall = static_cast<float>(r.size.x) / static_cast<float>(n);
  return paint(r, true, [&](float u, float v) {
    const PeriodicCells::Sample s = tufts(u, v);
    const float dome = std::fmax(0.0f, 1 - s.nearest * s.nearest * 2.2f);
    const float tone = 0.3f + 0.45f * dome + 0.22f * fibre(u, v) +
                       0.25f * (randomAt(s.id, r.seed, 3) - 0.5f) + 0.14f * sweep(u, v);
    return Texel{ramp(tone), 0.3f * tall * dome};
  });
}

// Colours: dark to light; the creases take the dark.
ProceduralTexture leather(const TextureRecipe& r) {
  const Ramp ramp(colorsOr(r, {{0.6f, 0.6f, 0.6f}, {0.88f, 0.88f, 0.88f}, {0.97f, 0.97f, 0.97f}}));
  const int n = std::max(8, static_cast<int>(std::lround(r.size.x / r.number("grain", 0.0032))));
  const PeriodicCells pebbles(n, n, r.seed);
  const PeriodicNoise warpX(n / 2, n / 2, r.seed + 1), warpY(n / 2, n / 2, r.seed + 2);
  const PeriodicFbm cloud(4, 4, 4, r.seed + 3);
  const float warp = 0.25f / static_cast<float>(n);
  return paint(r, true, [&](float u, float v) {
    const PeriodicCells::Sample s = pebbles(u + warp * warpX(u, v), v + warp * warpY(u, v));
    const float pebble = smoothStep(0.0f, 0.3f, s.second - s.nearest);
    const float tone =
        0.6f + 0.2f * cloud(u, v) + 0.08f * (randomAt(s.id, r.seed, 4) - 0.5f) - 0.17f * (1 - pebble);
    return Texel{ramp(tone), 0.00022f * pebble};
  });
}

// Colours: the shade between the canes, then cane from dark to light. A basket weave of `canes` a picture.
ProceduralTexture rattan(const TextureRecipe& r) {
  const std::vector<Color> colors =
      colorsOr(r, {{0.22f, 0.14f, 0.08f}, {0.62f, 0.45f, 0.27f}, {0.84f, 0.69f, 0.47f}});
  const Ramp ramp(colors);
  const int canes = std::max(1, static_cast<int>(r.number("canes", 16)) / 4) * 4;
  const PeriodicNoise grainU(10, canes * 5, r.seed), grainV(canes * 5, 10, r.seed + 1);
  const float thick = static_cast<float>(r.size.x) / static_cast<float>(canes);
  return paint(r, true, [&](float u, float v) {
    const float n = static_cast<float>(canes);
    const Crossing c = crossing(u * n, v * n, canes, 2);
    const float grain = c.weft ? grainU(u, v) : grainV(u, v);
    const float tone =
        0.12f + 0.72f * std::sqrt(c.height) + 0.16f * grain + 0.2f * (randomAt(c.id, r.seed, 2) - 0.5f);
    return Texel{ramp(tone), 0.3f * thick * c.height};
  });
}

// Fine scratches along u. Colours: dark to light.
ProceduralTexture brushed(const TextureRecipe& r) {
  const Ramp ramp(colorsOr(r, {{0.86f, 0.86f, 0.86f}, {1, 1, 1}}));
  const PeriodicNoise fine(6, 400, r.seed), coarse(2, 90, r.seed + 1);
  return paint(r, false, [&](float u, float v) {
    return Texel{ramp(0.6f + 0.5f * fine(u, v) + 0.25f * coarse(u, v)), 0};
  });
}

}  // namespace idap::pattern
