#include <gtest/gtest.h>

#include "editor/snap.h"
#include "editor/tools/tool_driver.h"
#include "model/edits/element_edits.h"
#include "support/wall_chain.h"

namespace idap {
namespace {

struct Handles : ToolDriver {
  void open(Furniture piece) {
    Home start;
    id = start.newId<FurnitureId>();
    start.furniture.set(id, std::move(piece));
    editor.open(std::make_unique<Document>(start));
    editor.select(only(id));
  }
  static Furniture box(Vec3 position, Vec3 size) {
    Furniture piece;
    piece.position = position;
    piece.size = size;
    return piece;
  }
  Vec2 handle(HandleKind kind, Vec2 towards = {}) const {
    const Handle* best = nullptr;
    const Overlay shown = overlay();
    for (const Handle& h : shown.handles)
      if (h.kind == kind && (!best || dot(h.at, towards) > dot(best->at, towards))) best = &h;
    EXPECT_TRUE(best) << "no such handle";
    return best ? best->at : Vec2{};
  }
  bool has(HandleKind kind) const {
    const Overlay shown = overlay();
    return std::any_of(shown.handles.begin(), shown.handles.end(),
                       [kind](const Handle& h) { return h.kind == kind; });
  }
  void dragHandle(HandleKind kind, Vec2 towards, Vec2 by) {
    const Vec2 from = handle(kind, towards);
    drag(from, from + by);
  }
  const Furniture& now() const { return *home().furniture.find(id); }
  FurnitureId id;
};

TEST_F(Handles, WidthGrowsAndTheOtherSideStays) {
  open(box({0, 0, 0}, {2, 1, 0.7}));
  dragHandle(HandleKind::ResizeWidth, {1, 0}, {0.5, 0.2});
  EXPECT_NEAR(now().size.x, 2.5, 1e-9);
  EXPECT_NEAR(now().position.x, 0.25, 1e-9);
  EXPECT_NEAR(now().size.y, 1, 1e-12);
  EXPECT_EQ(document().undoName(), "Resize");
  EXPECT_EQ(undoSteps(), 1);
  dragHandle(HandleKind::ResizeDepth, {0, -1}, {0, 0.3});
  EXPECT_NEAR(now().size.y, 0.7, 1e-9);
  EXPECT_NEAR(now().position.y, 0.15, 1e-9);
}

TEST_F(Handles, TurnedAndMirroredPiecesStretchAlongTheirOwnAxes) {
  Furniture piece = box({3, 1, 0}, {2, 1, 0.7});
  piece.angle = kPi / 6;
  piece.mirrored = true;
  open(piece);
  const Vec2 along = rotated(Vec2{1, 0}, kPi / 6);
  const Vec2 left = Vec2{3, 1} - along;
  modifiers.alt = true;
  dragHandle(HandleKind::ResizeWidth, along, along * 0.6);
  EXPECT_NEAR(now().size.x, 2.6, 1e-9);
  const Vec2 middle{now().position.x, now().position.y};
  expectNear(middle - along * 1.3, left);
}

TEST_F(Handles, CornerStretchesBothAndShiftKeepsProportions) {
  open(box({0, 0, 0}, {2, 1, 0.7}));
  dragHandle(HandleKind::ResizeCorner, {1, 1}, {0.4, 0.3});
  EXPECT_NEAR(now().size.x, 2.4, 1e-9);
  EXPECT_NEAR(now().size.y, 1.3, 1e-9);
  editor.undo();
  modifiers.shift = true;
  dragHandle(HandleKind::ResizeWidth, {1, 0}, {1, 0});
  EXPECT_NEAR(now().size.x, 3, 1e-9);
  EXPECT_NEAR(now().size.y, 1.5, 1e-9);
  EXPECT_NEAR(now().size.z, 1.05, 1e-9);
  EXPECT_NEAR(now().position.z, 0, 1e-9);
}

TEST_F(Handles, SizesCanBeTypedAndKeepToTheCatalog) {
  const CatalogPiecePtr bed = editor.catalog().find("idap/bed-double");
  ASSERT_TRUE(bed);
  open(makeFurniture(*bed, {0, 0, 0}));
  const Vec2 from = handle(HandleKind::ResizeCorner, {1, 1});
  press(from);
  pointer(PointerEvent::Kind::Move, from + Vec2{0.1, 0.1});
  ASSERT_EQ(overlay().fields.size(), 2u);
  type("150");
  key(Key::Tab);
  type("2.1m");
  key(Key::Enter);
  release(from);
  EXPECT_NEAR(now().size.x, 1.5, 1e-9);
  EXPECT_NEAR(now().size.y, 2.1, 1e-9);
  dragHandle(HandleKind::ResizeWidth, {1, 0}, {20, 0});
  EXPECT_NEAR(now().size.x, bed->maxSize.x, 1e-9);
}

TEST_F(Handles, SideMeetsTheWall) {
  open(box({2, 2, 0}, {1, 1, 1}));
  Home start = home();
  test::addWalls(start, {{4, 0}, {4, 4}}, false);
  editor.open(std::make_unique<Document>(start));
  editor.select(only(id));
  dragHandle(HandleKind::ResizeWidth, {1, 0}, {1.36, 0});
  EXPECT_NEAR(now().size.x, 2.4, 1e-9);
}

TEST_F(Handles, HeightFromTheSide) {
  open(box({0, 0, 0.2}, {2, 1, 0.7}));
  plane = Plane::XZ;
  dragHandle(HandleKind::ResizeHeight, {0, 1}, {0, 0.3});
  EXPECT_NEAR(now().size.z, 1, 1e-9);
  EXPECT_NEAR(now().position.z, 0.2, 1e-9);
  plane = Plane::YZ;
  dragHandle(HandleKind::ResizeDepth, {1, 0}, {0.5, 0});
  EXPECT_NEAR(now().size.y, 1.5, 1e-9);
  EXPECT_NEAR(now().position.y, 0.25, 1e-9);
}

TEST_F(Handles, ATurnedPieceHasOnlyItsHeightFromTheSide) {
  Furniture piece = box({0, 0, 0}, {2, 1, 0.7});
  piece.angle = 0.5;
  open(piece);
  plane = Plane::XZ;
  EXPECT_FALSE(has(HandleKind::ResizeWidth));
  EXPECT_TRUE(has(HandleKind::ResizeHeight));
}

TEST_F(Handles, TurnsInSteps) {
  open(box({0, 0, 0}, {2, 1, 0.7}));
  const Vec2 from = handle(HandleKind::Rotate);
  EXPECT_NEAR(from.y, -0.68, 1e-9);  // 18 pixels before the front
  drag(from, rotated(from, 0.5));
  EXPECT_NEAR(now().angle, kPi / 6, 1e-9);
  EXPECT_EQ(document().undoName(), "Rotate");
  editor.undo();
  modifiers.alt = true;
  drag(from, rotated(from, 0.5));
  EXPECT_NEAR(now().angle, 0.5, 1e-9);
  editor.undo();
  modifiers = {};
  press(from);
  pointer(PointerEvent::Kind::Move, rotated(from, 0.2));
  EXPECT_EQ(overlay().angles.size(), 1u);
  type("37.5");
  key(Key::Enter);
  release(from);
  EXPECT_NEAR(now().angle, 37.5 * kPi / 180, 1e-9);
}

TEST_F(Handles, TiltsInThePlaneWhereItIsSeen) {
  open(box({0, 0, 1}, {1, 0.5, 0.8}));
  EXPECT_FALSE(has(HandleKind::Pitch));
  plane = Plane::XZ;
  EXPECT_FALSE(has(HandleKind::Pitch));
  const Vec2 centre{0, 1.4};
  Vec2 from = handle(HandleKind::Roll);
  drag(from, centre + rotated(from - centre, kPi / 6));
  EXPECT_NEAR(std::abs(now().roll), kPi / 6, 1e-9);
  // What was to the right is higher now.
  EXPECT_GT(placement(now()).point({0.5, 0, 0.4}).z, placement(now()).point({-0.5, 0, 0.4}).z);
  editor.undo();
  plane = Plane::YZ;
  from = handle(HandleKind::Pitch);
  drag(from, centre + rotated(from - centre, kPi / 6));
  EXPECT_GT(placement(now()).point({0, 0.25, 0.4}).z, placement(now()).point({0, -0.25, 0.4}).z);
  EXPECT_NEAR(std::abs(now().pitch), kPi / 6, 1e-9);
}

TEST_F(Handles, RaisesOnThePlan) {
  open(box({0, 0, 0}, {1, 1, 0.5}));
  dragHandle(HandleKind::Raise, {}, {0.3, 0.8});
  EXPECT_NEAR(now().position.z, 0.8, 1e-9);
  EXPECT_EQ(document().undoName(), "Raise");
  dragHandle(HandleKind::Raise, {}, {0, -3});
  EXPECT_NEAR(now().position.z, 0, 1e-9);
}

TEST_F(Handles, SeveralTurnAndScaleTogether) {
  Home start;
  Elements two;
  for (const double x : {0.0, 3.0}) {
    two.furniture.push_back(start.newId<FurnitureId>());
    start.furniture.set(two.furniture.back(), box({x, 0, 0}, {1, 1, 1}));
  }
  editor.open(std::make_unique<Document>(start));
  editor.select(two);
  const auto at = [&](int i) { return home().furniture.find(two.furniture[std::size_t(i)])->position; };
  const Vec2 centre{1.5, 0}, from = handle(HandleKind::Rotate);
  drag(from, centre + rotated(from - centre, kPi / 2));
  EXPECT_NEAR(at(0).x, 1.5, 1e-9);
  EXPECT_NEAR(at(0).y, -1.5, 1e-9);
  editor.undo();
  dragHandle(HandleKind::ResizeCorner, {1, 1}, {4, 1});
  EXPECT_NEAR(at(0).x, 0.5, 1e-9);
  EXPECT_NEAR(at(1).x, 6.5, 1e-9);
  EXPECT_NEAR(home().furniture.find(two.furniture[1])->size.z, 2, 1e-9);
  EXPECT_EQ(undoSteps(), 1);
}

TEST_F(Handles, DoorInAWallIsWidenedButNotTurned) {
  Home start;
  test::addWalls(start, {{0, 0}, {5, 0}}, false);
  editor.open(std::make_unique<Document>(start));
  const auto in =
      snapOpening(editor, makeOpening(*editor.catalog().find("idap/door-flush"), {}), {2, 0.2}, 0.5);
  start = home();
  const auto door = start.newId<OpeningId>();
  start.openings.set(door, *in);
  editor.open(std::make_unique<Document>(start));
  editor.select(only(door));
  EXPECT_FALSE(has(HandleKind::Rotate));
  EXPECT_FALSE(has(HandleKind::ResizeDepth));
  dragHandle(HandleKind::ResizeWidth, {1, 0}, {0.2, 0});
  EXPECT_NEAR(home().openings.find(door)->size.x, 1.1, 1e-9);
  EXPECT_NEAR(home().openings.find(door)->position.x, 2.1, 1e-9);
}

}  // namespace
}  // namespace idap
