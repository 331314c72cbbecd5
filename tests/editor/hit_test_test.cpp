#include "editor/hit_test.h"

#include <gtest/gtest.h>

#include "editor/tools/tool_driver.h"
#include "model/edits/element_edits.h"
#include "support/wall_chain.h"

namespace idap {
namespace {

struct HitTestOf : ToolDriver {
  FurnitureId put(Vec3 position, Vec3 size) {
    const auto id = home_.newId<FurnitureId>();
    Furniture piece;
    piece.position = position;
    piece.size = size;
    home_.furniture.set(id, piece);
    return id;
  }
  void open() { editor.open(std::make_unique<Document>(home_)); }
  std::vector<AnyId> at(Vec2 p, Plane plane_ = Plane::XY) { return hitsAt(editor, plane_, p, 0.02); }
  Home home_;
};

TEST_F(HitTestOf, SmallAndUpperThingsGoFirst) {
  const std::vector<WallId> walls = test::addWalls(home_, {{0, 0}, {5, 0}, {5, 4}, {0, 4}});
  Room room;
  room.points = {{0.1, 0.1}, {4.9, 0.1}, {4.9, 3.9}, {0.1, 3.9}};
  const RoomEdit withRoom = addRoom(home_, room);
  home_ = withRoom.home;
  const FurnitureId rug = put({2, 2, 0}, {2, 1.2, 0.01}), sofa = put({2, 2, 0}, {2.1, 1.3, 0.8});
  const FurnitureId cushion = put({2, 2, 0.4}, {0.4, 0.4, 0.2});
  open();
  EXPECT_EQ(at({2, 2}), (std::vector<AnyId>{cushion, sofa, rug, withRoom.room}));
  EXPECT_EQ(at({2.8, 2}), (std::vector<AnyId>{sofa, rug, withRoom.room}));
  EXPECT_EQ(at({4.5, 3.5}), (std::vector<AnyId>{withRoom.room}));
  EXPECT_EQ(at({2, 0.05}), (std::vector<AnyId>{walls[0]}));
  EXPECT_TRUE(at({9, 9}).empty());
}

TEST_F(HitTestOf, NearestGoesFirstFromTheSide) {
  const FurnitureId front = put({0, 0, 0}, {1, 0.5, 1}), back = put({0, 2, 0}, {1, 0.5, 2});
  open();
  EXPECT_EQ(at({0, 0.5}, Plane::XZ), (std::vector<AnyId>{front, back}));
  EXPECT_EQ(at({0, 1.5}, Plane::XZ), (std::vector<AnyId>{back}));
  EXPECT_EQ(at({2, 1.5}, Plane::YZ), (std::vector<AnyId>{back}));
}

TEST_F(HitTestOf, WallsInFrontOfTheSectionAreHitByTheirOutline) {
  const std::vector<WallId> walls = test::addWalls(home_, {{0, 0}, {5, 0}, {5, 4}, {0, 4}});
  const FurnitureId piece = put({2, 2, 0}, {1, 1, 1});
  open();
  EXPECT_EQ(at({2, 0.5}, Plane::XZ), (std::vector<AnyId>{piece, walls[2]}));
  EXPECT_EQ(at({3.5, 2}, Plane::XZ), (std::vector<AnyId>{walls[2]}));  // the one at the back
  EXPECT_EQ(at({3.5, 2.5}, Plane::XZ).front(), AnyId(walls[0]));
  EXPECT_EQ(at({5, 1}, Plane::XZ).front(), AnyId(walls[1]));  // cut
}

TEST_F(HitTestOf, HiddenPiecesAndOtherLevelsAreNotHit) {
  const FurnitureId hidden = put({0, 0, 0}, {1, 1, 1});
  Furniture changed = *home_.furniture.find(hidden);
  changed.visible = false;
  home_.furniture.set(hidden, changed);
  const auto ground = home_.newId<LevelId>(), upper = home_.newId<LevelId>();
  home_.levels.set(ground, Level{.name = "0"});
  home_.levels.set(upper, Level{.name = "1", .elevation = 3});
  const FurnitureId above = put({0, 0, 0}, {1, 1, 1});
  changed = *home_.furniture.find(above);
  changed.level = upper;
  home_.furniture.set(above, changed);
  open();
  EXPECT_TRUE(at({0, 0}).empty());
  editor.setLevel(upper);
  EXPECT_EQ(at({0, 0}), (std::vector<AnyId>{above}));
  EXPECT_EQ(at({0, 3.5}, Plane::XZ), (std::vector<AnyId>{above}));
}

TEST_F(HitTestOf, LockedPlanLeavesFurnitureAlone) {
  test::addWalls(home_, {{0, 0}, {5, 0}}, false);
  const FurnitureId piece = put({2, 0, 0}, {1, 1, 1});
  open();
  EXPECT_EQ(at({2, 0}).size(), 2u);
  EditorSettings settings = editor.settings();
  settings.baseLocked = true;
  editor.setSettings(settings);
  EXPECT_EQ(at({2, 0}), (std::vector<AnyId>{piece}));
}

TEST_F(HitTestOf, AnnotationsAndCamerasGoBeforeBodies) {
  put({0, 0, 0}, {4, 4, 1});
  const auto dimension = home_.newId<DimensionId>();
  home_.dimensions.set(dimension, Dimension{.start = {-1, -1}, .end = {1, -1}, .offset = 0.5});
  const auto label = home_.newId<LabelId>();
  home_.labels.set(label, Label{.text = "Here", .position = {0, 1}});
  const auto line = home_.newId<PolylineId>();
  home_.polylines.set(line, Polyline{.points = {{-1, 0.5}, {1, 0.5}}});
  const auto camera = home_.newId<CameraId>();
  Camera eye;
  eye.eye = {-1.5, 0, 1.6};
  home_.cameras.set(camera, eye);
  open();
  EXPECT_EQ(at({-0.9, -0.5}).front(), AnyId(dimension));
  EXPECT_EQ(at({0.1, 1.05}).front(), AnyId(label));
  EXPECT_EQ(at({0.5, 0.51}).front(), AnyId(line));
  EXPECT_EQ(at({-1.45, 0.05}).front(), AnyId(camera));
  EXPECT_EQ(at({-1.5, 0.7}).back(), AnyId(camera));  // its cone lies under all
}

TEST_F(HitTestOf, GroupsAreHitAsOne) {
  Elements two;
  two.furniture = {put({0, 0, 0}, {1, 1, 1}), put({2, 0, 0}, {1, 1, 1})};
  const GroupEdit edit = groupElements(home_, two, "pair");
  home_ = edit.home;
  open();
  EXPECT_EQ(at({0, 0}), (std::vector<AnyId>{edit.group}));
  EXPECT_EQ(membersAt(editor, Plane::XY, {2, 0}, 0.02), (std::vector<AnyId>{two.furniture[1]}));
  EXPECT_EQ(hitsIn(editor, Plane::XY, {-1, -1}, {1, 1}).groups, std::vector<GroupId>{edit.group});
}

TEST_F(HitTestOf, RectangleToTheRightTakesWhatIsInside) {
  const FurnitureId in = put({1, 1, 0}, {0.5, 0.5, 1});
  put({2, 1, 0}, {1, 0.5, 1});
  open();
  EXPECT_EQ(hitsIn(editor, Plane::XY, {0, 0}, {2, 2}).furniture, std::vector<FurnitureId>{in});
  EXPECT_EQ(hitsIn(editor, Plane::XY, {2, 2}, {0, 0}).furniture.size(), 2u);
  EXPECT_EQ(hitsIn(editor, Plane::XZ, {2, 1.5}, {0, 0.1}).furniture.size(), 2u);
}

TEST_F(HitTestOf, FindsOneAmongTwoThousandPieces) {
  for (int i = 0; i < 2000; ++i) put({i % 50 * 1.0, i / 50 * 1.0, 0}, {0.9, 0.9, 1});
  open();
  std::size_t found = 0;
  for (int i = 0; i < 50; ++i) found += at({i * 1.0, 10}).size();
  EXPECT_EQ(found, 50u);
}

}  // namespace
}  // namespace idap
