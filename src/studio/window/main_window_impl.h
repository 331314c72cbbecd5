// The parts of the window, shared by the files that set it up. Not for others.
#pragma once

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QPointer>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTimer>
#include <QToolBar>

#include "editor/commands/command.h"
#include "studio/catalog/catalog_panel.h"
#include "studio/catalog/finish_panel.h"
#include "studio/film/film_window.h"
#include "studio/lists/camera_list.h"
#include "studio/lists/furniture_list.h"
#include "studio/lists/message_list.h"
#include "studio/picture/picture_form.h"
#include "studio/picture/picture_panel.h"
#include "studio/picture/picture_window.h"
#include "studio/plan/plan_view.h"
#include "studio/properties/property_panel.h"
#include "studio/view3d/live_panel.h"
#include "studio/view3d/view3d.h"
#include "studio/window/file_flow.h"
#include "studio/window/hint_line.h"
#include "studio/window/job_indicator.h"
#include "studio/window/level_bar.h"
#include "studio/window/main_window.h"
#include "studio/window/preferences.h"
#include "studio/window/view_area.h"
#include "studio/window/welcome_page.h"
#include "studio/window/window_actions.h"

namespace idap {

struct MainWindow::Impl {
  Impl(MainWindow* window, std::shared_ptr<StudioShared> shared);
  ~Impl();

  // main_window.cpp
  void makeWidgets();
  void makeStatusBar();
  void findFurniture();  // goes to the search of the catalog
  void connectParts();
  void onEditor(Editor::Change change);
  void refresh();
  void showHome(bool open);
  void retranslate();
  void retitle();
  void restoreLayout();
  void keepLayout();
  void showStatus();
  void fitToolBars();
  void pictureForRecent();

  // main_window_actions.cpp
  void makeActions();
  void makeFileActions();
  void makeEditActions();
  void makeViewActions();
  void makeHelpActions();
  void makeMenus();
  void makeToolBars();
  void fillRecentMenu();
  void fillTemplateMenu();
  void showContextMenu(QPoint global);
  QMenu* menu(const char* title);
  void addCommands(QMenu* menu, Menu of);
  void showDialog(QDialog* dialog);
  void importFurniture(const QString& file = {});
  void openDropped(const QString& file);
  void exportCsv();
  void exportScene();
  void exportFurniture();
  void erase();
  void rayTrace();
  void showPictures();
  void showFilm();

  MainWindow* w;
  std::shared_ptr<StudioShared> shared;
  Preferences& preferences;
  Editor editor;
  WindowActions* actions = nullptr;
  FileFlow* files = nullptr;

  QStackedWidget* pages = nullptr;
  WelcomePage* welcome = nullptr;
  QWidget* workPage = nullptr;
  LevelBar* levels = nullptr;
  ViewArea* views = nullptr;
  HintLine* hint = nullptr;
  QDockWidget *catalogDock = nullptr, *propertyDock = nullptr, *listDock = nullptr;
  QTabWidget* catalogTabs = nullptr;
  CatalogPanel* catalog = nullptr;
  FinishPanel* finishes = nullptr;
  PropertyPanel* properties = nullptr;
  QTabWidget* tabs = nullptr;
  FurnitureList* furniture = nullptr;
  CameraList* cameras = nullptr;
  MessageList* messages = nullptr;
  FilmWindow* film = nullptr;         // likewise
  PictureWindow* pictures = nullptr;  // null until it is first asked for
  QToolBar *commandBar = nullptr, *toolBar = nullptr;
  QLabel *pointerLabel = nullptr, *selectionLabel = nullptr, *zoomLabel = nullptr;
  JobIndicator* jobs = nullptr;
  std::vector<std::pair<QMenu*, const char*>> menus;  // with their titles, to be translated
  QMenu *recentMenu = nullptr, *templateMenu = nullptr;
  QTimer refreshSoon, statusSoon;
  int unseenWarnings = 0;
  int subscription = 0;
  bool homeShown = false, mayClose = false;
};

}  // namespace idap
