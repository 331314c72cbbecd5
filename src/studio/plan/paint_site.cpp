// What lies around the plan: the scanned plan under it, the compass, the points of view.
#include <QPainterPath>
#include <cmath>

#include "editor/hit_test_shapes.h"
#include "studio/plan/camera_shape.h"
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

class CameraPainter : public Painter {
 public:
  void paint(const Drawing& drawing, Canvas& c) const override {
    for (const auto& [id, camera] : drawing.home.cameras)
      if (c.shows(cameraBox(drawing.plane, *camera), 20)) drawCamera(c, drawing.plane, *camera, false);
  }
  void changed(const HomeDiff& diff, const Drawing& before, const Drawing& after,
               DirtyBoxes& dirty) const override {
    const auto box = [&](CameraId, const Camera& camera) {
      return grown(cameraBox(after.plane, camera), textBox({}, camera.name, 0.2).max.x);
    };
    addChanged(diff.cameras, before.home.cameras, after.home.cameras, box, box, dirty);
  }
};

}  // namespace

Box2 cameraBox(Plane plane, const Camera& camera) {
  const Vec2 eye = project(plane, camera.eye);
  return grown({eye, eye}, kCameraCone);
}

void drawCamera(Canvas& c, Plane plane, const Camera& camera, bool strong) {
  const Vec2 eye = project(plane, camera.eye);
  const QPointF at = c.at(eye);
  const Vec3 look = viewDirection(camera);
  const Vec2 flat = project(plane, look);
  const QColor color = strong ? c.colors.accent : c.colors.soft;
  if (const double share = length(flat); share > 0.05) {
    const Vec2 way = flat / share;
    // What the lens takes in, as far as this plane shows it.
    double half =
        plane == Plane::XY ? camera.fieldOfView / 2 : std::atan(std::tan(camera.fieldOfView / 2) * 0.75);
    half = std::clamp(half, 0.05, kPi * 0.49);
    const double reach = kCameraCone * (0.4 + 0.6 * share);
    const Vec2 left = eye + rotated(way, half) * reach, right = eye + rotated(way, -half) * reach;
    QColor cone = color;
    cone.setAlphaF(strong ? 0.16f : 0.1f);
    c.p.setPen(Qt::NoPen);
    c.p.setBrush(cone);
    c.p.drawPolygon(c.polygon({eye, left, right}));
    c.p.setPen(c.pen(color, 1));
    c.line(eye, left);
    c.line(eye, right);
    const QPointF u(way.x, -way.y), v(way.y, way.x);
    // The body with its lens, the same at any scale.
    c.p.setPen(c.pen(color, 1.2));
    c.p.setBrush(strong ? c.colors.accent : c.colors.paper);
    c.p.drawPolygon(
        QPolygonF{at + u * 2 + v * 4, at + u * 8 + v * 6, at + u * 8 - v * 6, at + u * 2 - v * 4});
    c.p.drawPolygon(
        QPolygonF{at + u * 2 + v * 6, at + u * 2 - v * 6, at - u * 9 - v * 6, at - u * 9 + v * 6});
  } else {  // looking at us or away from us
    c.p.setPen(c.pen(color, 1.2));
    c.p.setBrush(strong ? c.colors.accent : c.colors.paper);
    c.p.drawRoundedRect(QRectF(at.x() - 7, at.y() - 6, 14, 12), 2, 2);
    c.p.drawEllipse(at, 3.4, 3.4);
  }
  if (!camera.name.empty() && c.view.scale > 25) {
    c.p.setPen(c.pen(color));
    c.p.save();
    c.text(eye + Vec2{0, -18 / c.view.scale}, toQt(camera.name), c.smallFont(c.font().pixelSize() * 0.9), 0,
           TextAlignment::Centre, Canvas::Ground::Halo);
    c.p.restore();
  }
}

const Painter& backgroundPainter() {
  static const BackgroundPainter painter;
  return painter;
}
const Painter& compassPainter() {
  static const CompassPainter painter;
  return painter;
}
const Painter& cameraPainter() {
  static const CameraPainter painter;
  return painter;
}

}  // namespace idap
