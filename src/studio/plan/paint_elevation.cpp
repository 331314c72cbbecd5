// The building from the side: floors and ceilings with their heights, walls, and what stands in them.
#include <cmath>

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
    const double ceiling = floor + heightOf(drawing);
    const double left = c.area.min.x, right = c.area.max.x;
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
    if (!diff.levels.empty() || heightOf(before) != heightOf(after)) dirty.all = true;
  }
  void extend(const Drawing& drawing, Box2& box) const override {
    if (box.empty()) return;
    box.add({box.min.x, drawing.elevation()});
    box.add({box.min.x, drawing.elevation() + heightOf(drawing)});
  }

  static double heightOf(const Drawing& drawing) {
    const Level* level = drawing.home.levels.find(drawing.level);
    return level ? level->height : drawing.home.wallHeight;
  }
};

class ElevationPainter : public Painter {
 public:
  void paint(const Drawing& drawing, Canvas& c) const override {
    std::vector<WallFace> faces;
    for (const auto& [id, wall] : drawing.home.walls) {
      if (!(wall->level == drawing.level)) continue;
      for (WallFace& face : wallFaces(drawing.home, id, *wall, drawing.plane, drawing.section))
        if (face.kind != WallFace::Kind::Front && c.shows(bounds(face.polygon)))
          faces.push_back(std::move(face));
    }
    std::sort(faces.begin(), faces.end(),
              [](const WallFace& a, const WallFace& b) { return a.near < b.near; });
    for (const WallFace& face : faces) {
      if (face.kind != WallFace::Kind::Behind) continue;
      c.p.setPen(c.pen(c.colors.faint));
      c.p.setBrush(c.colors.wallPale);
      c.p.drawPolygon(c.polygon(face.polygon));
    }
    c.p.setPen(c.pen(c.colors.ink, 1));
    for (const WallFace& face : faces) {
      if (face.kind != WallFace::Kind::Cut) continue;
      fillWall(c, c.polygon(face.polygon), {});
      c.p.setPen(c.pen(c.colors.ink, 1));
      c.p.setBrush(Qt::NoBrush);
      c.p.drawPolygon(c.polygon(face.polygon));
    }
  }
  void changed(const HomeDiff& diff, const Drawing& before, const Drawing& after,
               DirtyBoxes& dirty) const override {
    if (diff.walls.empty()) return;
    if (before.section != after.section) dirty.all = true;
    const auto box = [](const Drawing& drawing) {
      return [&drawing](WallId id, const Wall& wall) {
        Box2 all;
        for (const WallId each : {id, wall.neighbourAtStart, wall.neighbourAtEnd})
          if (const Wall* w = each ? drawing.home.walls.find(each) : nullptr)
            for (const WallFace& face : wallFaces(drawing.home, each, *w, drawing.plane, drawing.section))
              add(all, bounds(face.polygon));
        return all;
      };
    };
    addChanged(diff.walls, before.home.walls, after.home.walls, box(before), box(after), dirty);
  }
  void extend(const Drawing& drawing, Box2& box) const override {
    for (const auto& [id, wall] : drawing.home.walls)
      if (wall->level == drawing.level)
        for (const WallFace& face : wallFaces(drawing.home, id, *wall, drawing.plane, drawing.section))
          add(box, bounds(face.polygon));
  }
};

class ElevationPiecePainter : public Painter {
 public:
  void paint(const Drawing& drawing, Canvas& c) const override {
    SymbolPainter symbols(c);
    // What is in the walls behind first: nothing stands behind a wall.
    for (const PieceItem* item : drawing.pieces.items())
      if (item->opening && c.shows(item->box) &&
          !inFront(drawing.home, *item->opening, drawing.plane, drawing.section))
        drawOpening(c, symbols, *item);
    for (const PieceItem* item : drawing.pieces.items())
      if (item->furniture && c.shows(item->box)) symbols.draw(*item);
    // Then what is before the section, in outline only.
    c.p.setBrush(Qt::NoBrush);
    c.p.setPen(c.pen(c.colors.faint, 1, Qt::DashLine));
    for (const auto& [id, wall] : drawing.home.walls) {
      if (!(wall->level == drawing.level)) continue;
      for (const WallFace& face : wallFaces(drawing.home, id, *wall, drawing.plane, drawing.section))
        if (face.kind == WallFace::Kind::Front && c.shows(bounds(face.polygon)))
          c.p.drawPolygon(c.polygon(face.polygon));
    }
    for (const PieceItem* item : drawing.pieces.items())
      if (item->opening && c.shows(item->box) &&
          inFront(drawing.home, *item->opening, drawing.plane, drawing.section))
        c.p.drawPolygon(c.polygon(item->outline));
  }
  void changed(const HomeDiff& diff, const Drawing& before, const Drawing& after,
               DirtyBoxes& dirty) const override {
    if (!diff.groups.empty()) dirty.all = true;
    const auto box = [](const Drawing& drawing) {
      return [&drawing](auto, const Piece& piece) {
        return bounds(outline(drawing.plane, piece, elevationOf(drawing.home, piece.level)));
      };
    };
    addChanged(diff.furniture, before.home.furniture, after.home.furniture, box(before), box(after), dirty);
    addChanged(diff.openings, before.home.openings, after.home.openings, box(before), box(after), dirty);
  }
  void extend(const Drawing& drawing, Box2& box) const override { add(box, drawing.pieces.bounds()); }

 private:
  static void drawOpening(Canvas& c, SymbolPainter& symbols, const PieceItem& item) {
    if (item.opening->kind != OpeningKind::Bare) {
      symbols.draw(item);
      return;
    }
    c.p.setPen(c.pen(c.colors.soft));
    c.p.setBrush(c.colors.paper);
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
const Painter& elevationPiecePainter() {
  static const ElevationPiecePainter painter;
  return painter;
}

}  // namespace idap
