// Does a sampling routine draw directions with the density it claims? Counts samples in cells of the sphere
// and compares with the integral of the density by Pearson's chi-square test (as pbrt and Mitsuba do).
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "geometry/vec.h"

namespace idap::render::test {

// sample(u1, u2, u3) -> (direction, valid); pdf(direction) per steradian. Cells in z and azimuth.
template <class Sample, class Pdf>
void expectMatchingDensity(const Sample& sample, const Pdf& pdf, int cellsZ = 24, int cellsPhi = 48,
                           int count = 200000) {
  const auto cells = static_cast<std::size_t>(cellsZ * cellsPhi);
  std::vector<double> seen(cells, 0), expected(cells, 0);
  std::mt19937 random(4711);
  std::uniform_real_distribution<float> uniform(0.0f, 0.99999994f);
  for (int i = 0; i < count; ++i) {
    const float a = uniform(random), b = uniform(random), c = uniform(random);
    const auto [d, valid] = sample(a, b, c);
    if (!valid) continue;
    const double phi = std::atan2(static_cast<double>(d.y), static_cast<double>(d.x)) / (2 * kPi) + 0.5;
    const int z = std::min(static_cast<int>((static_cast<double>(d.z) * 0.5 + 0.5) * cellsZ), cellsZ - 1);
    const int p = std::min(static_cast<int>(phi * cellsPhi), cellsPhi - 1);
    seen[static_cast<std::size_t>(std::max(z, 0) * cellsPhi + p)] += 1;
  }
  constexpr int kSub = 16;  // points a cell and side
  double total = 0;
  for (int z = 0; z < cellsZ; ++z)
    for (int p = 0; p < cellsPhi; ++p) {
      double sum = 0;
      for (int k = 0; k < kSub * kSub; ++k) {
        const double cz = 2 * (z + (k / kSub + 0.5) / kSub) / cellsZ - 1;
        const double phi = 2 * kPi * ((p + (k % kSub + 0.5) / kSub) / cellsPhi - 0.5);
        const double s = std::sqrt(std::max(0.0, 1 - cz * cz));
        sum += static_cast<double>(pdf(toFloat(Vec3{s * std::cos(phi), s * std::sin(phi), cz})));
      }
      const double mass = sum / (kSub * kSub) * 4 * kPi / static_cast<double>(cells);
      expected[static_cast<std::size_t>(z * cellsPhi + p)] = mass * count;
      total += mass;
    }
  EXPECT_LT(total, 1.02) << "the density integrates to more than one";
  const double drawn = std::accumulate(seen.begin(), seen.end(), 0.0) / count;
  EXPECT_NEAR(total, drawn, 0.02);

  // Cells that expect few are pooled.
  double chi2 = 0, pooledSeen = 0, pooledExpected = 0;
  int degrees = 0;
  const auto judge = [&](double n, double e) {
    // The expectation itself comes from a sum over points: allow it 1.5 % of error.
    const double gap = std::max(0.0, std::fabs(n - e) - 0.015 * e);
    chi2 += gap * gap / e;
    ++degrees;
  };
  for (std::size_t k = 0; k < cells; ++k) {
    if (expected[k] < 1e-3 && seen[k] == 0) continue;
    if (expected[k] >= 8) {
      judge(seen[k], expected[k]);
    } else {
      pooledSeen += seen[k];
      pooledExpected += expected[k];
    }
  }
  if (pooledExpected >= 8) judge(pooledSeen, pooledExpected);
  EXPECT_LT(pooledSeen, pooledExpected + 6 * std::sqrt(pooledExpected) + 8)
      << "samples where the density is 0";
  // Wilson and Hilferty's normal approximation; 4 sigma.
  const double n = std::max(degrees, 1), t = 2 / (9 * n);
  const double z = (std::cbrt(chi2 / n) - (1 - t)) / std::sqrt(t);
  EXPECT_LT(z, 4.0) << "chi-square " << chi2 << " with " << degrees << " cells";
}

}  // namespace idap::render::test
