// The window: what is on it, its actions, its views, its languages.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QStackedWidget>
#include <QTabBar>
#include <QToolBar>
#include <QToolButton>
#include <set>

#include "editor/selection.h"
#include "gui/window/window_fixture.h"
#include "model/edits/piece_edits.h"
#include "studio/picture/picture_panel.h"
#include "studio/plan/plan_view.h"
#include "studio/window/hint_line.h"
#include "studio/window/language.h"

namespace idap::test {
namespace {

class MainWindowTest : public WindowTest {};

TEST_F(MainWindowTest, BeginsWithTheWelcomePage) {
  EXPECT_TRUE(find<QWidget>("welcomePage")->isVisible());
  EXPECT_FALSE(window().files().isOpen());
  for (const char* id : {"save", "undo", "tool-wall", "print", "delete"})
    EXPECT_FALSE(action(id)->isEnabled()) << id;
  for (const char* id : {"new", "open", "quit", "preferences", "keys", "about"})
    EXPECT_TRUE(action(id)->isEnabled()) << id;
  shoot(window(), "welcome");
}

TEST_F(MainWindowTest, ANewRoomIsTypedIntoTheWelcomePage) {
  auto* x = find<QLineEdit>("roomX");
  ASSERT_TRUE(x);
  x->setFocus();
  x->selectAll();
  QTest::keyClicks(x, "4m");
  auto* y = find<QLineEdit>("roomY");
  QTest::keyClick(x, Qt::Key_Tab);
  EXPECT_TRUE(y->hasFocus());
  y->selectAll();
  QTest::keyClicks(y, "300+20");
  QTest::keyClick(y, Qt::Key_Tab);
  EXPECT_TRUE(find<QLineEdit>("roomZ")->hasFocus());
  QTest::keyClick(find<QLineEdit>("roomZ"), Qt::Key_Tab);
  EXPECT_EQ(QApplication::focusWidget()->objectName(), "startRoom");
  QTest::keyClick(find<QPushButton>("startRoom"), Qt::Key_Return);
  ASSERT_TRUE(window().files().isOpen());
  const Home& home = editor().home();
  EXPECT_EQ(home.walls.size(), 4u);
  ASSERT_EQ(home.rooms.size(), 1u);
  Box2 box;
  for (const Vec2 p : home.rooms.begin()->second->points) box.add(p);
  EXPECT_NEAR(box.max.x - box.min.x, 4, 1e-9);
  EXPECT_NEAR(box.max.y - box.min.y, 3.2, 1e-9);
  EXPECT_NEAR(home.wallHeight, 2.5, 1e-9);
  // Time to furnish: the catalog waits for a word, and the hint says what to do.
  EXPECT_TRUE(window().findChild<QWidget*>("catalogPanel")->isVisible());
  EXPECT_TRUE(window().findChild<QWidget*>("catalogPanel")->isAncestorOf(window().focusWidget()));
  EXPECT_TRUE(window().findChild<HintLine*>()->text().contains("catalog"));
  shoot(window(), "new_room");
}

TEST_F(MainWindowTest, TheTenCommandsAreSeenInBothLanguages) {
  newRoom();
  const QStringList ten{"New",       "Load", "Save",   "Point", "Property",
                        "Ray Trace", "Text", "Eraser", "Print", "Quit"};
  auto* bar = window().findChild<QToolBar*>("commandBar");
  ASSERT_TRUE(bar);
  for (const char* language : {"en", "th"}) {
    EditorSettings settings = editor().settings();
    settings.language = language;
    editor().setSettings(settings);
    QTest::qWait(50);
    ASSERT_EQ(bar->actions().size(), ten.size());
    for (int i = 0; i < ten.size(); ++i) {
      QAction* one = bar->actions()[i];
      if (language == std::string("en")) {
        EXPECT_EQ(one->iconText(), ten[i]);
      }
      auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(one));
      ASSERT_TRUE(button);
      EXPECT_TRUE(button->isVisible()) << one->iconText().toStdString() << " in " << language;
      EXPECT_EQ(button->toolButtonStyle(), Qt::ToolButtonTextUnderIcon);
      EXPECT_FALSE(one->icon().isNull()) << one->iconText().toStdString();
    }
    auto* tools = window().findChild<QToolBar*>("toolBar");
    for (QAction* one : tools->actions())
      EXPECT_TRUE(one->isSeparator() || tools->widgetForAction(one)->isVisible())
          << one->iconText().toStdString() << " in " << language;
    EXPECT_LE(window().width(), 1280);
    shoot(window(), (std::string("window_") + language).c_str());
  }
}

TEST_F(MainWindowTest, NoTwoActionsShareAShortcut) {
  std::map<QString, std::string> taken;
  for (const auto& [id, one] : window().actions().all())
    for (const QKeySequence& keys : one->shortcuts()) {
      const auto [place, fresh] = taken.emplace(keys.toString(), id);
      EXPECT_TRUE(fresh) << keys.toString().toStdString() << ": " << id << " and " << place->second;
    }
}

TEST_F(MainWindowTest, EveryActionHasWordsATipAndAPlace) {
  std::set<QAction*> placed;
  std::function<void(const QMenu*)> walk = [&](const QMenu* menu) {
    EXPECT_FALSE(menu->title().isEmpty());
    for (QAction* one : menu->actions()) {
      placed.insert(one);
      if (one->menu()) walk(one->menu());
    }
  };
  for (QAction* top : window().menuBar()->actions()) walk(top->menu());
  for (QToolBar* bar : window().findChildren<QToolBar*>())
    for (QAction* one : bar->actions()) placed.insert(one);
  for (const auto& [id, one] : window().actions().all()) {
    EXPECT_FALSE(one->text().isEmpty()) << id;
    EXPECT_FALSE(one->toolTip().isEmpty()) << id;
    EXPECT_FALSE(one->statusTip().isEmpty()) << id;
    EXPECT_TRUE(placed.count(one)) << id << " is in no menu";
  }
}

// Whatever state the home is in, no action may break the window.
TEST_F(MainWindowTest, EveryActionCanBeTriggered) {
  newRoom();
  put("idap/chair-windsor", {1, 1});
  put("idap/chair-windsor", {2, 1});
  const std::set<std::string> leaving{"quit", "close", "new-window"};
  for (const bool selected : {false, true}) {
    for (const auto& [id, one] : window().actions().all()) {
      if (leaving.count(id)) continue;
      if (selected) editor().select(everything(editor().home(), editor().level()));
      window().actions().refresh();
      if (one->isEnabled()) one->trigger();
      for (QWidget* top : QApplication::topLevelWidgets())
        if (auto* dialog = qobject_cast<QDialog*>(top); dialog && dialog->isVisible()) dialog->close();
      QCoreApplication::processEvents();
      EXPECT_TRUE(window().isVisible()) << id;
    }
    editor().takeTool("select");
  }
}

TEST_F(MainWindowTest, UndoAndRedoNameTheirStep) {
  newRoom();
  EXPECT_FALSE(action("undo")->isEnabled());
  put("idap/chair-windsor", {1, 1});
  EXPECT_TRUE(waitFor([&] { return action("undo")->text().contains("Add"); }));
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(editor().home().furniture.size(), 0u);
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(editor().home().furniture.size(), 1u);
}

TEST_F(MainWindowTest, UndoMeansTheHomeAlsoInTheSearchField) {
  newRoom();
  window().activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window()));
  QTest::keyClick(&window(), Qt::Key_F, Qt::ControlModifier);
  auto* search = qobject_cast<QLineEdit*>(QApplication::focusWidget());
  ASSERT_TRUE(search);
  QTest::keyClicks(search, "armchair");
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_EQ(editor().home().furniture.size(), 1u);
  QTest::keyClick(search, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(editor().home().furniture.size(), 0u);
  EXPECT_EQ(search->text(), QStringLiteral("armchair"));
  QTest::keyClick(search, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(editor().home().furniture.size(), 1u);
}

TEST_F(MainWindowTest, ThePictureIsTakenFromThePointOfViewChosenBesideIt) {
  newRoom();
  editor().apply("Camera", [](const Home& home) {
    Home next = home;
    Camera camera;
    camera.name = "Door";
    camera.eye = {2, 0.5, 1.6};
    next.cameras.set(next.newId<CameraId>(), camera);
    return next;
  });
  auto* points = window().views().picture().findChild<QComboBox*>("camera");
  ASSERT_TRUE(points);
  ASSERT_EQ(points->count(), 2);
  points->setFocus();
  QTest::keyClick(points, Qt::Key_Down);
  EXPECT_EQ(points->currentText(), QStringLiteral("Door"));
  trigger("ray-trace");
  EXPECT_TRUE(window().views().picture().busy());
  EXPECT_EQ(points->currentText(), QStringLiteral("Door"));
  window().views().picture().stop();
}

TEST_F(MainWindowTest, ToolsAreTakenInHandByKeyAndButton) {
  newRoom();
  window().views().plan(Plane::XY).setFocus();
  for (const ToolEntry& tool : tools()) {
    const std::string id = std::string("tool-") + tool.info->id;
    trigger(id.c_str());
    EXPECT_EQ(editor().tool().info().id, std::string(tool.info->id));
    EXPECT_TRUE(action(id.c_str())->isChecked());
    EXPECT_TRUE(window().findChild<HintLine*>()->text().contains(QString::fromUtf8(tool.info->name)));
  }
  trigger("tool-select");
  auto* wall = window().findChild<QToolButton*>("tool-wallButton");
  ASSERT_TRUE(wall);
  QTest::mouseClick(wall, Qt::LeftButton);
  EXPECT_EQ(editor().tool().info().id, std::string("wall"));
  EXPECT_TRUE(wall->isChecked());
}

TEST_F(MainWindowTest, TheEraserDeletesWhatIsSelectedAndIsATool) {
  newRoom();
  const FurnitureId chair = put("idap/chair-windsor", {1, 1});
  editor().select(only(chair));
  trigger("eraser");
  EXPECT_EQ(editor().home().furniture.size(), 0u);
  trigger("eraser");
  EXPECT_EQ(editor().tool().info().id, std::string("eraser"));
}

TEST_F(MainWindowTest, AViewFillsTheMiddleByItsKeyAndGivesItBack) {
  newRoom();
  ViewArea& views = window().views();
  const Qt::Key keys[] = {Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_4};
  for (int i = 0; i < ViewArea::kViews; ++i) {
    QTest::keyClick(&window(), keys[i], Qt::ControlModifier);
    for (int j = 0; j < ViewArea::kViews; ++j) EXPECT_EQ(views.view(j)->isVisible(), i == j) << i << j;
    QTest::keyClick(&window(), Qt::Key_0, Qt::ControlModifier);
    for (int j = 0; j < ViewArea::kViews; ++j) EXPECT_TRUE(views.view(j)->isVisible()) << i << j;
  }
  views.plan(Plane::XZ).setFocus();
  QTest::keyClick(&window(), Qt::Key_F11);
  EXPECT_EQ(views.maximised(), 1);
  QTest::keyClick(&window(), Qt::Key_F11);
  EXPECT_EQ(views.maximised(), ViewArea::kAll);
}

TEST_F(MainWindowTest, LevelsHaveTabsAndAButtonThatAddsOne) {
  newRoom();
  auto* tabs = window().findChild<QTabBar*>("levels");
  ASSERT_TRUE(tabs);
  EXPECT_EQ(tabs->count(), 1);
  QTest::mouseClick(window().findChild<QToolButton*>("addLevel"), Qt::LeftButton);
  EXPECT_EQ(tabs->count(), 2);
  EXPECT_EQ(editor().home().levels.size(), 2u);
  EXPECT_EQ(tabs->currentIndex(), 1);
  QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(0).center());
  EXPECT_EQ(elevationOf(editor().home(), editor().level()), 0);
  editor().undo();
  EXPECT_EQ(tabs->count(), 1);
}

TEST_F(MainWindowTest, TheLanguageIsSwitchedWhileItRuns) {
  newRoom();
  EditorSettings settings = editor().settings();
  settings.language = "th";
  editor().setSettings(settings);
  EXPECT_EQ(window().preferences().language(), QStringLiteral("th"));
  QTest::qWait(20);
  EXPECT_NE(action("save")->iconText(), QStringLiteral("Save"));
  EXPECT_FALSE(action("save")->iconText().isEmpty());
  settings.language = "en";
  editor().setSettings(settings);
  QTest::qWait(20);
  EXPECT_EQ(action("save")->iconText(), QStringLiteral("Save"));
}

TEST_F(MainWindowTest, StatusBarTellsSelectionAndPointer) {
  newRoom();
  const FurnitureId chair = put("idap/chair-windsor", {1, 1});
  editor().select(only(chair));
  auto* selection = window().findChild<QLabel*>("selection");
  EXPECT_TRUE(waitFor([&] { return selection->text().contains("×"); }));
  PlanView& plan = window().views().plan(Plane::XY);
  QTest::mouseMove(&plan, plan.toView({2, 1}).toPoint());
  EXPECT_TRUE(waitFor([&] { return window().findChild<QLabel*>("pointer")->text().contains("X"); }));
  EXPECT_TRUE(window().findChild<QLabel*>("zoom")->text().startsWith("1:"));
}

TEST_F(MainWindowTest, TheLayoutIsKeptBetweenStarts) {
  newRoom();
  trigger("panel-lists");
  EXPECT_FALSE(window().findChild<QWidget*>("listDock")->isVisible());
  editor().document().markSaved({});
  window().close();
  window_ = makeWindow();
  newRoom();
  EXPECT_FALSE(window().findChild<QWidget*>("listDock")->isVisible());
  EXPECT_TRUE(window().findChild<QWidget*>("catalogDock")->isVisible());
  trigger("panel-lists");
}

TEST_F(MainWindowTest, WhatIsCopiedInOneWindowIsPastedInAnother) {
  newRoom();
  editor().select(only(put("idap/chair-windsor", {1, 1})));
  QTest::keyClick(&window(), Qt::Key_C, Qt::ControlModifier);
  const auto other = makeWindow();
  other->files().newRoom(3, 3, 2.5);
  other->actions().refresh();
  other->actions().get("paste")->trigger();
  ASSERT_EQ(other->editor().home().furniture.size(), 1u);
  EXPECT_EQ(count(other->editor().selection()), 1u);
  // In place: exactly where the original is.
  other->editor().select({});
  other->actions().get("paste-in-place")->trigger();
  ASSERT_EQ(other->editor().home().furniture.size(), 2u);
  const Furniture& copy = *other->editor().home().furniture.find(other->editor().selection().furniture[0]);
  EXPECT_NEAR(copy.position.x, 1, 1e-9);
  EXPECT_NEAR(copy.position.y, 1, 1e-9);
  other->editor().document().markSaved({});
}

TEST_F(MainWindowTest, CutLeavesWhatIsLocked) {
  newRoom();
  const FurnitureId locked = put("idap/chair-windsor", {1, 1}), free = put("idap/chair-windsor", {2, 1});
  editor().apply("Lock", [&](const Home& home) {
    return changeFurniture(home, only(locked), [](Furniture& piece) { piece.locked = true; });
  });
  Elements both;
  add(both, locked), add(both, free);
  editor().select(both);
  trigger("cut");
  EXPECT_TRUE(editor().home().furniture.contains(locked));
  EXPECT_FALSE(editor().home().furniture.contains(free));
}

TEST_F(MainWindowTest, CutTakesAwayInOneStepAndStyleIsPasted) {
  newRoom();
  const FurnitureId first = put("idap/chair-windsor", {1, 1}), second = put("idap/chair-windsor", {2, 1});
  editor().apply("Paint", [&](const Home& home) {
    return changeFurniture(home, only(first), [](Furniture& piece) { piece.finish = plain(Color{1, 0, 0}); });
  });
  editor().select(only(first));
  trigger("cut");
  EXPECT_EQ(editor().home().furniture.size(), 1u);
  editor().select(only(second));
  trigger("paste-style");
  EXPECT_EQ(editor().home().furniture.find(second)->finish, plain(Color{1, 0, 0}));
  editor().undo();
  editor().undo();
  EXPECT_EQ(editor().home().furniture.size(), 2u);
}

}  // namespace
}  // namespace idap::test
