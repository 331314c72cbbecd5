// The points of view on a plane.
#include <QFontMetricsF>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <vector>

#include "editor/hit_test_shapes.h"
#include "studio/plan/camera_shape.h"
#include "studio/plan/paint_overlay.h"
#include "studio/plan/painters.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

class CameraPainter : public Painter {
 public:
  void paint(const Drawing& drawing, Canvas& c) const override {
    for (const auto& [id, camera] : drawing.home.cameras)
      if (c.shows(cameraBox(drawing.plane, *camera), 20)) drawCamera(c, drawing.plane, *camera, false);
  }
  void changed(const HomeDiff& diff, const Drawing& before, const Drawing& after,
               DirtyBoxes& dirty) const override {
    const auto box = [&](CameraId, const Camera& camera) { return cameraBox(after.plane, camera); };
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
}

void paintCameraNames(const Drawing& drawing, Canvas& c, const Elements& selection,
                      std::optional<AnyId> hovered) {
  std::vector<CameraId> shown;
  if (hovered)
    if (const auto* id = std::get_if<CameraId>(&*hovered)) shown.push_back(*id);
  shown.insert(shown.end(), selection.cameras.begin(), selection.cameras.end());
  const QFont font = c.smallFont(c.font().pixelSize() * 0.9);
  const QFontMetricsF metrics(font);
  std::vector<QRectF> taken;
  for (const CameraId id : shown) {
    const Camera* camera = drawing.home.cameras.find(id);
    if (!camera || camera->name.empty() || !c.shows(cameraBox(drawing.plane, *camera), 20)) continue;
    const QString name = toQt(camera->name);
    const QPointF eye = c.at(project(drawing.plane, camera->eye));
    const double width = metrics.horizontalAdvance(name), height = metrics.height();
    constexpr double kAway = 13;  // pixels: clear of the body
    const QPointF corners[] = {{-width / 2, kAway},
                               {-width / 2, -kAway - height},
                               {kAway, -height / 2},
                               {-kAway - width, -height / 2}};
    for (const QPointF corner : corners) {
      const QRectF box(eye + corner, QSizeF(width, height));
      if (std::any_of(taken.begin(), taken.end(), [&](const QRectF& other) { return other.intersects(box); }))
        continue;
      taken.push_back(box);
      // A rim of paper around each letter hides less than a box.
      QPainterPath letters;
      letters.addText(box.left(), box.top() + metrics.ascent(), font, name);
      c.p.setBrush(Qt::NoBrush);
      c.p.setPen(QPen(c.colors.paper, 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      c.p.drawPath(letters);
      c.p.fillPath(letters, c.colors.accent);
      break;
    }
  }
}

const Painter& cameraPainter() {
  static const CameraPainter painter;
  return painter;
}

}  // namespace idap
