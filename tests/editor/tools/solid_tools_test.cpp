// Boxes, cylinders, balls, outlines and turned profiles drawn in each of the three planes.
#include "catalog/parametric/outline_parameter.h"
#include "tool_driver.h"

namespace idap {
namespace {

class SolidTools : public ToolDriver {
 protected:
  SolidTools() { openRoom(4, 3); }

  const Furniture& made() const { return newest(home().furniture); }
  void expectBox(Vec3 min, Vec3 size) {
    const Furniture& piece = made();
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(piece.size[i], size[i], 1e-6) << "size " << i;
    EXPECT_NEAR(piece.position.x - piece.size.x / 2, min.x, 1e-6);
    EXPECT_NEAR(piece.position.y - piece.size.y / 2, min.y, 1e-6);
    EXPECT_NEAR(piece.position.z, min.z, 1e-6);
  }
};

TEST_F(SolidTools, BoxIsDraggedOnTheFloorAndGetsATypedHeight) {
  const Home before = home();
  editor.takeTool("solid-box");
  modifiers.alt = true;
  drag({1, 1}, {2.2, 1.8});
  modifiers.alt = false;
  ASSERT_EQ(home().furniture.size(), 1u) << "seen before it is done";
  EXPECT_TRUE(document().inTransaction());
  ASSERT_EQ(overlay().fields.size(), 1u);
  EXPECT_EQ(std::string(overlay().fields.front().label), "Height");
  EXPECT_NEAR(overlay().fields.front().value, 0.5, 1e-9);
  type("75cm");
  key(Key::Enter);
  EXPECT_FALSE(document().inTransaction());
  EXPECT_EQ(made().model.catalogId, "idap/solid-box");
  expectBox({1, 1, 0}, {1.2, 0.8, 0.75});
  EXPECT_EQ(editor.selection().furniture.size(), 1u);
  EXPECT_EQ(undoSteps(), 1);
  editor.undo();
  EXPECT_EQ(home(), before);
}

TEST_F(SolidTools, BoxTakesTypedSides) {
  editor.takeTool("solid-box");
  modifiers.alt = true;
  click({1, 1});
  move({1.5, 1.5});
  modifiers.alt = false;
  type("2m");
  key(Key::Enter);
  type("1.5m");
  key(Key::Enter);
  type("30cm");
  key(Key::Enter);
  expectBox({1, 1, 0}, {2, 1.5, 0.3});
}

TEST_F(SolidTools, BoxInFrontViewHasItsElevationAndStandsInTheRoom) {
  editor.takeTool("solid-box");
  plane = Plane::XZ;
  modifiers.alt = true;
  drag({1, 0.8}, {2, 1.4});
  modifiers.alt = false;
  EXPECT_EQ(std::string(overlay().fields.at(0).label), "Depth");
  type("40cm");
  key(Key::Enter);
  EXPECT_NEAR(made().size.x, 1, 1e-6);
  EXPECT_NEAR(made().size.y, 0.4, 1e-6);
  EXPECT_NEAR(made().size.z, 0.6, 1e-6);
  EXPECT_NEAR(made().position.z, 0.8, 1e-6);
  EXPECT_GT(made().position.y, 0);
  EXPECT_LT(made().position.y, 3);
}

TEST_F(SolidTools, HeightCanBeShownInAnotherPlane) {
  editor.takeTool("solid-box");
  modifiers.alt = true;
  drag({1, 1}, {2, 2});
  plane = Plane::XZ;
  move({1.5, 1.2});
  EXPECT_FALSE(overlay().measures.empty());
  press({1.5, 1.2});
  EXPECT_NEAR(made().size.z, 1.2, 1e-3);
  EXPECT_FALSE(document().inTransaction());
}

TEST_F(SolidTools, CylindersAxisGoesAcrossThePlane) {
  const double axes[] = {0, 2, 1};
  for (const Plane in : kPlanes) {
    plane = in;
    editor.takeTool("solid-cylinder");
    modifiers.alt = modifiers.shift = true;
    drag({1, 1}, {1.6, 1.3});
    modifiers = {};
    type("1m");
    key(Key::Enter);
    const Furniture& piece = made();
    EXPECT_EQ(piece.model.parameters.at("axis"), axes[static_cast<int>(in)]);
    int metre = 0;
    for (int i = 0; i < 3; ++i) {
      if (std::abs(piece.size[i] - 1) < 1e-9)
        ++metre;
      else
        EXPECT_NEAR(piece.size[i], 0.6, 1e-6) << "equal sides with Shift";
    }
    EXPECT_EQ(metre, 1);
  }
}

TEST_F(SolidTools, BallHasItsCentreAndRadius) {
  editor.takeTool("solid-sphere");
  plane = Plane::YZ;
  modifiers.alt = true;
  drag({1.5, 1}, {1.5, 1.3});
  modifiers.alt = false;
  EXPECT_EQ(made().model.catalogId, "idap/solid-sphere");
  EXPECT_NEAR(made().position.y, 1.5, 1e-6);
  EXPECT_NEAR(made().position.z, 0.7, 1e-3);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(made().size[i], 0.6, 1e-3);
  plane = Plane::XY;
  click({1, 1});
  move({1.1, 1});
  type("25cm");
  key(Key::Enter);
  EXPECT_EQ(home().furniture.size(), 2u);
  EXPECT_NEAR(made().size.z, 0.5, 1e-9);
  EXPECT_NEAR(made().position.z, 0, 1e-9) << "it lies on the floor";
}

TEST_F(SolidTools, OutlineIsExtrudedAcrossEachPlane) {
  for (const Plane in : kPlanes) {
    SCOPED_TRACE(static_cast<int>(in));
    plane = in;
    editor.takeTool("solid-extrusion");
    modifiers.alt = true;
    click({1, 0.5});
    click({2, 0.5});
    click({2, 1});
    click({1, 1.5});
    modifiers.alt = false;
    key(Key::Enter);
    type("20cm");
    key(Key::Enter);
    const Furniture& piece = made();
    EXPECT_EQ(piece.model.catalogId, "idap/solid-extrusion");
    const auto outline = parametric::outlineFrom(piece.model.parameters);
    ASSERT_EQ(outline.size(), 4u);
    expectNear(outline[0], {0, 0});
    expectNear(outline[1], {1, 0});
    expectNear(outline[2], {1, 0.5});
    expectNear(outline[3], {0, 1});
    const Vec2 seen = project(in, piece.size);
    expectNear(seen, {1, 1});
    EXPECT_FALSE(document().inTransaction());
    editor.setTool(nullptr);
  }
  EXPECT_EQ(home().furniture.size(), 3u);
}

TEST_F(SolidTools, OutlineClosesAtItsFirstPointAndBackspaceTakesBack) {
  editor.takeTool("solid-extrusion");
  modifiers.alt = true;
  click({1, 1});
  click({2, 1});
  click({3.5, 2.5});
  modifiers.alt = false;
  key(Key::Backspace);
  modifiers.alt = true;
  click({2, 2});
  modifiers.alt = false;
  click({1.01, 1.01});
  EXPECT_TRUE(document().inTransaction());
  EXPECT_EQ(overlay().fields.size(), 1u);
  click({3, 2});  // anywhere
  EXPECT_EQ(home().furniture.size(), 1u);
  EXPECT_EQ(parametric::outlineFrom(made().model.parameters).size(), 3u);
  EXPECT_NEAR(made().size.x, 1, 1e-6);
  EXPECT_NEAR(made().size.z, 0.5, 1e-6);
  EXPECT_EQ(undoSteps(), 1);
}

TEST_F(SolidTools, ProfileIsTurnedAboutItsFirstPoint) {
  const Vec3 sizes[] = {{1, 0.8, 1}, {1, 1, 0.8}, {1, 1, 0.8}};
  for (const Plane in : kPlanes) {
    SCOPED_TRACE(static_cast<int>(in));
    plane = in;
    editor.takeTool("solid-turned");
    modifiers.alt = true;
    click({2, 1});
    click({2.5, 1});
    click({2.3, 1.8});
    modifiers.alt = false;
    EXPECT_FALSE(home().furniture.empty()) << "seen while it is drawn";
    key(Key::Enter);
    const Furniture& piece = made();
    EXPECT_EQ(piece.model.catalogId, "idap/solid-turned");
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(piece.size[i], sizes[static_cast<int>(in)][i], 1e-6);
    const auto profile = parametric::outlineFrom(piece.model.parameters);
    ASSERT_EQ(profile.size(), 3u);
    expectNear(profile[1], {1, 0});
    expectNear(profile[2], {0.6, 1});
    EXPECT_EQ(piece.model.parameters.at("axis"), in == Plane::XY ? 2 : 0);
    editor.setTool(nullptr);
  }
}

TEST_F(SolidTools, EscapeTakesBackWhatIsHalfDone) {
  const Home before = home();
  for (const char* id : {"solid-box", "solid-cylinder", "solid-sphere", "solid-extrusion", "solid-turned"}) {
    SCOPED_TRACE(id);
    editor.takeTool(id);
    modifiers.alt = true;
    click({1, 1});
    move({1.5, 1.5});
    modifiers.alt = false;
    key(Key::Escape);
    EXPECT_EQ(home(), before);
    EXPECT_FALSE(document().inTransaction());
    EXPECT_EQ(std::string(editor.tool().info().id), id) << "the tool stays for another try";
    key(Key::Escape);
    EXPECT_TRUE(editor.selecting());
  }
  EXPECT_FALSE(document().canUndo());
}

TEST_F(SolidTools, AProfileOnItsAxisIsRefusedWithAWord) {
  editor.takeTool("solid-turned");
  modifiers.alt = true;
  click({2, 1});
  click({2, 1.5});
  modifiers.alt = false;
  key(Key::Enter);
  EXPECT_TRUE(home().furniture.empty());
  EXPECT_FALSE(said.empty());
}

TEST_F(SolidTools, SolidsStandOnTheLevelThatIsDrawnOn) {
  Home two = home();
  Level ground, upper;
  upper.elevation = 2.8;
  const LevelId low = two.newId<LevelId>(), high = two.newId<LevelId>();
  two.levels.set(low, ground);
  two.levels.set(high, upper);
  editor.open(std::make_unique<Document>(two));
  editor.setLevel(high);
  editor.takeTool("solid-box");
  plane = Plane::XZ;
  modifiers.alt = true;
  drag({1, 3.0}, {2, 3.5});
  modifiers.alt = false;
  key(Key::Enter);
  EXPECT_EQ(made().level, high);
  EXPECT_NEAR(made().position.z, 0.2, 1e-6);
}

}  // namespace
}  // namespace idap
