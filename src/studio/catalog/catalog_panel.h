// The left side of the window: furniture by category, searched, filtered, seen in traced thumbnails; dragged
// from here into any plane, or placed by a double click or Enter.
#pragma once

#include <QWidget>
#include <memory>

#include "editor/editor.h"

namespace idap {

class ThumbnailStore;

class CatalogPanel : public QWidget {
  Q_OBJECT
 public:
  CatalogPanel(Editor& editor, ThumbnailStore& thumbnails, QWidget* parent = nullptr);
  ~CatalogPanel() override;

  void focusSearch();
  void reload();  // after libraries came or went

 signals:
  void importRequested();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
