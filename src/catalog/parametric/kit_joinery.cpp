// Doors of frame and panel, handles, castors, lamp sockets.
#include <algorithm>
#include <cmath>

#include "catalog/parametric/kit.h"

namespace idap::parametric {

void Builder::framedPanel(Vec3 min, Vec3 max, const FramedPanel& s) {
  const double stile = std::min({s.stile, 0.45 * (max.x - min.x), 0.45 * (max.z - min.z)});
  box({min.x, min.y, min.z}, {min.x + stile, max.y, max.z}, s.bevel, Grain::Z);
  box({max.x - stile, min.y, min.z}, {max.x, max.y, max.z}, s.bevel, Grain::Z);
  // Rails and bars stand back by a hair, so that no two faces share a plane.
  const double hair = 0.0004;
  const double x0 = min.x + stile - 0.001, x1 = max.x - stile + 0.001;
  box({x0, min.y + hair, min.z}, {x1, max.y - hair, min.z + stile}, s.bevel, Grain::X);
  box({x0, min.y + hair, max.z - stile}, {x1, max.y - hair, max.z}, s.bevel, Grain::X);
  const double w = max.x - min.x - 2 * stile, h = max.z - min.z - 2 * stile;
  for (int i = 1; i < s.columns; ++i) {
    const double x = min.x + stile + w * i / s.columns;
    box({x - s.bar / 2, min.y + 2 * hair, min.z + stile - 0.001},
        {x + s.bar / 2, max.y - 2 * hair, max.z - stile + 0.001}, s.bevel, Grain::Z);
  }
  for (int i = 1; i < s.rows; ++i) {
    const double z = min.z + stile + h * i / s.rows;
    box({x0, min.y + 3 * hair, z - s.bar / 2}, {x1, max.y - 3 * hair, z + s.bar / 2}, s.bevel, Grain::X);
  }
  const std::uint32_t before = slot_;
  if (!s.panelSlot.empty()) slot(s.panelSlot);
  const double thick = std::min(s.panelThickness, 0.6 * (max.y - min.y));
  const double y = min.y + std::clamp(s.setBack, 0.0005, max.y - min.y - thick - 0.0005);
  box({x0 - 0.004, y, min.z + stile - 0.005}, {x1 + 0.004, y + thick, max.z - stile + 0.005}, 0);
  slot_ = before;
}

void Builder::knob(Vec3 at, double radius) {
  within(facing(at, {0, -1, 0}), [&] {
    const double r = radius;
    lathe({},
          spline2({{0, 0},
                   {0.55 * r, 0},
                   {0.42 * r, 0.5 * r},
                   {0.5 * r, 0.9 * r},
                   {r, 1.2 * r},
                   {0.92 * r, 1.65 * r},
                   {0.5 * r, 1.85 * r},
                   {0, 1.9 * r}},
                  3),
          18);
  });
}

void Builder::barPull(Vec3 centre, double length, bool vertical, double radius, double standOff) {
  const Vec3 axis = vertical ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 out{0, -standOff, 0};
  rod(centre + out - axis * (length / 2), centre + out + axis * (length / 2), radius, 12, Cap::Round);
  for (const double s : {-0.38, 0.38})
    rod(centre + axis * (s * length), centre + axis * (s * length) + out, 0.8 * radius, 10);
}

void Builder::cupPull(Vec3 centre, double width, double height) {
  // A quarter of a shell: open below.
  surface(
      [&](double u, double v) {
        const double a = kPi * u, t = kPi / 2 * v;
        return centre + Vec3{-0.5 * width * std::cos(a) * std::cos(t * 0.3),
                             -0.9 * height * std::sin(t) - 0.001,
                             height * std::sin(a) * std::cos(t) - 0.35 * height};
      },
      14, 6, 0.002);
}

void Builder::castor(Vec3 floor, double radius) {
  const double r = radius;
  for (const double s : {-1.0, 1.0}) {
    within(facing(floor + Vec3{s * 0.3 * r, 0, r}, {s, 0, 0}), [&] {
      cylinder({0, 0, 0}, r, 0.5 * r, 0.15 * r, 20);
    });
  }
  // A hood over the wheels, and the stem.
  within(facing(floor + Vec3{-0.28 * r, 0, r}, {1, 0, 0}),
         [&] { cylinder({}, 0.8 * r, 0.56 * r, 0.05 * r, 20); });
  cylinder(floor + Vec3{0, 0.2 * r, 1.2 * r}, 0.28 * r, 1.3 * r, 0.001, 12);
}

void Builder::bulb(Vec3 centre, double radius, bool up) {
  // The glass is the lamp's own light; what is built is the socket it sits in.
  const double h = 1.4 * radius, s = up ? -1 : 1;
  const double near = centre.z + s * 1.15 * radius;
  cylinder({centre.x, centre.y, up ? near - h : near}, 0.5 * radius, h, 0.002, 16);
  light(centre);
}

}  // namespace idap::parametric
