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
  // file: already chosen (dropped on the window); empty: the user is asked. Shown without blocking by show()
  // or open().
  explicit ImportDialog(Editor& editor, std::filesystem::path file = {}, QWidget* parent = nullptr);
  ~ImportDialog() override;

  void chooseFile(const std::filesystem::path& file);

 signals:
  void libraryImported();  // the catalog has it already; its panel should reload()
  void pieceImported();    // it is in the home, selected

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
