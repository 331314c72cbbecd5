#include "studio/catalog/piece_delegate.h"

#include <QListView>
#include <QTextLayout>

#include "studio/catalog/catalog_model.h"
#include "studio/catalog/thumbnail_store.h"

namespace idap {

namespace {

constexpr int kPadding = 4;
constexpr qreal kRadius = 5;
constexpr QColor kCard(0xE4, 0xE4, 0xE4);  // as the pictures' own ground

// Of a line in this font, with room for the marks above and below Thai letters that another font may draw.
qreal lineHeight(const QFont& font) {
  QTextLayout layout(QStringLiteral("Ågที่กู้ญ"), font);
  layout.beginLayout();
  QTextLine line = layout.createLine();
  line.setLineWidth(1e6);
  layout.endLayout();
  return std::max(line.height(), QFontMetricsF(font).height());
}

// Two lines, centred, the second cut short with an ellipsis between letters.
void drawName(QPainter& painter, const QRectF& area, const QString& name, const QFont& font) {
  QTextLayout layout(name, font);
  QTextOption wrap(Qt::AlignHCenter);
  wrap.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  layout.setTextOption(wrap);
  layout.beginLayout();
  QTextLine first = layout.createLine();
  first.setLineWidth(area.width());
  layout.endLayout();
  const qreal height = lineHeight(font);
  QTextOption centred(Qt::AlignHCenter | Qt::AlignVCenter);
  centred.setWrapMode(QTextOption::NoWrap);
  const int cut = first.textStart() + first.textLength();
  painter.drawText(QRectF(area.left(), area.top(), area.width(), height), name.left(cut).trimmed(), centred);
  if (cut >= name.size()) return;
  const QString rest = QFontMetricsF(font).elidedText(name.mid(cut).trimmed(), Qt::ElideRight, area.width());
  painter.drawText(QRectF(area.left(), area.top() + height, area.width(), height), rest, centred);
}

}  // namespace

int PieceDelegate::narrowest(const QFont& font) {
  return std::max(72, qRound(QFontMetricsF(font).height() * 4.9));
}

int PieceDelegate::heightFor(const QFont& font, int width) {
  return width + qCeil(2 * lineHeight(font)) + 2 * kPadding;
}

// All of the grid's cell.
QSize PieceDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
  if (const auto* grid = qobject_cast<const QListView*>(option.widget)) return grid->gridSize();
  const int width = narrowest(option.font);
  return {width, heightFor(option.font, width)};
}

void PieceDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
  const auto piece = index.data(CatalogModel::PieceRole).value<CatalogPiecePtr>();
  if (!piece) return;
  painter->save();
  painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  painter->setFont(option.font);
  const bool selected = option.state & QStyle::State_Selected,
             focused = option.state & QStyle::State_HasFocus;
  const bool hovered = option.state & QStyle::State_MouseOver;
  const QRectF cell = QRectF(option.rect).adjusted(2, 2, -2, -2);
  const QPalette& palette = option.palette;
  if (selected || hovered) {
    QColor back = palette.color(QPalette::Highlight);
    if (!selected) back.setAlphaF(0.18f);
    painter->setPen(Qt::NoPen);
    painter->setBrush(back);
    painter->drawRoundedRect(cell, kRadius, kRadius);
  }
  const qreal side = cell.width() - 2 * kPadding;
  const QRectF picture(cell.left() + kPadding, cell.top() + kPadding, side, side);
  QPainterPath card;
  card.addRoundedRect(picture, kRadius, kRadius);
  const QPixmap pixmap = thumbnails_.thumbnail(piece);
  painter->fillPath(card, kCard);
  if (!pixmap.isNull()) {
    painter->setClipPath(card);
    painter->drawPixmap(picture, pixmap, QRectF(pixmap.rect()));
    painter->setClipping(false);
  }
  if (index.data(CatalogModel::LikedRole).toBool()) {
    QFont star = option.font;
    star.setPointSizeF(star.pointSizeF() * 1.2);
    painter->setFont(star);
    painter->setPen(QColor(0xC9, 0x7A, 0x00));
    painter->drawText(picture.adjusted(0, 1, -4, 0), Qt::AlignRight | Qt::AlignTop, QStringLiteral("★"));
    painter->setFont(option.font);
  }
  painter->setPen(palette.color(selected ? QPalette::HighlightedText : QPalette::Text));
  drawName(*painter,
           QRectF(cell.left() + 1, picture.bottom() + 2, cell.width() - 2, cell.bottom() - picture.bottom()),
           index.data(Qt::DisplayRole).toString(), option.font);
  if (focused && !selected) {
    painter->setPen(QPen(palette.color(QPalette::Highlight), 1.5));
    painter->setBrush(Qt::NoBrush);
    painter->drawRoundedRect(cell, kRadius, kRadius);
  }
  painter->restore();
}

}  // namespace idap
