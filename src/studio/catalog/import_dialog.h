// Bringing furniture from files: a whole library into the user's own, or one model into the home as a piece.
#pragma once

#include <QDialog>
#include <filesystem>
#include <memory>

#include "editor/editor.h"

namespace idap {

class ImportDialog : public QDialog {
  Q_OBJECT
 public:
  // Asks for a file at first. Shown without blocking, by show() or open().
  explicit ImportDialog(Editor& editor, QWidget* parent = nullptr);
  ~ImportDialog() override;

  void chooseFile(const std::filesystem::path& file);  // one that is known already (dropped on the window)

 signals:
  void libraryImported();  // the catalog has it already; its panel should reload()
  void pieceImported();    // it is in the home, selected

 protected:
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
