#include "model/room_geometry.h"
#include "studio/plan/painters.h"
#include "studio/plan/pictures.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

class RoomPainter : public Painter {
 public:
  void paint(const Drawing& drawing, Canvas& c) const override {
    for (const auto& [id, room] : drawing.home.rooms)
      if (room->level == drawing.level && c.shows(bounds(room->points))) fill(drawing, c, *room);
  }

  void changed(const HomeDiff& diff, const Drawing& before, const Drawing& after,
               DirtyBoxes& dirty) const override {
    const auto box = [](RoomId, const Room& room) { return roomBox(room); };
    addChanged(diff.rooms, before.home.rooms, after.home.rooms, box, box, dirty);
  }

  void extend(const Drawing& drawing, Box2& box) const override {
    for (const auto& [id, room] : drawing.home.rooms)
      if (room->level == drawing.level) add(box, bounds(room->points));
  }

  static Box2 roomBox(const Room& room) {
    Box2 box = bounds(room.points);
    const Vec2 centre = roomCentre(room);
    add(box, textBox(centre + room.nameOffset, room.name, room.nameStyle.size));
    add(box, textBox(centre + room.areaOffset, "1234.56 sq ft", room.areaStyle.size));
    return box;
  }

 private:
  static void fill(const Drawing& drawing, Canvas& c, const Room& room) {
    QColor floor = c.colors.floor;
    if (const auto color = drawing.pictures.colorOf(drawing.home, room.floor))
      floor = c.colors.wash(*color, c.colors.dark ? 0.28 : 0.36);
    if (!room.floorVisible) floor.setAlphaF(0.35f);
    c.p.setPen(c.pen(c.colors.faint));
    c.p.setBrush(floor);
    c.p.drawPolygon(c.polygon(room.points));
  }
};

// Above the furniture: a name under a table is of no use.
class RoomTextPainter : public Painter {
 public:
  void paint(const Drawing& drawing, Canvas& c) const override {
    for (const auto& [id, room] : drawing.home.rooms)
      if (room->level == drawing.level && c.shows(RoomPainter::roomBox(*room))) texts(drawing, c, *room);
  }

 private:
  static void texts(const Drawing& drawing, Canvas& c, const Room& room) {
    const Vec2 centre = roomCentre(room);
    const auto pen = [&](const TextStyle& style) {
      return c.pen(style.color ? c.colors.readable(*style.color) : c.colors.ink);
    };
    // Where nobody has moved them they stand below each other.
    const bool own = room.nameOffset == room.areaOffset && !room.name.empty() && room.areaVisible;
    const double apart = own ? (room.nameStyle.size + room.areaStyle.size) * 0.36 : 0;
    if (!room.name.empty()) {
      c.p.setPen(pen(room.nameStyle));
      c.text(centre + room.nameOffset + Vec2{0, apart}, toQt(room.name), c.fontOf(room.nameStyle),
             room.nameAngle, room.nameStyle.alignment, Canvas::Ground::Halo);
    }
    if (room.areaVisible) {
      c.p.setPen(pen(room.areaStyle));
      c.text(centre + room.areaOffset - Vec2{0, apart}, areaText(floorArea(room), drawing.settings.unit),
             c.fontOf(room.areaStyle), room.areaAngle, room.areaStyle.alignment, Canvas::Ground::Halo);
    }
  }
};

}  // namespace

const Painter& roomPainter() {
  static const RoomPainter painter;
  return painter;
}

const Painter& roomTextPainter() {
  static const RoomTextPainter painter;
  return painter;
}

}  // namespace idap
