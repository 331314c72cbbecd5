#include <QPainterPath>
#include <cmath>

#include "studio/plan/paint_symbol.h"
#include "studio/plan/painters.h"
#include "studio/plan/piece_items.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr double kNameSize = 0.18;  // m
constexpr double kOverhead = 1.25;  // m: what begins higher is above the cut of a plan, drawn dashed

// A sun-like sign in the middle of what gives light.
void drawLamp(Canvas& c, const PieceItem& item) {
  const Vec2 middle = (item.box.min + item.box.max) * 0.5;
  const double size =
      std::min({item.box.max.x - item.box.min.x, item.box.max.y - item.box.min.y, 0.24}) * c.view.scale / 2;
  const double r = std::max(size, 3.0);
  const bool on = item.furniture->lamp->on;
  const QPointF at = c.at(middle);
  c.p.setPen(c.pen(c.colors.ink, 1));
  c.p.setBrush(on ? mixed(c.colors.paper, QColor(255, 200, 40), c.colors.dark ? 0.7 : 0.8) : c.colors.paper);
  c.p.drawEllipse(at, r * 0.55, r * 0.55);
  if (r < 5) return;
  for (int ray = 0; ray < 8; ++ray) {
    const double angle = ray * kPi / 4;
    const QPointF way(std::cos(angle), std::sin(angle));
    c.p.drawLine(at + way * r * 0.75, at + way * r);
  }
}

// Which way is up: from the foot of a straight flight, at its front, to its back.
void drawStairs(Canvas& c, const PieceItem& item) {
  const Piece& piece = item.piece();
  if (piece.size.y < 1.3 * piece.size.x || piece.pitch != 0 || piece.roll != 0) return;
  const Vec2 middle{piece.position.x, piece.position.y};
  const Vec2 back = rotated(Vec2{0, 1}, piece.angle), right = rotated(Vec2{1, 0}, piece.angle);
  const Vec2 from = middle - back * (piece.size.y * 0.42), to = middle + back * (piece.size.y * 0.42);
  const double head = std::min(0.16, piece.size.x / 4);
  c.p.setPen(c.pen(c.colors.ink, 1.4));
  c.p.setBrush(c.colors.paper);
  c.line(from, to);
  c.p.drawPolyline(
      c.polygon({to - back * head - right * (head * 0.6), to, to - back * head + right * (head * 0.6)}));
  c.p.drawEllipse(c.at(from), 2.5, 2.5);
}

class FurniturePainter : public Painter {
 public:
  void paint(const Drawing& drawing, Canvas& c) const override {
    std::vector<const PieceItem*> shown;
    for (const PieceItem* item : drawing.pieces.items())
      if (item->furniture && c.shows(itemBox(*item))) shown.push_back(item);
    SymbolPainter symbols(c);
    for (const PieceItem* item : shown) {
      if (item->far > kOverhead) {
        symbols.drawOverhead(*item);
      } else {
        symbols.draw(*item);
      }
      if (!item->furniture->staircaseCutOut.empty()) drawStairs(c, *item);
      if (item->furniture->lamp) drawLamp(c, *item);
    }
    if (kNameSize * c.view.scale < kSmallestText) return;
    TextStyle style;
    style.size = kNameSize;
    const QFont font = c.fontOf(style);
    c.p.setPen(c.pen(c.colors.ink));
    for (const PieceItem* item : shown)
      if (item->furniture->nameVisible)
        c.text((item->box.min + item->box.max) * 0.5, toQt(item->furniture->name), font, 0,
               TextAlignment::Centre, Canvas::Ground::Halo);
  }

  void changed(const HomeDiff& diff, const Drawing& before, const Drawing& after,
               DirtyBoxes& dirty) const override {
    if (!diff.groups.empty()) dirty.all = true;  // what they hold may be hidden now
    const auto box = [&](const Drawing& drawing) {
      return [&drawing](FurnitureId, const Furniture& piece) {
        Box2 all = bounds(outline(drawing.plane, piece, elevationOf(drawing.home, piece.level)));
        if (piece.nameVisible) add(all, textBox((all.min + all.max) * 0.5, piece.name, kNameSize));
        return all;
      };
    };
    addChanged(diff.furniture, before.home.furniture, after.home.furniture, box(before), box(after), dirty);
  }

  void extend(const Drawing& drawing, Box2& box) const override { add(box, drawing.pieces.bounds()); }

 private:
  static Box2 itemBox(const PieceItem& item) {
    Box2 box = item.box;
    if (item.furniture->nameVisible)
      add(box, textBox((box.min + box.max) * 0.5, item.furniture->name, kNameSize));
    return box;
  }
};

}  // namespace

const Painter& furniturePainter() {
  static const FurniturePainter painter;
  return painter;
}

}  // namespace idap
