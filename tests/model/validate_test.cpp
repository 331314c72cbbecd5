#include "model/validate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "base/error.h"
#include "support/sample_home.h"

namespace idap {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

// Validates, and expects exactly one line of report that holds these words; the result must pass the check.
Home mend(const Home& home, const std::string& words) {
  EXPECT_THROW(requireValid(home), InvalidHome);
  ImportReport report;
  Home result = validated(home, report);
  EXPECT_EQ(report.entries.size(), 1u);
  if (!report.empty()) {
    EXPECT_THAT(report.entries[0].what, testing::HasSubstr(words));
  }
  EXPECT_NO_THROW(requireValid(result));
  return result;
}

template <class IdType, class T, class F>
IdType changeFirst(Table<IdType, T>& table, F change) {
  const auto [id, element] = *table.begin();
  T copy = *element;
  change(copy);
  table.set(id, std::move(copy));
  return id;
}

TEST(Validate, LeavesAValidHomeAloneAndShared) {
  for (const Home& home : {Home{}, test::fullHome(), test::smallFlat(), test::manyPieces(100)}) {
    ImportReport report;
    const Home result = validated(home, report);
    EXPECT_TRUE(report.empty());
    EXPECT_EQ(result, home);
    EXPECT_EQ(&result.walls.chunks(), &home.walls.chunks());
    EXPECT_NO_THROW(requireValid(home));
  }
}

TEST(Validate, DropsWallsThatAreNoneAndFreesWhatHungOnThem) {
  for (const Vec2 end : {Vec2{0, 0}, Vec2{kNan, 0}, Vec2{20'000, 0}}) {
    Home home = test::smallFlat();
    const auto id = changeFirst(home.walls, [&](Wall& wall) { wall.end = end; });
    ImportReport report;
    const Home result = validated(home, report);
    EXPECT_FALSE(result.walls.contains(id));
    EXPECT_EQ(result.walls.size(), 4u);
    EXPECT_EQ(report.entries.size(), 3u);  // the wall, its neighbours, its window
    EXPECT_NO_THROW(requireValid(result));
    for (const auto& [openingId, opening] : result.openings) EXPECT_NE(opening->wall, id);
  }
}

TEST(Validate, MendsWallBodies) {
  Home home = test::smallFlat();
  changeFirst(home.walls, [](Wall& wall) { wall.thickness = -1; });
  EXPECT_GT(mend(home, "thickness").walls.begin()->second->thickness, 0);
  home = test::smallFlat();
  changeFirst(home.walls, [](Wall& wall) { wall.heightAtStart = wall.heightAtEnd = 0; });
  EXPECT_EQ(mend(home, "zero height").walls.begin()->second->heightAtEnd, 2.5);
  home = test::smallFlat();
  changeFirst(home.walls, [](Wall& wall) { wall.heightAtEnd = 0; });  // running down to the floor is fine
  EXPECT_NO_THROW(requireValid(home));
  changeFirst(home.walls, [](Wall& wall) { wall.arcExtent = 7; });
  EXPECT_EQ(mend(home, "made straight").walls.begin()->second->arcExtent, 0);
}

TEST(Validate, DropsDoubleWallsAndHandsTheirDoorsToTheOther) {
  Home home = test::smallFlat();
  const auto original = home.openings.begin()->second->wall;
  Wall twin = *home.walls.find(original);
  std::swap(twin.start, twin.end);  // drawn the other way: still the same wall
  const auto twinId = home.newId<WallId>();
  home.walls.set(twinId, twin);
  changeFirst(home.openings, [&](Opening& opening) { opening.wall = twinId; });
  const Home result = mend(home, "lies exactly on another");
  EXPECT_FALSE(result.walls.contains(twinId));
  EXPECT_EQ(result.openings.begin()->second->wall, original);
}

TEST(Validate, DropsRoomsWithoutArea) {
  const auto withRoom = [](Polygon points) {
    Home home;
    Room room;
    room.points = std::move(points);
    home.rooms.set(home.newId<RoomId>(), room);
    return home;
  };
  EXPECT_TRUE(mend(withRoom({{0, 0}, {1, 0}}), "three points").rooms.empty());
  EXPECT_TRUE(mend(withRoom({{0, 0}, {1, 0}, {2, 0}}), "no area").rooms.empty());
  EXPECT_EQ(
      mend(withRoom({{0, 0}, {1, 0}, {kNan, 3}, {1, 1}}), "left out").rooms.begin()->second->points.size(),
      3u);
  // A ring crossing itself into two equal halves has area, though its signed area is zero.
  EXPECT_NO_THROW(requireValid(withRoom({{0, 0}, {1, 1}, {1, 0}, {0, 1}})));
}

TEST(Validate, MendsSizesAndPlaces) {
  for (const double bad : {kNan, kInf, -kInf, 0.0, -1.0, 1e9}) {
    Home home = test::manyPieces(3);
    changeFirst(home.furniture, [&](Furniture& piece) { piece.size.y = bad; });
    const double mended = mend(home, "size").furniture.begin()->second->size.y;
    EXPECT_GT(mended, 0);
    EXPECT_LE(mended, 10'000);
  }
  Home home = test::manyPieces(3);
  changeFirst(home.furniture, [&](Furniture& piece) { piece.position.z = -kInf; });
  EXPECT_EQ(mend(home, "put at the origin").furniture.begin()->second->position, Vec3{});
}

TEST(Validate, ClearsIdsThatPointNowhere) {
  Home home = test::smallFlat();
  changeFirst(home.furniture, [](Furniture& piece) { piece.level = LevelId{77}; });
  EXPECT_FALSE(mend(home, "level").furniture.begin()->second->level);
  home = test::smallFlat();
  changeFirst(home.furniture, [](Furniture& piece) { piece.group = GroupId{77}; });
  EXPECT_FALSE(mend(home, "group").furniture.begin()->second->group);
  home = test::smallFlat();
  changeFirst(home.openings, [](Opening& opening) { opening.wall = WallId{77}; });
  EXPECT_FALSE(mend(home, "wall").openings.begin()->second->wall);
  home = test::smallFlat();
  const auto self = changeFirst(home.walls, [](Wall&) {});
  changeFirst(home.walls, [&](Wall& wall) { wall.neighbourAtStart = self; });
  EXPECT_FALSE(mend(home, "itself").walls.begin()->second->neighbourAtStart);
  home = test::smallFlat();
  home.backgrounds[LevelId{5}] = {};
  EXPECT_TRUE(mend(home, "level").backgrounds.empty());
  home = test::smallFlat();
  changeFirst(home.furniture, [](Furniture& piece) { piece.model.asset = "models/none.obj"; });
  EXPECT_EQ(mend(home, "model is missing").furniture.begin()->second->model.asset, "");
}

TEST(Validate, BreaksGroupsThatHoldThemselves) {
  Home home;
  const auto a = home.newId<GroupId>(), b = home.newId<GroupId>(), c = home.newId<GroupId>();
  home.groups.set(a, Group{b, "a", true});
  home.groups.set(b, Group{a, "b", true});
  home.groups.set(c, Group{a, "c", true});
  const Home result = mend(home, "inside it");
  EXPECT_FALSE(result.groups.find(a)->parent);
  EXPECT_EQ(result.groups.find(b)->parent, a);
  EXPECT_EQ(result.groups.find(c)->parent, a);
}

TEST(Validate, CutsGroupsNestedWithoutEnd) {
  Home home;
  GroupId parent;
  for (int i = 0; i < 5000; ++i) {
    const auto id = home.newId<GroupId>();
    home.groups.set(id, Group{parent, "", true});
    parent = id;
  }
  mend(home, "too many groups");
}

TEST(Validate, GivesNumbersUsedTwiceANewOne) {
  Home home;
  home.levels.set(LevelId{5}, Level{});
  home.walls.set(WallId{5}, Wall{});
  changeFirst(home.walls, [](Wall& wall) { wall.end = {1, 0}; });
  Opening door;
  door.wall = WallId{5};
  door.level = LevelId{5};
  home.openings.set(OpeningId{0}, door);
  home.furniture.set(FurnitureId{~std::uint64_t{0}}, Furniture{});
  home.nextId = 3;
  ImportReport report;
  const Home result = validated(home, report);
  EXPECT_NO_THROW(requireValid(result));
  const Opening& kept = *result.openings.begin()->second;
  EXPECT_TRUE(result.levels.contains(LevelId{5}));
  EXPECT_EQ(kept.level, LevelId{5});
  EXPECT_NE(kept.wall, WallId{5});
  EXPECT_TRUE(result.walls.contains(kept.wall));
  EXPECT_EQ(result.furniture.size(), 1u);
  EXPECT_GT(result.nextId, result.furniture.begin()->first.value);
}

TEST(Validate, KeepsTheNextNumberFreeWithoutAFuss) {
  Home home = test::smallFlat();
  home.nextId = 1;
  EXPECT_THROW(requireValid(home), InvalidHome);
  ImportReport report;
  EXPECT_EQ(validated(home, report).nextId, test::smallFlat().nextId);
}

TEST(Validate, MendsTextsThatAreNotUtf8) {
  Home home = test::smallFlat();
  changeFirst(home.furniture, [](Furniture& piece) { piece.name = "Caf\xE9"; });
  EXPECT_EQ(mend(home, "letters").furniture.begin()->second->name, "Caf\xEF\xBF\xBD");
  home = Home{};
  home.properties = {{"a\xFF", "b\xC0\x80"}};
  mend(home, "letters");
  home = Home{};
  home.notes.assign((1 << 20) + 10, 'x');
  EXPECT_EQ(mend(home, "cut").notes.size(), std::size_t{1} << 20);
}

TEST(Validate, MendsLampsCamerasAndTheSite) {
  Home home = test::fullHome();
  changeFirst(home.furniture, [](Furniture& piece) { piece.lamp->lumens = -5; });
  EXPECT_EQ(mend(home, "brightness").furniture.begin()->second->lamp->lumens, 0);
  home = test::fullHome();
  changeFirst(home.cameras, [](Camera& camera) { camera.lens = Lens::Pinhole, camera.fieldOfView = 4; });
  EXPECT_LT(mend(home, "field of view").cameras.begin()->second->fieldOfView, kPi);
  home = Home{};
  home.site.latitude = 2;
  EXPECT_DOUBLE_EQ(mend(home, "latitude").site.latitude, kPi / 2);
  home = Home{};
  home.site.time = std::numeric_limits<std::int64_t>::min();
  mend(home, "time");
}

TEST(Validate, RefusesFilesThatLeaveTheArchive) {
  const auto bytes = std::make_shared<const Bytes>();
  for (const char* name :
       {"../evil", "/etc/passwd", "models/../../x", "c:/x", "a\\b", "", "models/", "home.json"}) {
    Home home;
    home.assets = std::make_shared<const Assets>(Assets{{name, bytes}, {"models/good.obj", bytes}});
    EXPECT_EQ(mend(home, "unusable name").assets->size(), 1u) << name;
  }
  Home home;
  home.assets = std::make_shared<const Assets>(Assets{{"models/null.obj", nullptr}});
  mend(home, "empty");
  home.assets = nullptr;
  EXPECT_THROW(requireValid(home), InvalidHome);
  ImportReport report;
  EXPECT_NE(validated(home, report).assets, nullptr);
}

TEST(Validate, TellsAThousandEqualMendsInOneLine) {
  Home home = test::manyPieces(1000);
  for (const auto& [id, piece] : home.furniture) {
    Furniture bad = *piece;
    bad.angle = kNan;
    home.furniture.set(id, bad);
  }
  ImportReport report;
  validated(home, report);
  ASSERT_EQ(report.entries.size(), 1u);
  EXPECT_EQ(report.entries[0].count, 1000u);
  EXPECT_THAT(report.entries[0].place, testing::HasSubstr("furniture 1 \"Piece 0\""));
  EXPECT_THAT(report.entries[0].place, testing::HasSubstr("and 997 more"));
}

TEST(Validate, CheckingAChangeSeesWhatTheChangeBroke) {
  const Home before = test::smallFlat();
  Home after = before;
  after.walls.erase(before.walls.begin()->first);  // its neighbours and its window now point nowhere
  EXPECT_THROW(requireValid(after, before), InvalidHome);
  after = before;
  after.furniture.set(FurnitureId{before.walls.begin()->first.value}, Furniture{});
  EXPECT_THROW(requireValid(after, before), InvalidHome) << "a number used twice";
  after = before;
  after.furniture.set(FurnitureId{after.nextId}, Furniture{});
  EXPECT_THROW(requireValid(after, before), InvalidHome) << "nextId not beyond it";
  after = test::fullHome();
  after.assets = std::make_shared<const Assets>();
  EXPECT_THROW(requireValid(after, test::fullHome()), InvalidHome) << "pictures gone";
}

// Whatever is broken, in whatever combination: what comes out is valid and stays as it is.
TEST(Validate, WhatItReturnsAlwaysPasses) {
  std::mt19937 random(5);
  const double numbers[] = {kNan, kInf, -kInf, 0, -0.0, -1, 1e-9, 1e5, 1e300, -1e300, 5e-324};
  for (int round = 0; round < 3000; ++round) {
    Home home = test::fullHome();
    const auto number = [&] { return numbers[random() % std::size(numbers)]; };
    const auto anyId = [&] { return std::uint64_t{random() % 20}; };
    for (int i = 0; i < 6; ++i) switch (random() % 14) {
        case 0:
          changeFirst(home.walls, [&](Wall& w) { w.start = {number(), number()}; });
          break;
        case 1:
          changeFirst(home.walls, [&](Wall& w) { w.heightAtStart = number(), w.heightAtEnd = number(); });
          break;
        case 2:
          changeFirst(home.walls, [&](Wall& w) { w.neighbourAtEnd = WallId{anyId()}; });
          break;
        case 3:
          changeFirst(home.rooms, [&](Room& r) { r.points[random() % 4] = {number(), number()}; });
          break;
        case 4:
          changeFirst(home.furniture, [&](Furniture& f) { f.size = {number(), number(), number()}; });
          break;
        case 5:
          changeFirst(home.furniture, [&](Furniture& f) { f.group = GroupId{anyId()}; });
          break;
        case 6:
          changeFirst(home.groups, [&](Group& g) { g.parent = GroupId{anyId()}; });
          break;
        case 7:
          changeFirst(home.furniture, [&](Furniture& f) { f.lamp->sources[0].share = number(); });
          break;
        case 8:
          changeFirst(home.openings, [&](Opening& o) { o.cutOut = "M0,0 Lxyz"; });
          break;
        case 9:
          changeFirst(home.openings, [&](Opening& o) { o.model.rotation[0].x = number(); });
          break;
        case 10:
          changeFirst(home.furniture, [&](Furniture& f) { f.finish.texture->size.x = number(); });
          break;
        case 11:
          home.levels.set(LevelId{anyId()}, Level{});
          break;
        case 12:
          home.walls.set(WallId{anyId()}, *home.walls.begin()->second);
          break;
        default:
          home.nextId = random() % 2 ? ~std::uint64_t{0} : anyId();
          break;
      }
    ImportReport report, second;
    const Home result = validated(home, report);
    ASSERT_NO_THROW(requireValid(result));
    EXPECT_EQ(validated(result, second), result);
    EXPECT_TRUE(second.empty());
  }
}

}  // namespace
}  // namespace idap
