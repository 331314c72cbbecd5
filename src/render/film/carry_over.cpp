#include "render/film/carry_over.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace idap::render {

namespace {

constexpr int kReach = 2;  // pixels around what has moved, of 640 along a row: its edges were smoothed
constexpr int kGrid = 32;  // pixels: few sizes of regions, since a denoiser gets ready for each
// Neighbourhoods, the widest first: radius, as a part of the picture's width.
constexpr float kRadii[] = {1 / 10.0f, 1 / 20.0f, 1 / 40.0f, 1 / 80.0f, 1 / 160.0f};
// A difference is believed from so many standard errors, and wholly from twice as many.
constexpr float kBelieved = 4.0f;
// Smaller parts of the light than the first are no change: a cache of light that has been learned anew errs
// by as much.
constexpr float kNoChange = 0.03f, kChange = 0.1f;
constexpr float kFewest = 60;  // pixels of a neighbourhood; fewer do not tell how uncertain they are
// Where neighbours were so many times as bright, the edge between them says more than any light.
constexpr float kEdge = 1.6f;
// Relative changes of light: below the first the clean picture is corrected, above the second the new one is
// shown.
constexpr float kSmall = 0.06f, kLarge = 0.25f;
// The same for what the denoiser makes of the new paths, which errs by more.
constexpr float kSmallSeen = 0.4f, kLargeSeen = 0.7f;

float step(float from, float to, float v) {
  const float t = std::clamp((v - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

// Layers of one picture, blurred together.
struct Layers {
  enum { kWeight, kRed, kGreen, kBlue, kSquare, kCount };
  int width, height;
  std::array<std::vector<float>, kCount> layer;
  Layers(int w, int h) : width(w), height(h) {
    for (auto& l : layer) l.assign(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), 0.0f);
  }
  Rgb color(std::size_t i) const { return {layer[kRed][i], layer[kGreen][i], layer[kBlue][i]}; }
};

// Sums over 2 radius + 1 values along a row of them, `apart` apart.
void boxSums(const float* from, float* to, int count, int apart, int radius) {
  const auto at = [&](int i) { return static_cast<std::ptrdiff_t>(i) * apart; };
  double sum = 0;
  for (int i = 0; i < std::min(radius, count); ++i) sum += static_cast<double>(from[at(i)]);
  for (int i = 0; i < count; ++i) {
    if (i + radius < count) sum += static_cast<double>(from[at(i + radius)]);
    to[at(i)] = static_cast<float>(sum);
    if (i - radius >= 0) sum -= static_cast<double>(from[at(i - radius)]);
  }
}

// Twice a box, which is a tent in either direction; not divided by its weight.
Layers blurred(const Layers& from, int radius) {
  Layers out(from.width, from.height);
  tbb::parallel_for(0, static_cast<int>(Layers::kCount), [&](int k) {
    const int w = from.width, h = from.height;
    const auto row = [&](std::vector<float>& v, int y) {
      return v.data() + static_cast<std::ptrdiff_t>(y) * w;
    };
    std::vector<float> a = from.layer[static_cast<std::size_t>(k)], b(a.size());
    for (int y = 0; y < h; ++y) {
      boxSums(row(a, y), row(b, y), w, 1, radius);
      boxSums(row(b, y), row(a, y), w, 1, radius);
    }
    for (int x = 0; x < w; ++x) {
      boxSums(a.data() + x, b.data() + x, h, w, radius);
      boxSums(b.data() + x, a.data() + x, h, w, radius);
    }
    out.layer[static_cast<std::size_t>(k)] = std::move(a);
  });
  return out;
}

// 1 where a pixel shows what it showed before, with some pixels around what does not left out.
std::vector<float> unchanged(const Features& seen, const Features& sees) {
  const int w = sees.width, h = sees.height;
  std::vector<std::uint8_t> other(sees.depth.size()), wide(other.size());
  tbb::parallel_for(0, h, [&](int y) {
    for (int x = 0; x < w; ++x) {
      const std::size_t i = sees.index(x, y);
      const auto near = [](float a, float b) { return std::fabs(a - b) <= 0.004f * b + 0.002f; };
      const Vec3f paint = sees.albedo[i] - seen.albedo[i];
      other[i] = !(near(seen.depth[i], sees.depth[i]) && near(seen.distance[i], sees.distance[i]) &&
                   dot(paint, paint) < 1e-3f &&
                   (sees.depth[i] == 0 || dot(seen.normal[i], sees.normal[i]) > 0.995f));
    }
  });
  const int reach = std::max(1, kReach * w / 640);
  tbb::parallel_for(0, h, [&](int y) {
    for (int x = 0; x < w; ++x)
      for (int k = std::max(x - reach, 0); k <= std::min(x + reach, w - 1); ++k)
        wide[sees.index(x, y)] |= other[sees.index(k, y)];
  });
  std::vector<float> out(other.size());
  tbb::parallel_for(0, h, [&](int y) {
    for (int x = 0; x < w; ++x) {
      std::uint8_t any = 0;
      for (int k = std::max(y - reach, 0); k <= std::min(y + reach, h - 1); ++k)
        any |= wide[sees.index(x, k)];
      out[sees.index(x, y)] = any ? 0.0f : 1.0f;
    }
  });
  return out;
}

// Where the picture has no edge between light and dark.
bool smoothAt(const std::vector<Rgb>& color, int width, int height, int x, int y) {
  float least = std::numeric_limits<float>::max(), most = 0;
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
      const float l = luminance(
          color[static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u)]);
      least = std::min(least, l), most = std::max(most, l);
    }
  return most <= kEdge * least + 1e-6f;
}

// How the light has changed, as a part of what it was, as far as the new paths say so beyond doubt: from wide
// neighbourhoods to narrow ones, each followed where it differs significantly from the wider.
std::vector<Rgb> changeOfLight(const std::vector<Rgb>& before, const std::vector<float>& same,
                               const Film& film, float dark) {
  Layers difference(film.width, film.height);
  const std::size_t n = film.pixels();
  for (std::size_t i = 0; i < n; ++i) {
    const Rgb d = (film.meanColor(i) - before[i]) / (luminance(before[i]) + dark);
    const float l = luminance(d);
    if (!std::isfinite(l) || !(film.weight[i] > 0)) continue;
    difference.layer[Layers::kWeight][i] = same[i];
    difference.layer[Layers::kRed][i] = same[i] * d.x;
    difference.layer[Layers::kGreen][i] = same[i] * d.y;
    difference.layer[Layers::kBlue][i] = same[i] * d.z;
    difference.layer[Layers::kSquare][i] = same[i] * l * l;
  }
  std::vector<Rgb> change(n, Rgb{});
  // Few of the paths bring most of the light. A small neighbourhood that none of them has met looks dark and
  // certain of it, so the uncertainty of the wider ones holds for it too.
  std::vector<float> spread(n, 0.0f);
  for (const float part : kRadii) {
    const int radius = std::max(1, static_cast<int>(std::lround(part * static_cast<float>(film.width) / 2)));
    const Layers mean = blurred(difference, radius);
    // Of equal weights W over an area, a tent is as good as 2.25 of a box's, (2 radius + 1)^2 pixels.
    const auto side = static_cast<float>(2 * radius + 1);
    const float whole = side * side * side * side;  // the sum of the tent
    for (std::size_t i = 0; i < n; ++i) {
      const float weight = mean.layer[Layers::kWeight][i];
      if (!(weight > 1e-3f * whole)) continue;
      const Rgb d = mean.color(i) / weight;
      const float l = luminance(d);
      spread[i] = std::max(mean.layer[Layers::kSquare][i] / weight - l * l, spread[i]);
      const float pixels = 2.25f * side * side * weight / whole;
      if (pixels < kFewest) continue;
      const float error = std::sqrt(spread[i] / pixels);
      const float apart = std::fabs(l - luminance(change[i]));
      change[i] += (d - change[i]) * (step(kBelieved, 2 * kBelieved, apart / std::max(error, 1e-9f)) *
                                      step(kNoChange, kChange, apart));
    }
  }
  return change;
}

// Between the pixels of a picture; x, y from 0 to 1.
struct Between {
  std::size_t i[4];
  float w[4];
  Between(float x, float y, int width, int height) {
    const float u = x * static_cast<float>(width) - 0.5f, v = y * static_cast<float>(height) - 0.5f;
    const float u0 = std::floor(u), v0 = std::floor(v), fu = u - u0, fv = v - v0;
    const auto place = [&](int p, int q) {
      return static_cast<std::size_t>(std::clamp(q, 0, height - 1)) * static_cast<std::size_t>(width) +
             static_cast<std::size_t>(std::clamp(p, 0, width - 1));
    };
    const int p = static_cast<int>(u0), q = static_cast<int>(v0);
    i[0] = place(p, q), i[1] = place(p + 1, q), i[2] = place(p, q + 1), i[3] = place(p + 1, q + 1);
    w[0] = (1 - fu) * (1 - fv), w[1] = fu * (1 - fv), w[2] = (1 - fu) * fv, w[3] = fu * fv;
  }
  template <class T>
  auto of(const std::vector<T>& values) const {
    return values[i[0]] * w[0] + values[i[1]] * w[1] + values[i[2]] * w[2] + values[i[3]] * w[3];
  }
};

}  // namespace

PixelRegion changedRegion(const Features& seen, const Features& sees) {
  const std::vector<float> same = unchanged(seen, sees);
  int x0 = sees.width, y0 = sees.height, x1 = 0, y1 = 0;
  for (int y = 0; y < sees.height; ++y)
    for (int x = 0; x < sees.width; ++x)
      if (same[sees.index(x, y)] <= 0) {
        x0 = std::min(x0, x), x1 = std::max(x1, x + 1);
        y0 = std::min(y0, y), y1 = std::max(y1, y + 1);
      }
  if (x0 >= x1) return {};
  // Shadows lie beside what throws them.
  const int margin = sees.width / 40;
  const auto below = [](int v) { return std::max(v, 0) / kGrid * kGrid; };
  const auto above = [](int v, int most) { return std::min((v + kGrid - 1) / kGrid * kGrid, most); };
  x0 = below(x0 - margin), x1 = above(x1 + margin, sees.width);
  y0 = below(y0 - margin), y1 = above(y1 + margin, sees.height);
  return {x0, y0, x1 - x0, y1 - y0};
}

std::vector<Rgb> reduced(const CleanPicture& from, int width, int height) {
  if (from.width == width && from.height == height) return from.color;
  std::vector<Rgb> out(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  tbb::parallel_for(0, height, [&](int y) {
    const int y0 = y * from.height / height, y1 = std::max(y0 + 1, (y + 1) * from.height / height);
    for (int x = 0; x < width; ++x) {
      const int x0 = x * from.width / width, x1 = std::max(x0 + 1, (x + 1) * from.width / width);
      Rgb sum{};
      for (int v = y0; v < y1; ++v)
        for (int u = x0; u < x1; ++u)
          sum += from.color[static_cast<std::size_t>(v) * static_cast<std::size_t>(from.width) +
                            static_cast<std::size_t>(u)];
      out[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] =
          sum / static_cast<float>((y1 - y0) * (x1 - x0));
    }
  });
  return out;
}

CleanPicture carriedOver(const CleanPicture& before, const Features& seen, const Film& film,
                         const Features& sees, const std::vector<Rgb>& color, float share, int threads) {
  if (seen.width != sees.width || seen.height != sees.height || color.size() != sees.depth.size())
    throw RenderError("pictures before and after a change differ in size");
  CleanPicture out{before.width, before.height, std::vector<Rgb>(before.color.size())};
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute([&] {
    const std::vector<float> same = unchanged(seen, sees);
    double total = 0;
    for (const Rgb& c : before.color) total += static_cast<double>(luminance(c));
    const float dark = 0.05f * static_cast<float>(total / static_cast<double>(before.color.size())) + 1e-6f;
    const std::vector<Rgb> was = reduced(before, film.width, film.height);
    std::vector<float> usable(film.pixels());
    for (int y = 0; y < film.height; ++y)
      for (int x = 0; x < film.width; ++x) {
        const std::size_t i = film.index(x, y);
        const Between at((static_cast<float>(x) + 0.5f) / static_cast<float>(film.width),
                         (static_cast<float>(y) + 0.5f) / static_cast<float>(film.height), sees.width,
                         sees.height);
        usable[i] = film.depth[i] > 0 && at.of(same) > 0.9f && smoothAt(was, film.width, film.height, x, y);
      }
    const std::vector<Rgb> change = changeOfLight(was, usable, film, dark);

    const bool whole = film.width == out.width && film.height == out.height;
    const bool full = sees.width == out.width && sees.height == out.height;
    tbb::parallel_for(0, out.height, [&](int y) {
      for (int x = 0; x < out.width; ++x) {
        const std::size_t i =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(out.width) + static_cast<std::size_t>(x);
        const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(out.width),
                    v = (static_cast<float>(y) + 0.5f) / static_cast<float>(out.height);
        const Between inView(u, v, sees.width, sees.height);
        const auto made = [&] { return full ? color[i] : inView.of(color); };
        const float stays = full ? same[i] : inView.of(same);
        if (stays <= 0) {
          out.color[i] = made();
          continue;
        }
        const Rgb old = before.color[i];
        const std::size_t middle = full ? i : inView.i[inView.w[0] + inView.w[2] > 0.5f ? 0 : 1];
        const Rgb light = sees.depth[middle] == 0 ? Rgb{}
                          : whole                 ? change[i]
                                                  : Between(u, v, film.width, film.height).of(change);
        Rgb corrected;
        for (int k = 0; k < 3; ++k)
          corrected[k] = std::max(old[k] + light[k] * (luminance(old) + dark), 0.0f);
        // What a small film has been enlarged to is too blurred to be better than the corrected picture.
        float isNew = 0;
        if (whole) {
          const float a = luminance(old) + dark, b = luminance(made()) + dark;
          isNew = std::max(step(kSmall, kLarge, std::fabs(luminance(corrected) - luminance(old)) / a),
                           step(kSmallSeen, kLargeSeen, std::fabs(b - a) / std::max(a, b)));
        }
        const float anew = 1 - share * stays * (1 - isNew);
        out.color[i] = anew > 0 ? corrected + (made() - corrected) * anew : corrected;
      }
    });
  });
  return out;
}

}  // namespace idap::render
