// A window as a user has it, in a folder of its own, and how its questions are answered.
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "catalog/catalog.h"
#include "gui/support/gui_support.h"
#include "studio/window/file_flow.h"
#include "studio/window/main_window.h"
#include "studio/window/preferences.h"
#include "studio/window/view_area.h"
#include "studio/window/window_actions.h"

namespace idap::test {

class WindowTest : public testing::Test {
 protected:
  void SetUp() override {
    // Built-in furniture only: the same on every machine.
    shared_ =
        std::make_shared<StudioShared>(std::make_shared<const Catalog>(std::vector<std::filesystem::path>()));
    EditorSettings settings;
    shared_->preferences->setEditor(settings);
    window_ = makeWindow();
  }
  void TearDown() override {
    window_.reset();
    shared_.reset();
    std::filesystem::remove_all(Recovery::folder());
  }

  std::unique_ptr<MainWindow> makeWindow() {
    auto window = std::make_unique<MainWindow>(shared_);
    window->resize(1280, 800);
    window->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    return window;
  }

  MainWindow& window() { return *window_; }
  Editor& editor() { return window_->editor(); }
  QAction* action(const char* id) {
    QAction* found = window_->actions().get(id);
    EXPECT_TRUE(found) << id;
    window_->actions().refresh();
    return found;
  }
  void trigger(const char* id) {
    QAction* found = action(id);
    ASSERT_TRUE(found && found->isEnabled()) << id;
    found->trigger();
  }
  template <class T>
  T* find(const char* name) {
    for (QWidget* top : QApplication::topLevelWidgets())
      if (top->isVisible()) {
        if (auto* self = qobject_cast<T*>(top); self && top->objectName() == QLatin1String(name)) return self;
        if (auto* below = top->findChild<T*>(QLatin1String(name))) return below;
      }
    return nullptr;
  }
  template <class T>
  T* await(const char* name) {
    waitFor([&] { return find<T>(name) != nullptr; });
    T* found = find<T>(name);
    EXPECT_TRUE(found) << name << " did not appear";
    return found;
  }
  bool settle() {
    return waitFor([this] { return !window_->busy(); });
  }
  void press(QMessageBox* box, QMessageBox::StandardButton button) {
    ASSERT_TRUE(box);
    QTest::mouseClick(box->button(button), Qt::LeftButton);
  }
  // Chooses a file in a dialog as if it had been typed.
  void choose(const char* dialogName, const QString& file) {
    auto* dialog = await<QFileDialog>(dialogName);
    ASSERT_TRUE(dialog);
    dialog->selectFile(file);
    emit dialog->fileSelected(file);
    dialog->close();
  }

  void newRoom() {
    window_->files().newRoom(5, 4, 2.5);
    ASSERT_TRUE(window_->files().isOpen());
  }
  FurnitureId put(const char* catalogId, Vec2 at);
  QString path(const char* name) const { return folder_.filePath(QLatin1String(name)); }

  QTemporaryDir folder_;
  std::shared_ptr<StudioShared> shared_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace idap::test
