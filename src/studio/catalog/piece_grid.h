// The pieces of the catalog as a grid of pictures with names: dragged from here, chosen by keys or a double
// click.
#pragma once

#include <QListView>

#include "catalog/catalog.h"

namespace idap {

class CatalogModel;
class ThumbnailStore;

class PieceGrid : public QListView {
  Q_OBJECT
 public:
  PieceGrid(CatalogModel& model, ThumbnailStore& thumbnails, QWidget* parent = nullptr);

  CatalogPiecePtr currentPiece() const;
  // The words of a tip, as rich text; the picture is put before them.
  std::function<QString(const CatalogPiece&)> describe;
  void setEmptyText(const QString& text);  // where nothing passes the filters

 signals:
  void chosen(CatalogPiecePtr piece);  // Enter or a double click
  void menuRequested(CatalogPiecePtr piece, QPoint global);
  void dropped(CatalogPiecePtr piece);

 protected:
  void startDrag(Qt::DropActions actions) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool viewportEvent(QEvent* event) override;

 private:
  void layOut();
  void showTip(const CatalogPiecePtr& piece, QPoint global);

  CatalogModel& model_;
  ThumbnailStore& thumbnails_;
  QString emptyText_;
  std::string tipPiece_;  // whose tip is shown
  QPoint tipAt_;
};

}  // namespace idap
