// Tables and desks. Tops keep their thickness and legs their section at any size.
#include <algorithm>
#include <cmath>

#include "catalog/parametric/registry.h"

namespace idap::parametric {
namespace {

// The outline of a top: "rectangle" (corners a little round), "oval", "round", "soft" (superellipse).
Polygon topOutline(const Builder& b, const std::string& shape, double inset = 0) {
  const Vec2 r{b.width() / 2 - inset, b.depth() / 2 - inset};
  if (shape == "oval" || shape == "round") return ellipse({}, r, 72);
  if (shape == "soft") return superellipse({}, r, 2.8, 80);
  return roundedRectangle(-r, r, 0.012, 4);
}

// A top with its edge shaped: "square" (a fine bevel), "round" (a half round), "under" (thin to the eye, cut
// away below).
void tableTop(Builder& b, const std::string& shape, const std::string& edge, double thick) {
  const double z = b.height() - thick;
  const Polygon outline = topOutline(b, shape);
  if (edge == "under") {
    // Two layers: the upper full, the lower tapering inwards.
    b.within(Transform::translation({0, 0, z}), [&] {
      const auto ring = [&](double in, double at) { return atHeight(topOutline(b, shape, in), at); };
      b.loft({ring(0.55 * thick + 0.03, 0), ring(0.012, 0.55 * thick), ring(0.001, 0.72 * thick),
              ring(0, 0.8 * thick), ring(0, thick - 0.003), ring(0.001, thick - 0.0008), ring(0.003, thick)},
             true, 0.6);
    });
  } else {
    b.extrude(outline, z, thick, edge == "round" ? 0.3 * thick : 0.002);
  }
}

// Four legs under a top with aprons between them; style of the legs: "square", "tapered", "turned".
void legTable(Builder& b, const Parameters& p) {
  const double thick = p.number("topThickness", 0.03);
  const std::string legs = p.text("legs", "tapered"), shape = p.text("shape", "rectangle");
  b.slot("top");
  tableTop(b, shape, p.text("edge", "square"), thick);
  b.slot("frame");
  const double under = b.height() - thick, apron = std::min(p.number("apron", 0.09), 0.3 * under);
  const double r = p.number("legSize", 0.065) / 2, inset = p.number("inset", 0.04) + r;
  const double share = shape == "rectangle" ? 1.0 : 0.74;
  const double x = share * b.width() / 2 - inset, y = share * b.depth() / 2 - inset;
  const double splay = p.number("splay", 0);
  b.mirroredXY([&] {
    if (legs == "turned") {
      b.box({x - r, y - r, under - apron - 0.04}, {x + r, y + r, under + 0.001}, 0.003, Grain::Z);
      b.leg({x, y, under - apron - 0.039}, {x, y, 0}, 0.98 * r, 0.8 * r, LegShape::Turned);
    } else if (legs == "square") {
      b.box({x - r, y - r, 0}, {x + r, y + r, under + 0.001}, 0.003, Grain::Z);
    } else {
      b.leg({x, y, under + 0.001}, {x + splay, y + splay, 0}, r, 0.55 * r,
            legs == "round" ? LegShape::Round : LegShape::Square);
    }
  });
  if (apron > 0.01) {
    const double t = 0.011, in = legs == "round" ? 0 : 0.35 * r;
    b.mirroredY([&] { b.box({-x, y + in - t, under - apron}, {x, y + in + t, under + 0.0005}); });
    b.mirroredX([&] { b.box({x + in - t, -y, under - apron}, {x + in + t, y, under + 0.0005}); });
  }
  if (p.flag("stretcher")) {
    const double z = 0.14;
    b.mirroredX([&] { b.box({x - 0.022, -y, z - 0.03}, {x + 0.022, y, z + 0.03}); });
    b.box({-x, -0.03, z - 0.024}, {x, 0.03, z + 0.024});
  }
  if (p.flag("shelf")) {
    const double z = 0.3 * b.height();
    b.box({-x + 0.4 * r, -y + 0.4 * r, z}, {x - 0.4 * r, y - 0.4 * r, z + 0.018});
  }
}

// A farmhouse table on two trestles: posts on shaped feet, tied by a rail wedged through.
void trestleTable(Builder& b, const Parameters& p) {
  const double thick = p.number("topThickness", 0.045), under = b.height() - thick;
  b.slot("top");
  // Planks with a hair of a gap, and breadboard ends.
  const double end = 0.09, x = b.width() / 2;
  const int planks = fitting(b.depth(), 0.17, 12);
  for (int i = 0; i < planks; ++i) {
    const double y0 = b.front() + b.depth() * i / planks, y1 = b.front() + b.depth() * (i + 1) / planks;
    b.box({-x + end + 0.0005, y0 + (i ? 0.0006 : 0), under},
          {x - end - 0.0005, y1 - (i + 1 < planks ? 0.0006 : 0), b.height()}, 0.0025, Grain::X);
  }
  b.mirroredX([&] { b.box({x - end, b.front(), under}, {x, b.back(), b.height()}, 0.0025, Grain::Y); });
  b.slot("frame");
  const double tx = x - std::min(0.32, 0.22 * b.width()), half = 0.42 * b.depth();
  b.mirroredX([&] {
    const Polygon foot = fillet({{-half, 0},
                                 {-half + 0.12, 0},
                                 {-half + 0.15, 0.012},
                                 {half - 0.15, 0.012},
                                 {half - 0.12, 0},
                                 {half, 0},
                                 {half, 0.035},
                                 {0.1, 0.095},
                                 {-0.1, 0.095},
                                 {-half, 0.035}},
                                0.015, 4);
    b.extrudeAlongX(foot, tx - 0.04, tx + 0.04, 0.004);
    const Polygon bearer = fillet({{-half, under - 0.04},
                                   {-half + 0.1, under - 0.08},
                                   {half - 0.1, under - 0.08},
                                   {half, under - 0.04},
                                   {half, under},
                                   {-half, under}},
                                  0.008, 3);
    b.extrudeAlongX(bearer, tx - 0.036, tx + 0.036, 0.004);
    b.box({tx - 0.034, -0.085, 0.09}, {tx + 0.034, -0.025, under - 0.075}, 0.005, Grain::Z);
    b.box({tx - 0.034, 0.025, 0.09}, {tx + 0.034, 0.085, under - 0.075}, 0.005, Grain::Z);
    b.box({tx + 0.045, -0.012, 0.235}, {tx + 0.065, 0.012, 0.36}, 0.003, Grain::Z);
  });
  b.box({-tx - 0.1, -0.021, 0.24}, {tx + 0.1, 0.021, 0.345}, 0.004);
}

// One foot: "turned" (a turned column on three or four bowed feet) or "tulip" (one sweep from the floor to
// the top).
void pedestalTable(Builder& b, const Parameters& p) {
  const double thick = p.number("topThickness", 0.028), under = b.height() - thick;
  b.slot("top");
  tableTop(b, p.text("shape", "round"), p.text("edge", "under"), thick);
  b.slot("frame");
  const double r = std::min(b.width(), b.depth()) / 2;
  if (p.text("style", "tulip") == "tulip") {
    const double foot = std::clamp(0.52 * r, 0.13, 0.42), neck = std::clamp(0.075 * r, 0.025, 0.05);
    const double oval = std::min(1.6, std::max(b.width(), b.depth()) / (2 * r));
    b.within(Transform::scaling({b.width() >= b.depth() ? oval : 1, b.width() < b.depth() ? oval : 1, 1}),
             [&] {
               b.lathe({},
                       spline2({{0, 0},
                                {0.96 * foot, 0},
                                {foot, 0.006},
                                {0.94 * foot, 0.014},
                                {0.62 * foot, 0.034},
                                {0.3 * foot, 0.075},
                                {1.25 * neck, 0.16},
                                {neck, 0.42 * under},
                                {1.2 * neck, 0.66 * under},
                                {2.2 * neck, 0.88 * under},
                                {0.5 * foot, under - 0.012},
                                {0.62 * foot, under + 0.0005},
                                {0, under + 0.001}},
                               5),
                       48);
             });
    return;
  }
  const double c = std::clamp(0.1 * r, 0.035, 0.075), h = under;
  b.lathe({},
          spline2({{0, 0.17 * h},
                   {0.5 * c, 0.17 * h},
                   {0.75 * c, 0.19 * h},
                   {1.05 * c, 0.26 * h},
                   {1.1 * c, 0.33 * h},
                   {0.75 * c, 0.4 * h},
                   {0.62 * c, 0.43 * h},
                   {0.95 * c, 0.45 * h},
                   {0.6 * c, 0.47 * h},
                   {0.72 * c, 0.55 * h},
                   {1.15 * c, 0.68 * h},
                   {0.95 * c, 0.78 * h},
                   {0.6 * c, 0.84 * h},
                   {0.9 * c, 0.87 * h},
                   {0.9 * c, 0.9 * h},
                   {1.5 * c, 0.95 * h},
                   {1.6 * c, h - 0.02},
                   {0, h - 0.019}},
                  4),
          32);
  b.cylinder({0, 0, h - 0.025}, std::min(0.5 * r, 0.22), 0.026, 0.004, 36);
  const int feet = p.count("feet", 4);
  const double reach = std::clamp(0.68 * r, 0.2, 0.5);
  for (int i = 0; i < feet; ++i) {
    b.within(Transform::rotationZ(kPi / 4 + 2 * kPi * i / feet), [&] {
      const Path way = spline({{0.5 * c, 0, 0.29 * h},
                               {0.32 * reach, 0, 0.27 * h},
                               {0.62 * reach, 0, 0.14 * h},
                               {0.86 * reach, 0, 0.045},
                               {reach, 0, 0.028}},
                              5);
      b.sweep(way, [](double t) {
        const double w = 0.021 - 0.003 * t, v = 0.036 * (1 - t) + 0.016 * t;
        return fillet(rectangle({-w, -v}, {w, v}), 0.012, 3);
      });
      b.ellipsoid({reach, 0, 0.024}, {0.034, 0.024, 0.024}, 16);
    });
  }
}

// A pane of glass on a frame of square steel tube; shape round: on a drum of bent tubes.
void glassTable(Builder& b, const Parameters& p) {
  const double thick = p.number("topThickness", 0.012), z = b.height() - thick, r = 0.0125;
  const std::string shape = p.text("shape", "rectangle");
  b.slot("glass");
  b.extrude(shape == "rectangle" ? roundedRectangle({b.left(), b.front()}, {b.right(), b.back()}, 0.02, 5)
                                 : topOutline(b, shape),
            z, thick, 0.0025);
  b.slot("metal");
  const double pad = 0.004;
  if (shape == "rectangle") {
    const double x = b.width() / 2 - 0.05, y = b.depth() / 2 - 0.05, top = z - pad;
    b.mirroredX([&] {
      // Each end is one frame.
      b.mirroredY([&] { b.box({x - r, y - r, 0}, {x + r, y + r, top - 2 * r}, 0.0025); });
      b.box({x - r - 0.0005, -y - r - 0.0005, top - 2 * r}, {x + r + 0.0005, y + r + 0.0005, top}, 0.0025);
      if (p.flag("sled", true))
        b.box({x - r - 0.0005, -y + r, 0.0005}, {x + r + 0.0005, y - r, 2 * r}, 0.0025);
    });
    b.mirroredY([&] { b.box({-x + r, y - r, top - 2 * r + 0.0008}, {x - r, y + r, top - 0.0008}, 0.0025); });
    b.slot("pads");
    b.mirroredXY([&] { b.cylinder({x, y, top - 0.001}, 0.009, pad + 0.0015, 0.001, 16); });
    if (p.flag("shelf")) {
      b.slot("shelf");
      const double s = 0.35 * z;
      b.box({-x + r, -y - 0.5 * r, s}, {x - r, y + 0.5 * r, s + 0.008}, 0.002);
      b.slot("metal");
      b.mirroredX([&] { b.box({x - 0.8 * r, -y, s - 0.016}, {x + 0.8 * r, y, s}, 0.002); });
    }
    return;
  }
  const double R = 0.72 * std::min(b.width(), b.depth()) / 2, low = 0.85 * R;
  b.within(
      Transform::scaling(
          {b.width() / std::min(b.width(), b.depth()), b.depth() / std::min(b.width(), b.depth()), 1}),
      [&] {
        b.torus({0, 0, z - pad - 0.008}, R, 0.008, 48, 10);
        b.torus({0, 0, 0.008}, low, 0.008, 48, 10);
        const int bars = p.count("bars", 12);
        for (int i = 0; i < bars; ++i) {
          const double a = 2 * kPi * i / bars, c = 2 * kPi * (i + 1.5) / bars;
          b.rod({low * std::cos(a), low * std::sin(a), 0.008},
                {R * std::cos(c), R * std::sin(c), z - pad - 0.008}, 0.0045, 8, Cap::None);
          b.rod({low * std::cos(c), low * std::sin(c), 0.008},
                {R * std::cos(a), R * std::sin(a), z - pad - 0.008}, 0.0045, 8, Cap::None);
        }
        b.slot("pads");
        for (int i = 0; i < 4; ++i) {
          const double a = kPi / 4 + i * kPi / 2;
          b.cylinder({R * std::cos(a), R * std::sin(a), z - pad - 0.001}, 0.009, pad + 0.0015, 0.001, 16);
        }
      });
}

// A drawer's front with its pull, in a carcass opening.
void drawerFront(Builder& b, Vec3 min, Vec3 max, const std::string& pull) {
  b.slot("front");
  b.box(min, max, 0.002, Grain::X);
  b.slot("handle");
  const Vec3 middle{(min.x + max.x) / 2, min.y, (min.z + max.z) / 2};
  if (pull == "knob") b.knob(middle);
  if (pull == "bar") b.barPull(middle, std::min(0.16, 0.5 * (max.x - min.x)), false);
  if (pull == "cup") b.cupPull(middle);
}

// A writing desk: style "pedestal" (cupboards of drawers to the floor on both sides or one), "writing"
// (shallow drawers over slender legs).
void desk(Builder& b, const Parameters& p) {
  const double thick = p.number("topThickness", 0.028), under = b.height() - thick;
  const std::string pull = p.text("pull", "knob");
  const double w = b.width() / 2, f = b.front(), k = b.back();
  const double stick = pull == "knob" ? 0.027 : pull == "bar" ? 0.036 : pull == "cup" ? 0.033 : 0;
  b.slot("top");
  b.box({-w, f, under}, {w, k, b.height()}, 0.003);
  const double gap = 0.003, board = 0.018,
               face = f + std::max(0.02, stick);  // fronts stand back under the top
  if (p.text("style", "writing") == "writing") {
    const double tall = std::min(0.13, 0.22 * b.height()), r = 0.024;
    b.slot("body");
    const double x = w - 0.03, back = k - 0.03;
    b.box({-x, face + 0.012, under - tall}, {x, back, under - tall + 0.012});
    b.mirroredX([&] { b.box({x - board, face, under - tall + 0.0005}, {x, back, under + 0.0005}); });
    b.box({-x + board, back - board, under - tall + 0.0005}, {x - board, back - 0.0005, under + 0.0005});
    b.slot("legs");
    b.mirroredX([&] {
      b.leg({x - r, face + r + 0.01, under - tall + 0.004},
            {x - 0.6 * r + p.number("splay", 0.02), face + 0.8 * r - p.number("splay", 0.02) * 0.4, 0}, r,
            0.5 * r, p.text("legs", "round") == "round" ? LegShape::Round : LegShape::Square);
      b.leg({x - r, back - r - 0.01, under - tall + 0.004},
            {x - 0.6 * r + p.number("splay", 0.02), back - 0.8 * r + p.number("splay", 0.02) * 0.4, 0}, r,
            0.5 * r, p.text("legs", "round") == "round" ? LegShape::Round : LegShape::Square);
    });
    const int drawers = p.count("drawers", 0) > 0 ? p.count("drawers", 0) : fitting(2 * x, 0.5, 6);
    const double x0 = -x + board + gap, span = (2 * (x - board) - gap) / drawers;
    for (int i = 0; i < drawers; ++i)
      drawerFront(b, {x0 + i * span, face + 0.001, under - tall + 0.015},
                  {x0 + (i + 1) * span - gap, face + 0.02, under - gap}, pull);
    return;
  }
  const double pedestal = std::min(0.42, 0.3 * b.width());
  const bool both = p.flag("both", true);
  const auto column = [&](double x0, double x1) {
    b.slot("body");
    const double plinth = 0.06;
    b.box({x0, face, plinth}, {x0 + board, k - 0.02, under + 0.0005}, kBevel, Grain::Z);
    b.box({x1 - board, face, plinth}, {x1, k - 0.02, under + 0.0005}, kBevel, Grain::Z);
    b.box({x0 + board, face + 0.004, plinth + 0.0005}, {x1 - board, k - 0.021, plinth + board});
    b.box({x0 + board, k - 0.028, plinth + board}, {x1 - board, k - 0.0205, under + 0.0005});
    b.box({x0 + 0.02, face + 0.03, 0}, {x1 - 0.02, k - 0.05, plinth + 0.0005});
    const double z0 = plinth + board + gap, h = under - gap - z0;
    const int rows = p.count("drawers", 0) > 0 ? p.count("drawers", 0) : fitting(h, 0.19, 8);
    for (int i = 0; i < rows; ++i)
      drawerFront(b, {x0 + board + gap, face + 0.001, z0 + h * i / rows},
                  {x1 - board - gap, face + 0.02, z0 + h * (i + 1) / rows - gap}, pull);
  };
  column(w - 0.02 - pedestal, w - 0.02);
  if (both) {
    column(-w + 0.02, -w + 0.02 + pedestal);
  } else {
    b.slot("body");
    b.box({-w + 0.02, face, 0}, {-w + 0.02 + 0.03, k - 0.02, under + 0.0005}, kBevel, Grain::Z);
  }
  b.slot("body");
  b.box({(both ? -w + 0.02 + pedestal : -w + 0.05) - 0.0005, k - 0.12, under - 0.35 * under},
        {w - 0.02 - pedestal + 0.0005, k - 0.102, under + 0.0004});
}

// Hairpin legs: bent rod under a slab with its natural edge or a straight one.
void hairpinTable(Builder& b, const Parameters& p) {
  const double thick = p.number("topThickness", 0.035), under = b.height() - thick;
  b.slot("top");
  tableTop(b, p.text("shape", "rectangle"), p.text("edge", "square"), thick);
  b.slot("metal");
  const double share = p.text("shape", "rectangle") == "rectangle" ? 1.0 : 0.75;
  const double x = share * b.width() / 2 - 0.09, y = share * b.depth() / 2 - 0.09, r = 0.006;
  b.mirroredXY([&] {
    b.box({x - 0.05, y - 0.05, under - 0.004}, {x + 0.05, y + 0.05, under + 0.0005}, 0.001);
    const double out = p.number("splay", 0.035);
    b.tube(roundedPath({{x - 0.035, y + 0.03, under - 0.003},
                        {x + out - 0.008, y + out + 0.008, r},
                        {x + out + 0.008, y + out - 0.008, r},
                        {x + 0.03, y - 0.035, under - 0.003}},
                       0.012, 5),
           r, 10, Cap::Flat);
  });
}

}  // namespace

void addTables(Generators& to) {
  to["legTable"] = legTable;
  to["trestleTable"] = trestleTable;
  to["pedestalTable"] = pedestalTable;
  to["glassTable"] = glassTable;
  to["desk"] = desk;
  to["hairpinTable"] = hairpinTable;
}

}  // namespace idap::parametric
