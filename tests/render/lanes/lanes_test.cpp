#include "render/lanes/lanes.h"

#include <gtest/gtest.h>

#include "render/lanes/lane_math.h"
#include "render/sampling/sampler.h"

namespace idap::render {
namespace {

Floats ramp(float from, float step) {
  return Floats([&](auto k) { return from + step * static_cast<float>(static_cast<int>(k)); });
}

TEST(Lanes, SelectTakesEachLanesOwn) {
  const Floats a = ramp(0, 1), b = -a;
  LaneMask odd(false);
  for (std::size_t k = 1; k < kLanes; k += 2) odd[k] = true;
  const Floats s = select(odd, a, b);
  const Ints i = select(odd, Ints(7), Ints(9));
  for (int k = 0; k < kLanes; ++k) {
    EXPECT_EQ(lane(s, k), (k % 2 ? 1.0f : -1.0f) * static_cast<float>(k));
    EXPECT_EQ(lane(i, k), k % 2 ? 7 : 9);
    EXPECT_EQ(lane(only(odd, a), k), k % 2 ? static_cast<float>(k) : 0.0f);
    EXPECT_EQ(lane(toMask(i > 8), k), k % 2 == 0);
  }
  EXPECT_TRUE(any(odd));
  EXPECT_FALSE(every(odd));
}

TEST(Lanes, GatherMeetsEveryLanesPlace) {
  std::vector<float> memory(100);
  for (std::size_t i = 0; i < memory.size(); ++i) memory[i] = static_cast<float>(i);
  const Ints places([](auto k) { return 97 - 5 * static_cast<int>(k); });
  const Floats read = gather(memory.data(), places);
  for (int k = 0; k < kLanes; ++k) EXPECT_EQ(lane(read, k), static_cast<float>(97 - 5 * k));
}

TEST(Lanes, AMasksLanesAreVisitedInOrder) {
  const Ints places([](auto k) { return static_cast<int>(k); });
  const LaneMask odd = toMask((places & Ints(1)) == Ints(1));
  std::vector<int> visited;
  forLanes(odd, [&](int k) { visited.push_back(k); });
  std::vector<int> wanted;
  for (int k = 1; k < kLanes; k += 2) wanted.push_back(k);
  EXPECT_EQ(visited, wanted);
  EXPECT_EQ(bitsOf(LaneMask(true)), (1u << kLanes) - 1);
  EXPECT_EQ(bitsOf(LaneMask(false)), 0u);
}

TEST(LaneMath, FunctionsAreThoseOfTheLibrary) {
  for (float x = -1; x <= 1; x += 0.001f) {
    EXPECT_NEAR(arcCosine(x), std::acos(x), 5e-7f);
    for (const float y : {-0.7f, -1e-6f, 0.3f, 1.0f}) EXPECT_NEAR(arcTangent2(y, x), std::atan2(y, x), 5e-7f);
    float sine, cosine;
    sinCos(20 * x, sine, cosine);
    EXPECT_NEAR(sine, std::sin(20 * x), 2e-6f);
    EXPECT_NEAR(cosine, std::cos(20 * x), 2e-6f);
  }
  const Floats x = ramp(-0.9f, 0.1f);
  Floats sine, cosine;
  sinCos(x, sine, cosine);
  for (int k = 0; k < kLanes; ++k) {
    EXPECT_NEAR(lane(sine, k), std::sin(lane(x, k)), 2e-7f);
    EXPECT_NEAR(lane(arcCosine(x), k), std::acos(lane(x, k)), 5e-7f);
    EXPECT_NEAR(lane(inverseSqrt(x + 2.0f), k), 1 / std::sqrt(lane(x, k) + 2), 3e-7f);
  }
}

TEST(Sampler, LanesDrawWhatEachWouldDrawAlone) {
  LaneSampler lanes{};
  std::vector<Sampler> alone;
  for (int k = 0; k < kLanes; ++k) {
    const Sampler& s = alone.emplace_back(3 * k, 5, static_cast<std::uint32_t>(k), 6, 4);
    const auto i = static_cast<std::size_t>(k);
    lanes.reversedIndex[i] = s.reversedIndex, lanes.seed[i] = s.seed, lanes.dimension[i] = s.dimension;
  }
  for (int draw = 0; draw < 5; ++draw) {
    const LaneVec2 pair = lanes.get2D();
    const Floats single = lanes.get1D();
    for (int k = 0; k < kLanes; ++k) {
      const Vec2f own = alone[static_cast<std::size_t>(k)].get2D();
      EXPECT_EQ(lane(pair.x, k), own.x);
      EXPECT_EQ(lane(pair.y, k), own.y);
      EXPECT_EQ(lane(single, k), alone[static_cast<std::size_t>(k)].get1D());
    }
  }
}

}  // namespace
}  // namespace idap::render
