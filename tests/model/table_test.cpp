#include "model/table.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "base/id.h"

namespace idap {
namespace {

using Key = Id<struct KeyTag>;
using IntTable = Table<Key, int>;

void expectSame(const IntTable& table, const std::map<std::uint64_t, int>& model) {
  ASSERT_EQ(table.size(), model.size());
  EXPECT_EQ(table.empty(), model.empty());
  auto expected = model.begin();
  for (const auto& [key, value] : table) {
    ASSERT_EQ(key.value, expected->first);
    ASSERT_EQ(*value, expected->second);
    ++expected;
  }
  EXPECT_EQ(expected, model.end());
}

TEST(Table, BehavesAsAnOrderedMapUnderRandomEdits) {
  std::mt19937 random(7);
  for (const std::uint64_t range : {20u, 400u, 5000u}) {
    IntTable table;
    std::map<std::uint64_t, int> model;
    std::vector<std::pair<IntTable, std::map<std::uint64_t, int>>> snapshots;
    for (int step = 0; step < 6000; ++step) {
      const std::uint64_t key = 1 + random() % range;
      // Phases that mostly grow, then mostly shrink, down to nothing.
      const bool grow = step % 2000 < 1000;
      if (random() % 10 < (grow ? 7u : 1u)) {
        table.set(Key{key}, step);
        model[key] = step;
      } else {
        EXPECT_EQ(table.erase(Key{key}), model.erase(key) == 1);
      }
      const int* found = table.find(Key{key});
      ASSERT_EQ(found != nullptr, model.contains(key));
      if (step % 500 == 0) snapshots.emplace_back(table, model);
    }
    expectSame(table, model);
    // Copies taken on the way never changed.
    for (const auto& [copy, expected] : snapshots) expectSame(copy, expected);
    for (const auto& [key, value] : model) EXPECT_EQ(*table.find(Key{key}), value);
    while (!model.empty()) {
      table.erase(Key{model.begin()->first});
      model.erase(model.begin());
    }
    expectSame(table, model);
    table.set(Key{3}, 4);
    EXPECT_EQ(*table.find(Key{3}), 4);
  }
}

TEST(Table, EqualityIsByContentHoweverItWasBuilt) {
  IntTable up, down, once;
  IntTable::Chunk entries;
  for (std::uint64_t i = 1; i <= 1000; ++i) {
    up.set(Key{i}, int(i));
    entries.emplace_back(Key{i}, std::make_shared<const int>(int(i)));
  }
  for (std::uint64_t i = 1000; i >= 1; --i) down.set(Key{i}, int(i));
  std::shuffle(entries.begin(), entries.end(), std::mt19937(1));
  once = IntTable::of(entries);
  EXPECT_EQ(up, down);
  EXPECT_EQ(up, once);
  EXPECT_EQ(down, once);
  once.set(Key{500}, 0);
  EXPECT_FALSE(up == once);
  EXPECT_FALSE(down == once);
  once.set(Key{500}, 500);
  EXPECT_EQ(up, once);
  up.erase(Key{1});
  EXPECT_FALSE(up == once);
}

TEST(Table, MadeOfManyKeepsTheFirstOfEqualIdsAndLeavesOutNulls) {
  const auto table = IntTable::of({{Key{5}, std::make_shared<const int>(50)},
                                   {Key{2}, nullptr},
                                   {Key{5}, std::make_shared<const int>(51)},
                                   {Key{1}, std::make_shared<const int>(10)}});
  expectSame(table, {{1, 10}, {5, 50}});
}

TEST(Table, ACopySharesElementsAndUntouchedChunks) {
  IntTable table;
  for (std::uint64_t i = 1; i <= 10'000; ++i) table.set(Key{i}, int(i));
  IntTable copy = table;
  EXPECT_EQ(&copy.chunks(), &table.chunks());
  copy.set(Key{5000}, -1);
  EXPECT_EQ(*table.find(Key{5000}), 5000);
  std::size_t different = 0;
  ASSERT_EQ(copy.chunks().size(), table.chunks().size());
  for (std::size_t i = 0; i < copy.chunks().size(); ++i) different += copy.chunks()[i] != table.chunks()[i];
  EXPECT_EQ(different, 1u);
  for (std::uint64_t i = 1; i <= 10'000; ++i)
    if (i != 5000) {
      ASSERT_EQ(copy.find(Key{i}), table.find(Key{i})) << "element " << i << " was copied";
    }
}

TEST(Table, ALoopMayChangeTheTableItWalks) {
  IntTable table;
  for (std::uint64_t i = 1; i <= 300; ++i) table.set(Key{i}, int(i));
  std::size_t visited = 0;
  for (const auto& [key, value] : table) {
    ++visited;
    if (key.value % 2)
      table.erase(key);
    else
      table.set(key, *value * 10);
    table.set(Key{key.value + 1000}, 1);
  }
  EXPECT_EQ(visited, 300u);
  EXPECT_EQ(table.size(), 450u);
  EXPECT_EQ(*table.find(Key{2}), 20);
}

TEST(Table, IsStillATableAfterBeingMovedFrom) {
  IntTable table;
  table.set(Key{1}, 1);
  const IntTable moved = std::move(table);
  EXPECT_EQ(moved.size(), 1u);
  EXPECT_EQ(std::size_t(std::distance(table.begin(), table.end())), table.size());  // NOLINT: the point
  table.set(Key{2}, 2);
  EXPECT_EQ(*table.find(Key{2}), 2);
}

TEST(Table, SettingNothingErases) {
  IntTable table;
  table.set(Key{1}, 1);
  table.set(Key{1}, std::shared_ptr<const int>());
  EXPECT_TRUE(table.empty());
}

}  // namespace
}  // namespace idap
