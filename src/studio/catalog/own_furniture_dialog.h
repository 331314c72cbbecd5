// Save as furniture: what is selected becomes a piece of the user's own catalog; and the same form again, to
// change what was said of a piece.
#pragma once

#include <QDialog>
#include <memory>

#include "editor/editor.h"

namespace idap {

class OwnFurnitureDialog : public QDialog {
  Q_OBJECT
 public:
  // Of what is selected.
  explicit OwnFurnitureDialog(Editor& editor, QWidget* parent = nullptr);
  // Of a piece that is in the user's catalog already.
  OwnFurnitureDialog(Editor& editor, const std::string& id, QWidget* parent = nullptr);
  ~OwnFurnitureDialog() override;

  static bool isOwn(const std::string& id);

  void accept() override;

 signals:
  void saved();  // the catalog's panel should reload()

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
