#include <gtest/gtest.h>

#include <set>

#include "render/chi_square.h"
#include "render/sampling/distribution.h"
#include "render/sampling/frame.h"
#include "render/sampling/sampler.h"
#include "render/sampling/spherical_rectangle.h"
#include "render/sampling/warp.h"

namespace idap::render {
namespace {

using namespace test;

TEST(Sampler, EveryPixelsPointsAreStratifiedInEveryElementaryInterval) {
  for (int dimension = 0; dimension < 6; ++dimension)
    for (int log2Width = 0; log2Width <= 6; ++log2Width) {
      // 64 points, one in each of 64 cells of any shape.
      std::set<std::pair<int, int>> cells;
      for (std::uint32_t i = 0; i < 64; ++i) {
        Sampler sampler(13, 7, i, 6, 99);
        for (int d = 0; d < dimension; ++d) sampler.get2D();
        const Vec2f u = sampler.get2D();
        ASSERT_TRUE(u.x >= 0 && u.x < 1 && u.y >= 0 && u.y < 1);
        cells.emplace(static_cast<int>(u.x * static_cast<float>(1 << log2Width)),
                      static_cast<int>(u.y * static_cast<float>(64 >> log2Width)));
      }
      EXPECT_EQ(cells.size(), 64u) << "dimension " << dimension << ", width 2^" << log2Width;
    }
}

TEST(Sampler, NeighbourPixelsShareOneStratifiedSet) {
  std::set<int> cells;
  for (int y = 8; y < 16; ++y)
    for (int x = 16; x < 24; ++x) {
      Sampler sampler(x, y, 0, 0, 5);
      cells.insert(static_cast<int>(sampler.get1D() * 64));
    }
  EXPECT_EQ(cells.size(), 64u);
}

TEST(Sampler, SeedsDimensionsAndEpochsAreIndependent) {
  double xy = 0, seeds = 0, epochs = 0;
  constexpr int n = 4096;
  for (std::uint32_t i = 0; i < n; ++i) {
    Sampler a(3, 4, i, 12, 1), b(3, 4, i, 12, 2), c(3, 4, i + n, 12, 1);
    const float first = a.get1D() - 0.5f;
    xy += static_cast<double>(first * (a.get1D() - 0.5f));
    seeds += static_cast<double>(first * (b.get1D() - 0.5f));
    epochs += static_cast<double>(first * (c.get1D() - 0.5f));
  }
  // Correlation of independent numbers: 1/sqrt(n) = 0.016; the products' scale is 1/12.
  for (const double sum : {xy, seeds, epochs}) EXPECT_NEAR(12 * sum / n, 0, 0.065);
}

TEST(Warp, CosineHemisphere) {
  expectMatchingDensity(
      [](float, float a, float b) {
        return std::pair(cosineHemisphere(Vec2f{a, b}), true);
      },
      [](Vec3f d) { return std::max(d.z, 0.0f) / kPiF; });
}

TEST(Warp, Cone) {
  const float oneMinusCos = 0.25f;  // a multiple of the cells' height
  expectMatchingDensity(
      [&](float, float a, float b) {
        return std::pair(uniformCone(Vec2f{a, b}, oneMinusCos), true);
      },
      [&](Vec3f d) { return d.z > 1 - oneMinusCos ? 1 / coneSolidAngle(oneMinusCos) : 0.0f; });
  EXPECT_NEAR(length(uniformCone(Vec2f{0.7f, 0.3f}, 1e-5f)), 1.0f, 1e-6f);
}

TEST(Warp, TriangleIsUniform) {
  int inCorner = 0;
  constexpr int n = 4096;
  for (int i = 0; i < n; ++i) {
    const Vec2f b = uniformTriangle(hammersley(i, n));
    ASSERT_GE(std::min({b.x, b.y, 1 - b.x - b.y}), -1e-6f);
    inCorner += b.x > 0.5f;
  }
  EXPECT_NEAR(inCorner / static_cast<double>(n), 0.25, 0.01);
}

TEST(SphericalRectangle, SolidAngleAndDensity) {
  // One face of a cube seen from its middle covers a sixth of the sphere.
  const SphericalRectangle face({-1, -1, 1}, {2, 0, 0}, {0, 2, 0}, {});
  EXPECT_NEAR(face.solidAngle(), 4 * kPiF / 6, 1e-5f);
  const Vec3f corner{-0.3f, 0.5f, -1}, u{1.5f, 0, 0}, v{0, 0, 1.2f};
  const SphericalRectangle window(corner, u, v, {});
  expectMatchingDensity(
      [&](float, float a, float b) {
        return std::pair(normalized(window.sample({a, b})), true);
      },
      [&](Vec3f d) {
        if (d.y <= 0) return 0.0f;
        const Vec3f p = d * (corner.y / d.y) - corner;
        return p.x >= 0 && p.x <= u.x && p.z >= 0 && p.z <= v.z ? 1 / window.solidAngle() : 0.0f;
      },
      96, 192);
}

TEST(Distribution, FollowsItsWeights) {
  const std::vector<float> weights{0, 3, 0, 1, 0};
  const Distribution2D d(weights, 5, 1);
  int counts[5] = {};
  for (int i = 0; i < 1000; ++i) {
    const auto s = d.sample(Vec2f{(static_cast<float>(i) + 0.5f) / 1000, 0.5f});
    const int cell = static_cast<int>(s.point.x * 5);
    ++counts[cell];
    EXPECT_NEAR(s.pdf, d.pdf(Vec2f{(static_cast<float>(cell) + 0.5f) / 5, 0.5f}), 1e-6f);
  }
  EXPECT_EQ(counts[1], 750);
  EXPECT_EQ(counts[3], 250);
  EXPECT_NEAR(d.pdf(Vec2f{0.3f, 0.5f}), 3.75f, 1e-5f);
  EXPECT_EQ(static_cast<int>(d.sample(Vec2f{0.99999994f, 0.5f}).point.x * 5), 3);
}

TEST(Distribution, TwoDimensionsIntegrateToOne) {
  std::vector<float> weights;
  for (int i = 0; i < 12; ++i) weights.push_back(static_cast<float>(i % 5));
  const Distribution2D d(weights, 4, 3);
  double sum = 0;
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x)
      sum += static_cast<double>(
                 d.pdf(Vec2f{(static_cast<float>(x) + 0.5f) / 4, (static_cast<float>(y) + 0.5f) / 3})) /
             12;
  EXPECT_NEAR(sum, 1.0, 1e-5);
  const auto s = d.sample(Vec2f{0.3f, 0.8f});
  EXPECT_NEAR(s.pdf, d.pdf(s.point), 1e-5f);
}

TEST(Frame, IsOrthonormalAllAround) {
  for (const Vec3f n : {Vec3f{0, 0, 1}, Vec3f{0, 0, -1}, Vec3f{1, 0, 0}, normalized(Vec3f{-1, 2, -1e-4f})}) {
    const Frame f(n);
    EXPECT_NEAR(dot(cross(f.x, f.y), f.z), 1.0f, 1e-5f);
    EXPECT_NEAR(dot(f.x, f.y), 0.0f, 1e-6f);
  }
}

}  // namespace
}  // namespace idap::render
