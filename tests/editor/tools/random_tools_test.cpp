// Whatever is done with the tools in whatever order: the home stays valid, nothing half done is left behind,
// and undo leads back to where it began, redo to where it ended.
#include <random>

#include "editor/tools/place_tool.h"
#include "model/validate.h"
#include "tool_driver.h"

namespace idap {
namespace {

class RandomTools : public ToolDriver, public testing::WithParamInterface<unsigned> {};

TEST_P(RandomTools, UndoLeadsBack) {
  std::mt19937 random(GetParam());
  const auto upTo = [&random](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  openRoom(4, 3);
  const Home before = home();
  const char* const pieces[] = {"idap/bed-double",  "idap/night-table",    "idap/light-globe",
                                "idap/door-double", "idap/window-double",  "idap/table-dining",
                                "idap/vase",        "idap/stairs-straight"};
  const char* const typed[] = {"2", "3.5m", "120", "-1", "45", "(", "0", "1+", "90", "10'8\""};
  for (int i = 0; i < 400; ++i) {
    const Vec2 at{upTo(700) / 100.0 - 1.5, upTo(600) / 100.0 - 1.5};
    plane = upTo(6) == 0 ? kPlanes[static_cast<std::size_t>(upTo(3))] : Plane::XY;
    modifiers = {upTo(8) == 0, false, upTo(8) == 0};
    switch (upTo(16)) {
      case 0:
        editor.setTool(tools()[static_cast<std::size_t>(upTo(static_cast<int>(tools().size())))].make());
        break;
      case 1:
        editor.setTool(makePlaceTool(editor.catalog().find(pieces[upTo(8)]), upTo(2) == 0));
        break;
      case 2:
        placeAutomatically(editor, *editor.catalog().find(pieces[upTo(8)]), at);
        break;
      case 3:
        drag(at, {upTo(700) / 100.0 - 1.5, upTo(600) / 100.0 - 1.5});
        break;
      case 4:
        doubleClick(at);
        break;
      case 5:
        rightClick(at);
        break;
      case 6:
        leave();
        break;
      case 7:
        type(typed[upTo(10)]);
        break;
      case 8:
        key(std::array{Key::Enter, Key::Escape, Key::Tab, Key::BackTab,
                       Key::Backspace}[std::size_t(upTo(5))]);
        break;
      case 9:
        type("r");
        break;
      case 10:
        upTo(2) == 0 ? editor.undo() : editor.redo();
        break;
      default:
        upTo(3) == 0 ? move(at) : click(at);
    }
    ASSERT_NO_THROW(requireValid(home())) << "after event " << i;
    for (const Plane p : kPlanes) {
      const Overlay shown = editor.tool().overlay(editor, p, 0.01);
      for (const Handle& handle : shown.handles) ASSERT_TRUE(isFinite(handle.at));
    }
  }
  editor.takeTool("select");
  ASSERT_FALSE(document().inTransaction());
  const Home after = home();
  int steps = 0;
  while (document().canUndo()) {
    editor.document().undo();
    ++steps;
  }
  EXPECT_EQ(home(), before);
  for (int i = 0; i < steps; ++i) editor.document().redo();
  EXPECT_EQ(home(), after);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomTools, testing::Range(1u, 17u));

}  // namespace
}  // namespace idap
