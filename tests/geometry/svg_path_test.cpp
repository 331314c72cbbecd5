#include "geometry/svg_path.h"

#include <gtest/gtest.h>

#include <string>

#include "base/error.h"

namespace idap {
namespace {

TEST(SvgPath, ReadsTheUnitSquareOfADoor) {
  const auto rings = parseSvgPath("M0,0 v1 h1 v-1 z");
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_EQ(rings[0], (Polygon{{0, 0}, {0, 1}, {1, 1}, {1, 0}}));
}

TEST(SvgPath, ImplicitLinesAndSeveralRings) {
  const auto rings = parseSvgPath("M 0 0 1 0 1 1z m2 0 l1,0 0,1 z");
  ASSERT_EQ(rings.size(), 2u);
  EXPECT_EQ(rings[1].front(), (Vec2{2, 0}));
  EXPECT_DOUBLE_EQ(signedArea(rings[1]), 0.5);
}

TEST(SvgPath, NumbersMayStandTogether) {
  EXPECT_EQ(parseSvgPath("M0-1L.5.5-1e-1+2").at(0), (Polygon{{0, -1}, {0.5, 0.5}, {-0.1, 2}}));
}

TEST(SvgPath, ArcsKeepTheirChordError) {
  const auto rings = parseSvgPath("M0,1 V.5 A.5 .5 0 0 1 1,.5 V1 Z", 0.001);
  ASSERT_EQ(rings.size(), 1u);
  for (std::size_t i = 2; i + 1 < rings[0].size(); ++i) {
    const Vec2 middle = (rings[0][i] + rings[0][i - 1]) / 2;
    if (middle.y < 0.5) {
      EXPECT_NEAR(length(middle - Vec2{0.5, 0.5}), 0.5, 0.001);
    }
  }
  EXPECT_NEAR(std::abs(signedArea(rings[0])), 0.5 + kPi / 8, 0.002);
  EXPECT_NEAR(std::abs(signedArea(parseSvgPath("M0 .5a.5.5 0 011 0 .5.5 0 01-1 0z", 0.0005).at(0))), kPi / 4,
              0.002);
}

TEST(SvgPath, ArcRadiiThatAreTooSmallGrow) {
  EXPECT_NEAR(std::abs(signedArea(parseSvgPath("M0,0 A.1 .1 0 0 1 1,0 Z", 0.0005).at(0))), kPi / 8, 0.002);
}

TEST(SvgPath, CurvesAndTheirSmoothContinuations) {
  // A cubic with its control points on the chord is a line.
  EXPECT_NEAR(std::abs(signedArea(parseSvgPath("M0 0 C.3 0 .6 0 1 0 L1 1Z").at(0))), 0.5, 1e-12);
  // Area under a quadratic: two thirds of its triangle's.
  EXPECT_NEAR(std::abs(signedArea(parseSvgPath("M0 0 Q.5 1 1 0Z", 1e-5).at(0))), 1.0 / 3, 1e-4);
  EXPECT_NEAR(signedArea(parseSvgPath("M0 0 Q.5 1 1 0 T2 0 L2 5 L0 5Z", 1e-5).at(0)), 10, 1e-3);
  EXPECT_NO_THROW(parseSvgPath("M0 0c0 .5 .5 .5 .5 0s.5-.5.5 0v1z"));
}

TEST(SvgPath, ErrorsNameThePlace) {
  for (const char* bad :
       {"0 0", "L0 0", "M0", "M0,0 X1", "M0 0 A1 1 0 2 0 1 1", "M0 0 L1 nan", "M0 0 L1e999 0"}) {
    EXPECT_THROW(parseSvgPath(bad), ParseError) << bad;
  }
  try {
    parseSvgPath("M0,0 X1");
    FAIL();
  } catch (const ParseError& e) {
    EXPECT_EQ(e.file(), "path");
    EXPECT_NE(e.place().find('7'), std::string::npos) << e.place();
  }
}

TEST(SvgPath, TooManyPointsAreRefused) {
  std::string path = "M0 0";
  for (int i = 0; i < 100'001; ++i) path += "h1";
  EXPECT_THROW(parseSvgPath(path), ParseError);
}

TEST(SvgPath, ShortRingsAndEmptyPathsGiveNothing) {
  EXPECT_TRUE(parseSvgPath("").empty());
  EXPECT_TRUE(parseSvgPath("M0 0 L1 1 Z").empty());
}

}  // namespace
}  // namespace idap
