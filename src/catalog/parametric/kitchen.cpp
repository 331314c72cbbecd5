// Kitchen units: base, sink, hob, corner, wall and tall cabinets, island, extractor hoods. Base units have a
// worktop and a recessed plinth; their fronts share one height, so that units in a row line up.
#include <algorithm>
#include <cmath>

#include "catalog/parametric/casework.h"

namespace idap::parametric {

namespace {

constexpr double kOverhang = 0.02;  // m, the worktop's over the fronts
constexpr double kPlinth = 0.1;     // m
constexpr double kTopThickness = 0.03;

FrontStyle styleOf(const Parameters& p) {
  FrontStyle style;
  style.style = p.text("front", "flat");
  style.pull = pullNamed(p.text("handle", "bar"));
  return style;
}

struct Base {
  double face, inner, z0, z1;  // z1: underside of the worktop
};

// Plinth, case and, unless it is to have a hole, the worktop with its upper side at `top`.
Base baseCase(Builder& b, const Parameters& p, const FrontStyle& style, double top, bool worktop) {
  const double t = p.number("worktop", kTopThickness);
  Base s;
  s.face = b.front() + std::max(kOverhang, pullDepth(style.pull));
  s.inner = s.face + style.thickness + 0.002;
  s.z0 = kPlinth;
  s.z1 = top - t;
  b.slot("plinth");
  b.box({b.left(), s.inner + 0.05, 0}, {b.right(), b.back() - 0.02, s.z0 + 0.001}, 0.001, Grain::X);
  b.slot("carcass");
  carcass(b, {b.left(), s.inner, s.z0}, {b.right(), b.back(), s.z1}, {0.018, 0.006, false, worktop});
  if (worktop) {
    b.slot("worktop");
    b.box({b.left(), s.face - kOverhang, s.z1}, {b.right(), b.back(), top}, 0.0025, Grain::X);
  }
  return s;
}

void doorsAcross(Builder& b, const Pane& pane, double face, const FrontStyle& style, int doors, PullAt at) {
  const double w = pane.width() / doors;
  for (int i = 0; i < doors; ++i)
    door(b, {pane.x0 + w * i, pane.z0, pane.x0 + w * (i + 1), pane.z1}, face, style,
         doors == 1 || i % 2 == 0 ? Hinge::Left : Hinge::Right, at);
}

// drawers above doors; or nothing but drawers.
void baseFronts(Builder& b, const Base& s, const Parameters& p, const FrontStyle& style, double x0,
                double x1) {
  const int drawers = std::clamp(p.count("drawers", 1), 0, 6);
  const int doors = std::clamp(p.count("doors", fitting(x1 - x0, 0.5)), 0, 6);
  double z = s.z1 - 0.002;
  const double room = z - s.z0;
  for (int i = 0; i < drawers; ++i) {
    const double h = doors > 0 ? std::min(0.15, room / (drawers + 1)) : room / drawers;
    drawer(b, {x0, z - h, x1, z}, s.face, style);
    z -= h;
  }
  if (doors > 0) doorsAcross(b, {x0, s.z0, x1, z}, s.face, style, doors, PullAt::Top);
}

void baseUnit(Builder& b, const Parameters& p) {
  const FrontStyle style = styleOf(p);
  const Base s = baseCase(b, p, style, b.height(), true);
  baseFronts(b, s, p, style, b.left(), b.right());
}

void sinkUnit(Builder& b, const Parameters& p) {
  const FrontStyle style = styleOf(p);
  const double tapHeight = p.number("tapHeight", 0.3);
  // The box includes the tap: the counter lies lower.
  const double counter = b.height() - tapHeight, t = p.number("worktop", kTopThickness);
  const Base s = baseCase(b, p, style, counter, false);
  const int bowls = b.width() > 1.0 && p.flag("double") ? 2 : 1;
  const double y0 = s.face + 0.05, y1 = b.back() - 0.12;
  const double span = std::min(b.width() - 0.1, bowls == 2 ? 0.86 : 0.54);
  const Polygon hole = roundedRectangle({-span / 2, y0}, {span / 2, y1}, 0.05);
  b.slot("worktop");
  Region region{rectangle({b.left(), s.face - kOverhang}, {b.right(), b.back()}), {hole}};
  std::reverse(region.holes[0].begin(), region.holes[0].end());
  b.extrude(region, s.z1, t, 0.002);
  b.slot("sink");
  const double wall = 0.012, w = (span - wall * (bowls + 1)) / bowls;
  for (int i = 0; i < bowls; ++i) {
    const double x = -span / 2 + wall + w / 2 + i * (w + wall);
    basin(b, {x, (y0 + y1) / 2}, {w / 2, (y1 - y0) / 2 - wall}, counter + 0.001, 0.18, 9, wall);
  }
  b.slot("drain");
  for (int i = 0; i < bowls; ++i)
    b.cylinder({-span / 2 + wall + w / 2 + i * (w + wall), (y0 + y1) / 2, counter - 0.179}, 0.04, 0.003,
               0.001);
  b.slot("tap");
  tap(b, {0, b.back() - 0.065, counter}, tapHeight, std::min(0.2, 0.42 * b.depth()));
  doorsAcross(b, {b.left(), s.z0, b.right(), s.z1 - 0.002}, s.face, style,
              std::clamp(p.count("doors", fitting(b.width(), 0.5)), 1, 4), PullAt::Top);
}

void hobPlate(Builder& b, double x, double y0, double y1, double z, double w) {
  b.slot("hob");
  b.box({x - w / 2, y0, z}, {x + w / 2, y1, z + 0.006}, 0.002);
  b.slot("hob-mark");
  const double h = y1 - y0;
  int i = 0;
  for (const double fx : {-0.25, 0.25})
    for (const double fy : {-0.22, 0.24}) {
      const double r = (i++ % 3 == 0 ? 0.16 : 0.125) * std::min(w, h);
      b.torus({x + fx * w, (y0 + y1) / 2 + fy * h, z + 0.006}, r, 0.0012, 36, 6);
    }
  for (int k = -2; k <= 2; ++k) b.cylinder({x + 0.03 * k, y0 + 0.03, z + 0.0055}, 0.004, 0.001, 0, 12);
}

// The face of an oven: glass with a dark window, a bar to pull, knobs above.
void ovenFront(Builder& b, const Pane& p, double face, double thick) {
  const double panel = std::min(0.11, 0.2 * p.height());
  b.slot("steel");
  b.box({p.x0, face, p.z1 - panel}, {p.x1, face + thick, p.z1}, 0.002, Grain::X);
  b.box({p.x0, face, p.z0}, {p.x1, face + thick, p.z1 - panel - 0.004}, 0.003, Grain::X);
  b.slot("dark-glass");
  b.box({p.x0 + 0.04, face - 0.003, p.z0 + 0.05}, {p.x1 - 0.04, face + 0.002, p.z1 - panel - 0.09}, 0.001);
  b.box({p.midX() - 0.06, face - 0.002, p.z1 - 0.75 * panel},
        {p.midX() + 0.06, face + 0.002, p.z1 - 0.25 * panel}, 0.001);
  b.slot("handle");
  b.barPull({p.midX(), face, p.z1 - panel - 0.045}, 0.82 * p.width(), false, 0.008, 0.032);
  for (const double f : {-0.38, -0.24, 0.24, 0.38})
    b.within(facing({p.midX() + f * p.width(), face, p.z1 - panel / 2}, {0, -1, 0}),
             [&] { b.cone({}, 0.02, 0.016, 0.02, 0.003, 24); });
}

void hobUnit(Builder& b, const Parameters& p) {
  FrontStyle style = styleOf(p);
  style.pull = Pull::Bar;
  const double t = p.number("worktop", kTopThickness), top = b.height() - 0.0072;
  Base s{b.front() + 0.04, 0, kPlinth, top - t};
  s.inner = s.face + 0.022;
  b.slot("plinth");
  b.box({b.left(), s.inner + 0.05, 0}, {b.right(), b.back() - 0.02, s.z0 + 0.001}, 0.001, Grain::X);
  b.slot("carcass");
  carcass(b, {b.left(), s.inner, s.z0}, {b.right(), b.back(), s.z1});
  b.slot("worktop");
  b.box({b.left(), s.face - kOverhang, s.z1}, {b.right(), b.back(), top}, 0.0025, Grain::X);
  hobPlate(b, 0, s.face + 0.05, b.back() - 0.06, top, std::min(0.58, b.width() - 0.04));
  const double w = std::min(0.596, b.width() - 0.004);
  const Pane oven{-w / 2, s.z1 - 0.6, w / 2, s.z1 - 0.004};
  ovenFront(b, oven, s.face, 0.021);
  drawer(b, {b.left(), s.z0, b.right(), oven.z0 - 0.002}, s.face, style);
  if (b.width() - w > 0.05) {
    b.slot("front");
    for (const double sign : {-1.0, 1.0})
      b.box({sign * w / 2 + sign * 0.002, s.face, oven.z0},
            {sign * b.width() / 2, s.face + 0.019, s.z1 - 0.002}, 0.001);
  }
}

// An L: arms of `arm` depth along the back and along the left side; the door folds across the inner corner.
void cornerUnit(Builder& b, const Parameters& p) {
  const FrontStyle style = styleOf(p);
  const double t = p.number("worktop", kTopThickness);
  const double arm = std::min({p.number("arm", 0.6), 0.75 * b.width(), 0.75 * b.depth()});
  const double z1 = b.height() - t, x0 = b.left(), y1 = b.back();
  const auto outline = [&](double in) {
    return Polygon{{x0, b.front()},
                   {x0 + arm - in, b.front()},
                   {x0 + arm - in, y1 - arm + in},
                   {b.right(), y1 - arm + in},
                   {b.right(), y1},
                   {x0, y1}};
  };
  b.slot("plinth");
  b.extrude(outline(kOverhang + 0.075), 0, kPlinth + 0.001, 0);
  b.slot("carcass");
  b.extrude(outline(kOverhang + style.thickness + 0.002), kPlinth, z1 - kPlinth, 0.001);
  b.slot("worktop");
  b.extrude(outline(0), z1, t, 0.002);
  const double face = y1 - arm + kOverhang;
  door(b, {x0 + arm - kOverhang, kPlinth, b.right(), z1 - 0.002}, face, style, Hinge::Right, PullAt::Top);
  // The other leaf faces +x.
  const double length = y1 - arm + kOverhang - b.front();
  b.within(Transform::translation({x0 + arm - kOverhang, b.front(), 0}) * Transform::rotationZ(kPi / 2), [&] {
    FrontStyle plain = style;
    plain.pull = Pull::None;
    door(b, {0, kPlinth, length, z1 - 0.002}, 0, plain, Hinge::Left, PullAt::Top);
  });
}

void wallUnit(Builder& b, const Parameters& p) {
  FrontStyle style = styleOf(p);
  const double face = b.front() + pullDepth(style.pull), inner = face + style.thickness + 0.002;
  const int doors = std::clamp(p.count("doors", fitting(b.width(), 0.5)), 1, 8);
  const bool glass = p.flag("glass");
  b.slot("carcass");
  carcass(b, {b.left(), inner, 0}, {b.right(), b.back(), b.height()});
  const int shelves = std::clamp(p.count("shelves", fitting(b.height(), 0.36) - 1), 0, 5);
  for (int i = 1; i <= shelves; ++i) {
    const double z = b.height() * i / (shelves + 1);
    b.slot("carcass");
    b.box({b.left() + 0.017, inner + 0.02, z - 0.009}, {b.right() - 0.017, b.back() - 0.01, z + 0.009}, 0.001,
          Grain::X);
  }
  if (glass) {
    style.style = "glass";
    for (int i = 0; i <= shelves; ++i)
      for (int k = 0; k < 2 * doors; ++k)
        ornament(b,
                 {b.left() + b.width() * (k + 0.5) / (2 * doors), (inner + b.back()) / 2,
                  b.height() * i / (shelves + 1) + (i ? 0.009 : 0.018)},
                 std::min({0.22, 0.9 * b.width() / (2 * doors), b.height() / (shelves + 1) - 0.04}),
                 i * 5 + k + 2);
  }
  doorsAcross(b, {b.left(), 0, b.right(), b.height()}, face, style, doors, PullAt::Bottom);
}

// Floor to ceiling: larder doors, or an oven at eye level between them.
void tallUnit(Builder& b, const Parameters& p) {
  FrontStyle style = styleOf(p);
  const bool oven = p.flag("oven");
  const double face = b.front() + std::max(pullDepth(style.pull), oven ? 0.041 : 0.0),
               inner = face + style.thickness + 0.002;
  b.slot("plinth");
  b.box({b.left(), inner + 0.05, 0}, {b.right(), b.back() - 0.02, kPlinth + 0.001}, 0.001, Grain::X);
  b.slot("carcass");
  carcass(b, {b.left(), inner, kPlinth}, {b.right(), b.back(), b.height()});
  const int doors = b.width() > 0.7 ? 2 : 1;
  if (!oven) {
    const double split = std::min(kPlinth + 1.3, 0.62 * b.height());
    doorsAcross(b, {b.left(), kPlinth, b.right(), split}, face, style, doors, PullAt::Top);
    doorsAcross(b, {b.left(), split, b.right(), b.height()}, face, style, doors, PullAt::Bottom);
    return;
  }
  double z = kPlinth;
  for (int i = 0; i < 2; ++i, z += 0.33) drawer(b, {b.left(), z, b.right(), z + 0.33}, face, style);
  ovenFront(b, Pane{b.left(), z, b.right(), z + 0.596}.inset(0.002), face, 0.021);
  z += 0.6;
  const Pane micro = Pane{b.left(), z, b.right(), std::min(z + 0.39, b.height() - 0.1)}.inset(0.002);
  b.slot("steel");
  b.box({micro.x0, face, micro.z0}, {micro.x1, face + 0.021, micro.z1}, 0.002, Grain::X);
  b.slot("dark-glass");
  b.box({micro.x0 + 0.03, face - 0.003, micro.z0 + 0.03}, {micro.x1 - 0.14, face + 0.002, micro.z1 - 0.03},
        0.001);
  b.box({micro.x1 - 0.11, face - 0.003, micro.z1 - 0.09}, {micro.x1 - 0.03, face + 0.002, micro.z1 - 0.05},
        0.001);
  b.slot("handle");
  b.within(facing({micro.x1 - 0.07, face, micro.midZ() - 0.04}, {0, -1, 0}),
           [&] { b.cone({}, 0.024, 0.02, 0.02, 0.003, 24); });
  doorsAcross(b, {b.left(), micro.z1 + 0.002, b.right(), b.height()}, face, style, doors, PullAt::Bottom);
}

// Doors on both long sides, the top reaching out at the back for stools.
void island(Builder& b, const Parameters& p) {
  const FrontStyle style = styleOf(p);
  const double t = p.number("worktop", 0.04), reach = std::min(p.number("bar", 0.28), 0.4 * b.depth());
  const double z1 = b.height() - t, side = 0.03;
  const double face = b.front() + std::max(kOverhang, pullDepth(style.pull)),
               inner = face + style.thickness + 0.002;
  const double x0 = b.left() + side, x1 = b.right() - side, back = b.back() - reach;
  b.slot("plinth");
  b.box({x0 + 0.03, inner + 0.05, 0}, {x1 - 0.03, back - 0.05, kPlinth + 0.001}, 0.001, Grain::X);
  b.slot("carcass");
  carcass(b, {x0 + 0.02, inner, kPlinth}, {x1 - 0.02, back - 0.02, z1});
  b.slot("front");  // panels close the sides and the back
  b.box({x0, inner - 0.002, kPlinth}, {x0 + 0.02, back, z1}, 0.002, Grain::Z);
  b.box({x1 - 0.02, inner - 0.002, kPlinth}, {x1, back, z1}, 0.002, Grain::Z);
  b.box({x0 + 0.02, back - 0.02, kPlinth}, {x1 - 0.02, back - 0.001, z1}, 0.002, Grain::Z);
  b.slot("worktop");
  b.box({b.left(), face - kOverhang, z1}, {b.right(), b.back(), b.height()}, 0.004, Grain::X);
  const int columns = std::clamp(p.count("columns", fitting(x1 - x0, 0.6)), 1, 6);
  const double w = (x1 - x0) / columns;
  for (int i = 0; i < columns; ++i) {
    const double left = x0 + w * i;
    if (i % 2 == 0) {
      double z = z1 - 0.002;
      for (const double f : {0.2, 0.4, 0.4}) {
        const double h = f * (z1 - 0.002 - kPlinth);
        drawer(b, {left, z - h, left + w, z}, face, style);
        z -= h;
      }
    } else {
      doorsAcross(b, {left, kPlinth, left + w, z1 - 0.002}, face, style, w > 0.55 ? 2 : 1, PullAt::Top);
    }
  }
}

void hood(Builder& b, const Parameters& p) {
  const double canopy = 0.06, h = b.height();
  const double duct = std::min(0.3, 0.5 * b.width()), ductDepth = std::min(0.28, 0.6 * b.depth());
  b.slot("steel");
  b.box({b.left(), b.front(), 0.004}, {b.right(), b.back(), canopy}, 0.003, Grain::X);
  if (p.text("style", "pyramid") == "pyramid") {
    const double top = std::min(0.32, 0.45 * h);
    const auto ring = [&](double f, double z) {
      const double k = f * f * (3 - 2 * f), hw = b.width() / 2 * (1 - k) + duct / 2 * k,
                   d = b.depth() * (1 - k) + ductDepth * k;
      return atHeight(rectangle({-hw + 0.002, b.back() - d + 0.002}, {hw - 0.002, b.back()}), z);
    };
    std::vector<Path> rings;
    for (int i = 0; i <= 10; ++i) rings.push_back(ring(i / 10.0, canopy - 0.001 + (top - canopy) * i / 10.0));
    b.loft(rings, true, 0.5);
  }
  b.box({-duct / 2, b.back() - ductDepth, canopy - 0.002}, {duct / 2, b.back(), h}, 0.002, Grain::Z);
  b.slot("filter");
  for (const double s : {-1.0, 1.0})
    b.box({s * 0.01, b.front() + 0.06, 0}, {s * (b.width() / 2 - 0.05), b.back() - 0.05, 0.006}, 0.001);
  b.slot("handle");
  for (int i = -2; i <= 2; ++i)
    b.within(facing({0.035 * i, b.front() + 0.001, canopy / 2}, {0, -1, 0}),
             [&] { b.cylinder({}, 0.008, 0.0015, 0.0004, 16); });
}

}  // namespace

void addKitchen(Generators& to) {
  to["kitchenBase"] = baseUnit;
  to["kitchenSink"] = sinkUnit;
  to["kitchenHob"] = hobUnit;
  to["kitchenCorner"] = cornerUnit;
  to["kitchenWall"] = wallUnit;
  to["kitchenTall"] = tallUnit;
  to["kitchenIsland"] = island;
  to["extractorHood"] = hood;
}

}  // namespace idap::parametric
