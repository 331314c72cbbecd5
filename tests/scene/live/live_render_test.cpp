#include "scene/live/live_render.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>

#include "scene/scene_test_support.h"

namespace idap {
namespace {

class Viewer {
 public:
  Viewer()
      : live({[this](LiveFrame frame) {
                const std::lock_guard lock(mutex);
                frames.push_back(std::move(frame));
                wake.notify_all();
              },
              [this](const std::string& why) { ADD_FAILURE() << why; }},
             2) {
    request.home = test::closedRoom();
    request.catalog = std::shared_ptr<const Catalog>(&test::noLibraries(), [](const Catalog*) {});
    request.camera.eye = {2, 0.5, 1.6};
    request.width = 64;
    request.height = 40;
    request.samples = 2;
  }
  LiveFrame await(std::uint64_t generation, bool finished) {
    std::unique_lock lock(mutex);
    LiveFrame found;
    EXPECT_TRUE(wake.wait_for(lock, std::chrono::seconds(60), [&] {
      for (const LiveFrame& f : frames)
        if (f.generation == generation && (!finished || f.finished)) {
          found = f;
          return true;
        }
      return false;
    }));
    return found;
  }

  std::mutex mutex;
  std::condition_variable wake;
  std::vector<LiveFrame> frames;
  LiveRequest request;
  LiveRender live;  // last: it goes first
};

TEST(LiveRender, ShowsACoarseFrameFirstAndAFinishedOneInTheEnd) {
  Viewer viewer;
  const auto generation = viewer.live.submit(viewer.request);
  EXPECT_EQ(viewer.await(generation, false).samples, 0);
  const LiveFrame last = viewer.await(generation, true);
  EXPECT_EQ(last.samples, 2);
  EXPECT_EQ(last.image.width, 64);
  ASSERT_TRUE(last.view);
  const std::size_t middle = last.view->features.index(32, 20);
  EXPECT_NEAR(last.view->features.distance[middle], 2.4, 0.05) << "to the wall in front";
  EXPECT_TRUE(std::holds_alternative<WallId>(last.view->objects[last.view->features.objectId[middle]]));
}

TEST(LiveRender, TheNewestRequestIsAnsweredHoweverManyCameBefore) {
  Viewer viewer;
  std::uint64_t newest = 0;
  for (int i = 0; i < 40; ++i) {
    viewer.request.camera.yaw = 0.1 * i;
    newest = viewer.live.submit(viewer.request);
  }
  EXPECT_EQ(viewer.await(newest, true).view->camera.yaw, viewer.request.camera.yaw);
}

TEST(LiveRender, WaitsWhilePausedAndEndsInTheMiddleOfWork) {
  Viewer viewer;
  viewer.live.pause(true);
  viewer.request.samples = 1 << 12;
  const auto generation = viewer.live.submit(viewer.request);
  {
    const std::lock_guard lock(viewer.mutex);
    EXPECT_TRUE(viewer.frames.empty());
  }
  viewer.live.pause(false);
  viewer.await(generation, false);
}

double meanDifference(const Image8& a, const Image8& b) {
  EXPECT_EQ(a.rgb.size(), b.rgb.size());
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(int(a.rgb[i]) - int(b.rgb[i]));
  return sum / double(a.rgb.size());
}

TEST(LiveRender, WhatDoesNotChangeStaysCleanFromTheFirstFrameOn) {
  Viewer viewer;
  viewer.request.samples = 16;
  const LiveFrame rest = viewer.await(viewer.live.submit(viewer.request), true);
  viewer.request.home.name = "renamed";
  const LiveFrame first = viewer.await(viewer.live.submit(viewer.request), false);
  EXPECT_EQ(first.samples, 0);
  EXPECT_LT(meanDifference(first.image, rest.image), 3);
}

TEST(LiveRender, AFinishedFrameOwesNothingToTheOnesBefore) {
  Viewer viewer, fresh;
  viewer.request.samples = fresh.request.samples = 8;
  viewer.await(viewer.live.submit(viewer.request), true);
  for (const auto& [id, wall] : viewer.request.home.walls) {
    Wall painted = *wall;
    painted.left.finish.color = painted.right.finish.color = Color{0.8f, 0.1f, 0.1f};
    viewer.request.home.walls.set(id, painted);
    break;
  }
  fresh.request.home = viewer.request.home;
  const LiveFrame changed = viewer.await(viewer.live.submit(viewer.request), true);
  const LiveFrame anew = fresh.await(fresh.live.submit(fresh.request), true);
  EXPECT_LT(meanDifference(changed.image, anew.image), 1);
}

}  // namespace
}  // namespace idap
