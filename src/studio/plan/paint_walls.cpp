#include <QPainterPath>
#include <map>

#include "model/wall_outline.h"
#include "studio/plan/painters.h"
#include "studio/plan/wall_hatch.h"

namespace idap {

namespace {

// The area of a wall, and of those it is joined to: their mitres follow.
Box2 wallBox(const Home& home, WallId id, const Wall& wall) {
  Box2 box = bounds(wallOutline(home, id, wall).polygon());
  for (const WallId next : {wall.neighbourAtStart, wall.neighbourAtEnd})
    if (const Wall* other = next ? home.walls.find(next) : nullptr)
      add(box, bounds(wallOutline(home, next, *other).polygon()));
  return box;
}

class WallPainter : public Painter {
 public:
  void paint(const Drawing& drawing, Canvas& c) const override {
    std::map<std::string, QPainterPath> byPattern;
    std::vector<QPolygonF> outlines;
    for (const auto& [id, wall] : drawing.home.walls) {
      if (!(wall->level == drawing.level)) continue;
      const Polygon polygon = wallOutline(drawing.home, id, *wall).polygon();
      if (!c.shows(bounds(polygon))) continue;
      QPainterPath& path = byPattern[wall->pattern];
      path.setFillRule(Qt::WindingFill);
      path.addPolygon(outlines.emplace_back(c.polygon(polygon)));
      path.closeSubpath();
    }
    // All outlines first and all fills over them: what is left is the outline of the walls together, with no
    // lines across where they meet.
    const QPen outline = c.pen(c.colors.ink, 2.4);
    c.p.setPen(outline);
    c.p.setBrush(Qt::NoBrush);
    for (const QPolygonF& polygon : outlines) c.p.drawPolygon(polygon);
    for (const auto& [pattern, path] : byPattern) fillWall(c, path, pattern);
  }

  void changed(const HomeDiff& diff, const Drawing& before, const Drawing& after,
               DirtyBoxes& dirty) const override {
    addChanged(
        diff.walls, before.home.walls, after.home.walls,
        [&](WallId id, const Wall& wall) { return wallBox(before.home, id, wall); },
        [&](WallId id, const Wall& wall) { return wallBox(after.home, id, wall); }, dirty);
  }

  void extend(const Drawing& drawing, Box2& box) const override {
    for (const auto& [id, wall] : drawing.home.walls)
      if (wall->level == drawing.level) add(box, bounds(wallOutline(drawing.home, id, *wall).polygon()));
  }
};

class LevelBelowPainter : public Painter {
 public:
  void paint(const Drawing& drawing, Canvas& c) const override {
    const LevelId below = levelBelow(drawing);
    if (!below) return;
    c.p.setPen(c.pen(c.colors.faint));
    c.p.setBrush(Qt::NoBrush);
    for (const auto& [id, wall] : drawing.home.walls) {
      if (!(wall->level == below)) continue;
      const Polygon polygon = wallOutline(drawing.home, id, *wall).polygon();
      if (c.shows(bounds(polygon))) c.p.drawPolygon(c.polygon(polygon));
    }
    c.p.setPen(c.pen(c.colors.faint, 1, Qt::DotLine));
    for (const auto& [id, room] : drawing.home.rooms)
      if (room->level == below && c.shows(bounds(room->points))) c.p.drawPolygon(c.polygon(room->points));
  }

  void changed(const HomeDiff& diff, const Drawing& before, const Drawing&,
               DirtyBoxes& dirty) const override {
    if (!diff.levels.empty() && before.settings.levelBelowShown) dirty.all = true;
  }

 private:
  static LevelId levelBelow(const Drawing& drawing) {
    const Level* own = drawing.level ? drawing.home.levels.find(drawing.level) : nullptr;
    if (!own || !drawing.settings.levelBelowShown) return {};
    const auto rank = [](const Level& level) { return std::pair(level.elevation, level.order); };
    LevelId found;
    for (const auto& [id, level] : drawing.home.levels) {
      if (id == drawing.level || rank(*level) >= rank(*own)) continue;
      const Level* best = drawing.home.levels.find(found);
      if (!best || rank(*level) > rank(*best)) found = id;
    }
    return found;
  }
};

}  // namespace

const Painter& wallPainter() {
  static const WallPainter painter;
  return painter;
}

const Painter& levelBelowPainter() {
  static const LevelBelowPainter painter;
  return painter;
}

}  // namespace idap
