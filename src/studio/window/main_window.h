// The studio's window: toolbar, planes, catalog, properties, lists, and the file being worked on.
#pragma once

#include <QMainWindow>
#include <filesystem>
#include <memory>

#include "editor/editor.h"

namespace idap {

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(std::shared_ptr<const Catalog> catalog, QWidget* parent = nullptr);
  ~MainWindow() override;

  Editor& editor();
  void openFile(const std::filesystem::path& file);  // in the background, with progress
  bool busy() const;                                 // reading or saving

 protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
