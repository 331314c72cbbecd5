#include "film/film_job.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "film/film_test_support.h"

namespace idap {
namespace {

using test::eyeAt;
using test::Folder;
using test::twoRooms;

double brightness(const Image8& image) {
  return std::accumulate(image.rgb.begin(), image.rgb.end(), 0.0) / static_cast<double>(image.rgb.size());
}

FilmPlan shortWalk() {
  WalkSettings settings;
  settings.framesPerSecond = 5;
  settings.seconds = 3;
  return planWalk(twoRooms(), {eyeAt(1, 1, kPi), eyeAt(3, 3, 0)}, settings);
}

const FilmSettings kTiny{.width = 48, .height = 28, .samples = 2, .lamps = LampPolicy::On};

TEST(FilmJob, EveryFrameIsShownAndWritten) {
  const Folder folder;
  const FilmPlan plan = shortWalk();
  std::vector<double> seen;
  const FilmResult result = makeFilm(plan, Catalog(), kTiny, folder / "a.mp4", {}, [&](FilmFrame frame) {
    EXPECT_EQ(frame.number, static_cast<int>(seen.size()));
    EXPECT_EQ(frame.image.width, 48);
    seen.push_back(brightness(frame.image));
  });
  EXPECT_FALSE(result.stopped);
  EXPECT_EQ(result.frames, static_cast<int>(plan.frames.size()));
  EXPECT_EQ(seen.size(), plan.frames.size());
  EXPECT_EQ(test::readFilm(folder / "a.mp4").frames, result.frames);
}

TEST(FilmJob, StoppedEarlyItLeavesNothingStoppedLaterTheFilmSoFar) {
  const Folder folder;
  const FilmPlan plan = shortWalk();
  for (const int stopAt : {2, 8}) {
    Progress progress;
    const auto make = [&] {
      return makeFilm(plan, Catalog(), kTiny, folder / "a.mp4", progress, [&](const FilmFrame& frame) {
        if (frame.number == stopAt) progress.cancel();
      });
    };
    if (stopAt < plan.framesPerSecond) {
      EXPECT_THROW(make(), Cancelled);
      EXPECT_EQ(folder.files(), 0u);
    } else {
      const FilmResult result = make();
      EXPECT_TRUE(result.stopped);
      EXPECT_EQ(result.frames, stopAt + 1);
      EXPECT_EQ(test::readFilm(folder / "a.mp4").frames, stopAt + 1);
    }
  }
}

TEST(FilmJob, ADaySeenFromOutsideLooksIn) {
  const Folder folder;
  Home home = twoRooms();
  std::vector<RoomId> rooms;
  for (const auto& [id, room] : home.rooms) rooms.push_back(id);
  for (const RoomId id : rooms) {
    Room room = *home.rooms.find(id);
    room.floor = plain(Color{0.8f, 0.05f, 0.05f});
    home.rooms.set(id, room);
  }
  Camera above = eyeAt(2, 2);
  above.eye.z = 8;
  above.pitch = kPi / 2;
  DaySettings day;
  day.framesPerSecond = 5;
  day.seconds = 1;
  day.from = 12, day.to = 12.5;
  const FilmPlan plan = planDay(home, above, day);
  makeFilm(plan, Catalog(), kTiny, folder / "a.mp4", {}, [&](const FilmFrame& frame) {
    const std::size_t middle = std::size_t(3) * (14 * 48 + 24);
    EXPECT_GT(frame.image.rgb[middle], frame.image.rgb[middle + 1] + 30) << frame.number;
  });
}

TEST(FilmJob, WhereTheCameraStandsNothingIsTracedTwice) {
  const FilmPlan plan = shortWalk();
  EXPECT_LT(tracedFrames(plan), static_cast<int>(plan.frames.size()));
  EXPECT_GT(estimatedSeconds(plan, {}), estimatedSeconds(plan, kTiny));
}

}  // namespace
}  // namespace idap
