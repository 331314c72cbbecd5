#include "studio/plan/paint_overlay.h"

#include <QFontMetricsF>
#include <cmath>

#include "editor/hit_test_shapes.h"
#include "model/wall_outline.h"
#include "studio/plan/camera_shape.h"
#include "studio/plan/elevation.h"
#include "studio/plan/opening_shape.h"
#include "studio/plan/piece_items.h"
#include "studio/plan/smooth_line.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr double kHandle = 4.5;   // pixels from the middle to the edge
constexpr double kFieldGap = 18;  // pixels from the pointer

template <class... Fs>
struct Overloaded : Fs... {
  using Fs::operator()...;
};

void dressed(Canvas& c, const QColor& color, double width, Qt::PenStyle style = Qt::SolidLine) {
  c.p.setPen(c.pen(color, width, style));
  c.p.setBrush(Qt::NoBrush);
}

// Two lines, so that it is seen on anything: paper below, colour above.
void seenLine(Canvas& c, const QPolygonF& line, bool closed, const QColor& color, double width,
              Qt::PenStyle style = Qt::SolidLine) {
  for (const bool above : {false, true}) {
    QColor under = c.colors.paper;
    under.setAlphaF(0.8f);
    dressed(c, above ? color : under, above ? width : width + 2, above ? style : Qt::SolidLine);
    if (closed) {
      c.p.drawPolygon(line);
    } else {
      c.p.drawPolyline(line);
    }
  }
}

void drawHandle(Canvas& c, const Handle& handle) {
  const QPointF at = c.at(handle.at);
  const double r = kHandle * (handle.active ? 1.3 : 1);
  c.p.setPen(c.pen(c.colors.accent, 1.4));
  c.p.setBrush(handle.active ? c.colors.accent : c.colors.paper);
  const auto arrows = [&](bool both) {  // along its direction
    const QPointF u(std::cos(handle.direction), -std::sin(handle.direction)), v(-u.y(), u.x());
    const auto head = [&](double side) {
      const QPointF foot = at + u * (side * 1.5), tip = at + u * (side * (r + 5));
      c.p.drawPolygon(QPolygonF{tip, foot + v * (r * 1.1), foot - v * (r * 1.1)});
    };
    head(1);
    if (both) head(-1);
  };
  switch (handle.kind) {
    case HandleKind::Rotate:
    case HandleKind::Pitch:
    case HandleKind::Roll: {
      const double round = r + 2.5, ring = round * 0.58;
      c.p.drawEllipse(at, round, round);
      const QColor sign = handle.active ? c.colors.onAccent : c.colors.accent;
      c.p.setPen(c.pen(sign, 1.3));
      c.p.setBrush(Qt::NoBrush);
      c.p.drawArc(QRectF(at.x() - ring, at.y() - ring, 2 * ring, 2 * ring), 60 * 16, 270 * 16);
      // The arc begins at 60 degrees and runs left; its end, at -30 degrees, has the head.
      const QPointF end = at + QPointF(std::cos(kPi / 6), std::sin(kPi / 6)) * ring;
      c.p.setBrush(sign);
      c.p.setPen(Qt::NoPen);
      c.p.drawPolygon(QPolygonF{end + QPointF(1.2, -3.6), end + QPointF(2.6, 1.6), end + QPointF(-2.8, 0)});
      break;
    }
    case HandleKind::ResizeWidth:
    case HandleKind::ResizeDepth:
    case HandleKind::ResizeHeight:
    case HandleKind::Height:
      c.p.drawRect(QRectF(at.x() - r * 0.85, at.y() - r * 0.85, 1.7 * r, 1.7 * r));
      break;
    case HandleKind::ResizeCorner:
      c.p.drawRect(QRectF(at.x() - r, at.y() - r, 2 * r, 2 * r));
      break;
    case HandleKind::Raise:
    case HandleKind::Offset:
    case HandleKind::WallArc:
      arrows(true);
      break;
    case HandleKind::Aim:
      c.p.drawEllipse(at, r, r);
      c.p.drawLine(at - QPointF(r + 3, 0), at + QPointF(r + 3, 0));
      c.p.drawLine(at - QPointF(0, r + 3), at + QPointF(0, r + 3));
      break;
    case HandleKind::Move:
      c.p.drawEllipse(at, r + 1, r + 1);
      c.p.drawLine(at - QPointF(r - 1, 0), at + QPointF(r - 1, 0));
      c.p.drawLine(at - QPointF(0, r - 1), at + QPointF(0, r - 1));
      break;
    case HandleKind::WallEnd:
    case HandleKind::Point:
      c.p.drawEllipse(at, r, r);
      break;
  }
}

void drawMeasure(Canvas& c, const MeasureLine& measure, LengthUnit unit) {
  const Vec2 a = measure.from, b = measure.to;
  const double distance = length(b - a), pixels = distance * c.view.scale;
  if (pixels < 3) return;
  const QColor color = measure.strong ? c.colors.accent : c.colors.soft;
  dressed(c, color, measure.strong ? 1.6 : 1);
  c.line(a, b);
  const Vec2 along = (b - a) / distance, tick = perpendicular(along) * (4 / c.view.scale);
  c.line(a - tick, a + tick);
  c.line(b - tick, b + tick);
  if (pixels < 22) return;
  c.p.setPen(c.pen(measure.strong ? c.colors.accent : c.colors.ink));
  c.text((a + b) * 0.5, lengthText(distance, unit), c.smallFont(c.font().pixelSize() * 0.95, measure.strong),
         std::atan2(along.y, along.x), TextAlignment::Centre, Canvas::Ground::Box);
}

void drawAngle(Canvas& c, const AngleMark& mark) {
  const double turn = std::remainder(mark.to - mark.from, 2 * kPi);
  constexpr double kFlat = 0.02;  // radians: hardly an angle, and its number would lie on the line
  if (std::abs(turn) < kFlat) return;
  const QPointF at = c.at(mark.centre);
  constexpr double kRadius = 34;
  dressed(c, c.colors.soft, 1);
  const QRectF circle(at.x() - kRadius, at.y() - kRadius, 2 * kRadius, 2 * kRadius);
  c.p.drawArc(circle, int(std::lround(mark.from * 180 / kPi * 16)), int(std::lround(turn * 180 / kPi * 16)));
  const double middle = mark.from + turn / 2;
  const Vec2 beside =
      mark.centre + Vec2{std::cos(middle), std::sin(middle)} * ((kRadius + 16) / c.view.scale);
  c.p.setPen(c.pen(c.colors.ink));
  c.text(beside, angleText(std::abs(turn)), c.smallFont(c.font().pixelSize() * 0.95), 0,
         TextAlignment::Centre, Canvas::Ground::Box);
}

QString fieldText(const Field& field, LengthUnit unit) {
  if (!field.typed.empty()) return toQt(field.typed);
  switch (field.kind) {
    case Field::Kind::Length:
      return lengthText(field.value, unit);
    case Field::Kind::Angle:
      return angleText(field.value);
    case Field::Kind::Text:
      break;
  }
  return {};
}

// Little boxes, one below the other, beside the pointer; a note under them.
void drawFields(Canvas& c, const Overlay& overlay, LengthUnit unit, const QRectF& visible) {
  if (overlay.fields.empty() && overlay.note.empty()) return;
  const QFont font = c.smallFont(c.font().pixelSize());
  const QFontMetricsF metrics(font);
  const double pad = std::round(metrics.height() * 0.3), row = std::round(metrics.height() + pad);
  double labels = 0, values = metrics.horizontalAdvance(QStringLiteral("000.00 cm"));
  for (const Field& field : overlay.fields) {
    if (*field.label) labels = std::max(labels, metrics.horizontalAdvance(translated(field.label)) + pad * 2);
    values = std::max(values, metrics.horizontalAdvance(fieldText(field, unit)));
  }
  const QString note = overlay.note.empty() ? QString() : translated(overlay.note);
  const double width = overlay.fields.empty() ? 0 : labels + values + 2 * pad;
  const double noteWidth = note.isEmpty() ? 0 : metrics.horizontalAdvance(note) + 2 * pad;
  const double height = row * double(overlay.fields.size()) + (note.isEmpty() ? 0 : row);
  QPointF corner = c.at(overlay.fieldsAt) + QPointF(kFieldGap, kFieldGap);
  const double all = std::max(width, noteWidth);
  if (corner.x() + all > visible.right() - 4) corner.setX(corner.x() - all - 2 * kFieldGap);
  if (corner.y() + height > visible.bottom() - 4) corner.setY(corner.y() - height - 2 * kFieldGap);
  corner.setX(
      std::clamp(corner.x(), visible.left() + 4, std::max(visible.left() + 4, visible.right() - all - 4)));
  corner.setY(
      std::clamp(corner.y(), visible.top() + 4, std::max(visible.top() + 4, visible.bottom() - height - 4)));
  corner = QPointF(std::round(corner.x()) + 0.5, std::round(corner.y()) + 0.5);

  c.p.setFont(font);
  double y = corner.y();
  for (const Field& field : overlay.fields) {
    const QRectF whole(corner.x(), y, width, row);
    c.p.setPen(c.pen(field.wrong    ? c.colors.wrong
                     : field.active ? c.colors.accent
                                    : c.colors.faint,
                     field.active ? 1.6 : 1));
    c.p.setBrush(c.colors.paper);
    c.p.drawRect(whole);
    c.p.setPen(c.pen(c.colors.soft));
    c.p.drawText(whole.adjusted(pad, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                 *field.label ? translated(field.label) : QString());
    const QRectF value = whole.adjusted(labels, 0, -pad, 0);
    const QString words = fieldText(field, unit);
    c.p.setPen(c.pen(field.wrong ? c.colors.wrong : field.active ? c.colors.ink : c.colors.soft));
    c.p.drawText(value, Qt::AlignLeft | Qt::AlignVCenter, words);
    if (field.active && !field.typed.empty()) {  // the caret
      const double x = value.left() + metrics.horizontalAdvance(words) + 1.5;
      c.p.drawLine(QPointF(x, value.top() + pad / 2), QPointF(x, value.bottom() - pad / 2));
    }
    y += row;
  }
  if (!note.isEmpty()) {
    const QRectF whole(corner.x(), y, noteWidth, row);
    QColor ground = c.colors.paper;
    ground.setAlphaF(0.88f);
    c.p.setPen(Qt::NoPen);
    c.p.setBrush(ground);
    c.p.drawRoundedRect(whole, 3, 3);
    c.p.setPen(c.pen(c.colors.ink));
    c.p.drawText(whole.adjusted(pad, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, note);
  }
}

void addGroup(const Drawing& drawing, GroupId group, std::vector<Polygon>& rings, int depth = 0) {
  if (depth > 100) return;
  for (const PieceItem* item : drawing.pieces.items())
    if (item->piece().group == group) rings.push_back(item->outline);
  for (const auto& [id, each] : drawing.home.groups)
    if (each->parent == group) addGroup(drawing, id, rings, depth + 1);
}

Polygon lineOf(const Polyline& line) {
  return line.curved ? smoothLine(line.points, line.closed) : line.points;
}

}  // namespace

std::vector<Polygon> outlinesOf(const Drawing& drawing, AnyId any) {
  const Home& home = drawing.home;
  const bool plan = drawing.plane == Plane::XY;
  std::vector<Polygon> rings;
  std::visit(Overloaded{
                 [&](WallId id) {
                   const Wall* wall = home.walls.find(id);
                   if (!wall || !(wall->level == drawing.level)) return;
                   if (plan) {
                     rings.push_back(wallOutline(home, id, *wall).polygon());
                   } else if (auto faces = wallFaces(home, id, *wall, drawing.plane, drawing.section);
                              !faces.empty()) {
                     rings.push_back(std::move(faces.front().polygon));
                   }
                 },
                 [&](RoomId id) {
                   const Room* room = home.rooms.find(id);
                   if (room && plan && room->level == drawing.level) rings.push_back(room->points);
                 },
                 [&](OpeningId id) {
                   const Opening* opening = home.openings.find(id);
                   const PieceItem* item = drawing.pieces.find(id.value);
                   if (!opening || !item) return;
                   if (plan) {
                     const OpeningShape shape = openingShape(home, *opening);
                     rings.emplace_back(shape.hole.begin(), shape.hole.end());
                   } else {
                     rings.push_back(item->outline);
                   }
                 },
                 [&](FurnitureId id) {
                   if (const PieceItem* item = drawing.pieces.find(id.value)) rings.push_back(item->outline);
                 },
                 [&](GroupId id) { addGroup(drawing, id, rings); },
                 [&](CameraId) {},  // drawn strong instead
                 [&](DimensionId id) {
                   const Dimension* d = home.dimensions.find(id);
                   if (!d || !(d->level == drawing.level)) return;
                   if (const auto line = dimensionLine(drawing.plane, *d, drawing.elevation()))
                     rings.push_back({line->start, line->from, line->to, line->end});
                 },
                 [&](LabelId id) {
                   const Label* label = home.labels.find(id);
                   if (!label || !plan || !(label->level == drawing.level)) return;
                   const QFont font;
                   const QStringList lines = toQt(label->text).split(QLatin1Char('\n'));
                   QFont sized(label->style.font.empty() ? font.family() : toQt(label->style.font));
                   sized.setPixelSize(100);
                   sized.setBold(label->style.bold);
                   sized.setItalic(label->style.italic);
                   const QFontMetricsF metrics(sized);
                   double width = 0;
                   for (const QString& line : lines) width = std::max(width, metrics.horizontalAdvance(line));
                   const double unit = label->style.size / 100;
                   width *= unit;
                   const double height = metrics.height() * unit * double(lines.size()) / 2;
                   const double left = label->style.alignment == TextAlignment::Left    ? 0
                                       : label->style.alignment == TextAlignment::Right ? -width
                                                                                        : -width / 2;
                   Polygon ring;
                   for (const Vec2 corner : {Vec2{left, -height}, Vec2{left + width, -height},
                                             Vec2{left + width, height}, Vec2{left, height}})
                     ring.push_back(label->position + rotated(corner, uprightAngle(label->angle)));
                   rings.push_back(std::move(ring));
                 },
                 [&](PolylineId id) {
                   const Polyline* line = home.polylines.find(id);
                   if (line && plan && line->level == drawing.level) rings.push_back(lineOf(*line));
                 },
             },
             any);
  return rings;
}

void paintSelection(const Drawing& drawing, Canvas& c, const Elements& selection) {
  QColor glow = c.colors.accent;
  glow.setAlphaF(0.12f);
  for (const AnyId id : list(selection)) {
    if (const auto* camera = std::get_if<CameraId>(&id)) {
      if (const Camera* each = drawing.home.cameras.find(*camera)) {
        drawCamera(c, drawing.plane, *each, true);
        // Its aim: a line on, to the end of what is seen.
        const Vec2 eye = project(drawing.plane, each->eye),
                   way = project(drawing.plane, viewDirection(*each));
        dressed(c, c.colors.accent, 1, Qt::DashLine);
        c.line(eye, eye + way * 4);
      }
      continue;
    }
    const bool open = std::holds_alternative<DimensionId>(id) || [&] {
      const auto* line = std::get_if<PolylineId>(&id);
      const Polyline* each = line ? drawing.home.polylines.find(*line) : nullptr;
      return each && !each->closed;
    }();
    for (const Polygon& ring : outlinesOf(drawing, id)) {
      if (ring.empty() || !c.shows(bounds(ring), 4)) continue;
      const QPolygonF polygon = c.polygon(ring);
      if (!open) {
        c.p.setPen(Qt::NoPen);
        c.p.setBrush(glow);
        c.p.drawPolygon(polygon);
      }
      c.p.setPen(c.pen(c.colors.accent, 2));
      c.p.setBrush(Qt::NoBrush);
      if (open) {
        c.p.drawPolyline(polygon);
      } else {
        c.p.drawPolygon(polygon);
      }
    }
  }
}

void paintHover(const Drawing& drawing, Canvas& c, AnyId id) {
  QColor color = c.colors.accent;
  color.setAlphaF(0.65f);
  if (const auto* camera = std::get_if<CameraId>(&id)) {
    if (const Camera* each = drawing.home.cameras.find(*camera)) {
      dressed(c, color, 1.4);
      c.p.drawEllipse(c.at(project(drawing.plane, each->eye)), 13, 13);
    }
    return;
  }
  for (const Polygon& ring : outlinesOf(drawing, id)) {
    dressed(c, color, 1.4);
    if (std::holds_alternative<DimensionId>(id) || std::holds_alternative<PolylineId>(id)) {
      c.p.drawPolyline(c.polygon(ring));
    } else {
      c.p.drawPolygon(c.polygon(ring));
    }
  }
}

void paintOverlay(Canvas& c, const Overlay& overlay, LengthUnit unit, const QRectF& visible) {
  for (const PreviewShape& shape : overlay.shapes) {
    const QPolygonF line = c.polygon(shape.points);
    if (shape.filled && shape.points.size() > 2) {
      QColor fill = c.colors.accent;
      fill.setAlphaF(0.16f);
      c.p.setPen(Qt::NoPen);
      c.p.setBrush(fill);
      c.p.drawPolygon(line);
    }
    seenLine(c, line, shape.closed, c.colors.accent, 1.6);
  }
  for (const GuideLine& guide : overlay.guides) {
    dressed(c, c.colors.guide, 1, Qt::DashLine);
    c.line(guide.from, guide.to);
  }
  for (const MeasureLine& measure : overlay.measures) drawMeasure(c, measure, unit);
  for (const AngleMark& mark : overlay.angles) drawAngle(c, mark);
  for (const Handle& handle : overlay.handles) drawHandle(c, handle);
  drawFields(c, overlay, unit, visible);
}

}  // namespace idap
