// What every chapter of pictures needs: a window with the sample home in it, and ways to do and to show
// things.
#pragma once

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QTest>
#include <cstdio>

#include "studio/plan/plan_view.h"
#include "studio/widgets/texts.h"
#include "studio/window/file_flow.h"
#include "studio/window/main_window.h"
#include "studio/window/preferences.h"
#include "studio/window/view_area.h"
#include "studio/window/window_actions.h"

namespace idap {

class Photographer {
 public:
  Photographer(const QString& folder, const QString& language, Preferences::Theme theme)
      : folder_(folder),
        shared_(std::make_shared<StudioShared>(
            std::make_shared<const Catalog>(std::vector<std::filesystem::path>{}))) {
    EditorSettings settings = shared_->preferences->editor();
    settings.language = fromQt(language);
    shared_->preferences->setEditor(settings);
    shared_->preferences->setTheme(theme);
    const QString homes = QStringLiteral(IDAP_SOURCE_DIR "/share/templates/");
    for (const char* name : {"kitchen.idap", "studio-apartment.idap"})
      shared_->preferences->addRecent(homes + QLatin1String(name));
    window_ = std::make_unique<MainWindow>(shared_);
    window_->resize(1280, 800);
    window_->show();
    QTest::qWait(300);
  }

 protected:
  Editor& editor() { return window_->editor(); }
  PlanView& plan(Plane plane) { return window_->views().plan(plane); }

  void shoot(const char* name, QWidget* widget = nullptr) {
    QTest::qWait(60);
    if (!widget) widget = window_.get();
    if (!widget->grab().save(folder_.filePath(QLatin1String(name) + QStringLiteral(".png"))))
      std::fprintf(stderr, "screenshots: cannot write %s\n", name);
  }

  void trigger(const char* id) {
    window_->actions().refresh();
    QAction* action = window_->actions().get(id);
    if (!action || !action->isEnabled()) {
      std::fprintf(stderr, "screenshots: nothing to be done with %s\n", id);
      return;
    }
    action->trigger();
    QTest::qWait(30);
  }

  void openSample() {
    window_->openFile(IDAP_SOURCE_DIR "/share/samples/apartment.idap");
    (void)QTest::qWaitFor([this] { return window_->files().isOpen() && !window_->busy(); }, 20'000);
    window_->views().zoomAllToFit();
    QTest::qWait(4000);  // symbols and thumbnails come one by one
  }

  FurnitureId piece(const char* catalogId) {
    for (const auto& [id, furniture] : editor().home().furniture)
      if (furniture->model.catalogId == catalogId) return id;
    return {};
  }
  void select(const char* catalogId) {
    Elements one;
    one.furniture.push_back(piece(catalogId));
    editor().select(one);
  }
  template <class W>
  W* part(QWidget* of, const char* name) {
    W* found = of->findChild<W*>(QLatin1String(name));
    if (!found) qFatal("screenshots: there is no %s", name);
    return found;
  }
  QWidget* topLevel(const char* name) {
    for (QWidget* top : QApplication::topLevelWidgets())
      if (top->isVisible() && top->objectName() == QLatin1String(name)) return top;
    qFatal("screenshots: there is no window %s", name);
  }
  QWidget* topDialog() {
    for (QWidget* top : QApplication::topLevelWidgets())
      if (top->isVisible() && qobject_cast<QDialog*>(top)) return top;
    return nullptr;
  }
  void shootDialog(const char* name, int wait = 0) {
    (void)QTest::qWaitFor([this] { return topDialog() != nullptr; }, 2000);
    QWidget* dialog = topDialog();
    if (!dialog) {
      std::fprintf(stderr, "screenshots: no dialog for %s\n", name);
      return;
    }
    QTest::qWait(wait);
    shoot(name, dialog);
    static_cast<QDialog*>(dialog)->reject();
    QTest::qWait(50);
  }
  void dialog(const char* id) {
    trigger(id);
    shootDialog((std::string("dialog-") + id).c_str(), 300);
  }

  QDir folder_;
  std::shared_ptr<StudioShared> shared_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace idap
