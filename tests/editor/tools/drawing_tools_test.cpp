// Rooms, polylines, dimensions, labels, cameras, the eraser and the background's tools.
#include "editor/hit_test.h"
#include "editor/tools/calibrate_tool.h"
#include "model/room_geometry.h"
#include "tool_driver.h"

namespace idap {
namespace {

using DrawingTools = ToolDriver;

TEST_F(DrawingTools, EveryToolSaysWhatItIs) {
  for (const ToolEntry& entry : tools()) {
    const auto tool = entry.make();
    EXPECT_EQ(&tool->info(), entry.info);
    EXPECT_NE(std::string(entry.info->id), "");
    EXPECT_NE(std::string(entry.info->name), "");
    EXPECT_NE(std::string(entry.info->tip), "");
    EXPECT_NE(std::string(entry.info->shortcut), "") << entry.info->id;
    EXPECT_FALSE(tool->hint().empty());
  }
}

TEST_F(DrawingTools, NothingHalfDoneStaysWhenAToolIsPutAway) {
  openRoom(4, 3);
  const Home before = home();
  for (const ToolEntry& entry : tools()) {
    if (std::string(entry.info->id) == "select") continue;
    editor.setTool(entry.make());
    move({1, 1});
    if (std::string(entry.info->id) == "wall" || std::string(entry.info->id) == "room" ||
        std::string(entry.info->id) == "polyline" || std::string(entry.info->id) == "dimension")
      click({1, 1});
    move({2, 2.5});
    editor.takeTool("select");
    EXPECT_EQ(home(), before) << entry.info->id;
    EXPECT_FALSE(document().canUndo()) << entry.info->id;
  }
}

TEST_F(DrawingTools, DrawsARoomPointByPoint) {
  const Home before = home();
  editor.takeTool("room");
  click({0, 0});
  move({1, 0});
  type("4m");
  key(Key::Enter);
  click({4, 3});
  click({0, 3});
  click({0.02, 0.03});
  ASSERT_EQ(home().rooms.size(), 1u);
  EXPECT_NEAR(floorArea(newest(home().rooms)), 12, 1e-6);
  EXPECT_EQ(editor.selection().rooms.size(), 1u);
  EXPECT_EQ(undoSteps(), 1);
  editor.undo();
  EXPECT_EQ(home(), before);
}

TEST_F(DrawingTools, DoubleClickClosesARoom) {
  editor.takeTool("room");
  click({0, 0});
  click({4, 0});
  doubleClick({4, 3});
  ASSERT_EQ(home().rooms.size(), 1u);
  EXPECT_NEAR(floorArea(newest(home().rooms)), 6, 1e-6);
}

TEST_F(DrawingTools, DoubleClickFillsWalls) {
  openRoom(4, 3);
  editor.takeTool("room");
  move({2, 1});
  EXPECT_EQ(overlay().shapes.size(), 1u) << "shows the area before";
  doubleClick({2, 1});
  ASSERT_EQ(home().rooms.size(), 1u);
  EXPECT_NEAR(floorArea(newest(home().rooms)), 12, 1e-3);
  doubleClick({2, 1.5});
  EXPECT_EQ(home().rooms.size(), 1u) << "not twice";
  doubleClick({9, 9});
  EXPECT_EQ(home().rooms.size(), 1u);
  EXPECT_EQ(said.size(), 2u);
}

TEST_F(DrawingTools, BackspaceTakesACornerBack) {
  editor.takeTool("room");
  click({0, 0});
  click({4, 0});
  click({6, 6});
  key(Key::Backspace);
  click({4, 3});
  key(Key::Enter);
  ASSERT_EQ(home().rooms.size(), 1u);
  EXPECT_NEAR(floorArea(newest(home().rooms)), 6, 1e-6);
}

TEST_F(DrawingTools, DrawsOpenAndClosedPolylines) {
  editor.takeTool("polyline");
  click({0, 0});
  click({2, 0});
  doubleClick({2, 2});
  ASSERT_EQ(home().polylines.size(), 1u);
  EXPECT_FALSE(newest(home().polylines).closed);
  EXPECT_EQ(newest(home().polylines).points.size(), 3u);
  click({5, 0});
  click({7, 0});
  click({7, 2});
  click({5, 0});
  ASSERT_EQ(home().polylines.size(), 2u);
  EXPECT_TRUE(newest(home().polylines).closed);
  EXPECT_EQ(newest(home().polylines).points.size(), 3u);
}

TEST_F(DrawingTools, MeasuresBetweenFacesOfWalls) {
  openRoom(4, 3);
  editor.takeTool("dimension");
  click({0.02, 1.5});
  click({3.97, 1.5});
  move({2, 1.9});
  EXPECT_TRUE(document().inTransaction());
  click({2, 1.9});
  ASSERT_EQ(home().dimensions.size(), 1u);
  const Dimension& line = newest(home().dimensions);
  EXPECT_NEAR(length(line.end - line.start), 4, 1e-6);
  EXPECT_NEAR(line.offset, 0.4, 1e-6);
  EXPECT_EQ(editor.selection().dimensions.size(), 1u);
  EXPECT_EQ(undoSteps(), 1);
}

TEST_F(DrawingTools, OffsetOfADimensionCanBeTyped) {
  editor.takeTool("dimension");
  click({0, 0});
  click({2, 0});
  move({1, -1});
  type("-0.6");
  EditorSettings settings;
  settings.unit = LengthUnit::Metre;
  key(Key::Escape);
  editor.setSettings(settings);
  type("-0.6");
  key(Key::Enter);
  ASSERT_EQ(home().dimensions.size(), 1u);
  EXPECT_NEAR(newest(home().dimensions).offset, -0.6, 1e-9);
}

TEST_F(DrawingTools, MeasuresHeightsInTheUprightPlanes) {
  openRoom(4, 3);
  editor.takeTool("dimension");
  plane = Plane::XZ;
  modifiers.alt = true;
  click({1, 0});
  click({1.1, 2.5});
  click({1.6, 1});
  ASSERT_EQ(home().dimensions.size(), 1u);
  const Dimension& line = newest(home().dimensions);
  expectNear(line.start, line.end);
  EXPECT_NEAR(line.endElevation - line.startElevation, 2.5, 1e-9);
  EXPECT_NEAR(std::abs(line.offset), 0.6, 1e-9);
}

TEST_F(DrawingTools, WritesALabel) {
  const Home before = home();
  editor.takeTool("label");
  click({1, 2});
  EXPECT_EQ(home(), before) << "an empty text is none";
  EXPECT_TRUE(type("Kitchen 2"));
  EXPECT_EQ(newest(home().labels).text, "Kitchen 2") << "shown as it is written";
  key(Key::Enter);
  ASSERT_EQ(home().labels.size(), 1u);
  expectNear(newest(home().labels).position, {1, 2});
  EXPECT_EQ(editor.selection().labels.size(), 1u);
  EXPECT_EQ(undoSteps(), 1);
  editor.undo();
  EXPECT_EQ(home(), before);
}

TEST_F(DrawingTools, AClickElsewhereKeepsTheLabelAndBeginsTheNext) {
  editor.takeTool("label");
  click({1, 2});
  type("a");
  click({3, 2});
  EXPECT_EQ(home().labels.size(), 1u);
  type("b");
  editor.takeTool("select");
  EXPECT_EQ(home().labels.size(), 2u) << "what was typed stays when another tool is taken";
}

TEST_F(DrawingTools, EscapeDropsALabel) {
  const Home before = home();
  editor.takeTool("label");
  click({1, 2});
  type("abc");
  key(Key::Escape);
  EXPECT_EQ(home(), before);
  EXPECT_FALSE(editor.selecting());
}

TEST_F(DrawingTools, PutsACameraAndAimsIt) {
  editor.takeTool("camera");
  drag({1, 1}, {1, 4});
  ASSERT_EQ(home().cameras.size(), 1u);
  const Camera& camera = newest(home().cameras);
  EXPECT_EQ(camera.name, "View 1");
  EXPECT_NEAR(camera.eye.z, 1.6, 1e-12);
  EXPECT_NEAR(viewDirection(camera).y, 1, 1e-9);
  EXPECT_TRUE(editor.selecting()) << "one camera at a time";
  EXPECT_EQ(editor.selection().cameras.size(), 1u);
  editor.takeTool("camera");
  click({2, 2});
  move({5, 2});
  click({5, 2});
  ASSERT_EQ(home().cameras.size(), 2u);
  EXPECT_EQ(newest(home().cameras).name, "View 2");
  EXPECT_NEAR(viewDirection(newest(home().cameras)).x, 1, 1e-9);
  EXPECT_EQ(undoSteps(), 2);
}

TEST_F(DrawingTools, EyeHeightCanBeTyped) {
  editor.takeTool("camera");
  press({1, 1});
  release({1, 1});
  move({1, 3});
  type("110");  // centimetres
  key(Key::Enter);
  EXPECT_NEAR(newest(home().cameras).eye.z, 1.1, 1e-12);
  key(Key::Enter);
  EXPECT_TRUE(editor.selecting());
  EXPECT_NEAR(newest(home().cameras).eye.z, 1.1, 1e-12);
}

TEST_F(DrawingTools, CamerasInUprightPlanesLookUpAndDown) {
  plane = Plane::XZ;
  modifiers.alt = true;
  editor.takeTool("camera");
  drag({1, 1.5}, {3, 0.5});
  const Camera& camera = newest(home().cameras);
  EXPECT_NEAR(camera.eye.x, 1, 1e-9);
  EXPECT_NEAR(camera.eye.z, 1.5, 1e-9);
  const Vec3 direction = viewDirection(camera);
  EXPECT_NEAR(direction.z / direction.x, -0.5, 1e-9);
  EXPECT_NEAR(direction.y, 0, 1e-9);
}

TEST_F(DrawingTools, ErasesWhatIsClicked) {
  openRoom(4, 3);
  const Home before = home();
  editor.takeTool("eraser");
  move({2, -0.05});
  ASSERT_EQ(overlay().shapes.size(), 1u) << "shows what would go";
  click({2, -0.05});
  EXPECT_EQ(home().walls.size(), 3u);
  click({2, 1.5});
  EXPECT_EQ(home().walls.size(), 3u) << "nothing there";
  EXPECT_EQ(undoSteps(), 1);
  editor.undo();
  EXPECT_EQ(home(), before);
}

TEST_F(DrawingTools, DraggingTheEraserIsOneStep) {
  openRoom(4, 3);
  const Home before = home();
  editor.takeTool("eraser");
  drag({2, -1}, {2, 5});
  EXPECT_EQ(home().walls.size(), 2u);
  EXPECT_EQ(undoSteps(), 1);
  editor.undo();
  EXPECT_EQ(home(), before);
  move({2, -1});
  press({2, -0.05});
  EXPECT_EQ(home().walls.size(), 3u);
  key(Key::Escape);
  EXPECT_EQ(home(), before) << "taken back while the button is held";
}

TEST_F(DrawingTools, CalibratesTheBackground) {
  Home scanned;
  scanned.backgrounds[{}] = {"plan.png", 0.01, {1, 5}, true};
  scanned.assets = std::make_shared<const Assets>(Assets{{"plan.png", std::make_shared<const Bytes>(4)}});
  editor.open(std::make_unique<Document>(scanned));
  editor.setTool(makeCalibrateTool({}));
  click({2, 3});
  click({4, 3});
  type("5m");
  key(Key::Enter);
  const Background& background = home().backgrounds.at({});
  EXPECT_NEAR(background.scale, 0.025, 1e-12);
  expectNear(background.origin, {-0.5, 8});  // (2, 3) is the same point of the picture
  EXPECT_TRUE(editor.selecting());
  EXPECT_EQ(undoSteps(), 1);

  editor.setTool(makeMoveBackgroundTool({}));
  modifiers.alt = true;
  drag({0, 0}, {1, 2});
  expectNear(home().backgrounds.at({}).origin, {0.5, 10});
  EXPECT_EQ(undoSteps(), 2);
}

}  // namespace
}  // namespace idap
