#include "base/memo.h"

#include <gtest/gtest.h>

namespace idap {
namespace {

TEST(Memo, MakesOnceAndForgetsWhatNobodyAsksFor) {
  Memo<int> memo;
  int made = 0;
  const auto ask = [&](const char* key) { return memo.get(key, [&] { return ++made; }); };
  EXPECT_EQ(ask("a"), 1);
  EXPECT_EQ(ask("a"), 1);
  EXPECT_EQ(ask("b"), 2);
  for (int i = 0; i < 3; ++i) {
    memo.nextRound(2);
    ask("a");
  }
  EXPECT_EQ(ask("a"), 1);
  EXPECT_EQ(ask("b"), 3);
}

}  // namespace
}  // namespace idap
