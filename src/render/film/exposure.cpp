#include "render/film/exposure.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace idap::render {

namespace {

constexpr float kSaturation = 1.2f;
constexpr double kDarkest = 1e-6;  // cd/m2; below, a block is black

// Luminances in eighths of a stop.
struct Histogram {
  static constexpr int kBinsPerStop = 8;
  static constexpr double kFirstStop = -20;
  static constexpr int kBins = 48 * kBinsPerStop;
  std::array<double, kBins> weight{};
  double total = 0;

  void add(double log2Luminance, double w) {
    const int bin = static_cast<int>((log2Luminance - kFirstStop) * kBinsPerStop);
    weight[static_cast<std::size_t>(std::clamp(bin, 0, kBins - 1))] += w;
    total += w;
  }

  // Mean log2 luminance of what lies between two shares of the total weight.
  double meanBetween(double low, double high) const {
    const double from = low * total, to = high * total;
    double before = 0, sum = 0, mass = 0;
    for (std::size_t i = 0; i < weight.size(); ++i) {
      const double inside = std::min(before + weight[i], to) - std::max(before, from);
      if (inside > 0) {
        sum += inside * (kFirstStop + (static_cast<double>(i) + 0.5) / kBinsPerStop);
        mass += inside;
      }
      before += weight[i];
    }
    return mass > 0 ? sum / mass : 0;
  }
};

}  // namespace

float exposureMultiplier(float ev100) { return 1.0f / (kSaturation * std::exp2(ev100)); }
float ev100FromMultiplier(float multiplier) { return -std::log2(kSaturation * multiplier); }

float autoExposure(const Film& film) { return autoExposure(film, film.meanColors()); }

float autoExposure(const Film& film, const std::vector<Rgb>& color) {
  // What is seen of the outdoors tells little about how the room should look, but a view of nothing else must
  // still be exposed.
  enum { kHome, kLand, kSky, kKinds };
  constexpr double kWeight[kKinds] = {1, 0.1, 0.02};
  constexpr double kLow = 0.05, kHigh = 0.85;
  constexpr int kBlocks = 60;  // along the shorter side
  const int block = std::max(std::min(film.width, film.height) / kBlocks, 1);
  Histogram histogram;
  double albedoSum = 0, albedoWeight = 0;
  for (int y0 = 0; y0 < film.height; y0 += block) {
    for (int x0 = 0; x0 < film.width; x0 += block) {
      double sum[kKinds] = {0, 0, 0};
      int count[kKinds] = {0, 0, 0};
      for (int y = y0; y < std::min(y0 + block, film.height); ++y) {
        for (int x = x0; x < std::min(x0 + block, film.width); ++x) {
          const std::size_t i = film.index(x, y);
          const float l = luminance(color[i]);
          if (!(l >= 0) || !std::isfinite(l)) continue;
          const int kind = film.depth[i] == 0 ? kSky : film.objectId[i] == 0 ? kLand : kHome;
          sum[kind] += static_cast<double>(l);
          ++count[kind];
          const float albedo = luminance(film.meanAlbedo(i));
          if (kind == kSky || !std::isfinite(albedo)) continue;
          albedoSum += static_cast<double>(std::clamp(albedo, 0.0f, 1.0f)) * kWeight[kind];
          albedoWeight += kWeight[kind];
        }
      }
      for (int kind = 0; kind < kKinds; ++kind) {
        const double mean = count[kind] > 0 ? sum[kind] / count[kind] : 0;
        if (mean > kDarkest) histogram.add(std::log2(mean), count[kind] * kWeight[kind]);
      }
    }
  }
  if (histogram.total <= 0) return 8;
  // A meter that makes everything mid-grey turns a white room grey: the mid-tone follows the reflectance
  // seen.
  const double albedo = albedoWeight > 0 ? albedoSum / albedoWeight : 0.5;
  const double midTone = albedo > 0 ? std::clamp(0.58 * albedo, 0.22, 0.4) : 0.28;
  const double mean = std::exp2(histogram.meanBetween(kLow, kHigh));
  return std::clamp(ev100FromMultiplier(static_cast<float>(midTone / mean)), kMinEv, kMaxEv);
}

}  // namespace idap::render
