// Solids drawn with the mouse in the three planes of a real window.
#include <QMenu>
#include <QToolButton>

#include "gui/window/window_fixture.h"
#include "studio/plan/plan_view.h"

namespace idap {
namespace {

class SolidToolsTest : public test::WindowTest {
 protected:
  PlanView& plan(Plane plane) { return window().views().plan(plane); }
  QPoint at(Plane in, Vec2 metres) { return plan(in).toView(metres).toPoint(); }

  void drag(Plane in, Vec2 from, Vec2 to) {
    PlanView& view = plan(in);
    view.setFocus();
    QTest::mouseMove(&view, at(in, from));
    QTest::mousePress(&view, Qt::LeftButton, {}, at(in, from));
    for (int i = 1; i <= 4; ++i) QTest::mouseMove(&view, at(in, from + (to - from) * (i / 4.0)));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, at(in, to));
  }
  void click(Plane in, Vec2 where) {
    PlanView& view = plan(in);
    QTest::mouseMove(&view, at(in, where));
    QTest::mouseClick(&view, Qt::LeftButton, {}, at(in, where));
  }
  void type(Plane in, const char* text) {
    QTest::keyClicks(&plan(in), QLatin1String(text));
    QTest::keyClick(&plan(in), Qt::Key_Return);
  }
  const Furniture& made() {
    const Furniture* last = nullptr;
    for (const auto& [id, piece] : editor().home().furniture) last = piece.get();
    return *last;
  }
};

TEST_F(SolidToolsTest, ABoxIsDrawnInThePlan) {
  newRoom();
  trigger("tool-solid-box");
  drag(Plane::XY, {1, 1}, {2, 2});
  test::shoot(window(), "solid-box-height");
  type(Plane::XY, "80");
  ASSERT_EQ(editor().home().furniture.size(), 1u);
  EXPECT_NEAR(made().size.x, 1, 0.1);
  EXPECT_NEAR(made().size.y, 1, 0.1);
  EXPECT_NEAR(made().size.z, 0.8, 1e-6);
  trigger("undo");
  EXPECT_TRUE(editor().home().furniture.empty());
}

TEST_F(SolidToolsTest, ACylinderIsDrawnInTheFrontView) {
  newRoom();
  trigger("tool-solid-cylinder");
  drag(Plane::XZ, {1, 0.5}, {2, 1.5});
  type(Plane::XZ, "30");
  ASSERT_EQ(editor().home().furniture.size(), 1u);
  EXPECT_NEAR(made().size.x, 1, 0.1);
  EXPECT_NEAR(made().size.y, 0.3, 1e-6);
  EXPECT_NEAR(made().size.z, 1, 0.1);
  EXPECT_NEAR(made().position.z, 0.5, 0.1);
}

TEST_F(SolidToolsTest, AVaseIsTurnedInTheSideView) {
  newRoom();
  trigger("tool-solid-turned");
  plan(Plane::YZ).setFocus();
  for (const Vec2 point : {Vec2{2, 0.5}, {2.3, 0.5}, {2.5, 1.1}, {2.2, 1.5}, {2.3, 1.8}})
    click(Plane::YZ, point);
  test::shoot(window(), "solid-turned-drawing");
  QTest::keyClick(&plan(Plane::YZ), Qt::Key_Return);
  ASSERT_EQ(editor().home().furniture.size(), 1u);
  EXPECT_EQ(made().model.catalogId, "idap/solid-turned");
  EXPECT_NEAR(made().size.z, 1.3, 0.15);
  EXPECT_NEAR(made().position.y, 2, 0.1);
}

TEST_F(SolidToolsTest, OneButtonHoldsTheFiveAndShowsTheLast) {
  newRoom();
  auto* button = window().findChild<QToolButton*>("solidButton");
  ASSERT_TRUE(button);
  EXPECT_EQ(button->menu()->actions().size(), 5);
  EXPECT_FALSE(button->icon().isNull());
  QTest::mouseClick(button, Qt::LeftButton, {}, QPoint(8, button->height() / 2));
  EXPECT_EQ(editor().tool().info().id, std::string("solid-box"));
  trigger("tool-solid-sphere");
  EXPECT_EQ(button->defaultAction(), action("tool-solid-sphere"));
  EXPECT_TRUE(button->isChecked());
  auto* menu = window().findChild<QMenu*>("solidMenu");
  ASSERT_TRUE(menu);
  EXPECT_EQ(menu->actions().size(), 5);
}

}  // namespace
}  // namespace idap
