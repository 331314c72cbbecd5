// What is written on the plan: dimension lines, labels and polylines.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/finish.h"
#include "model/ids.h"
#include "model/text_style.h"

namespace idap {

struct Dimension {
  LevelId level;
  Vec2 start, end;  // m
  double startElevation = 0, endElevation = 0;
  double offset = 0;  // m from the measured points to the drawn line, positive to the left of start -> end
  double pitch = 0;
  std::optional<Color> color;
  double textSize = 0.18;  // m
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

struct Label {
  LevelId level;
  std::string text;
  Vec2 position;
  double elevation = 0;
  double angle = 0;
  std::optional<double> pitch;  // set: also shown in 3-D, tilted so
  TextStyle style;
  friend bool operator==(const Label&, const Label&) = default;
};

enum class LineDash { Solid, Dot, Dash, DashDot, DashDotDot };
enum class LineArrow { None, Delta, Open, Disc };

struct Polyline {
  LevelId level;
  std::vector<Vec2> points;
  bool closed = false, curved = false;
  double thickness = 0.01;  // m
  LineDash dash = LineDash::Solid;
  LineArrow startArrow = LineArrow::None, endArrow = LineArrow::None;
  Color color{0, 0, 0};
  std::optional<double> elevation;  // set: also shown in 3-D
  friend bool operator==(const Polyline&, const Polyline&) = default;
};

}  // namespace idap
