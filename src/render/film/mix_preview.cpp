#include "render/film/mix_preview.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "render/denoise/denoise.h"
#include "render/film/exposure.h"

namespace idap::render {

Film reduced(const Film& film, std::size_t mostPixels) {
  int side = 1;
  while (film.pixels() / static_cast<std::size_t>(side * side) > mostPixels) ++side;
  if (side == 1) return film;
  const int w = std::max(1, film.width / side), h = std::max(1, film.height / side);
  Film small(w, h, static_cast<int>(film.groups.size()));
  small.samples = film.samples;
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      const std::size_t to = small.index(x, y);
      for (int v = y * side; v < std::min((y + 1) * side, film.height); ++v)
        for (int u = x * side; u < std::min((x + 1) * side, film.width); ++u) {
          const std::size_t from = film.index(u, v);
          small.color[to] += film.color[from];
          small.albedo[to] += film.albedo[from];
          small.normal[to] += film.normal[from];
          small.depth[to] += film.depth[from];
          small.coverage[to] += film.coverage[from];
          small.weight[to] += film.weight[from];
          for (std::size_t g = 0; g < film.groups.size(); ++g) small.groups[g][to] += film.groups[g][from];
        }
      small.objectId[to] =
          film.objectId[film.index(std::min(x * side, film.width - 1), std::min(y * side, film.height - 1))];
    }
  return small;
}

MixPreview::MixPreview(const Film& film, std::vector<LightGroup> groups, std::size_t mostPixels,
                       const Progress& progress)
    : groups_(std::move(groups)) {
  if (film.groups.empty()) throw RenderError("this picture keeps no light by itself");
  groups_.resize(film.groups.size());
  film_ = reduced(film, mostPixels);
  ev_ = autoExposure(film_);
  illuminant_ = estimateIlluminant(film_);
  std::fill(film_.square.begin(), film_.square.end(), 0.0f);
  Denoiser denoiser;
  std::vector<double> sums;
  double all = 0;
  for (std::size_t g = 0; g < film_.groups.size(); ++g) {
    progress.report(static_cast<double>(g) / static_cast<double>(film_.groups.size()), "denoising");
    std::vector<Rgb>& light = film_.groups[g];
    for (std::size_t i = 0; i < light.size(); ++i) light[i] = light[i] * film_.inverseWeight(i);
    double sum = 0;
    for (const Rgb& c : light) sum += static_cast<double>(luminance(c));
    sums.push_back(sum);
    all += sum;
    if (sum > 0) denoiser.run(film_, light, {.fast = true, .progress = &progress});
  }
  for (const double sum : sums) shares_.push_back(all > 0 ? static_cast<float>(sum / all) : 0.0f);
}

Image8 MixPreview::picture(const std::vector<LightChange>& changes, ToneMap toneMap,
                           float compensation) const {
  std::vector<Rgb> color(film_.pixels());
  for (std::size_t g = 0; g < film_.groups.size(); ++g) {
    const Rgb factor = mixFactor(groups_[g], g < changes.size() ? changes[g] : LightChange{});
    if (maxComponent(factor) <= 0) continue;
    for (std::size_t i = 0; i < color.size(); ++i) color[i] += film_.groups[g][i] * factor;
  }
  const float share = DevelopSettings{}.whiteBalance;
  const WhiteBalance balance(illuminant_, share);
  const float gain = exposureMultiplier(ev_ - compensation);
  for (Rgb& c : color) c = balance(c) * gain;
  return toImage(color, film_.width, film_.height, toneMap);
}

}  // namespace idap::render
