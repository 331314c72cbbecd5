#include "studio/window/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QScreen>
#include <QStatusBar>
#include <QToolButton>
#include <QUrl>

#include "editor/commands/command.h"
#include "studio/catalog/thumbnail_store.h"
#include "studio/widgets/texts.h"
#include "studio/window/language.h"
#include "studio/window/main_window_impl.h"
#include "studio/window/recent_pictures.h"
#include "studio/window/search_keys.h"
#include "studio/window/selection_summary.h"
#include "studio/window/theme.h"

namespace idap {

StudioShared::StudioShared(std::shared_ptr<const Catalog> theCatalog)
    : catalog(std::move(theCatalog)),
      preferences(std::make_unique<Preferences>()),
      thumbnails(std::make_unique<ThumbnailStore>(catalog)) {
  applyTheme(preferences->theme());
  applyLanguage(preferences->language());
  QObject::connect(preferences.get(), &Preferences::themeChanged, preferences.get(),
                   [this] { applyTheme(preferences->theme()); });
  QObject::connect(preferences.get(), &Preferences::languageChanged, preferences.get(),
                   [this] { applyLanguage(preferences->language()); });
}

StudioShared::~StudioShared() = default;

MainWindow::MainWindow(std::shared_ptr<const Catalog> catalog, QWidget* parent)
    : MainWindow(std::make_shared<StudioShared>(std::move(catalog)), parent) {}

MainWindow::MainWindow(std::shared_ptr<StudioShared> shared, QWidget* parent)
    : QMainWindow(parent), impl_(std::make_unique<Impl>(this, std::move(shared))) {}

MainWindow::~MainWindow() {
  delete impl_->film;
  delete impl_->pictures;
  // The widgets listen to the editor, which goes with impl_: they go before it.
  impl_->editor.unsubscribe(impl_->subscription);
  if (isVisible() && impl_->homeShown) impl_->keepLayout();  // hidden, all panels count as closed
  delete impl_->actions;
  const auto parts = findChildren<QWidget*>(Qt::FindDirectChildrenOnly);
  for (QWidget* part : parts) delete part;
  delete impl_->files;
}

Editor& MainWindow::editor() { return impl_->editor; }
void MainWindow::openFile(const std::filesystem::path& file) { impl_->files->open(toQt(file.string())); }
void MainWindow::offerRestore() { impl_->files->offerRestore(); }
bool MainWindow::busy() const { return impl_->files->busy(); }
Preferences& MainWindow::preferences() { return impl_->preferences; }
FileFlow& MainWindow::files() { return *impl_->files; }
ViewArea& MainWindow::views() { return *impl_->views; }
WindowActions& MainWindow::actions() { return *impl_->actions; }

MainWindow* MainWindow::newWindow() {
  auto* other = new MainWindow(impl_->shared);
  other->setAttribute(Qt::WA_DeleteOnClose);
  other->move(pos() + QPoint(30, 30));
  other->show();
  return other;
}

void MainWindow::closeEvent(QCloseEvent* event) {
  // Closing again from within the question would be passed over: what is safe closes at once.
  if (impl_->mayClose || impl_->files->safe()) {
    if (impl_->homeShown) impl_->keepLayout();
    impl_->files->recovery().drop();
    return QMainWindow::closeEvent(event);
  }
  event->ignore();
  closeThen({});
}

void MainWindow::closeThen(std::function<void()> then) {
  impl_->files->whenSafe([this, then = std::move(then)] {
    impl_->mayClose = true;
    close();
    if (then) then();
  });
}

// A home opens, a picture goes under the plan, anything else may be furniture.
void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.size() == 1 && urls[0].isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QString file = event->mimeData()->urls().value(0).toLocalFile();
  if (file.isEmpty()) return;
  event->acceptProposedAction();
  // Out of the drop, which the other program waits for.
  QMetaObject::invokeMethod(
      this, [this, file] { impl_->openDropped(file); }, Qt::QueuedConnection);
}

void MainWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange && impl_) impl_->retranslate();
  if (event->type() == QEvent::PaletteChange && impl_ && impl_->actions) impl_->actions->retranslate();
  QMainWindow::changeEvent(event);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  impl_->fitToolBars();
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  impl_->fitToolBars();
}

MainWindow::Impl::Impl(MainWindow* window, std::shared_ptr<StudioShared> all)
    : w(window), shared(std::move(all)), preferences(*shared->preferences), editor(shared->catalog) {
  w->setObjectName(QStringLiteral("mainWindow"));
  w->setAcceptDrops(true);
  editor.setSettings(preferences.editor());
  actions = new WindowActions(editor, w);
  files = new FileFlow(editor, preferences, w);
  makeWidgets();
  makeStatusBar();
  makeActions();
  makeMenus();
  makeToolBars();
  connectParts();
  w->resize(QSize(1280, 800).boundedTo(w->screen() ? w->screen()->availableSize() : QSize(1280, 800)));
  w->restoreGeometry(preferences.layout("geometry"));
  retranslate();
  showHome(false);
}

MainWindow::Impl::~Impl() = default;

void MainWindow::Impl::makeWidgets() {
  pages = new QStackedWidget(w);
  w->setCentralWidget(pages);
  welcome = new WelcomePage(preferences, pages);
  pages->addWidget(welcome);

  workPage = new QWidget(pages);
  auto* layout = new QVBoxLayout(workPage);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  levels = new LevelBar(editor, workPage);
  views = new ViewArea(editor, workPage);
  hint = new HintLine(editor, workPage);
  layout->addWidget(levels);
  layout->addWidget(views, 1);
  layout->addWidget(hint);
  pages->addWidget(workPage);

  const auto dock = [this](const char* name, QWidget* widget, Qt::DockWidgetArea area) {
    auto* made = new QDockWidget(w);
    made->setObjectName(QLatin1String(name));
    made->setWidget(widget);
    w->addDockWidget(area, made);
    return made;
  };
  catalog = new CatalogPanel(editor, *shared->thumbnails);
  finishes = new FinishPanel(editor);
  properties = new PropertyPanel(editor);
  furniture = new FurnitureList(editor);
  cameras = new CameraList(editor);
  messages = new MessageList(editor);
  catalog->setObjectName(QStringLiteral("catalogPanel"));
  properties->setObjectName(QStringLiteral("propertyPanel"));
  furniture->setObjectName(QStringLiteral("furnitureList"));
  cameras->setObjectName(QStringLiteral("cameraList"));
  messages->setObjectName(QStringLiteral("messageList"));
  finishes->setObjectName(QStringLiteral("finishPanel"));
  catalogTabs = new QTabWidget;
  catalogTabs->setObjectName(QStringLiteral("catalogTabs"));
  catalogTabs->setDocumentMode(true);
  catalogTabs->addTab(catalog, QString());
  catalogTabs->addTab(finishes, QString());
  tabs = new QTabWidget;
  tabs->setObjectName(QStringLiteral("lists"));
  tabs->setDocumentMode(true);
  for (QWidget* list : std::initializer_list<QWidget*>{furniture, cameras, messages})
    tabs->addTab(list, QString());
  auto* searches = new SearchKeys(w);
  searches->watch(catalog);
  searches->watch(furniture);
  catalogDock = dock("catalogDock", catalogTabs, Qt::LeftDockWidgetArea);
  propertyDock = dock("propertyDock", properties, Qt::RightDockWidgetArea);
  listDock = dock("listDock", tabs, Qt::BottomDockWidgetArea);
  listDock->setTitleBarWidget(new QWidget(listDock));  // its tabs say enough
  // Both sides reach to the bottom, where catalog and properties need the height.
  w->setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  w->setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  const int em = w->fontMetrics().height();
  w->resizeDocks({catalogDock, propertyDock}, {16 * em, 17 * em}, Qt::Horizontal);
  w->resizeDocks({listDock}, {9 * em}, Qt::Vertical);
}

void MainWindow::Impl::findFurniture() {
  catalogDock->show();
  catalogDock->raise();
  catalogTabs->setCurrentWidget(catalog);
  catalog->focusSearch();
}

void MainWindow::Impl::makeStatusBar() {
  QStatusBar* bar = w->statusBar();
  jobs = new JobIndicator(bar);
  pointerLabel = new QLabel(bar);
  pointerLabel->setObjectName(QStringLiteral("pointer"));
  selectionLabel = new QLabel(bar);
  selectionLabel->setObjectName(QStringLiteral("selection"));
  zoomLabel = new QLabel(bar);
  zoomLabel->setObjectName(QStringLiteral("zoom"));
  // Wide enough that nothing jumps while the pointer moves.
  pointerLabel->setMinimumWidth(
      pointerLabel->fontMetrics().horizontalAdvance(QStringLiteral("X -0000.0 cm  Y -0000.0 cm")));
  bar->addPermanentWidget(jobs);
  bar->addPermanentWidget(selectionLabel);
  bar->addPermanentWidget(pointerLabel);
  bar->addPermanentWidget(zoomLabel);
}

void MainWindow::Impl::connectParts() {
  refreshSoon.setSingleShot(true);
  refreshSoon.setInterval(30);
  QObject::connect(&refreshSoon, &QTimer::timeout, w, [this] { refresh(); });
  statusSoon.setSingleShot(true);
  statusSoon.setInterval(30);
  QObject::connect(&statusSoon, &QTimer::timeout, w, [this] { showStatus(); });

  Editor::Listener listener;
  listener.changed = [this](Editor::Change change) { onEditor(change); };
  listener.said = [this](const Text& text, Editor::Severity severity) {
    w->statusBar()->showMessage(translated(text), severity == Editor::Severity::Note ? 6000 : 15000);
  };
  subscription = editor.subscribe(std::move(listener));

  QObject::connect(files, &FileFlow::jobStarted, jobs, &JobIndicator::follow);
  QObject::connect(files, &FileFlow::openChanged, w, [this] { showHome(files->isOpen()); });
  QObject::connect(files, &FileFlow::titleChanged, w, [this] { retitle(); });
  QObject::connect(files, &FileFlow::newHome, w, [this] { findFurniture(); });
  QObject::connect(files, &FileFlow::savedTo, w, [this] { pictureForRecent(); });

  QObject::connect(welcome, &WelcomePage::roomRequested, files, &FileFlow::newRoom);
  QObject::connect(welcome, &WelcomePage::templateChosen, files, &FileFlow::startFromTemplate);
  QObject::connect(welcome, &WelcomePage::fileChosen, files, &FileFlow::open);
  QObject::connect(welcome, &WelcomePage::openRequested, files, &FileFlow::openDialog);

  QObject::connect(views, &ViewArea::pointerAt, w, [this](Plane plane, double u, double v) {
    const char* axes[3][2] = {{"X", "Y"}, {"X", "Z"}, {"Y", "Z"}};
    const LengthUnit unit = editor.settings().unit;
    const auto& names = axes[std::size_t(plane)];
    pointerLabel->setText(QLatin1String(names[0]) + QLatin1Char(' ') + lengthText(u, unit, 1) +
                          QStringLiteral("   ") + QLatin1String(names[1]) + QLatin1Char(' ') +
                          lengthText(v, unit, 1));
    if (!statusSoon.isActive()) statusSoon.start();
  });
  QObject::connect(views, &ViewArea::pointerLeft, w, [this] { pointerLabel->clear(); });
  QObject::connect(views, &ViewArea::contextMenuRequested, w, [this](QPoint at) { showContextMenu(at); });
  QObject::connect(views, &ViewArea::maximisedChanged, w, [this] { refresh(); });

  QObject::connect(catalog, &CatalogPanel::importRequested, w, [this] { importFurniture(); });
  QObject::connect(cameras, &CameraList::currentChanged, w, [this] {
    views->picture().setCamera(cameras->current());
    if (cameras->current()) views->live().setCamera(cameras->current());
  });
  QObject::connect(cameras, &CameraList::pictureRequested, w, [this] {
    views->picture().setCamera(cameras->current());
    views->showPicture(true);
    rayTrace();
  });
  QObject::connect(messages, &MessageList::unseen, w, [this](int warnings) {
    unseenWarnings = warnings;
    retitle();
  });

  QObject::connect(&preferences, &Preferences::editorChanged, w,
                   [this] { editor.setSettings(preferences.editor()); });
  QObject::connect(&preferences, &Preferences::recentChanged, w, [this] { fillRecentMenu(); });
}

void MainWindow::Impl::onEditor(Editor::Change change) {
  switch (change) {
    case Editor::Change::Overlay:
      return;
    case Editor::Change::Settings:
      preferences.setEditor(editor.settings());
      break;
    case Editor::Change::Document:
      if (pages->currentWidget() == workPage) views->zoomAllToFit();
      break;
    default:
      break;
  }
  // A drag changes the home with every move of the pointer.
  if (!editor.document().inTransaction())
    refresh();
  else if (!refreshSoon.isActive())
    refreshSoon.start();
}

void MainWindow::Impl::refresh() {
  actions->refresh();
  const auto name = [this](const char* id, const std::string& step) {
    QAction* action = actions->get(id);
    const bool undo = std::string_view(id) == "undo";
    const QString word =
        translated(undo ? QT_TRANSLATE_NOOP("idap", "&Undo") : QT_TRANSLATE_NOOP("idap", "&Redo"));
    action->setText(step.empty() ? word : word + QLatin1Char(' ') + translated(step.c_str()));
  };
  name("undo", editor.document().undoName());
  name("redo", editor.document().redoName());
  showStatus();
  retitle();
}

void MainWindow::Impl::showStatus() {
  selectionLabel->setText(homeShown ? selectionSummary(editor) : QString());
  if (!homeShown) {
    zoomLabel->clear();
    return;
  }
  // As a scale on paper: what is drawn as long as a metre is in nature.
  const double metresAPixelOfScreen = 0.0254 / std::max(1, w->logicalDpiX());
  const double scale = views->current().pixel() / metresAPixelOfScreen;
  zoomLabel->setText(QStringLiteral("1:%1").arg(qRound(scale)));
}

void MainWindow::Impl::showHome(bool open) {
  if (!open && homeShown) keepLayout();
  homeShown = open;
  actions->setHomeOpen(open);
  pages->setCurrentWidget(open ? workPage : static_cast<QWidget*>(welcome));
  if (open) {
    restoreLayout();
    views->zoomAllToFit();
    // When the layout has its final sizes.
    QTimer::singleShot(0, w, [this] { views->zoomAllToFit(); });
    views->current().setFocus(Qt::OtherFocusReason);
  } else {
    for (QDockWidget* dock : {catalogDock, propertyDock, listDock}) dock->hide();
    if (pictures) pictures->hide();
    if (film) film->hide();
    welcome->focusFirst();
  }
  retitle();
  refresh();
}

void MainWindow::Impl::restoreLayout() {
  for (QDockWidget* dock : {catalogDock, propertyDock, listDock}) dock->show();
  const QByteArray state = preferences.layout("docks");
  if (!state.isEmpty()) w->restoreState(state);
  const QByteArray planes = preferences.layout("planes");
  if (!planes.isEmpty()) views->restoreState(planes);
  for (QToolBar* bar : {commandBar, toolBar})
    if (bar) bar->show();
}

void MainWindow::Impl::keepLayout() {
  preferences.setLayout("geometry", w->saveGeometry());
  preferences.setLayout("docks", w->saveState());
  preferences.setLayout("planes", views->saveState());
}

void MainWindow::Impl::fitToolBars() {
  if (!commandBar || !toolBar) return;
  // The words under the drawing tools give way before the ten commands would have to.
  toolBar->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  const int wide = commandBar->sizeHint().width() + toolBar->sizeHint().width();
  if (wide > w->width()) toolBar->setToolButtonStyle(Qt::ToolButtonIconOnly);
}

void MainWindow::Impl::retitle() {
  const bool modified = files->isOpen() && editor.document().modified();
  w->setWindowTitle(files->isOpen() ? files->title() + QStringLiteral("[*]") : MainWindow::tr("Welcome"));
  w->setWindowModified(modified);
  catalogTabs->setTabText(0, MainWindow::tr("Furniture"));
  catalogTabs->setTabText(1, MainWindow::tr("Finishes"));
  tabs->setTabText(0, MainWindow::tr("Furniture"));
  tabs->setTabText(1, MainWindow::tr("Points of view"));
  tabs->setTabText(2, unseenWarnings > 0 ? MainWindow::tr("Messages (%1)").arg(unseenWarnings)
                                         : MainWindow::tr("Messages"));
}

void MainWindow::Impl::retranslate() {
  actions->retranslate();
  for (const auto& [menu, title] : menus) menu->setTitle(translated(title));
  catalogDock->setWindowTitle(MainWindow::tr("Catalog"));
  propertyDock->setWindowTitle(MainWindow::tr("Properties"));
  listDock->setWindowTitle(MainWindow::tr("Lists"));
  commandBar->setWindowTitle(MainWindow::tr("Commands"));
  toolBar->setWindowTitle(MainWindow::tr("Tools"));
  selectionLabel->setToolTip(MainWindow::tr("What is selected"));
  pointerLabel->setToolTip(MainWindow::tr("Where the pointer is"));
  zoomLabel->setToolTip(MainWindow::tr("The scale of the plan on this screen"));
  fillTemplateMenu();
  fillRecentMenu();
  retitle();
  refresh();
  fitToolBars();
}

void MainWindow::Impl::pictureForRecent() {
  const auto file = editor.document().file();
  if (file.empty()) return;
  // A little later, when nobody waits for the window.
  QTimer::singleShot(300, w, [this, file] {
    if (editor.document().file() == file) keepRecentPicture(toQt(file.string()), views->plan(Plane::XY));
  });
}

}  // namespace idap
