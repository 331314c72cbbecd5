// Draws one piece of the catalog: its picture on a card, its name on two lines.
#pragma once

#include <QStyledItemDelegate>

namespace idap {

class ThumbnailStore;

class PieceDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  PieceDelegate(ThumbnailStore& thumbnails, QObject* parent)
      : QStyledItemDelegate(parent), thumbnails_(thumbnails) {}

  // Sizes in logical pixels, by the font.
  static int narrowest(const QFont& font);  // width of a cell
  static int heightFor(const QFont& font, int width);

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  ThumbnailStore& thumbnails_;
};

}  // namespace idap
