#include "studio/plan/paint_symbol.h"

#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace idap {

namespace {

constexpr double kAreasFrom = 24;  // pixels: smaller symbols are one area and its outline
constexpr double kShortest = 2.5;  // pixels: shorter lines are left out
const Color kNoColor{0.8f, 0.8f, 0.8f};

}  // namespace

SymbolPainter::SymbolPainter(Canvas& canvas) : c_(canvas) {}

QColor SymbolPainter::tint(const PieceItem& item, std::size_t slot, bool sloped, bool faded) const {
  const Color color = slot < item.colors.size() ? item.colors[slot] : kNoColor;
  double strength = c_.colors.dark ? 0.42 : 0.46;
  if (item.symbol && slot < item.symbol->slots.size())
    strength *= 1 - 0.75 * double(item.symbol->slots[slot].clear);
  if (faded) strength *= 0.5;
  QColor wash = c_.colors.wash(color, strength);
  // White furniture on white paper still is a thing.
  wash = mixed(wash, c_.colors.ink, sloped ? 0.09 : 0.03);
  return wash;
}

void SymbolPainter::place(const PieceItem& item) {
  const double s = c_.view.scale, cosine = std::cos(item.turn), sine = std::sin(item.turn);
  double su = 1, sv = 1;
  if (!item.exact) {
    const Piece& piece = item.piece();
    const Vec2 size{piece.size.x, piece.size.y};
    if (item.symbol->size.x > 1e-6) su = size.x / item.symbol->size.x;
    if (item.symbol->size.y > 1e-6) sv = size.y / item.symbol->size.y;
  }
  ax_ = s * cosine * su, ay_ = -s * sine * su;
  bx_ = -s * sine * sv, by_ = -s * cosine * sv;
  const QPointF origin = c_.at(item.place);
  cx_ = origin.x(), cy_ = origin.y();
}

void SymbolPainter::box(const PieceItem& item, bool faded) {
  c_.p.setPen(c_.pen(faded ? c_.colors.faint : c_.colors.soft));
  c_.p.setBrush(tint(item, item.colors.size(), false, faded));
  c_.p.drawPolygon(c_.polygon(item.outline));
}

void SymbolPainter::drawOverhead(const PieceItem& item) {
  QPen pen = c_.pen(c_.colors.soft, 1, Qt::DashLine);
  // Qt's fast dashes: a symbol has hundreds of lines, and nobody follows their dashes across a patch.
  if (!c_.printing()) pen.setWidthF(1);
  c_.p.setPen(pen);
  c_.p.setBrush(Qt::NoBrush);
  if (!item.symbol || item.symbol->empty()) {
    c_.p.drawPolygon(c_.polygon(item.outline));
    return;
  }
  place(item);
  for (const SymbolRing& ring : item.symbol->outline) {
    points_.clear();
    for (const Vec2f point : ring) points_.push_back(map(point));
    c_.p.drawPolygon(points_.data(), int(points_.size()));
  }
}

void SymbolPainter::draw(const PieceItem& item, bool faded) {
  if (!item.symbol || item.symbol->empty()) {
    box(item, faded);
    return;
  }
  const Symbol& symbol = *item.symbol;
  place(item);
  const Vec2 extent = item.box.max - item.box.min;
  const double pixels = std::max(extent.x, extent.y) * c_.view.scale;
  const bool large = pixels >= kAreasFrom || c_.printing();
  const auto fill = [this](const std::vector<SymbolRing>& rings) {
    if (rings.size() == 1) {
      points_.clear();
      for (const Vec2f point : rings.front()) points_.push_back(map(point));
      c_.p.drawPolygon(points_.data(), int(points_.size()));
      return;
    }
    QPainterPath path;
    path.setFillRule(Qt::OddEvenFill);
    for (const SymbolRing& ring : rings) {
      QPolygonF polygon;
      polygon.reserve(qsizetype(ring.size()));
      for (const Vec2f point : ring) polygon << map(point);
      path.addPolygon(polygon);
      path.closeSubpath();
    }
    c_.p.drawPath(path);
  };
  const QColor ink = faded ? c_.colors.faint : mixed(c_.colors.paper, c_.colors.ink, 0.88);
  const QColor fine = faded ? c_.colors.faint : mixed(c_.colors.paper, c_.colors.ink, 0.55);
  const std::size_t main = symbol.areas.empty() ? 0 : symbol.areas.front().slot;
  if (!large) {
    c_.p.setPen(c_.pen(fine));
    c_.p.setBrush(tint(item, main, false, faded));
    points_.clear();
    for (const Vec2f point : symbol.coarse) points_.push_back(map(point));
    c_.p.drawPolygon(points_.data(), int(points_.size()));
    return;
  }
  c_.p.setPen(Qt::NoPen);
  c_.p.setBrush(tint(item, main, false, faded));
  fill(symbol.outline);
  for (const SymbolArea& area : symbol.areas) {
    if (area.slot == main && !area.sloped) continue;
    c_.p.setBrush(tint(item, area.slot, area.sloped, faded));
    fill(area.rings);
  }
  const QPen finePen = c_.pen(fine, 1), inkPen = c_.pen(ink, 1);
  const double shortest = kShortest / c_.view.scale;
  c_.p.setBrush(Qt::NoBrush);
  c_.p.setPen(finePen);
  bool heavy = false;
  for (const SymbolLine& line : symbol.lines) {
    if (double(line.length) < shortest) break;
    if (line.outline != heavy) c_.p.setPen((heavy = line.outline) ? inkPen : finePen);
    points_.clear();
    for (const Vec2f point : line.points) points_.push_back(map(point));
    c_.p.drawPolyline(points_.data(), int(points_.size()));
  }
}

}  // namespace idap
