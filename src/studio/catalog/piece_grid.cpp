#include "studio/catalog/piece_grid.h"

#include <QBuffer>
#include <QContextMenuEvent>
#include <QDrag>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QScrollBar>
#include <QToolTip>

#include "studio/catalog/catalog_model.h"
#include "studio/catalog/piece_delegate.h"
#include "studio/catalog/thumbnail_store.h"
#include "studio/widgets/mime_types.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr int kTipSide = 160;  // logical pixels

QString imageTag(const QPixmap& pixmap) {
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  pixmap.save(&buffer, "PNG");
  return QStringLiteral("<img width='%1' height='%1' src='data:image/png;base64,%2'>")
      .arg(kTipSide)
      .arg(QString::fromLatin1(png.toBase64()));
}

}  // namespace

PieceGrid::PieceGrid(CatalogModel& model, ThumbnailStore& thumbnails, QWidget* parent)
    : QListView(parent), model_(model), thumbnails_(thumbnails) {
  setModel(&model);
  setItemDelegate(new PieceDelegate(thumbnails, this));
  setViewMode(QListView::IconMode);
  setMovement(QListView::Static);
  setResizeMode(QListView::Adjust);
  setUniformItemSizes(true);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setDragEnabled(true);
  setDragDropMode(QAbstractItemView::DragOnly);
  setMouseTracking(true);
  setWordWrap(true);
  layOut();
  connect(this, &QAbstractItemView::doubleClicked, this, [this](const QModelIndex& index) {
    if (const CatalogPiecePtr piece = model_.piece(index)) emit chosen(piece);
  });
  connect(&thumbnails, &ThumbnailStore::ready, this, [this](const QString& id) {
    const QModelIndex index = model_.indexOf(fromQt(id));
    if (index.isValid()) update(index);
    if (QToolTip::isVisible() && tipPiece_ == fromQt(id))
      if (const CatalogPiecePtr piece = model_.find(tipPiece_)) showTip(piece, tipAt_);
  });
}

CatalogPiecePtr PieceGrid::currentPiece() const { return model_.piece(currentIndex()); }

void PieceGrid::setEmptyText(const QString& text) {
  emptyText_ = text;
  viewport()->update();
}

// As many columns as fit, sharing the width evenly.
void PieceGrid::layOut() {
  const int width = viewport()->width() - 1, least = PieceDelegate::narrowest(font());
  const int columns = std::max(1, width / least);
  const int cell = std::max(least, width / columns);
  const QSize size(cell, PieceDelegate::heightFor(font(), cell));
  if (gridSize() == size) return;
  setGridSize(size);
  scheduleDelayedItemsLayout();
  verticalScrollBar()->setSingleStep(size.height() / 3);
}

void PieceGrid::startDrag(Qt::DropActions) {
  const CatalogPiecePtr piece = currentPiece();
  if (!piece) return;
  auto* mime = new QMimeData;
  mime->setData(QString::fromLatin1(kPieceMime), QByteArray::fromStdString(piece->id));
  auto* drag = new QDrag(this);
  drag->setMimeData(mime);
  if (QPixmap picture = thumbnails_.thumbnail(piece); !picture.isNull()) {
    const qreal scale = devicePixelRatioF();
    picture = picture.scaledToWidth(qRound(72 * scale), Qt::SmoothTransformation);
    picture.setDevicePixelRatio(scale);
    drag->setPixmap(picture);
    drag->setHotSpot({36, 36});
  }
  if (drag->exec(Qt::CopyAction) != Qt::IgnoreAction) emit dropped(piece);
}

void PieceGrid::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    if (const CatalogPiecePtr piece = currentPiece()) emit chosen(piece);
    return;
  }
  QListView::keyPressEvent(event);
}

void PieceGrid::contextMenuEvent(QContextMenuEvent* event) {
  QModelIndex index = indexAt(viewport()->mapFromGlobal(event->globalPos()));
  QPoint at = event->globalPos();
  if (event->reason() == QContextMenuEvent::Keyboard) {
    index = currentIndex();
    at = viewport()->mapToGlobal(visualRect(index).center());
  }
  if (const CatalogPiecePtr piece = model_.piece(index)) emit menuRequested(piece, at);
}

void PieceGrid::resizeEvent(QResizeEvent* event) {
  layOut();
  QListView::resizeEvent(event);
}

void PieceGrid::paintEvent(QPaintEvent* event) {
  QListView::paintEvent(event);
  if (model_.rowCount() > 0 || emptyText_.isEmpty()) return;
  QPainter painter(viewport());
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(viewport()->rect().adjusted(12, 12, -12, -12),
                   Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, emptyText_);
}

void PieceGrid::changeEvent(QEvent* event) {
  QListView::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) layOut();
}

bool PieceGrid::viewportEvent(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QListView::viewportEvent(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  if (const CatalogPiecePtr piece = model_.piece(indexAt(help->pos()))) {
    showTip(piece, help->globalPos());
  } else {
    QToolTip::hideText();
  }
  return true;
}

void PieceGrid::showTip(const CatalogPiecePtr& piece, QPoint global) {
  tipPiece_ = piece->id;
  tipAt_ = global;
  QPixmap picture = thumbnails_.large(piece);
  if (picture.isNull()) picture = thumbnails_.thumbnail(piece);
  const QString words = describe ? describe(*piece) : toQt(piece->name);
  QString text = QStringLiteral("<div style='white-space:nowrap'>%1</div>").arg(words);
  if (!picture.isNull()) text.prepend(imageTag(picture));
  const QModelIndex index = model_.indexOf(piece->id);
  QToolTip::showText(global, text, viewport(), visualRect(index));
}

}  // namespace idap
