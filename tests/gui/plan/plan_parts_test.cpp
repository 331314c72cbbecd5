// The parts of the plan that can be told without a widget.
#include <gtest/gtest.h>

#include <QKeyEvent>
#include <cmath>
#include <map>

#include "studio/plan/canvas.h"
#include "studio/plan/elevation.h"
#include "studio/plan/grid.h"
#include "studio/plan/opening_shape.h"
#include "studio/plan/plan_colors.h"
#include "studio/plan/plan_input.h"
#include "studio/plan/smooth_line.h"
#include "support/sample_home.h"

namespace idap {
namespace {

TEST(Grid, StepsAreRoundInTheUsersUnit) {
  for (const double scale : {3.0, 20.0, 100.0, 700.0}) {
    const GridSteps steps = gridSteps(LengthUnit::Centimetre, scale);
    EXPECT_GE(steps.fine * scale, 9);
    const double power = std::log10(steps.strong);
    EXPECT_TRUE(std::abs(power - std::round(power)) < 1e-9 ||
                std::abs(power - std::floor(power) - std::log10(5)) < 1e-9);
    const double times = steps.strong / steps.fine;
    EXPECT_NEAR(times, std::round(times), 1e-9);
  }
  EXPECT_NEAR(std::remainder(gridSteps(LengthUnit::FeetInches, 30).strong, 0.3048), 0, 1e-9);
}

TEST(Grid, RulersCountInTheUsersUnit) {
  EXPECT_EQ(rulerNumber(2.5, LengthUnit::Centimetre, 0.5), "250");
  EXPECT_EQ(rulerNumber(-0.5, LengthUnit::Metre, 0.5), "-0.5");
  EXPECT_EQ(rulerNumber(1.2, LengthUnit::Millimetre, 0.1), "1200");
  EXPECT_EQ(rulerNumber(3 * 0.3048, LengthUnit::FeetInches, 0.3048), "3'");
  EXPECT_EQ(rulerNumber(1e-17, LengthUnit::Centimetre, 0.5), "0");
}

TEST(OpeningShape, TheHoleGoesThroughTheWholeWall) {
  Home home = test::smallFlat();
  const auto [id, opening] = *std::next(home.openings.begin());  // the window in a wall of 20 cm
  Opening thin = *opening;
  thin.size.y = 0.08;
  const OpeningShape shape = openingShape(home, thin);
  EXPECT_NEAR(shape.hole[0].y, -0.1, 1e-9);
  EXPECT_NEAR(shape.hole[2].y, 0.1, 1e-9);
  EXPECT_NEAR(shape.frame[2].y - shape.frame[0].y, 0.08, 1e-9);
  EXPECT_TRUE(shape.leaves.empty());
}

TEST(OpeningShape, APlainDoorHasALeafAndAWideOneTwo) {
  Home home;
  Opening door;
  door.size = {0.9, 0.1, 2};
  ASSERT_EQ(openingShape(home, door).leaves.size(), 1u);
  const OpeningShape::Leaf leaf = openingShape(home, door).leaves[0];
  EXPECT_NEAR(leaf.width, 0.9, 1e-9);
  EXPECT_NEAR(leaf.axis.x, -0.45, 1e-9);
  door.mirrored = true;
  EXPECT_NEAR(openingShape(home, door).leaves[0].axis.x, 0.45, 1e-9);
  door.size.x = 1.6;
  EXPECT_EQ(openingShape(home, door).leaves.size(), 2u);
  const Box2 box = openingBox(home, door);
  EXPECT_LE(box.min.y, -0.8);
}

TEST(Elevation, WallsAreCutBehindOrInFront) {
  const Home home = test::smallFlat();
  std::map<WallFace::Kind, int> kinds;
  for (const auto& [id, wall] : home.walls)
    for (const WallFace& face : wallFaces(home, id, *wall, Plane::XZ, -2)) ++kinds[face.kind];
  EXPECT_EQ(kinds[WallFace::Kind::Front], 1);
  EXPECT_EQ(kinds[WallFace::Kind::Cut], 3) << "both sides and the wall between";
  EXPECT_EQ(kinds[WallFace::Kind::Behind], 4) << "the back, and what is seen of those that are cut";
}

TEST(Canvas, TextNeverStandsOnItsHead) {
  for (double angle = -7; angle < 7; angle += 0.1) {
    EXPECT_GE(std::cos(uprightAngle(angle)), -1e-6);
    EXPECT_NEAR(std::sin(2 * (uprightAngle(angle) - angle)), 0, 1e-9);
  }
  EXPECT_NEAR(uprightAngle(kPi), 0, 1e-9);
  EXPECT_NEAR(uprightAngle(-kPi / 2), kPi / 2, 1e-9) << "vertical text reads from below";
}

TEST(PlanColors, LinesAreReadableOnLightAndDark) {
  for (const bool dark : {false, true}) {
    QPalette palette;
    palette.setColor(QPalette::Base, dark ? QColor(30, 32, 36) : QColor(255, 255, 255));
    palette.setColor(QPalette::Text, dark ? QColor(230, 230, 230) : QColor(10, 10, 10));
    const PlanColors colors(palette);
    EXPECT_EQ(colors.dark, dark);
    const int paper = qGray(colors.paper.rgb());
    for (const QColor& color : {colors.ink, colors.soft, colors.wall, colors.guide, colors.wrong})
      EXPECT_GT(std::abs(qGray(color.rgb()) - paper), 70);
    for (const Color& own : {Color{0, 0, 0}, Color{1, 1, 1}, Color{0.9f, 0.9f, 0.2f}})
      EXPECT_GT(std::abs(qGray(colors.readable(own).rgb()) - paper), 50);
  }
}

TEST(SmoothLine, GoesThroughItsPoints) {
  const std::vector<Vec2> points{{0, 0}, {1, 1}, {2, 0}, {3, 1}};
  const std::vector<Vec2> curve = smoothLine(points, false);
  for (const Vec2 p : points)
    EXPECT_TRUE(std::any_of(curve.begin(), curve.end(), [p](Vec2 q) { return length(p - q) < 1e-9; }));
  EXPECT_GT(curve.size(), 20u);
}

TEST(PlanInput, ShortcutsAreNotText) {
  const auto key = [](int code, Qt::KeyboardModifiers modifiers, const QString& text) {
    return keyOf(QKeyEvent(QEvent::KeyPress, code, modifiers, text));
  };
  EXPECT_EQ(key(Qt::Key_3, {}, QStringLiteral("3"))->text, "3");
  EXPECT_EQ(key(0x0e01, {}, QStringLiteral("ก"))->text, "ก");
  EXPECT_FALSE(key(Qt::Key_C, Qt::ControlModifier, QStringLiteral("\x03")));
  EXPECT_FALSE(key(Qt::Key_F2, {}, {}));
  EXPECT_EQ(key(Qt::Key_Backtab, Qt::ShiftModifier, {})->key, Key::BackTab);
  EXPECT_EQ(key(Qt::Key_Left, Qt::ControlModifier, {})->key, Key::Left);
}

}  // namespace
}  // namespace idap
