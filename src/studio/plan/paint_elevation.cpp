// The building from the side: floors and ceilings with their heights, walls, and what stands in them.
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <limits>

#include "model/edits/level_edits.h"
#include "studio/plan/elevation.h"
#include "studio/plan/paint_symbol.h"
#include "studio/plan/painters.h"
#include "studio/plan/piece_items.h"
#include "studio/plan/wall_hatch.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

class StoreyPainter : public Painter {
 public:
  void paint(const Drawing& drawing, Canvas& c) const override {
    const double floor = drawing.elevation();
    const double ceiling = floor + ceilingHeight(drawing.home, drawing.level);
    // Dashes begin at the same places whatever part is painted, so that parts fit together. They repeat after
    // 6 and after 9 times their width.
    constexpr double kRepeat = 18 * kDashedWidth;
    const double repeat = kRepeat / c.view.scale;
    const double left = std::floor(c.area.min.x / repeat) * repeat, right = c.area.max.x;
    c.p.setPen(c.pen(c.colors.faint, 1, Qt::DashLine));
    for (const auto& [id, level] : drawing.home.levels)
      if (!(id == drawing.level)) c.line({left, level->elevation}, {right, level->elevation});
    if (!drawing.home.levels.empty() || std::abs(floor) > 1e-9) {
      c.p.setPen(c.pen(c.colors.faint));
      c.line({left, 0}, {right, 0});
    }
    c.p.setPen(c.pen(c.colors.soft, 1, Qt::DashDotLine));
    c.line({left, ceiling}, {right, ceiling});
    c.p.setPen(c.pen(c.colors.ink, 1.6));
    c.line({left, floor}, {right, floor});
  }
  void changed(const HomeDiff& diff, const Drawing& before, const Drawing& after,
               DirtyBoxes& dirty) const override {
    if (!diff.levels.empty() ||
        ceilingHeight(before.home, before.level) != ceilingHeight(after.home, after.level))
      dirty.all = true;
  }
};

// Whether a wall between the section and a piece before it hides most of that piece.
bool behindAWall(const PieceItem& item, const std::vector<WallFace>& front) {
  const double middle = (item.near + item.far) / 2, width = item.box.max.x - item.box.min.x;
  for (const WallFace& face : front) {
    if (face.near > middle) continue;
    const Box2 box = bounds(face.polygon);
    const double shared = std::min(box.max.x, item.box.max.x) - std::max(box.min.x, item.box.min.x);
    if (shared > 0.5 * width) return true;
  }
  return false;
}

// Walls and what stands between them, from the farthest to the nearest: up to the section as they are seen,
// before it in outline.
class ElevationPainter : public Painter {
 public:
  void paint(const Drawing& drawing, Canvas& c) const override {
    std::vector<WallFace> behind, cut, front;
    for (const auto& [id, wall] : drawing.home.walls) {
      if (!(wall->level == drawing.level)) continue;
      for (WallFace& face : wallFaces(drawing.home, id, *wall, drawing.plane, drawing.section))
        (face.kind == WallFace::Kind::Front ? front
         : face.kind == WallFace::Kind::Cut ? cut
                                            : behind)
            .push_back(std::move(face));
    }
    std::sort(behind.begin(), behind.end(),
              [](const WallFace& a, const WallFace& b) { return a.near < b.near; });
    SymbolPainter symbols(c);
    // What stands behind a wall shows through it faintly: it can still be found, and is no part of the room.
    auto next = behind.begin();
    const auto wallsUpTo = [&](double near) {
      for (; next != behind.end() && next->near <= near; ++next) wall(c, *next);
    };
    bool sectionDrawn = false;
    const auto drawSection = [&] {
      sectionDrawn = true;
      wallsUpTo(std::numeric_limits<double>::infinity());
      for (const WallFace& face : cut) {
        QPainterPath path;
        path.addPolygon(c.polygon(face.polygon));
        path.closeSubpath();
        fillWall(c, path, {});
        c.p.setPen(c.pen(c.colors.ink, 1));
        c.p.setBrush(Qt::NoBrush);
        c.p.drawPath(path);
      }
    };
    for (const PieceItem* item : drawing.pieces.items()) {
      const double middle = (item->near + item->far) / 2;
      if (middle > drawing.section && !sectionDrawn) drawSection();
      if (!sectionDrawn) wallsUpTo(item->opening ? item->near + 0.5 : middle);  // a window is in its wall
      if (!c.shows(item->box)) continue;
      const bool open =
          item->opening ? middle > drawing.section : middle > drawing.section && behindAWall(*item, front);
      if (open) {
        outlineOnly(c, *item);
      } else if (item->opening && item->opening->kind == OpeningKind::Bare) {
        c.p.setPen(c.pen(c.colors.soft));
        c.p.setBrush(c.colors.paper);
        c.p.drawPolygon(c.polygon(item->outline));
      } else {
        symbols.draw(*item);
      }
    }
    if (!sectionDrawn) drawSection();
    c.p.setBrush(Qt::NoBrush);
    c.p.setPen(c.pen(c.colors.faint, 1, Qt::DashLine));
    for (const WallFace& face : front)
      if (c.shows(bounds(face.polygon))) c.p.drawPolygon(c.polygon(face.polygon));
  }

  void changed(const HomeDiff& diff, const Drawing& before, const Drawing& after,
               DirtyBoxes& dirty) const override {
    if (!diff.groups.empty()) dirty.all = true;
    if (before.section != after.section) dirty.all = true;
    const auto piece = [](const Drawing& drawing) {
      return [&drawing](auto, const Piece& each) {
        return bounds(outline(drawing.plane, each, elevationOf(drawing.home, each.level)));
      };
    };
    addChanged(diff.furniture, before.home.furniture, after.home.furniture, piece(before), piece(after),
               dirty);
    addChanged(diff.openings, before.home.openings, after.home.openings, piece(before), piece(after), dirty);
    const auto walls = [](const Drawing& drawing) {
      return [&drawing](WallId id, const Wall& wall) {
        Box2 all;
        for (const WallId each : {id, wall.neighbourAtStart, wall.neighbourAtEnd})
          if (const Wall* w = each ? drawing.home.walls.find(each) : nullptr)
            for (const WallFace& face : wallFaces(drawing.home, each, *w, drawing.plane, drawing.section))
              add(all, bounds(face.polygon));
        // A wall that hides pieces decides on how they look.
        for (const PieceItem* item : drawing.pieces.items())
          if (item->box.overlaps(all)) add(all, item->box);
        return all;
      };
    };
    addChanged(diff.walls, before.home.walls, after.home.walls, walls(before), walls(after), dirty);
  }

  void extend(const Drawing& drawing, Box2& box) const override {
    for (const auto& [id, wall] : drawing.home.walls)
      if (wall->level == drawing.level)
        for (const WallFace& face : wallFaces(drawing.home, id, *wall, drawing.plane, drawing.section))
          add(box, bounds(face.polygon));
    add(box, drawing.pieces.bounds());
    if (box.empty()) return;  // a floor and a ceiling alone are without an end
    const double left = box.min.x, floor = drawing.elevation();
    box.add({left, floor});
    box.add({left, floor + ceilingHeight(drawing.home, drawing.level)});
  }

 private:
  static void wall(Canvas& c, const WallFace& face) {
    if (!c.shows(bounds(face.polygon))) return;
    QColor pale = c.colors.wallPale;
    pale.setAlphaF(0.86f);
    c.p.setPen(c.pen(c.colors.faint));
    c.p.setBrush(pale);
    c.p.drawPolygon(c.polygon(face.polygon));
  }
  static void outlineOnly(Canvas& c, const PieceItem& item) {
    c.p.setPen(c.pen(c.colors.faint, 1, Qt::DashLine));
    c.p.setBrush(Qt::NoBrush);
    c.p.drawPolygon(c.polygon(item.outline));
  }
};

}  // namespace

const Painter& storeyPainter() {
  static const StoreyPainter painter;
  return painter;
}
const Painter& elevationPainter() {
  static const ElevationPainter painter;
  return painter;
}

}  // namespace idap
