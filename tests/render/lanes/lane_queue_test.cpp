#include "render/lanes/lane_queue.h"

#include <gtest/gtest.h>

namespace idap::render {
namespace {

struct Record {
  Floats number;
  Ints name;
};

LaneMask bits(std::uint32_t pattern) {
  LaneMask mask(false);
  for (int k = 0; k < kLanes; ++k) mask[static_cast<std::size_t>(k)] = ((pattern >> k) & 1u) != 0;
  return mask;
}

TEST(LaneQueue, KeepsTheLanesOfTheMaskInOrderAndWithoutGaps) {
  LaneQueue<Record> queue;
  std::vector<int> wanted;
  std::uint32_t pattern = 0x9e3779b9u;
  for (int i = 0; i < 40; ++i) {
    pattern = i % 9 == 0 ? 0xffffffffu : i % 7 == 0 ? 0u : pattern * 1664525u + 1013904223u;
    const Record record{Floats([&](int k) { return static_cast<float>(100 * i + k) + 0.5f; }),
                        Ints([&](int k) { return 100 * i + k; })};
    queue.push(bits(pattern >> 8), record);
    for (int k = 0; k < kLanes; ++k)
      if (((pattern >> 8 >> k) & 1u) != 0) wanted.push_back(100 * i + k);
  }
  std::vector<int> found;
  std::size_t visits = 0;
  queue.visit([&](LaneMask lanes, const Record& record) {
    ++visits;
    forLanes(lanes, [&](int k) {
      found.push_back(lane(record.name, k));
      EXPECT_EQ(lane(record.number, k), static_cast<float>(found.back()) + 0.5f);
    });
  });
  EXPECT_EQ(found, wanted);
  EXPECT_EQ(visits, (wanted.size() + kLanes - 1) / kLanes);
}

TEST(LaneQueue, IdleLanesRepeatTheFirst) {
  LaneQueue<Record> queue;
  queue.push(bits(2), {Floats([](int k) { return static_cast<float>(k); }), Ints([](int k) { return k; })});
  queue.visit([&](LaneMask lanes, const Record& record) {
    EXPECT_EQ(bitsOf(lanes), 1u);
    EXPECT_TRUE(every(record.number == 1.0f));
  });
}

TEST(LaneQueue, ClearedHoldsNothing) {
  LaneQueue<Record> queue;
  EXPECT_TRUE(queue.empty());
  queue.push(bits(3), {1.0f, 1});
  EXPECT_FALSE(queue.empty());
  queue.clear();
  EXPECT_TRUE(queue.empty());
  queue.visit([](LaneMask, const Record&) { ADD_FAILURE(); });
}

}  // namespace
}  // namespace idap::render
