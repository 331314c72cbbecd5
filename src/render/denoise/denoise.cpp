#include "render/denoise/denoise.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <thread>

#include "base/error.h"
#include "base/log.h"
#include "render/denoise/feature_filter.h"
#include "render/denoise/network.h"
#include "render/film/noise_estimate.h"

namespace idap::render {

namespace {

constexpr int kLeastToJudge = 64;  // samples a pixel, for its own noise to be known

bool usable(Rgb c) { return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z); }

// Pixels that are no numbers take the mean of the numbers around them.
void mend(std::vector<Rgb>& color, int width, int height) {
  const auto at = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  };
  std::vector<std::pair<std::size_t, Rgb>> mended;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (usable(color[at(x, y)])) continue;
      Rgb sum;
      int count = 0;
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height - 1); ++j) {
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width - 1); ++i) {
          if (!usable(color[at(i, j)])) continue;
          sum += color[at(i, j)];
          ++count;
        }
      }
      mended.emplace_back(at(x, y), count > 0 ? sum / static_cast<float>(count) : Rgb{});
    }
  }
  for (const auto& [i, c] : mended) color[i] = c;
  constexpr float kMost = 1e12f;  // cd/m2; squares of it still fit a float
  for (Rgb& c : color)
    c = {std::clamp(c.x, 0.0f, kMost), std::clamp(c.y, 0.0f, kMost), std::clamp(c.z, 0.0f, kMost)};
}

Vec3 sumOf(const std::vector<Rgb>& color) {
  Vec3 sum;
  for (const Rgb& c : color) sum += toDouble(c);
  return sum;
}

// A network trained to please the eye drifts by a per cent or two in brightness; that is put right. Larger
// differences are stray bright pixels that it took out on purpose.
void keepBrightness(std::vector<Rgb>& color, double before) {
  const double after =
      static_cast<double>(luminance(toFloat(sumOf(color) / static_cast<double>(color.size()))));
  if (!(after > 0)) return;
  const double ratio = before / after;
  if (ratio < 0.95 || ratio > 1.05) return;
  for (Rgb& c : color) c *= static_cast<float>(ratio);
}

int threadCount(int wanted) {
  return wanted > 0 ? wanted : static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
}

// Where the film is quiet already, what was traced is truer than what a network makes of it.
void keepWhatIsQuiet(const Film& film, const std::vector<Rgb>& traced, std::vector<Rgb>& color) {
  constexpr float kQuiet = 0.003f, kLoud = 0.012f;  // of noiseEstimate()
  if (film.samples < kLeastToJudge) return;
  const std::vector<float> noise = noiseEstimate(film);
  for (std::size_t i = 0; i < color.size(); ++i) {
    const float t = std::clamp((noise[i] - kQuiet) / (kLoud - kQuiet), 0.0f, 1.0f);
    if (t < 1) color[i] = traced[i] + (color[i] - traced[i]) * (t * t * (3 - 2 * t));
  }
}

}  // namespace

Denoiser::Denoiser() = default;
Denoiser::~Denoiser() = default;
Denoiser::Denoiser(Denoiser&&) noexcept = default;
Denoiser& Denoiser::operator=(Denoiser&&) noexcept = default;

void Denoiser::run(const Film& film, std::vector<Rgb>& color, const DenoiseSettings& settings) {
  if (color.size() != film.pixels()) throw RenderError("the film and the picture to denoise differ in size");
  if (color.empty()) return;
  mend(color, film.width, film.height);
  const double before =
      static_cast<double>(luminance(toFloat(sumOf(color) / static_cast<double>(color.size()))));
  const int threads = threadCount(settings.threads);
  const bool wanted = settings.method == DenoiseMethod::Network;
  if (settings.method != DenoiseMethod::Filter && (wanted || DenoiseNetwork::available(settings.fast))) {
    try {
      std::unique_ptr<DenoiseNetwork>& network = settings.fast ? fast_ : normal_;
      if (!network) network = std::make_unique<DenoiseNetwork>(settings.fast);
      const std::vector<Rgb> traced = film.samples >= kLeastToJudge ? color : std::vector<Rgb>();
      network->run(film, color, threads, settings.progress);
      keepBrightness(color, before);
      keepWhatIsQuiet(film, traced, color);
      return;
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      if (wanted) throw RenderError(std::string("cannot denoise with the network: ") + error.what());
      spdlog::warn("the denoiser's network cannot be used, the built-in filter is: {}", error.what());
    }
  }
  const std::vector<Rgb> traced = film.samples >= kLeastToJudge ? color : std::vector<Rgb>();
  filterByFeatures(film, color, threads);
  keepBrightness(color, before);
  keepWhatIsQuiet(film, traced, color);
}

void denoise(const Film& film, std::vector<Rgb>& color, const DenoiseSettings& settings) {
  Denoiser().run(film, color, settings);
}

bool hasDenoiserNetwork() { return DenoiseNetwork::available(false); }

}  // namespace idap::render
