// The window's own actions, its menus and its toolbars.
#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QToolButton>

#include "editor/commands/command.h"
#include "formats/registry.h"
#include "model/edits/element_edits.h"
#include "studio/catalog/import_dialog.h"
#include "studio/catalog/own_furniture_dialog.h"
#include "studio/widgets/icons.h"
#include "studio/widgets/texts.h"
#include "studio/window/clipboard.h"
#include "studio/window/dialogs/about_dialog.h"
#include "studio/window/dialogs/background_dialog.h"
#include "studio/window/dialogs/keys_dialog.h"
#include "studio/window/dialogs/level_dialog.h"
#include "studio/window/dialogs/new_room_dialog.h"
#include "studio/window/dialogs/preferences_dialog.h"
#include "studio/window/dialogs/print_dialog.h"
#include "studio/window/dialogs/site_dialog.h"
#include "studio/window/dialogs/text_dialog.h"
#include "studio/window/main_window_impl.h"
#include "studio/window/solid_tools.h"

namespace idap {

namespace {

// The ten commands of 1993, in their order, by the ids of today's actions.
constexpr const char* kTen[] = {"new",       "open", "save",   "tool-select", "property",
                                "ray-trace", "text", "eraser", "print",       "quit"};

// One after another, as each may have something to ask; who cancels one stays with the rest.
void closeAll() {
  for (QWidget* top : QApplication::topLevelWidgets())
    if (auto* window = qobject_cast<MainWindow*>(top); window && window->isVisible())
      return window->closeThen(closeAll);
}

}  // namespace

void MainWindow::Impl::makeActions() {
  makeFileActions();
  makeEditActions();
  makeViewActions();
  makeHelpActions();
}

void MainWindow::Impl::makeFileActions() {
  const auto ofHome = [this](QAction* action) { actions->restWithoutHome(action); };
  actions->add({"new", QT_TRANSLATE_NOOP("idap", "&New room…"),
                QT_TRANSLATE_NOOP("idap", "Starts an empty room: asks for its size along X, Y and Z"),
                "Ctrl+N", QT_TRANSLATE_NOOP("idap", "New")},
               [this] {
                 auto* dialog = new NewRoomDialog(preferences.editor().unit, w);
                 QObject::connect(dialog, &NewRoomDialog::started, files, &FileFlow::newRoom);
                 showDialog(dialog);
               });
  actions->add({"new-window", QT_TRANSLATE_NOOP("idap", "New &window"),
                QT_TRANSLATE_NOOP("idap", "Another window, to work on two homes and copy between them"),
                "Ctrl+Shift+N"},
               [this] { w->newWindow(); });
  actions->add({"open", QT_TRANSLATE_NOOP("idap", "&Open…"),
                QT_TRANSLATE_NOOP("idap", "Reads a home of IDAP (.idap) or Sweet Home 3D (.sh3d)"), "Ctrl+O",
                QT_TRANSLATE_NOOP("idap", "Load")},
               [this] { files->openDialog(); });
  QAction* save = actions->add(
      {"save", QT_TRANSLATE_NOOP("idap", "&Save"), QT_TRANSLATE_NOOP("idap", "Writes the home to its file"),
       "Ctrl+S", QT_TRANSLATE_NOOP("idap", "Save")},
      [this] { files->save(); });
  ofHome(save);
  ofHome(actions->add(
      {"save-as", QT_TRANSLATE_NOOP("idap", "Save &as…"),
       QT_TRANSLATE_NOOP("idap", "Writes the home to another file and goes on with that"), "Ctrl+Shift+S"},
      [this] { files->saveAs(); }));
  ofHome(actions->add(
      {"save-compact", QT_TRANSLATE_NOOP("idap", "Save a &compact copy…"),
       QT_TRANSLATE_NOOP("idap", "Writes a copy without the models and pictures that nothing uses")},
      [this] { files->saveCompact(); }));
  ofHome(actions->add({"export-csv", QT_TRANSLATE_NOOP("idap", "Export the &furniture list…"),
                       QT_TRANSLATE_NOOP("idap", "Writes the list as a table (CSV) for a spreadsheet")},
                      [this] { exportCsv(); }));
  ofHome(
      actions->add({"export-scene", QT_TRANSLATE_NOOP("idap", "Export in &three dimensions…"),
                    QT_TRANSLATE_NOOP("idap", "Writes the home as glTF, for viewers and other 3D programs")},
                   [this] { exportScene(); }));
  ofHome(actions->add({"print", QT_TRANSLATE_NOOP("idap", "&Print…"),
                       QT_TRANSLATE_NOOP("idap", "Prints the plan to scale, on paper or into a PDF"),
                       "Ctrl+P", QT_TRANSLATE_NOOP("idap", "Print")},
                      [this] {
                        auto* dialog = new PrintDialog(editor, w);
                        dialog->setChoices(shared->preferences->layout("print"));
                        QObject::connect(dialog, &QDialog::finished, w, [this, dialog] {
                          shared->preferences->setLayout("print", dialog->choices());
                        });
                        showDialog(dialog);
                      }));
  actions->add(
      {"preferences", QT_TRANSLATE_NOOP("idap", "P&references…"),
       QT_TRANSLATE_NOOP("idap", "Units, language, light or dark, snapping and new walls"), "Ctrl+,"},
      [this] { showDialog(new PreferencesDialog(preferences, w)); });
  ofHome(
      actions->add({"close", QT_TRANSLATE_NOOP("idap", "&Close the home"),
                    QT_TRANSLATE_NOOP("idap", "Back to the first page; asks about unsaved work"), "Ctrl+W"},
                   [this] { files->closeHome(); }));
  QAction* quit = actions->add({"quit", QT_TRANSLATE_NOOP("idap", "&Quit"),
                                QT_TRANSLATE_NOOP("idap", "Leaves the program; asks about unsaved work"),
                                "Ctrl+Q", QT_TRANSLATE_NOOP("idap", "Quit")},
                               closeAll);
  quit->setMenuRole(QAction::QuitRole);
}

void MainWindow::Impl::makeEditActions() {
  const auto ofHome = [this](QAction* action, std::function<bool()> enabled = {}) {
    actions->restWithoutHome(action);
    if (enabled) actions->enableBy(action, std::move(enabled));
  };
  const auto selected = [this] { return !empty(editor.selection()); };
  ofHome(actions->add({"undo", QT_TRANSLATE_NOOP("idap", "&Undo"),
                       QT_TRANSLATE_NOOP("idap", "Takes back the last step; there is no limit"), "Ctrl+Z",
                       QT_TRANSLATE_NOOP("idap", "Undo")},
                      [this] { editor.undo(); }),
         [this] { return editor.document().canUndo() || editor.document().inTransaction(); });
  ofHome(actions->add({"redo", QT_TRANSLATE_NOOP("idap", "&Redo"),
                       QT_TRANSLATE_NOOP("idap", "Does again what was taken back"), "Ctrl+Shift+Z; Ctrl+Y",
                       QT_TRANSLATE_NOOP("idap", "Redo")},
                      [this] { editor.redo(); }),
         [this] { return editor.document().canRedo(); });
  ofHome(actions->add({"cut", QT_TRANSLATE_NOOP("idap", "Cu&t"),
                       QT_TRANSLATE_NOOP("idap", "Moves the selection to the clipboard"), "Ctrl+X"},
                      [this] { cutSelection(editor); }),
         selected);
  ofHome(actions->add({"copy", QT_TRANSLATE_NOOP("idap", "&Copy"),
                       QT_TRANSLATE_NOOP("idap", "Copies the selection, also for other windows"), "Ctrl+C"},
                      [this] { copySelection(editor); }),
         selected);
  ofHome(actions->add({"paste", QT_TRANSLATE_NOOP("idap", "&Paste"),
                       QT_TRANSLATE_NOOP("idap", "Puts what was copied beside its original"), "Ctrl+V"},
                      [this] { paste(editor, PasteAs::Beside); }),
         canPaste);
  ofHome(actions->add({"paste-in-place", QT_TRANSLATE_NOOP("idap", "Paste in p&lace"),
                       QT_TRANSLATE_NOOP("idap", "Puts what was copied where its original is, on this level"),
                       "Ctrl+Shift+V"},
                      [this] { paste(editor, PasteAs::InPlace); }),
         canPaste);
  ofHome(actions->add({"paste-into-group", QT_TRANSLATE_NOOP("idap", "Paste into the &group"),
                       QT_TRANSLATE_NOOP("idap", "What was copied becomes part of the selected group")},
                      [this] { paste(editor, PasteAs::IntoGroup); }),
         [this] { return canPaste() && editor.selection().groups.size() == 1; });
  ofHome(actions->add(
             {"paste-style", QT_TRANSLATE_NOOP("idap", "Paste st&yle"),
              QT_TRANSLATE_NOOP("idap", "Gives the selection the finishes of what was copied"), "Ctrl+Alt+V"},
             [this] { pasteStyle(editor); }),
         [this, selected] { return canPaste() && selected(); });
  ofHome(actions->add({"property", QT_TRANSLATE_NOOP("idap", "P&roperties"),
                       QT_TRANSLATE_NOOP("idap", "Goes to the numbers and finishes of the selection"),
                       "Alt+Return; Ctrl+E", QT_TRANSLATE_NOOP("idap", "Property")},
                      [this] {
                        propertyDock->show();
                        propertyDock->raise();
                        properties->focusFirst();
                      }));
  ofHome(actions->add(
      {"eraser", QT_TRANSLATE_NOOP("idap", "&Eraser"),
       QT_TRANSLATE_NOOP("idap", "Deletes what is selected; with nothing selected, what is clicked"), "",
       QT_TRANSLATE_NOOP("idap", "Eraser")},
      [this] { erase(); }));
  ofHome(
      actions->add({"find", QT_TRANSLATE_NOOP("idap", "&Find in the catalog"),
                    QT_TRANSLATE_NOOP("idap", "Search for furniture by its name; Enter places it"), "Ctrl+F"},
                   [this] { findFurniture(); }));
  ofHome(actions->add(
      {"import-furniture", QT_TRANSLATE_NOOP("idap", "&Import furniture…"),
       QT_TRANSLATE_NOOP("idap", "Adds a model of your own, or a library of furniture, to the catalog")},
      [this] { importFurniture(); }));
  ofHome(actions->add(
             {"save-as-furniture", QT_TRANSLATE_NOOP("idap", "&Save as furniture…"),
              QT_TRANSLATE_NOOP("idap", "Makes one piece of what is selected and keeps it in the catalog")},
             [this] {
               auto* dialog = new OwnFurnitureDialog(editor, w);
               QObject::connect(dialog, &OwnFurnitureDialog::saved, catalog, &CatalogPanel::reload);
               showDialog(dialog);
             }),
         [this] {
           const Elements& e = editor.selection();
           return !e.furniture.empty() || !e.groups.empty() || !e.openings.empty();
         });
  actions->add(
      {"export-furniture", QT_TRANSLATE_NOOP("idap", "E&xport own furniture…"),
       QT_TRANSLATE_NOOP("idap", "Writes your furniture as a library (SH3F) that Sweet Home 3D opens, too")},
      [this] { exportFurniture(); });
  ofHome(actions->add({"text", QT_TRANSLATE_NOOP("idap", "&Title and notes…"),
                       QT_TRANSLATE_NOOP("idap", "The title on prints, and notes about the home"), "Ctrl+T",
                       QT_TRANSLATE_NOOP("idap", "Text")},
                      [this] { showDialog(new TextDialog(editor, w)); }));
  ofHome(actions->add(
      {"compass", QT_TRANSLATE_NOOP("idap", "&Compass and place…"),
       QT_TRANSLATE_NOOP("idap", "Where north is, the town, the date and the hour: they set the sun")},
      [this] { showDialog(new SiteDialog(editor, w)); }));
  ofHome(actions->add({"background", QT_TRANSLATE_NOOP("idap", "&Background picture…"),
                       QT_TRANSLATE_NOOP("idap", "A scanned plan under the drawing, to draw it over")},
                      [this] { showDialog(new BackgroundDialog(editor, w)); }));
  ofHome(actions->add({"level-properties", QT_TRANSLATE_NOOP("idap", "Level &properties…"),
                       QT_TRANSLATE_NOOP("idap", "Name, elevation, height and floor of this level")},
                      [this] { showDialog(new LevelDialog(editor, w)); }));
}

void MainWindow::Impl::makeViewActions() {
  const auto ofHome = [this](QAction* action) {
    actions->restWithoutHome(action);
    return action;
  };
  const auto later = [this](std::function<void()> zoom) {
    return [this, zoom = std::move(zoom)] {
      zoom();
      showStatus();
    };
  };
  ofHome(actions->add(
      {"zoom-in", QT_TRANSLATE_NOOP("idap", "Zoom &in"),
       QT_TRANSLATE_NOOP("idap", "Nearer; the wheel does it under the pointer"), "Ctrl++; Ctrl+="},
      later([this] { views->current().zoomBy(1.4); })));
  ofHome(actions->add({"zoom-out", QT_TRANSLATE_NOOP("idap", "Zoom &out"),
                       QT_TRANSLATE_NOOP("idap", "Farther; the wheel does it under the pointer"), "Ctrl+-"},
                      later([this] { views->current().zoomBy(1 / 1.4); })));
  ofHome(actions->add({"zoom-fit", QT_TRANSLATE_NOOP("idap", "Zoom to &fit"),
                       QT_TRANSLATE_NOOP("idap", "All of the home, in every plane"), "Ctrl+9; Home"},
                      later([this] { views->zoomAllToFit(); })));
  QAction* toSelection =
      ofHome(actions->add({"zoom-selection", QT_TRANSLATE_NOOP("idap", "Zoom to the &selection"),
                           QT_TRANSLATE_NOOP("idap", "What is selected, as large as it fits"), "Ctrl+8"},
                          later([this] { views->current().zoomToSelection(); })));
  actions->enableBy(toSelection, [this] { return !empty(editor.selection()); });

  const ActionText one[] = {
      {"view-xy", QT_TRANSLATE_NOOP("idap", "Only plan &X-Y"),
       QT_TRANSLATE_NOOP("idap", "The plan from above, alone; again: all views"), "Ctrl+1"},
      {"view-xz", QT_TRANSLATE_NOOP("idap", "Only elevation X-&Z"),
       QT_TRANSLATE_NOOP("idap", "The view from the front, alone; again: all views"), "Ctrl+2"},
      {"view-yz", QT_TRANSLATE_NOOP("idap", "Only elevation &Y-Z"),
       QT_TRANSLATE_NOOP("idap", "The view from the right, alone; again: all views"), "Ctrl+3"},
      {"view-picture", QT_TRANSLATE_NOOP("idap", "Only the &picture"),
       QT_TRANSLATE_NOOP("idap", "The ray-traced picture, alone; again: all views"), "Ctrl+4"}};
  for (int i = 0; i < ViewArea::kViews; ++i) {
    QAction* action =
        ofHome(actions->addSwitch(one[i], [this, i](bool on) { views->maximise(on ? i : ViewArea::kAll); }));
    actions->checkBy(action, [this, i] { return views->maximised() == i; });
  }
  QAction* all =
      ofHome(actions->add({"view-all", QT_TRANSLATE_NOOP("idap", "&All views"),
                           QT_TRANSLATE_NOOP("idap", "The three planes and the picture together"), "Ctrl+0"},
                          [this] { views->maximise(ViewArea::kAll); }));
  actions->enableBy(all, [this] { return views->maximised() != ViewArea::kAll; });
  ofHome(
      actions->add({"maximise", QT_TRANSLATE_NOOP("idap", "&Maximise this view"),
                    QT_TRANSLATE_NOOP(
                        "idap", "The view in use alone, or all again; so does a double click on its caption"),
                    "F11"},
                   [this] { views->toggle(views->currentView()); }));
  ofHome(actions->add(
      {"ray-trace", QT_TRANSLATE_NOOP("idap", "&Ray trace"),
       QT_TRANSLATE_NOOP("idap", "Makes the picture of the chosen point of view, while you go on working"),
       "F5", QT_TRANSLATE_NOOP("idap", "Ray Trace")},
      [this] { rayTrace(); }));
  ofHome(actions->add(
      {"store-view", QT_TRANSLATE_NOOP("idap", "&Keep this point of view"),
       QT_TRANSLATE_NOOP("idap", "Keeps where the live view stands as a camera of the home"), "Ctrl+B"},
      [this] { views->live().storeView(); }));
  ofHome(actions->add(
      {"pictures", QT_TRANSLATE_NOOP("idap", "Pict&ures and gallery…"),
       QT_TRANSLATE_NOOP("idap",
                         "Makes pictures of any size, one or many at once, and keeps them in the home"),
       "F4"},
      [this] { showPictures(); }));
  ofHome(actions->add(
      {"film", QT_TRANSLATE_NOOP("idap", "Fil&m…"),
       QT_TRANSLATE_NOOP("idap", "A walk through the home, or a day of sunlight, as a film (MP4)"),
       "Shift+F4"},
      [this] { showFilm(); }));
  const auto panel = [&](const ActionText& text, QDockWidget* dock) {
    QAction* action = ofHome(actions->addSwitch(text, [dock](bool on) { dock->setVisible(on); }));
    actions->checkBy(action, [dock] { return !dock->isHidden(); });
    QObject::connect(dock, &QDockWidget::visibilityChanged, w, [this] { refreshSoon.start(); });
  };
  panel({"panel-catalog", QT_TRANSLATE_NOOP("idap", "&Catalog"),
         QT_TRANSLATE_NOOP("idap", "The furniture, on the left"), "F6"},
        catalogDock);
  panel({"panel-properties", QT_TRANSLATE_NOOP("idap", "&Properties"),
         QT_TRANSLATE_NOOP("idap", "The selection in numbers, on the right"), "F8"},
        propertyDock);
  panel({"panel-lists", QT_TRANSLATE_NOOP("idap", "&Lists"),
         QT_TRANSLATE_NOOP("idap", "Furniture, points of view and messages, below"), "F9"},
        listDock);
}

void MainWindow::Impl::makeHelpActions() {
  actions->add({"keys", QT_TRANSLATE_NOOP("idap", "&Keys"),
                QT_TRANSLATE_NOOP("idap", "Every key and what it does"), "F1"},
               [this] { showDialog(new KeysDialog(*actions, w)); });
  QAction* about = actions->add({"about", QT_TRANSLATE_NOOP("idap", "&About IDAP"),
                                 QT_TRANSLATE_NOOP("idap", "Version, licence, and whose work is in it")},
                                [this] { showDialog(new AboutDialog(w)); });
  about->setMenuRole(QAction::AboutRole);
}

QMenu* MainWindow::Impl::menu(const char* title) {
  QMenu* made = w->menuBar()->addMenu(QString());
  made->setToolTipsVisible(false);
  menus.emplace_back(made, title);
  return made;
}

void MainWindow::Impl::addCommands(QMenu* into, Menu of) {
  std::map<std::string, QMenu*> below;
  for (const Command& command : commands()) {
    if (command.menu != of) continue;
    QMenu* place = into;
    if (*command.submenu) {
      QMenu*& sub = below[command.submenu];
      if (!sub) {
        if (command.separatorBefore) into->addSeparator();
        sub = into->addMenu(QString());
        menus.emplace_back(sub, command.submenu);
      } else if (command.separatorBefore) {
        sub->addSeparator();
      }
      place = sub;
    } else if (command.separatorBefore) {
      into->addSeparator();
    }
    place->addAction(actions->get(command.id));
  }
}

void MainWindow::Impl::makeMenus() {
  const auto add = [this](QMenu* to, std::initializer_list<const char*> ids) {
    for (const char* id : ids) {
      if (*id)
        to->addAction(actions->get(id));
      else
        to->addSeparator();
    }
  };
  QMenu* file = menu(QT_TRANSLATE_NOOP("idap", "&File"));
  add(file, {"new"});
  templateMenu = file->addMenu(QString());
  menus.emplace_back(templateMenu, QT_TRANSLATE_NOOP("idap", "New from a &template"));
  add(file, {"new-window", "", "open"});
  recentMenu = file->addMenu(QString());
  menus.emplace_back(recentMenu, QT_TRANSLATE_NOOP("idap", "Open &recent"));
  add(file, {"close", "", "save", "save-as", "save-compact", "", "export-csv", "export-scene", "print", "",
             "preferences", "", "quit"});

  QMenu* edit = menu(QT_TRANSLATE_NOOP("idap", "&Edit"));
  add(edit,
      {"undo", "redo", "", "cut", "copy", "paste", "paste-in-place", "paste-into-group", "paste-style", ""});
  addCommands(edit, Menu::Edit);
  add(edit, {"", "property"});

  QMenu* drawing = menu(QT_TRANSLATE_NOOP("idap", "&Draw"));
  for (const ToolEntry& tool : tools())
    if (!isSolidTool(*tool.info)) drawing->addAction(actions->get(std::string("tool-") + tool.info->id));
  menus.emplace_back(addSolidMenu(*drawing, *actions), QT_TRANSLATE_NOOP("idap", "&Solids"));

  QMenu* pieces = menu(QT_TRANSLATE_NOOP("idap", "F&urniture"));
  add(pieces, {"find", "import-furniture", "save-as-furniture", "export-furniture", ""});
  addCommands(pieces, Menu::Furniture);

  QMenu* plan = menu(QT_TRANSLATE_NOOP("idap", "&Plan"));
  add(plan, {"text", "compass", "background", ""});
  addCommands(plan, Menu::Plan);

  addCommands(menu(QT_TRANSLATE_NOOP("idap", "&Walls")), Menu::Walls);

  QMenu* storeys = menu(QT_TRANSLATE_NOOP("idap", "&Levels"));
  addCommands(storeys, Menu::Levels);
  add(storeys, {"", "level-properties"});

  QMenu* view = menu(QT_TRANSLATE_NOOP("idap", "&View"));
  add(view, {"zoom-in",          "zoom-out",    "zoom-fit", "zoom-selection", "",         "view-all",
             "view-xy",          "view-xz",     "view-yz",  "view-picture",   "maximise", "",
             "store-view",       "ray-trace",   "pictures", "film",           "",         "panel-catalog",
             "panel-properties", "panel-lists", ""});
  addCommands(view, Menu::View);

  add(menu(QT_TRANSLATE_NOOP("idap", "&Help")), {"keys", "about"});
}

void MainWindow::Impl::makeToolBars() {
  const auto bar = [this](const char* name) {
    auto* made = new QToolBar(w);
    made->setObjectName(QLatin1String(name));
    made->setMovable(false);
    made->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    made->setContextMenuPolicy(Qt::PreventContextMenu);
    const int side = w->fontMetrics().height() * 3 / 2;
    made->setIconSize({side, side});
    w->addToolBar(made);
    return made;
  };
  commandBar = bar("commandBar");
  for (const char* id : kTen) commandBar->addAction(actions->get(id));
  toolBar = bar("toolBar");
  toolBar->addAction(actions->get("undo"));
  toolBar->addAction(actions->get("redo"));
  toolBar->addSeparator();
  for (const ToolEntry& tool : tools()) {
    const std::string id = tool.info->id;
    // These two are among the ten.
    if (id != "select" && id != "eraser" && !isSolidTool(*tool.info))
      toolBar->addAction(actions->get("tool-" + id));
  }
  addSolidButton(*toolBar, *actions);
  toolBar->addSeparator();
  for (const char* id : {"zoom-in", "zoom-out", "zoom-fit"}) toolBar->addAction(actions->get(id));
  // What is plain by its picture needs no word.
  for (const char* id : {"undo", "redo", "zoom-in", "zoom-out", "zoom-fit"})
    if (auto* button = qobject_cast<QToolButton*>(toolBar->widgetForAction(actions->get(id))))
      QObject::connect(toolBar, &QToolBar::toolButtonStyleChanged, button,
                       [button] { button->setToolButtonStyle(Qt::ToolButtonIconOnly); });
  for (QToolBar* made : {commandBar, toolBar})
    for (QAction* action : made->actions())
      if (QWidget* button = made->widgetForAction(action))
        button->setObjectName(action->objectName() + QStringLiteral("Button"));
  w->setContextMenuPolicy(Qt::NoContextMenu);
}

void MainWindow::Impl::fillRecentMenu() {
  recentMenu->clear();
  for (const QString& file : preferences.recentFiles()) {
    QString name = QFileInfo(file).fileName();
    QAction* action = recentMenu->addAction(name.replace(QLatin1Char('&'), QStringLiteral("&&")), files,
                                            [this, file] { files->open(file); });
    action->setToolTip(QDir::toNativeSeparators(file));
  }
  recentMenu->setToolTipsVisible(true);
  recentMenu->setEnabled(!recentMenu->isEmpty());
}

void MainWindow::Impl::fillTemplateMenu() {
  templateMenu->clear();
  for (const HomeTemplate& home : homeTemplates(preferences.language()))
    templateMenu->addAction(home.name, files, [this, home] { files->startFromTemplate(home.file); });
  templateMenu->setEnabled(!templateMenu->isEmpty());
}

void MainWindow::Impl::showContextMenu(QPoint global) {
  actions->refresh();
  auto* popup = new QMenu(w);
  popup->setObjectName(QStringLiteral("contextMenu"));
  popup->setAttribute(Qt::WA_DeleteOnClose);
  if (empty(editor.selection())) {
    for (const char* id : {"paste", "paste-in-place"}) popup->addAction(actions->get(id));
    popup->addSeparator();
    for (const char* id : {"zoom-fit", "maximise", "ray-trace"}) popup->addAction(actions->get(id));
  } else {
    for (const char* id : {"property", "cut", "copy", "paste", "paste-style", "save-as-furniture"})
      popup->addAction(actions->get(id));
  }
  popup->addSeparator();
  for (const Command& command : commands()) {
    QAction* action = actions->get(command.id);
    // What cannot be done here only makes the way to the rest longer.
    if (!command.inContextMenu || !action->isEnabled()) continue;
    if (command.separatorBefore) popup->addSeparator();
    popup->addAction(action);
  }
  popup->popup(global);
}

void MainWindow::Impl::showDialog(QDialog* dialog) {
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

void MainWindow::Impl::importFurniture(const QString& file) {
  auto* dialog = new ImportDialog(editor, w);
  QObject::connect(dialog, &ImportDialog::libraryImported, catalog, &CatalogPanel::reload);
  showDialog(dialog);
  if (!file.isEmpty()) dialog->chooseFile(fromQt(file));
}

void MainWindow::Impl::openDropped(const QString& file) {
  const std::string extension = fromQt(QFileInfo(file).suffix().toLower());
  for (const HomeFormat& format : homeFormats())
    if (format.read &&
        std::find(format.extensions.begin(), format.extensions.end(), extension) != format.extensions.end())
      return files->open(file);
  if (!homeShown) {
    editor.say({QT_TRANSLATE_NOOP("idap", "%1 is not a home; begin a room first, then drop it there"),
                {fromQt(QFileInfo(file).fileName())}},
               Editor::Severity::Warning);
  } else if (extension == "png" || extension == "jpg" || extension == "jpeg") {
    auto* dialog = new BackgroundDialog(editor, w);
    showDialog(dialog);
    dialog->usePicture(file);
  } else {
    importFurniture(file);
  }
}

void MainWindow::Impl::erase() {
  const Command* command = findCommand("delete");
  if (!empty(editor.selection()) && command && (!command->enabled || command->enabled(editor)))
    command->run(editor);
  else
    editor.takeTool("eraser");
}

void MainWindow::Impl::rayTrace() {
  if (views->maximised() != ViewArea::kAll && views->maximised() != 3) views->maximise(ViewArea::kAll);
  // What the live view shows is what one wants a picture of.
  if (!views->pictureShown()) views->picture().setPlace(views->live().view().camera());
  views->showPicture(true);
  views->picture().rayTrace();
}

void MainWindow::Impl::showFilm() {
  if (!film) film = new FilmWindow(editor, w);
  film->show();
  film->raise();
  film->activateWindow();
}

void MainWindow::Impl::showPictures() {
  if (!pictures) {
    pictures = new PictureWindow(editor, w);
    pictures->form().setLiveCamera([this] { return views->live().view().camera(); });
  }
  pictures->show();
  pictures->raise();
  pictures->activateWindow();
}

}  // namespace idap
