#include "geometry/polygon.h"

#include <gtest/gtest.h>

#include <limits>

namespace idap {
namespace {

Polygon rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}
double covered(const Triangulation& t) {
  double sum = 0;
  for (const auto& v : t.triangles) {
    sum += cross(t.points[v[1]] - t.points[v[0]], t.points[v[2]] - t.points[v[0]]) / 2;
  }
  return sum;
}

TEST(Polygon, AreaIsPositiveCounterClockwiseEvenFarFromTheOrigin) {
  EXPECT_DOUBLE_EQ(signedArea(rectangle(0, 0, 2, 3)), 6);
  EXPECT_DOUBLE_EQ(signedArea({{0, 0}, {0, 3}, {2, 3}, {2, 0}}), -6);
  EXPECT_NEAR(signedArea(rectangle(1e7, 1e7, 1e7 + 2, 1e7 + 3)), 6, 1e-7);
  EXPECT_DOUBLE_EQ(perimeter(rectangle(0, 0, 2, 3)), 10);
}

TEST(Polygon, ContainsIsEvenOdd) {
  EXPECT_TRUE(contains(rectangle(0, 0, 2, 2), {1, 1}));
  EXPECT_FALSE(contains(rectangle(0, 0, 2, 2), {3, 1}));
  EXPECT_FALSE(contains({}, {0, 0}));
}

TEST(Polygon, RepairSplitsABowTie) {
  const Regions r = repair({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  EXPECT_EQ(r.size(), 2u);
  EXPECT_NEAR(area(r), 2, 1e-12);
}

TEST(Polygon, SubtractionLeavesAHoleOfTheRightOrientation) {
  const Regions r = subtract({{rectangle(0, 0, 4, 4), {}}}, {{rectangle(1, 1, 2, 2), {}}});
  ASSERT_EQ(r.size(), 1u);
  ASSERT_EQ(r[0].holes.size(), 1u);
  EXPECT_GT(signedArea(r[0].outer), 0);
  EXPECT_LT(signedArea(r[0].holes[0]), 0);
  EXPECT_NEAR(area(r), 15, 1e-12);
}

TEST(Polygon, UnionIntersectionAndBuffer) {
  const Regions a{{rectangle(0, 0, 2, 2), {}}}, b{{rectangle(1, 1, 3, 3), {}}};
  EXPECT_NEAR(area(unite(a, b)), 7, 1e-12);
  EXPECT_NEAR(area(unite({a[0].outer, b[0].outer})), 7, 1e-12);
  EXPECT_NEAR(area(intersect(a, b)), 1, 1e-12);
  EXPECT_NEAR(area(buffer(a, 0.5)), 9, 1e-9);
  EXPECT_NEAR(area(buffer(a, -0.5)), 1, 1e-9);
  EXPECT_TRUE(buffer(a, -2).empty());
}

TEST(Polygon, ClockwiseInputCountsLikeCounterClockwise) {
  const Regions a{{{{0, 0}, {0, 2}, {2, 2}, {2, 0}}, {}}};
  EXPECT_NEAR(area(subtract(a, {{rectangle(0, 0, 1, 2), {}}})), 2, 1e-12);
}

TEST(Polygon, TriangulationCoversExactlyAndUsesOnlyThePoints) {
  Region r{rectangle(0, 0, 10, 10), {}};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      Polygon hole = rectangle(1 + 3 * i, 1 + 3 * j, 3 + 3 * i, 3 + 3 * j);
      std::reverse(hole.begin(), hole.end());
      r.holes.push_back(hole);
    }
  }
  const Triangulation t = triangulate({r});
  EXPECT_NEAR(covered(t), 100 - 36, 1e-9);
  EXPECT_EQ(t.points.size(), 40u);
  for (const auto& v : t.triangles) {
    EXPECT_GT(cross(t.points[v[1]] - t.points[v[0]], t.points[v[2]] - t.points[v[0]]), 0);
  }
}

TEST(Polygon, TriangulatesHolesThatTouchEachOtherAndTheRim) {
  Regions r = subtract({{rectangle(0, 0, 6, 4), {}}},
                       unite({rectangle(1, 1, 2, 2), rectangle(2, 2, 3, 3), rectangle(3, 1, 4, 2),
                              Polygon{{4.5, 0}, {5, 1}, {4, 1}}}));
  EXPECT_NEAR(covered(triangulate(r)), area(r), 1e-9);
}

TEST(Polygon, DegenerateInputGivesNothing) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(repair({}).empty());
  EXPECT_TRUE(repair({{0, 0}, {1, 1}}).empty());
  EXPECT_TRUE(repair({{0, 0}, {1, 1}, {2, 2}}).empty());
  EXPECT_TRUE(repair({{0, 0}, {kInf, 1}, {2, 2}}).empty());
  EXPECT_TRUE(unite(std::vector<Polygon>{}).empty());
  EXPECT_TRUE(unite(Regions{}, Regions{}).empty());
  EXPECT_TRUE(subtract({}, {{rectangle(0, 0, 1, 1), {}}}).empty());
  EXPECT_TRUE(triangulate({}).triangles.empty());
  EXPECT_NEAR(area(subtract({{rectangle(0, 0, 1, 1), {}}}, {})), 1, 1e-12);
}

}  // namespace
}  // namespace idap
