#include <gtest/gtest.h>

#include <random>

#include "editor/snap.h"
#include "editor/tools/tool_driver.h"
#include "model/edits/element_edits.h"
#include "model/validate.h"
#include "support/wall_chain.h"

namespace idap {
namespace {

// A home with something of every kind.
Home everyKind(const Editor& editor) {
  Home home;
  const auto walls = test::addWalls(home, {{0, 0}, {5, 0}, {5, 4}, {0, 4}});
  Wall round = test::wall({5, 0}, {8, 0});
  round.arcExtent = 1.2;
  home.walls.set(home.newId<WallId>(), round);
  home = addRoomAt(home, {}, {2, 2}, "Room").home;
  std::vector<FurnitureId> ids;
  for (const char* name :
       {"idap/bed-double", "idap/night-table", "idap/chair-windsor", "idap/wardrobe-hinged"}) {
    ids.push_back(home.newId<FurnitureId>());
    Furniture piece = makeFurniture(*editor.catalog().find(name), {1.0 + double(ids.size()) * 0.7, 2, 0});
    piece.angle = 0.3 * double(ids.size());
    home.furniture.set(ids.back(), piece);
  }
  Elements two;
  two.furniture = {ids[1], ids[2]};
  home = groupElements(home, two, "pair").home;
  Opening door = makeOpening(*editor.catalog().find("idap/door-flush"), {2, 0, 0});
  door.wall = walls[0];
  home.openings.set(home.newId<OpeningId>(), door);
  Camera camera;
  camera.eye = {4, 3, 1.6};
  home.cameras.set(home.newId<CameraId>(), camera);
  home.dimensions.set(home.newId<DimensionId>(), Dimension{.start = {0, 0}, .end = {5, 0}, .offset = -0.5});
  home.labels.set(home.newId<LabelId>(), Label{.text = "Here", .position = {1, 3}});
  home.polylines.set(home.newId<PolylineId>(), Polyline{.points = {{6, 1}, {7, 2}, {6, 3}}});
  return home;
}

struct RandomDrags : ToolDriver {};

TEST_F(RandomDrags, AnySequenceKeepsTheHomeSoundAndUndoesToTheStart) {
  std::mt19937 random(7);
  const auto number = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto chance = [&number](double share) { return number(0, 1) < share; };
  const Home start = everyKind(editor);
  editor.open(std::make_unique<Document>(start));
  for (int round = 0; round < 400; ++round) {
    plane = chance(0.6) ? Plane::XY : chance(0.5) ? Plane::XZ : Plane::YZ;
    modifiers = {.shift = chance(0.2), .control = chance(0.1), .alt = chance(0.3)};
    const auto somewhere = [&] { return Vec2{number(-1, 8), number(plane == Plane::XY ? -1 : 0, 4)}; };
    Vec2 from = somewhere();
    const Overlay shown = overlay();
    if (!shown.handles.empty() && chance(0.6))
      from = shown.handles[std::size_t(number(0, double(shown.handles.size()) - 0.01))].at;
    move(from);
    press(from);
    const int steps = int(number(0, 6));
    for (int i = 0; i < steps; ++i) {
      pointer(PointerEvent::Kind::Move, somewhere());
      (void)overlay();
      EXPECT_FALSE(editor.tool().hint().empty());
      if (chance(0.15)) type("120");
      if (chance(0.1)) key(Key::Tab);
      if (chance(0.1)) key(Key::Enter);
      if (chance(0.05)) key(Key::Escape);
      if (chance(0.03)) editor.undo();
    }
    release(chance(0.9) ? somewhere() : from);
    EXPECT_FALSE(document().inTransaction());
    if (chance(0.1)) doubleClick(somewhere());
    if (chance(0.1)) key(Key::PageUp);
    if (chance(0.1)) key(Key::Left);
    if (chance(0.02)) key(Key::Delete);
    if (chance(0.05)) editor.undo();
    ASSERT_NO_THROW(requireValid(home())) << "in round " << round;
  }
  EXPECT_GT(undoSteps(), 50);
  const Home end = home();
  while (document().canUndo()) editor.undo();
  EXPECT_TRUE(home() == start);
  while (document().canRedo()) editor.redo();
  EXPECT_TRUE(home() == end);
}

}  // namespace
}  // namespace idap
