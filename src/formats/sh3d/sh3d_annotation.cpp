// What is written on the plan.
#include "formats/sh3d/sh3d_context.h"

namespace idap {

void readDimension(Sh3dContext& context, const Sh3dElement& element) {
  const auto start = element.point("xStart", "yStart"), end = element.point("xEnd", "yEnd");
  if (!start || !end) {
    context.report.add(element.place(), "a dimension line without ends: dropped");
    return;
  }
  Dimension dimension;
  dimension.level = context.levelOf(element);
  dimension.start = *start;
  dimension.end = *end;
  dimension.startElevation = element.length("elevationStart", 0);
  dimension.endElevation = element.length("elevationEnd", 0);
  dimension.offset = -element.length("offset", 0);  // the file counts to the right of start -> end
  dimension.pitch = sh3dAngle(element.number("pitch", 0));
  dimension.color = element.color("color");
  dimension.textSize = sh3dTextStyle(element, "lengthStyle").size;
  context.home.dimensions.set(context.home.newId<DimensionId>(), std::move(dimension));
}

void readLabel(Sh3dContext& context, const Sh3dElement& element) {
  const auto position = element.point("x", "y");
  const auto text = element.child("text");
  if (!position || !text) {
    context.report.add(element.place(), "a label without a place or a text: dropped");
    return;
  }
  Label label;
  label.level = context.levelOf(element);
  label.text = text->node().text().as_string();
  label.position = *position;
  label.elevation = element.length("elevation", 0);
  label.angle = sh3dAngle(element.number("angle", 0));
  label.pitch = element.number("pitch");
  label.style = sh3dTextStyle(element, nullptr);
  label.style.color = element.color("color");
  context.home.labels.set(context.home.newId<LabelId>(), std::move(label));
}

namespace {

LineDash dashOf(const std::string& name) {
  if (name == "DOT") return LineDash::Dot;
  if (name == "DASH" || name == "CUSTOMIZED") return LineDash::Dash;
  if (name == "DASH_DOT") return LineDash::DashDot;
  if (name == "DASH_DOT_DOT") return LineDash::DashDotDot;
  return LineDash::Solid;
}

LineArrow arrowOf(const std::string& name) {
  if (name == "DELTA") return LineArrow::Delta;
  if (name == "OPEN") return LineArrow::Open;
  if (name == "DISC") return LineArrow::Disc;
  return LineArrow::None;
}

}  // namespace

void readPolyline(Sh3dContext& context, const Sh3dElement& element) {
  Polyline line;
  line.level = context.levelOf(element);
  for (const pugi::xml_node node : element.node().children("point"))
    if (const auto point = Sh3dElement(node, context.report).point("x", "y")) line.points.push_back(*point);
  if (line.points.size() < 2) {
    context.report.add(element.place(), "a polyline of fewer than two points: dropped");
    return;
  }
  line.closed = element.flag("closedPath", false);
  line.curved = element.text("joinStyle") == "CURVED";
  line.thickness = element.length("thickness", line.thickness);
  line.dash = dashOf(element.text("dashStyle"));
  line.startArrow = arrowOf(element.text("startArrowStyle"));
  line.endArrow = arrowOf(element.text("endArrowStyle"));
  line.color = element.color("color").value_or(line.color);
  line.elevation = element.length("elevation");
  context.home.polylines.set(context.home.newId<PolylineId>(), std::move(line));
}

}  // namespace idap
