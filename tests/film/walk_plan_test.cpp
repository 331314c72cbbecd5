#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "film/camera_path.h"
#include "film/film_plan.h"
#include "film/film_test_support.h"

namespace idap {
namespace {

using test::eyeAt;
using test::twoRooms;

double turnBetween(const Camera& a, const Camera& b) {
  return std::abs(std::remainder(a.yaw - b.yaw, 2 * kPi));
}

TEST(SmoothCurve, GoesThroughItsPointsWithoutCorners) {
  const std::vector<Vec2> points{{0, 0}, {2, 0}, {2.2, 1}, {2, 3}, {5, 3}};
  const std::vector<Vec2> curve = smoothCurve(points);
  for (const Vec2& p : points) {
    const auto far = [&](Vec2 q) { return length(q - p); };
    EXPECT_LT(far(*std::ranges::min_element(curve, {}, far)), 1e-9);
  }
  for (std::size_t i = 1; i + 1 < curve.size(); ++i) {
    EXPECT_LT(length(curve[i + 1] - curve[i]), 0.1);
    EXPECT_GT(dot(normalized(curve[i] - curve[i - 1]), normalized(curve[i + 1] - curve[i])), 0.95)
        << "a corner";
  }
  EXPECT_EQ(smoothCurve({{1, 1}, {1, 1}}).size(), 1u);
}

FilmPlan walk() {
  return planWalk(twoRooms(), {eyeAt(1, 1, 0.5), eyeAt(3, 0.8, -2), eyeAt(7, 1, kPi / 2), eyeAt(5, 1, kPi)});
}

TEST(Walk, VisitsEveryPointOfViewAndLooksTheirWay) {
  const FilmPlan plan = walk();
  EXPECT_TRUE(plan.cuts.empty());
  EXPECT_TRUE(plan.warnings.empty());
  for (const Camera& stop : {eyeAt(1, 1, 0.5), eyeAt(3, 0.8, -2), eyeAt(7, 1, kPi / 2), eyeAt(5, 1, kPi)}) {
    const auto frames = std::count_if(plan.frames.begin(), plan.frames.end(), [&](const Camera& frame) {
      return length(frame.eye - stop.eye) < 1e-3 && turnBetween(frame, stop) < 1e-3;
    });
    EXPECT_GE(frames, 24) << "a second to look";
  }
}

TEST(Walk, IsNeverFastNorJerky) {
  const FilmPlan plan = walk();
  const double step = 1.0 / plan.framesPerSecond;
  double fastest = 0, turn = 0, jerk = 0, lastTurn = 0, pull = 0;
  Vec3 lastMove;
  for (std::size_t i = 1; i < plan.frames.size(); ++i) {
    const Camera &a = plan.frames[i - 1], &b = plan.frames[i];
    const Vec3 move = b.eye - a.eye;
    const double turned = std::remainder(b.yaw - a.yaw, 2 * kPi);
    fastest = std::max(fastest, length(move) / step);
    turn = std::max(turn, std::abs(turned) / step);
    if (i > 1) jerk = std::max(jerk, std::abs(turned - lastTurn) / (step * step));
    if (i > 1) pull = std::max(pull, std::abs(length(move) - length(lastMove)) / (step * step));
    lastTurn = turned;
    lastMove = move;
    EXPECT_LT(std::abs(b.pitch - a.pitch) / step, kPi / 3 + 1e-6);
  }
  EXPECT_LE(fastest, 1.2 * 1.02);
  EXPECT_GT(fastest, 1.0) << "and does walk";
  EXPECT_LE(turn, kPi / 3) << "60 degrees a second";
  EXPECT_LE(jerk, 4);
  EXPECT_LE(pull, 4);
}

TEST(Walk, NeverComesNearAWall) {
  for (const Camera& frame : walk().frames) {
    const Vec3 p = frame.eye;
    const bool inDoor = std::abs(p.y - 3) < 0.33;
    EXPECT_TRUE(inDoor || std::abs(p.x - 4) > 0.15) << p.x << ", " << p.y;
  }
}

TEST(Walk, OpensTheDoorItGoesThroughAndNoOther) {
  Home home = twoRooms();
  Opening other = *home.openings.begin()->second;
  const OpeningId passed = home.openings.begin()->first;
  other.position = {8, 2, 0};
  const auto closed = home.newId<OpeningId>();
  home.openings.set(closed, other);
  const FilmPlan plan = planWalk(home, {eyeAt(1, 1), eyeAt(7, 1)});
  EXPECT_EQ(plan.home.openings.find(passed)->kind, OpeningKind::Bare);
  EXPECT_EQ(plan.home.openings.find(closed)->kind, OpeningKind::Door);
}

TEST(Walk, CutsWhereNobodyCanWalkAndSaysSo) {
  Camera from = eyeAt(1, 1), to = eyeAt(7, 1);
  from.name = "Kitchen";
  to.name = "Cellar";
  const FilmPlan plan = planWalk(twoRooms(false), {from, to});
  ASSERT_EQ(plan.cuts.size(), 1u);
  EXPECT_EQ(plan.frames[plan.cuts[0]].eye, to.eye);
  EXPECT_EQ(plan.frames[plan.cuts[0] - 1].eye, from.eye);
  ASSERT_EQ(plan.warnings.size(), 1u);
  EXPECT_THAT(plan.warnings[0], testing::AllOf(testing::HasSubstr("Kitchen"), testing::HasSubstr("Cellar")));
}

TEST(Walk, TakesAsLongAsAsked) {
  WalkSettings settings;
  settings.seconds = 4;
  EXPECT_NEAR(planWalk(twoRooms(), {eyeAt(1, 1), eyeAt(7, 1)}, settings).seconds(), 4, 0.05);
  EXPECT_THROW(planWalk(twoRooms(), {}), Error);
}

TEST(Walk, WithoutPointsOfViewItVisitsTheRooms) {
  const std::vector<Camera> stops = defaultStops(twoRooms());
  ASSERT_EQ(stops.size(), 2u);
  EXPECT_LT(stops[0].eye.x, 4);
  EXPECT_GT(stops[1].eye.x, 4);
  EXPECT_TRUE(planWalk(twoRooms(), stops).cuts.empty());
}

TEST(Day, GoesFromBeforeSunriseToAfterSunset) {
  Home home = twoRooms();
  home.site.timeZone = "Europe/Paris";
  DaySettings settings;
  settings.seconds = 2;
  settings.date = {2026, 6, 21};
  const FilmPlan plan = planDay(home, eyeAt(1, 1), settings);
  ASSERT_EQ(plan.frames.size(), 50u);
  const CivilTime first = civilFromUtc(*plan.frames.front().time, "Europe/Paris"),
                  last = civilFromUtc(*plan.frames.back().time, "Europe/Paris");
  EXPECT_EQ(first.hour, 5);
  EXPECT_EQ(last.hour, 22);
  EXPECT_EQ(first.day, 21);
  settings.from = 6;
  settings.to = 20;
  EXPECT_EQ(civilFromUtc(*planDay(home, eyeAt(1, 1), settings).frames.back().time, "Europe/Paris").hour, 20);
  settings.to = 5;
  EXPECT_THROW(planDay(home, eyeAt(1, 1), settings), Error);
}

}  // namespace
}  // namespace idap
