// Wood as growth rings cut by a plane: rings follow the board with a slow wander (which makes the cathedrals
// of a flat-sawn board), under fibres and pores that run along it.
#include <algorithm>

#include "catalog/procedural_noise.h"
#include "catalog/procedural_pattern.h"

namespace idap::pattern {

namespace {

// The tone of a sheet of wood that repeats every `across` by `along` metres.
class Grain {
 public:
  Grain(const TextureRecipe& r, float across, float along)
      : rings_(std::max(1, static_cast<int>(std::lround(r.number("rings", 60) * across)))),
        wander_(static_cast<float>(r.number("wander", 2.2))),
        contrast_(static_cast<float>(r.number("contrast", 0.5))),
        fibre_(static_cast<float>(r.number("fibre", 0.22))),
        pores_(static_cast<float>(r.number("pores", 0.3))),
        seed_(r.seed),
        slow_(cells(across * 4.5f), cells(along * 0.9f), r.seed),
        bend_(cells(across * 14), cells(along * 2.5f), r.seed + 11),
        tint_(cells(across * 9), cells(along * 1.2f), r.seed + 12),
        fine_(cells(across * 420), cells(along * 7), r.seed + 13),
        coarse_(cells(across * 130), cells(along * 3), r.seed + 14),
        pore_(cells(across * 520), cells(along * 45), r.seed + 15) {}

  // c across and a along, in sheets; 0 the darkest, 1 the lightest.
  float operator()(float c, float a) const {
    const float ring = c * static_cast<float>(rings_) + wander_ * slow_(c, a) * 2.0f + 0.35f * bend_(c, a);
    const float whole = std::floor(ring), part = ring - whole;
    const int index = wrapped(static_cast<int>(whole), rings_);
    const float strength = 0.45f + 0.55f * randomAt(static_cast<std::uint32_t>(index), seed_, 5);
    // Early wood darkens slowly into late wood, which ends at once.
    const float late = part < 0.82f ? part * part * 1.2f : 0.807f * (1.0f - smoothStep(0.82f, 1.0f, part));
    const float fibre = 0.6f * fine_(c, a) + 0.5f * coarse_(c, a);
    const float pore = std::fmax(0.0f, pore_(c, a) - 0.28f) * (1.15f - late);
    return 0.72f - contrast_ * strength * late + fibre_ * fibre + 0.16f * tint_(c, a) - 1.8f * pores_ * pore;
  }

 private:
  static int cells(float n) { return std::max(1, static_cast<int>(std::lround(n))); }

  int rings_;
  float wander_, contrast_, fibre_, pores_;
  std::uint32_t seed_;
  PeriodicNoise slow_, bend_, tint_, fine_, coarse_, pore_;
};

constexpr float kSheetAcross = 0.7f, kSheetAlong = 2.4f;  // m, the sheet that floor boards are cut from

// A board cut out of the sheet at a place of its own, in a shade of its own.
struct Board {
  float shiftAcross, shiftAlong, shade;
  bool turned;

  Board(std::uint32_t id, std::uint32_t seed, float variation)
      : shiftAcross(randomAt(id, seed, 21)),
        shiftAlong(randomAt(id, seed, 22)),
        shade(variation * (randomAt(id, seed, 23) + randomAt(id, seed, 24) - 1.0f)),
        turned(randomAt(id, seed, 25) < 0.5f) {}

  float tone(const Grain& grain, float across, float along) const {  // m
    if (turned) across = -across, along = -along;
    return grain(across / kSheetAcross + shiftAcross, along / kSheetAlong + shiftAlong) + shade;
  }
};

// A joint: a dark line over an eased edge. d: m to the nearest edge.
Texel board(const Ramp& ramp, float tone, float d, float bevel) {
  const float open = 1.0f - smoothStep(0.0f, bevel, d);
  return {ramp(tone * (1.0f - 0.45f * open) - 0.12f * open), -0.0009f * open};
}

std::vector<Color> oak() { return {{0.42f, 0.29f, 0.17f}, {0.66f, 0.5f, 0.33f}, {0.79f, 0.64f, 0.46f}}; }

}  // namespace

ProceduralTexture wood(const TextureRecipe& r) {
  const Grain grain(r, static_cast<float>(r.size.y), static_cast<float>(r.size.x));
  const Ramp ramp(colorsOr(r, oak()));
  return paint(r, false, [&](float u, float v) { return Texel{ramp(grain(v, u)), 0}; });
}

ProceduralTexture planks(const TextureRecipe& r) {
  const Grain grain(r, kSheetAcross, kSheetAlong);
  const Ramp ramp(colorsOr(r, oak()));
  const auto width = static_cast<float>(r.size.y), length = static_cast<float>(r.size.x);
  const int rows = std::max(1, static_cast<int>(std::lround(r.size.y / r.number("width", 0.16))));
  const int perRow = std::max(1, static_cast<int>(std::lround(r.size.x / r.number("length", 1.2))));
  const auto variation = static_cast<float>(r.number("variation", 0.16));
  const auto bevel = static_cast<float>(r.number("bevel", 0.0025));
  std::vector<Board> boards;
  for (int i = 0; i < rows * perRow; ++i)
    boards.emplace_back(static_cast<std::uint32_t>(i), r.seed, variation);
  return paint(r, true, [&, rows, perRow](float u, float v) {
    const float x = v * static_cast<float>(rows);
    const int row = std::min(static_cast<int>(x), rows - 1);
    // Neighbouring rows never line up: a third on, and a little of their own.
    const float stagger =
        0.38f * static_cast<float>(row) + 0.2f * randomAt(static_cast<std::uint32_t>(row), r.seed, 31);
    const float y = fractionOf(u + stagger / static_cast<float>(perRow)) * static_cast<float>(perRow);
    const int column = std::min(static_cast<int>(y), perRow - 1);
    const float across = (x - static_cast<float>(row)) * width / static_cast<float>(rows);
    const float along = (y - static_cast<float>(column)) * length / static_cast<float>(perRow);
    const float side = std::min(across, width / static_cast<float>(rows) - across);
    const float end = std::min(along, length / static_cast<float>(perRow) - along);
    const Board& b = boards[static_cast<std::size_t>(row * perRow + column)];
    return board(ramp, b.tone(grain, across, along), std::min(side, end), bevel);
  });
}

ProceduralTexture herringbone(const TextureRecipe& r) {
  // In cells of one block's width the pattern repeats after (1, 1) and (2k, 0), k = length / width; turned by
  // 45 degrees these span the rectangle sqrt(2) by k sqrt(2), of which the picture holds m by n.
  const Grain grain(r, kSheetAcross, kSheetAlong);
  const Ramp ramp(colorsOr(r, oak()));
  const int k = std::max(2, static_cast<int>(std::lround(r.number("ratio", 6))));
  const int n = std::max(1, static_cast<int>(std::lround(r.number("repeats", 2))));
  const int m = n * k;
  const auto variation = static_cast<float>(r.number("variation", 0.16));
  const auto bevel = static_cast<float>(r.number("bevel", 0.0015));
  const float cell = static_cast<float>(r.size.x) / (static_cast<float>(m) * 1.41421356f);
  return paint(r, true, [&, k, m, n, cell](float u, float v) {
    const float p = u * static_cast<float>(m), q = v * static_cast<float>(n * k);
    const float x = p + q, y = p - q;  // (p, q) sqrt(2) turned back by 45 degrees
    const int ix = static_cast<int>(std::floor(x)), iy = static_cast<int>(std::floor(y));
    const int d = wrapped(ix - iy, 2 * k);
    const bool flat = d < k;
    const int startX = flat ? ix - d : ix, startY = flat ? iy : iy - (2 * k - 1 - d);
    const float along = flat ? x - static_cast<float>(startX) : y - static_cast<float>(startY);
    const float across = flat ? y - static_cast<float>(startY) : x - static_cast<float>(startX);
    const auto id = static_cast<std::uint32_t>((wrapped(startX + startY, 2 * m) * 2 * k * n * 2) +
                                               wrapped(startX - startY, 2 * k * n) * 2 + (flat ? 1 : 0));
    const float edge =
        std::min(std::min(across, 1.0f - across), std::min(along, static_cast<float>(k) - along));
    const float tone = Board(id, r.seed, variation).tone(grain, across * cell, along * cell);
    return board(ramp, tone - (flat ? 0.03f : 0.0f), edge * cell, bevel);
  });
}

}  // namespace idap::pattern
