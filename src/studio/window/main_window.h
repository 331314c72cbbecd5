// The studio's window: toolbar, planes, catalog, properties, lists, and the file being worked on.
#pragma once

#include <QMainWindow>
#include <filesystem>
#include <functional>
#include <memory>

#include "editor/editor.h"

namespace idap {

class FileFlow;
class Preferences;
class ThumbnailStore;
class ViewArea;
class WindowActions;

// What all windows of the program have together.
struct StudioShared {
  explicit StudioShared(std::shared_ptr<const Catalog> catalog);
  ~StudioShared();
  std::shared_ptr<const Catalog> catalog;
  std::unique_ptr<Preferences> preferences;
  std::unique_ptr<ThumbnailStore> thumbnails;
};

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(std::shared_ptr<const Catalog> catalog, QWidget* parent = nullptr);
  explicit MainWindow(std::shared_ptr<StudioShared> shared, QWidget* parent = nullptr);
  ~MainWindow() override;

  Editor& editor();
  void openFile(const std::filesystem::path& file);  // in the background, with progress
  void offerRestore();                               // of what a program that stopped has left; asks
  bool busy() const;                                 // reading or saving

  Preferences& preferences();
  FileFlow& files();
  ViewArea& views();
  WindowActions& actions();
  MainWindow* newWindow();  // another one, shown; belongs to itself
  // Closes when nothing is lost by it; then is not called where the user goes on working instead.
  void closeThen(std::function<void()> then);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
