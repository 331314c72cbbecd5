// What lies around the plan: the scanned plan under it, the compass.
#include <QPainterPath>
#include <cmath>

#include "studio/plan/painters.h"
#include "studio/plan/pictures.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

class BackgroundPainter : public Painter {
 public:
  void paint(const Drawing& drawing, Canvas& c) const override {
    const auto at = drawing.home.backgrounds.find(drawing.level);
    if (at == drawing.home.backgrounds.end() || !at->second.visible) return;
    const QImage image = pictureOf(drawing, at->second);
    if (image.isNull()) return;
    c.p.save();
    c.p.setRenderHint(QPainter::SmoothPixmapTransform);
    c.p.setOpacity(c.colors.dark ? 0.45 : 0.6);
    c.p.drawImage(c.view.toView(box(at->second, image)), image);
    c.p.restore();
  }
  void changed(const HomeDiff& diff, const Drawing&, const Drawing&, DirtyBoxes& dirty) const override {
    if (diff.backgrounds) dirty.all = true;
  }
  void extend(const Drawing& drawing, Box2& all) const override {
    const auto at = drawing.home.backgrounds.find(drawing.level);
    if (at == drawing.home.backgrounds.end() || !at->second.visible) return;
    const QImage image = pictureOf(drawing, at->second);
    if (!image.isNull()) add(all, box(at->second, image));
  }

 private:
  static QImage pictureOf(const Drawing& drawing, const Background& background) {
    const auto file = drawing.home.assets->find(background.asset);
    return file == drawing.home.assets->end() ? QImage() : drawing.pictures.picture(file->second);
  }
  // origin: where the picture's upper left corner lies.
  static Box2 box(const Background& b, const QImage& image) {
    // A picture that was made smaller to be shown covers the same ground.
    const double width = image.text(QStringLiteral("width")).toDouble(),
                 scale = width > 0 ? b.scale * width / image.width() : b.scale;
    const Vec2 corner = b.origin;
    return {{corner.x, corner.y - image.height() * scale}, {corner.x + image.width() * scale, corner.y}};
  }
};

class CompassPainter : public Painter {
 public:
  void paint(const Drawing& drawing, Canvas& c) const override {
    const Site& site = drawing.home.site;
    if (!site.compassVisible || !c.shows(compassBox(site))) return;
    const double r = site.compassDiameter / 2;
    const Vec2 north = rotated(Vec2{0, 1}, site.north), east = -perpendicular(north);
    const auto at = [&](double right, double up) {
      return site.compassPosition + (east * right + north * up) * r;
    };
    c.p.setPen(c.pen(c.colors.soft, 1));
    c.p.setBrush(Qt::NoBrush);
    c.p.drawEllipse(c.at(site.compassPosition), 0.72 * r * c.view.scale, 0.72 * r * c.view.scale);
    c.p.setPen(c.pen(c.colors.ink, 1));
    c.p.setBrush(c.colors.ink);
    c.p.drawPolygon(c.polygon({at(0, 0.95), at(0.2, 0), at(0, 0.12)}));
    c.p.setBrush(c.colors.paper);
    c.p.drawPolygon(c.polygon({at(0, 0.95), at(0, 0.12), at(-0.2, 0)}));
    c.line(at(0, 0.1), at(0, -0.72));
    c.line(at(-0.72, 0), at(-0.6, 0)), c.line(at(0.6, 0), at(0.72, 0));
    c.text(at(0, 1.12), QStringLiteral("N"), c.smallFont(std::max(r * 0.36 * c.view.scale, 0.0), true));
  }
  void changed(const HomeDiff& diff, const Drawing& before, const Drawing& after,
               DirtyBoxes& dirty) const override {
    if (diff.site) dirty.add(compassBox(before.home.site)), dirty.add(compassBox(after.home.site));
  }
  // A compass beside the drawing is part of it; one far away is not worth a small drawing.
  void extend(const Drawing& drawing, Box2& box) const override {
    constexpr double kBeside = 3;  // m
    const Box2 own = compassBox(drawing.home.site);
    if (drawing.home.site.compassVisible && !box.empty() && grown(box, kBeside).overlaps(own)) add(box, own);
  }

 private:
  static Box2 compassBox(const Site& site) {
    return grown({site.compassPosition, site.compassPosition}, site.compassDiameter * 0.75);
  }
};

}  // namespace

const Painter& backgroundPainter() {
  static const BackgroundPainter painter;
  return painter;
}
const Painter& compassPainter() {
  static const CompassPainter painter;
  return painter;
}

}  // namespace idap
