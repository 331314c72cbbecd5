// Shows every view, dialog and state of the studio once and saves a picture of each, to be looked at by a
// person: screenshots FOLDER LANGUAGE light|dark. dev/screenshots runs it in both languages and scales.
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QTabWidget>
#include <QTemporaryDir>

#include "editor/tools/place_tool.h"
#include "gui/screenshots/showing_pictures.h"
#include "studio/picture/picture_panel.h"

namespace idap {
namespace {

class Everything : public ShowingPictures {
 public:
  using ShowingPictures::ShowingPictures;

  void all() {
    shoot("welcome");
    openSample();
    shoot("main");
    views();
    selections();
    drags();
    tools();
    lists();
    menus();
    dialogs();
    picture();
    liveView();
    sheets();
    ownFurniture();
    pictureWindow();
    filmWindow();
    questions();
  }

  // Only what differs with the theme.
  void some() {
    shoot("welcome");
    openSample();
    select("idap/sofa-three");
    shoot("main");
    dialog("preferences");
  }

 private:
  QPoint at(Plane plane, Vec2 where) { return plan(plane).toView(where).toPoint(); }
  void move(Vec2 where) {
    QTest::mouseMove(&plan(Plane::XY), at(Plane::XY, where));
    QTest::qWait(20);
  }
  void click(Vec2 where) {
    move(where);
    QTest::mouseClick(&plan(Plane::XY), Qt::LeftButton, {}, at(Plane::XY, where));
  }

  void views() {
    const char* names[] = {"view-xy", "view-xz", "view-yz", "view-picture"};
    for (int k = 0; k < ViewArea::kViews; ++k) {
      window_->views().maximise(k);
      QTest::qWait(200);
      trigger("zoom-fit");
      shoot(names[k]);
    }
    window_->views().maximise(ViewArea::kAll);
    QTest::qWait(200);
    window_->views().zoomAllToFit();
  }

  void selections() {
    const Home& home = editor().home();
    const auto shootSelected = [&](const char* name, const std::function<void(Elements&)>& fill) {
      Elements chosen;
      fill(chosen);
      editor().select(chosen);
      shoot(name);
    };
    shootSelected("selected-piece",
                  [&](Elements& e) { e.furniture.push_back(piece("idap/bed-upholstered")); });
    shootSelected("selected-lamp", [&](Elements& e) { e.furniture.push_back(piece("idap/light-tripod")); });
    shootSelected("selected-pieces", [&](Elements& e) {
      e.furniture.push_back(piece("idap/sofa-three"));
      e.furniture.push_back(piece("idap/table-coffee"));
    });
    shootSelected("selected-wall", [&](Elements& e) { e.walls.push_back(home.walls.begin()->first); });
    shootSelected("selected-room", [&](Elements& e) { e.rooms.push_back(home.rooms.begin()->first); });
    shootSelected("selected-door", [&](Elements& e) { e.openings.push_back(home.openings.begin()->first); });
    shootSelected("selected-camera", [&](Elements& e) { e.cameras.push_back(home.cameras.begin()->first); });
    trigger("select-all");
    shoot("selected-all");
    editor().select({});
  }

  void drags() {
    const FurnitureId sofa = piece("idap/sofa-three");
    const Vec3 p = editor().home().furniture.find(sofa)->position;
    click({p.x, p.y});
    QTest::mousePress(&plan(Plane::XY), Qt::LeftButton, {}, at(Plane::XY, {p.x, p.y}));
    move({p.x + 0.3, p.y + 0.15});
    move({p.x + 0.5, p.y + 0.3});
    shoot("drag-move");
    QTest::keyClick(&plan(Plane::XY), Qt::Key_Escape);
    QTest::mouseRelease(&plan(Plane::XY), Qt::LeftButton, {}, at(Plane::XY, {p.x, p.y}));
    editor().select({});
    QTest::mousePress(&plan(Plane::XY), Qt::LeftButton, {}, at(Plane::XY, {-1, -1}));
    move({2, 2});
    move({3, 3});
    shoot("drag-rectangle");
    QTest::mouseRelease(&plan(Plane::XY), Qt::LeftButton, {}, at(Plane::XY, {3, 3}));
    editor().select({});
  }

  void tools() {
    const auto inHand = [&](const char* id, const std::vector<Vec2>& clicks, Vec2 then, const char* typed) {
      trigger(id);
      for (const Vec2 where : clicks) click(where);
      move(then);
      if (*typed) QTest::keyClicks(&plan(Plane::XY), QLatin1String(typed));
      shoot(id);
      QTest::keyClick(&plan(Plane::XY), Qt::Key_Escape);
      QTest::keyClick(&plan(Plane::XY), Qt::Key_Escape);
      editor().setTool(nullptr);
    };
    inHand("tool-wall", {{-2, -2}, {2, -2}}, {2, -0.8}, "");
    inHand("tool-room", {{-3, 0}, {-1, 0}}, {-1, 2}, "");
    inHand("tool-door", {}, {3, 0}, "");
    inHand("tool-window", {}, {0, 3.8}, "");
    inHand("tool-opening", {}, {5.2, 4.6}, "");
    inHand("tool-dimension", {{0.15, 0.15}, {5.15, 0.15}}, {3, -0.6}, "");
    inHand("tool-polyline", {{-2, 0}, {-1, 2}}, {-2, 3}, "");
    inHand("tool-solid-box", {{-2, 0}, {-1, 1}}, {-1, 2}, "");
    inHand("tool-solid-extrusion", {{-3, 0}, {-1, 0}, {-1, 1}}, {-2, 2}, "");
    inHand("tool-label", {{2, 5}}, {2.2, 5}, "Sofa");
    inHand("tool-camera", {}, {2, 3}, "");
    inHand("tool-eraser", {}, {0.66, 2.05}, "");
    editor().setTool(makePlaceTool(editor().catalog().find("idap/armchair-tub"), true));
    move({3.4, 1.2});
    move({3.5, 1.3});
    shoot("tool-place");
    QTest::keyClick(&plan(Plane::XY), Qt::Key_Escape);
    editor().setTool(nullptr);
    trigger("tool-wall");
    click({-2, -2});
    move({1, -2});
    QTest::keyClicks(&plan(Plane::XY), QStringLiteral("3.25"));
    shoot("tool-wall-typed");
    for (int k = 0; k < 3; ++k) QTest::keyClick(&plan(Plane::XY), Qt::Key_Escape);
    editor().setTool(nullptr);
    while (editor().document().canUndo()) editor().undo();
  }

  void lists() {
    auto* tabs = window_->findChild<QTabWidget*>(QStringLiteral("lists"));
    editor().say({"%1: %2 (%3 times)", {"home.sh3d", "zero length: dropped", "2"}},
                 Editor::Severity::Warning);
    editor().say({"%1 could not be opened: %2", {"home.idap", "it is damaged"}}, Editor::Severity::Error);
    for (int k = 0; tabs && k < tabs->count(); ++k) {
      tabs->setCurrentIndex(k);
      shoot(("list-" + std::to_string(k + 1)).c_str());
    }
    if (tabs) tabs->setCurrentIndex(0);
  }

  void menus() {
    int number = 0;
    for (QAction* action : window_->menuBar()->actions()) {
      QMenu* menu = action->menu();
      if (!menu) continue;
      menu->popup(window_->mapToGlobal(QPoint(50, 50)));
      shoot(("menu-" + std::to_string(++number)).c_str(), menu);
      menu->close();
    }
    select("idap/sofa-three");
    emit window_->views().contextMenuRequested(window_->mapToGlobal(QPoint(300, 300)));
    if (auto* popup = window_->findChild<QMenu*>(QStringLiteral("contextMenu"))) {
      shoot("menu-context", popup);
      popup->close();
    }
    editor().select({});
  }

  void dialogs() {
    for (const char* id : {"new", "open", "save-as", "export-csv", "print", "preferences", "import-furniture",
                           "text", "compass", "background", "level-properties", "keys", "about"})
      dialog(id);
  }

  void picture() {
    PicturePanel& panel = window_->views().picture();
    panel.setCamera(editor().home().cameras.begin()->first);
    panel.setQuality(4, 8);
    panel.rayTrace();
    (void)QTest::qWaitFor([&] { return !panel.picture().isNull(); }, 20'000);
    QTest::qWait(700);
    shoot("picture-tracing");
    (void)QTest::qWaitFor([&] { return !panel.busy(); }, 60'000);
    select("idap/sofa-three");
    shoot("picture");
    editor().apply("Move", [](const Home& before) {
      Home home = before;
      home.title = "Another";
      return home;
    });
    shoot("picture-outdated", &panel);
    editor().undo();
    window_->views().showPicture(false);
  }

  void questions() {
    window_->files().closeHome();
    shootDialog("question-unsaved");
    while (editor().document().canUndo()) editor().undo();
    window_->openFile("/no/such/folder/home.idap");
    shootDialog("error-open");
  }
};

}  // namespace
}  // namespace idap

int main(int argc, char** argv) {
  const QTemporaryDir own;
  for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME"})
    qputenv(name, own.filePath(QString::fromLatin1(name).toLower()).toLocal8Bit());
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  QApplication::setApplicationName(QStringLiteral("idap"));
  QApplication::setApplicationDisplayName(QStringLiteral("IDAP"));
  const QStringList arguments = QApplication::arguments();
  if (arguments.size() != 4) {
    std::fprintf(stderr, "screenshots FOLDER LANGUAGE light|dark\n");
    return 2;
  }
  QDir().mkpath(arguments[1]);
  const bool dark = arguments[3] == QLatin1String("dark");
  idap::Everything photographer(arguments[1], arguments[2],
                                dark ? idap::Preferences::Theme::Dark : idap::Preferences::Theme::Light);
  if (dark)
    photographer.some();
  else
    photographer.all();
  // Nothing is asked of the user at the end.
  std::fflush(nullptr);
  std::_Exit(0);
}
