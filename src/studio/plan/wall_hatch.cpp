#include "studio/plan/wall_hatch.h"

#include <algorithm>
#include <cmath>

namespace idap {

namespace {

struct Hatch {
  const char* name;
  double gap;  // pixels between two lines
  bool up, down;
  bool reversed = false;  // light lines on dark
};
constexpr Hatch kHatches[] = {
    {"hatchUp", 6, true, false},
    {"smallHatchUp", 4, true, false},
    {"largeHatchUp", 10, true, false},
    {"hatchDown", 6, false, true},
    {"smallHatchDown", 4, false, true},
    {"largeHatchDown", 10, false, true},
    {"crossHatch", 7, true, true},
    {"smallCrossHatch", 5, true, true},
    {"largeCrossHatch", 11, true, true},
    {"reversedHatchUp", 6, true, false, true},
    {"reversedHatchDown", 6, false, true, true},
    {"reversedCrossHatch", 7, true, true, true},
};

}  // namespace

void fillWall(Canvas& c, const QPainterPath& path, const std::string& pattern) {
  c.p.setPen(Qt::NoPen);
  const auto hatch = std::find_if(std::begin(kHatches), std::end(kHatches),
                                  [&](const Hatch& h) { return pattern == h.name; });
  if (hatch == std::end(kHatches)) {
    c.p.setBrush(pattern == "background" ? c.colors.paper : c.colors.wall);
    c.p.drawPath(path);
    return;
  }
  c.p.setBrush(hatch->reversed ? c.colors.wall : c.colors.paper);
  c.p.drawPath(path);
  c.p.save();
  c.p.setClipPath(path, Qt::IntersectClip);
  c.p.setPen(c.pen(hatch->reversed ? c.colors.paper : c.colors.soft));
  const QRectF box = path.boundingRect().intersected(c.view.toView(c.area));
  const double step = hatch->gap * std::sqrt(2.0), height = box.height();
  // Lines hang on the plane, not on the wall: neighbouring walls' hatches meet.
  const double phaseUp = c.view.origin.x() + c.view.origin.y(),
               phaseDown = c.view.origin.x() - c.view.origin.y();
  std::vector<QLineF> lines;
  if (hatch->up) {
    for (double s = std::floor((box.left() + box.top() - phaseUp) / step) * step + phaseUp;
         s < box.right() + box.bottom(); s += step)
      lines.emplace_back(s - box.top(), box.top(), s - box.top() - height, box.bottom());
  }
  if (hatch->down) {
    for (double s = std::floor((box.left() - box.bottom() - phaseDown) / step) * step + phaseDown;
         s < box.right() - box.top(); s += step)
      lines.emplace_back(s + box.top(), box.top(), s + box.top() + height, box.bottom());
  }
  c.p.drawLines(lines.data(), int(lines.size()));
  c.p.restore();
}

}  // namespace idap
