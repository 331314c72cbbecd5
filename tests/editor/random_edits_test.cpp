// Properties that hold whatever a user does: undo and redo lead through the same homes, what is saved opens
// equal, and rooms are as large as they were drawn. IDAP_RANDOM_EDITS=200 tries that many seeds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "base/error.h"
#include "editor/commands/command.h"
#include "formats/registry.h"
#include "model/edits/arrange_edits.h"
#include "model/edits/level_edits.h"
#include "model/edits/piece_edits.h"
#include "model/edits/wall_shape_edits.h"
#include "model/room_geometry.h"
#include "model/validate.h"
#include "support/sample_home.h"

namespace idap {
namespace {

unsigned seeds(unsigned usual) {
  const char* wish = std::getenv("IDAP_RANDOM_EDITS");
  return wish ? static_cast<unsigned>(std::strtoul(wish, nullptr, 10)) : usual;
}

std::shared_ptr<const Catalog> builtIn() {
  static const auto catalog = std::make_shared<const Catalog>(std::vector<std::filesystem::path>{});
  return catalog;
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(engine_); }
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  template <class T>
  const T& of(const std::vector<T>& from) {
    return from[static_cast<std::size_t>(below(static_cast<int>(from.size())))];
  }
  template <class T>
  void shuffle(std::vector<T>& all) {
    std::shuffle(all.begin(), all.end(), engine_);
  }
  // Often a place that others share.
  Vec2 point() {
    return below(3) ? Vec2{double(below(9)), double(below(7))} : Vec2{real(-2, 10), real(-2, 8)};
  }

 private:
  std::mt19937 engine_;
};

// Somebody who does anything at all.
class User {
 public:
  explicit User(unsigned seed) : random_(seed), editor_(builtIn()) {
    editor_.open(std::make_unique<Document>(seed % 3 ? test::smallFlat() : test::fullHome()));
    history_.push_back(editor_.home());
  }

  void act() {
    const int kind = random_.below(20);
    if (kind < 9)
      command();
    else if (kind < 12)
      editor_.apply("Edit", change());
    else if (kind < 16)
      drag();
    else if (kind < 18)
      undo();
    else
      redo();
    note();
    if (random_.below(3) == 0) choose();
  }

  void check() {
    ASSERT_EQ(editor_.home(), history_[at_]);
    ASSERT_NO_THROW(requireValid(editor_.home()));
  }

  void undoAll() {
    while (at_ > 0) {
      undo();
      ASSERT_EQ(editor_.home(), history_[at_]);
    }
    ASSERT_FALSE(editor_.document().canUndo());
  }
  void redoAll() {
    while (at_ + 1 < history_.size()) {
      redo();
      ASSERT_EQ(editor_.home(), history_[at_]);
    }
    ASSERT_FALSE(editor_.document().canRedo());
  }
  const Home& home() const { return editor_.home(); }

 private:
  using Change = std::function<Home(const Home&)>;

  // What was done is a new home after the one before; what could have been redone is gone.
  void note() {
    if (editor_.home() == history_[at_]) return;
    history_.resize(at_ + 1);
    history_.push_back(editor_.home());
    ++at_;
  }
  void undo() {
    if (at_ > 0) --at_;
    editor_.undo();
    ASSERT_EQ(editor_.home(), history_[at_]);
  }
  void redo() {
    if (at_ + 1 < history_.size()) ++at_;
    editor_.redo();
    ASSERT_EQ(editor_.home(), history_[at_]);
  }

  void choose() {
    const Elements all = everything(editor_.home(), std::nullopt);
    Elements some;
    const int share = 1 + random_.below(6);
    for (const AnyId id : list(all))
      if (random_.below(6) < share) add(some, id);
    editor_.select(some);
    if (!editor_.home().levels.empty()) editor_.setLevel(random_.of(levelsInOrder(editor_.home())));
  }

  void command() {
    const Command& chosen = random_.of(commands());
    // Without this the home grows until it takes minutes.
    const bool grows = chosen.id == std::string("duplicate") || chosen.id == std::string("split-wall");
    if (grows && editor_.home().nextId > 300) return;
    if (!chosen.enabled || chosen.enabled(editor_)) chosen.run(editor_);
  }

  Change change() {
    const Elements chosen = editor_.selection();
    const LevelId level = editor_.level();
    const Vec2 a = random_.point(), b = random_.point();
    const double x = random_.real(-1, 1);
    const std::vector<WallId> walls = allElements(editor_.home()).walls;
    const WallId wall = walls.empty() ? WallId{} : random_.of(walls);
    switch (random_.below(12)) {
      case 0:
        return [=](const Home& h) { return moveElements(h, chosen, {x, -x / 2, 0.1}); };
      case 1:
        return [=](const Home& h) { return turnElements(h, chosen, a, 3 * x); };
      case 2:
      case 3:
        return [=](const Home& h) {
          Wall drawn;
          drawn.level = level;
          drawn.start = a;
          drawn.end = b;
          return followWalls(h, addWall(h, drawn).home, level, true);
        };
      case 4:
        return [=](const Home& h) {
          return followWalls(h, moveWallEnd(h, wall, x > 0 ? WallEnd::Start : WallEnd::End, b), level, true);
        };
      case 5:
        return [=](const Home& h) {
          const Wall* found = h.walls.find(wall);
          return found ? moveCorner(h, found->level, found->start, b) : h;
        };
      case 6:
        return [=](const Home& h) { return followWalls(h, bendWall(h, wall, b), level, x > 0); };
      case 7:
        return [=](const Home& h) {
          return pasteElements(h, extractElements(h, chosen), level, {x, x, 0}).home;
        };
      case 8:
        return [=](const Home& h) { return pasteStyle(h, extractElements(h, chosen), allElements(h)); };
      case 9:
        return [=](const Home& h) {
          Furniture piece;
          piece.level = level;
          piece.position = {a.x, a.y, 0};
          piece.size = {0.2 + std::abs(x), 0.5, 0.7};
          if (x > 0) piece.lamp = Lamp{};
          return addFurniture(h, piece).home;
        };
      case 10:
        return [=](const Home& h) {
          Dimension dimension;
          dimension.level = level;
          dimension.start = a;
          dimension.end = b;
          Home next = h;
          next.dimensions.set(next.newId<DimensionId>(), dimension);
          return next;
        };
      default:
        return [=](const Home& h) {
          const Home moved = moveElements(h, chosen, {x, x, 0});
          return dimensionsFollow(h, followWalls(h, moved, level, true));
        };
    }
  }

  void drag() {
    editor_.document().begin("Drag");
    const Change step = change();
    for (int i = 0; i < 3; ++i) editor_.preview(i < 2 ? change() : step);
    if (random_.below(4) == 0)
      editor_.document().cancel();
    else
      editor_.document().commit();
  }

  Random random_;
  Editor editor_;
  std::vector<Home> history_;
  std::size_t at_ = 0;
};

TEST(RandomEdits, UndoAndRedoLeadThroughTheSameHomes) {
  for (unsigned seed = 1; seed <= seeds(12); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    User user(seed);
    for (int i = 0; i < 60; ++i) {
      user.act();
      ASSERT_NO_FATAL_FAILURE(user.check());
    }
    const Home last = user.home();
    ASSERT_NO_FATAL_FAILURE(user.undoAll());
    ASSERT_NO_FATAL_FAILURE(user.redoAll());
  }
}

TEST(RandomEdits, WhatIsSavedOpensEqual) {
  const HomeFormat* idap = nullptr;
  for (const HomeFormat& format : homeFormats())
    if (format.id == "idap") idap = &format;
  ASSERT_TRUE(idap);
  for (unsigned seed = 101; seed <= 100 + seeds(10); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    User user(seed);
    for (int i = 0; i < 40; ++i) user.act();
    const auto bytes = std::make_shared<const Bytes>(idap->write(user.home(), {}));
    const ReadResult back = idap->read(bytes, "home.idap", {});
    // Files that nothing uses any more are not saved.
    EXPECT_EQ(back.home, withoutUnusedAssets(user.home()));
    EXPECT_TRUE(back.report.entries.empty());
  }
}

// A house drawn wall by wall in any order and direction, as with the wall tool, and how large its rooms are.
struct Drawing {
  std::vector<Wall> walls;
  std::vector<double> areas;  // m2

  void add(Vec2 start, Vec2 end, double thickness) {
    Wall wall;
    wall.start = start;
    wall.end = end;
    wall.thickness = thickness;
    walls.push_back(wall);
  }
};

// Columns of rooms between walls from bottom to top, each cut by walls across.
Drawing rectangles(Random& random) {
  Drawing drawing;
  const double outer = random.real(0.1, 0.4), inner = random.real(0.05, 0.2), height = random.real(6, 12);
  std::vector<double> xs{0};
  for (int i = 1 + random.below(4); i > 0; --i) xs.push_back(xs.back() + random.real(2, 5));
  const double width = xs.back();
  drawing.add({0, 0}, {width, 0}, outer);
  drawing.add({width, 0}, {width, height}, outer);
  drawing.add({width, height}, {0, height}, outer);
  drawing.add({0, height}, {0, 0}, outer);
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    const bool last = i + 2 == xs.size();
    if (!last) drawing.add({xs[i + 1], 0}, {xs[i + 1], height}, inner);
    const double clear = xs[i + 1] - xs[i] - (i == 0 ? outer : inner) / 2 - (last ? outer : inner) / 2;
    double floor = outer / 2, y = 0;
    while (random.below(2) && height - y > 5) {
      // In steps of a centimetre: ends within a millimetre of each other are one corner.
      y += 0.01 * (100 + random.below(150));
      drawing.add({xs[i], y}, {xs[i + 1], y}, inner);
      drawing.areas.push_back(clear * (y - inner / 2 - floor));
      floor = y + inner / 2;
    }
    drawing.areas.push_back(clear * (height - outer / 2 - floor));
  }
  return drawing;
}

// An L, whole or cut into two at its inner corner.
Drawing lShape(Random& random) {
  Drawing drawing;
  const double t = random.real(0.05, 0.4), width = random.real(5, 9), height = random.real(5, 9),
               w = random.real(1, 3), h = random.real(1, 3);
  const Vec2 corners[] = {
      {0, 0}, {width, 0}, {width, height - h}, {width - w, height - h}, {width - w, height}, {0, height}};
  for (std::size_t i = 0; i < 6; ++i) drawing.add(corners[i], corners[(i + 1) % 6], t);
  if (random.below(2)) {
    drawing.areas = {(width - t) * (height - t) - w * h};
  } else {
    drawing.add(corners[3], {0, height - h}, t);
    drawing.areas = {(width - t) * (height - h - t), (width - w - t) * (h - t)};
  }
  return drawing;
}

TEST(RandomRooms, AreAsLargeAsTheyWereDrawn) {
  for (unsigned seed = 1; seed <= seeds(60); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    Drawing drawing = seed % 2 ? rectangles(random) : lShape(random);
    random.shuffle(drawing.walls);
    const double angle = random.below(2) ? random.real(0, 2 * kPi) : 0;
    const Vec2 by{random.real(-50, 50), random.real(-50, 50)};
    Home home;
    for (Wall wall : drawing.walls) {
      wall.start = rotated(wall.start, angle) + by;
      wall.end = rotated(wall.end, angle) + by;
      if (random.below(2)) std::swap(wall.start, wall.end);
      home = followWalls(home, addWall(home, wall).home, {}, true);
    }
    ASSERT_NO_THROW(requireValid(home));
    std::vector<double> found;
    for (const auto& [id, room] : home.rooms) found.push_back(floorArea(*room));
    std::sort(found.begin(), found.end());
    std::sort(drawing.areas.begin(), drawing.areas.end());
    ASSERT_EQ(found.size(), drawing.areas.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], drawing.areas[i], 1e-6);

    // However the walls are moved about then, the rooms fill what they enclose.
    for (int i = 0; i < 5; ++i) {
      const Home before = home;
      Elements one;
      one.walls = {random.of(allElements(home).walls)};
      home = moveElements(home, one, {random.real(-0.3, 0.3), random.real(-0.3, 0.3), 0});
      home = followWalls(before, home, {}, true);
    }
    const std::vector<Polygon> areas = closedAreas(home, {});
    ASSERT_EQ(home.rooms.size(), areas.size());
    for (const auto& [id, room] : home.rooms)
      EXPECT_TRUE(std::any_of(areas.begin(), areas.end(), [&](const Polygon& area) {
        return std::abs(std::abs(signedArea(area)) - floorArea(*room)) < 1e-6 &&
               length(bounds(area).min - bounds(room->points).min) < 1e-6;
      }));
  }
}

}  // namespace
}  // namespace idap
