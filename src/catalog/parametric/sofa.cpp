// Sofas, armchairs, chaises and poufs.
#include <algorithm>
#include <cmath>

#include "catalog/parametric/registry.h"
#include "catalog/parametric/seating.h"

namespace idap::parametric {
namespace {

// A row of seat cushions between x0 and x1, their fronts at y0.
void seatCushions(Builder& b, double x0, double x1, double y0, double y1, double z0, double z1, int count,
                  bool piped) {
  const double each = (x1 - x0) / count;
  for (int i = 0; i < count; ++i) {
    const Vec3 min{x0 + i * each + 0.002, y0, z0}, max{x0 + (i + 1) * each - 0.002, y1, z1};
    b.cushion(min, max,
              {.radius = 0.045,
               .crown = 0.025,
               .bulge = 0.006,
               .wrinkle = 0.003,
               .wrinkleLength = 0.4,
               .segments = 12});
    if (piped) {
      b.piping({min.x + 0.003, min.y + 0.003, min.z}, {max.x - 0.003, max.y - 0.003, max.z}, 0.045, 2, 0.74);
      b.piping({min.x + 0.003, min.y + 0.003, min.z}, {max.x - 0.003, max.y - 0.003, max.z}, 0.045, 2, 0.2);
    }
  }
}

// Loose back cushions that lean against the back, whose face is at y1.
void backCushions(Builder& b, double x0, double x1, double y1, double thick, double z0, double z1, int count,
                  double lean) {
  const double each = (x1 - x0) / count;
  for (int i = 0; i < count; ++i) {
    const double tall = (z1 - z0) / std::cos(lean);
    leaningCushion(b, {x0 + i * each + 0.004, y1 - thick - std::sin(lean) * tall, z0},
                   {x0 + (i + 1) * each - 0.004, y1 - std::sin(lean) * tall, z0 + tall}, lean,
                   {.radius = 0.06,
                    .crown = 0.045,
                    .bulge = 0.012,
                    .wrinkle = 0.005,
                    .wrinkleLength = 0.3,
                    .segments = 12},
                   false);
  }
}

// Four feet under a body: "tapered" (wood), "block", "bun" or "steel".
void feet(Builder& b, const std::string& style, double x0, double x1, double y0, double y1, double height) {
  b.slot("legs");
  std::vector<double> xs{x0, x1};
  if (x1 - x0 > 1.9) xs.push_back((x0 + x1) / 2);
  for (const double x : xs) {
    for (const double y : {y0, y1}) {
      const Vec3 top{x, y, height + 0.002};
      if (style == "block") {
        b.box({x - 0.025, y - 0.025, 0}, {x + 0.025, y + 0.025, height + 0.002}, 0.003);
      } else if (style == "bun") {
        const double r = 0.036, h = height;
        b.lathe({x, y, 0},
                spline2({{0, 0},
                         {0.5 * r, 0},
                         {0.62 * r, 0.06 * h},
                         {r, 0.4 * h},
                         {0.95 * r, 0.65 * h},
                         {0.6 * r, 0.86 * h},
                         {0.8 * r, 0.93 * h},
                         {0.8 * r, h + 0.002},
                         {0, h + 0.003}},
                        3),
                20);
      } else if (style == "steel") {
        b.cylinder({x, y, 0}, 0.012, height + 0.002, 0.002, 16);
        b.cylinder({x, y, 0}, 0.02, 0.006, 0.002, 16);
      } else {
        const double sx = x > (x0 + x1) / 2 + 0.01   ? 1
                          : x < (x0 + x1) / 2 - 0.01 ? -1
                                                     : 0,
                     sy = y > (y0 + y1) / 2 ? 1 : -1;
        b.leg(top, {x + 0.025 * sx, y + 0.025 * sy, 0}, 0.022, 0.012);
      }
    }
  }
}

// Plain modern sofa: frame, box arms, seat and back cushions by width. chaise: the last seat at that end
// (left, right) reaches to the front of the box while the rest stands back.
void modernSofa(Builder& b, const Parameters& p) {
  const double w = b.width() / 2, f = b.front(), k = b.back(), h = b.height();
  const double legs = p.number("legHeight", 0.13), seat = std::min(p.number("seatHeight", 0.43), 0.62 * h);
  const double arm = std::min(p.number("arm", 0.15), 0.2 * b.width()),
               armTop = std::min(seat + p.number("armRise", 0.17), h - 0.06);
  const double back = 0.17, base = std::max(legs + 0.07, seat - 0.17);
  const std::string chaise = p.text("chaise");
  const bool corner = !chaise.empty();
  const double front = corner ? std::min(f + 0.6, k - 0.85) : f;  // of the part without chaise
  const int seats = p.count("seats", 0) > 0 ? p.count("seats", 0) : fitting(b.width() - 2 * arm, 0.72, 6);
  const double inner = w - arm, each = 2 * inner / seats;
  feet(b, p.text("legs", "tapered"), -w + 0.08, w - 0.08, (corner ? front : f) + 0.09, k - 0.09, legs);
  const auto build = [&] {
    b.slot("fabric");
    const Soft firm{.radius = 0.028, .crown = 0.008};
    const double a = corner ? each : 0;  // width of the chaise, at the left
    b.cushion({-inner - 0.01 + a, front + 0.03, legs}, {inner + 0.01, k - 0.02, base + 0.01}, firm);
    b.cushion({-w + 0.01, k - back, legs + 0.01}, {w - 0.01, k, h - 0.04}, {.radius = 0.04, .crown = 0.006});
    b.cushion({w - arm, front, legs}, {w, k - 0.01, armTop},
              {.radius = 0.035, .crown = 0.01, .bulge = 0.004});
    if (corner) {
      b.cushion({-w + 0.004, f + 0.02, legs}, {-inner + a + 0.006, k - 0.03, base + 0.008}, firm);
      b.cushion({-w, front + 0.35, legs}, {-w + arm, k - 0.01, armTop},
                {.radius = 0.035, .crown = 0.01, .bulge = 0.004});
      seatCushions(b, -inner, -inner + a, f, k - back - 0.012, base, seat + 0.01, 1, p.flag("piping"));
      seatCushions(b, -inner + a, inner, front, k - back - 0.01, base, seat + 0.01,
                   seats - 1 > 0 ? seats - 1 : 1, p.flag("piping"));
    } else {
      b.cushion({-w, f, legs}, {-w + arm, k - 0.01, armTop},
                {.radius = 0.035, .crown = 0.01, .bulge = 0.004});
      seatCushions(b, -inner, inner, f + 0.004, k - back - 0.01, base, seat + 0.01, seats, p.flag("piping"));
    }
    backCushions(b, -inner, inner, k - back + 0.04, 0.17, seat - 0.015, h, seats, 0.16);
    if (p.flag("pillows", true)) {
      b.slot("pillow");
      const double s = std::min(0.42, h - seat + 0.06);
      b.within(
          Transform::translation({inner - 0.5 * s, k - back - 0.26, seat - 0.005}) *
              Transform::rotationZ(-0.35) * Transform::rotationX(-0.38),
          [&] {
            b.cushion(
                {-s / 2, -0.075, 0}, {s / 2, 0.075, s},
                {.radius = 0.05, .wrinkle = 0.006, .wrinkleLength = 0.2, .pinched = true, .segments = 14});
          });
    }
  };
  if (corner) {
    b.slot("legs");
    const double side = chaise == "right" ? -1 : 1;
    b.within(Transform::scaling({side, 1, 1}), [&] {
      b.leg({-w + 0.08, f + 0.1, legs + 0.01}, {-w + 0.06, f + 0.08, 0}, 0.022, 0.012);
      b.leg({-inner + each - 0.08, f + 0.1, legs + 0.01}, {-inner + each - 0.06, f + 0.08, 0}, 0.022, 0.012);
      build();
    });
  } else {
    build();
  }
}

// A scroll: the section of a rolled arm, its inside to the right: from the floor side up and around.
Polygon scroll(double width, double z0, double z1) {
  const double r = 0.5 * width * 1.08, cz = z1 - r;
  Polygon out{{-0.32 * width, z0}, {0.5 * width, z0}, {0.5 * width, cz}};
  for (const Vec2 q : arc({-0.04 * width, cz}, r, 0.0, 1.28 * kPi, 18)) out.push_back(q);
  return out;
}

// Chesterfield: back and arms of one height, rolled over and deeply buttoned.
void chesterfieldSofa(Builder& b, const Parameters& p) {
  const double w = b.width() / 2, f = b.front(), k = b.back(), h = b.height();
  const double legs = 0.09, seat = std::min(0.44, 0.62 * h), arm = std::min(0.2, 0.22 * b.width());
  feet(b, "bun", -w + 0.1, w - 0.1, f + 0.08, k - 0.1, legs);
  b.slot("fabric");
  b.cushion({-w + 0.5 * arm, f + 0.025, legs}, {w - 0.5 * arm, k - 0.06, seat - 0.13},
            {.radius = 0.02, .crown = 0.004});
  const double r = 0.54 * arm, cz = h - r;
  b.mirroredX([&] {
    // The arm's body and the roll on it.
    b.cushion({w - 0.86 * arm, f + 0.03, legs}, {w - 0.2 * arm, k - 0.04, cz},
              {.radius = 0.03, .crown = 0.0});
    const Polygon face = [&] {
      Polygon q = scroll(arm, legs + 0.004, h - 0.006);
      for (Vec2& v : q) v.x = -v.x;
      std::reverse(q.begin(), q.end());
      return q;
    }();
    Polygon placed;
    for (const Vec2 q : face) placed.push_back({q.x * 0.97 + w - 0.54 * arm, q.y});
    b.extrudeAlongY(placed, f + 0.004, f + 0.05, 0.012);
    b.within(facing({w - r, f + 0.03, cz}, {0, 1, 0}),
             [&] { b.cylinder({}, r, k - f - 0.03 - 0.5 * r, 0.02, 28); });
    // A row of nails around the scroll.
    b.slot("nails");
    for (std::size_t i = 3; i + 1 < placed.size(); i += 1) {
      const Vec2 c{w - r, cz};
      const Vec2 q = c + (placed[i] - c) * 0.86;
      b.ellipsoid({q.x, f + 0.003, q.y}, {0.006, 0.003, 0.006}, 6);
    }
    b.slot("fabric");
    // Buttoned inside of the arm.
    const int columns = std::max(2, fitting(k - f - 0.2, 0.17));
    b.cushion({w - arm - 0.03, f + 0.05, seat - 0.06}, {w - 0.55 * arm, k - 0.1, h - 0.25 * r},
              {.radius = 0.045,
               .crown = 0.012,
               .tuftColumns = columns,
               .tuftRows = 2,
               .tuftDepth = 0.024,
               .tuftFace = {-1, 0, 0},
               .segments = 8});
  });
  b.cushion({-w + 0.3 * arm, k - 0.85 * arm, legs}, {w - 0.3 * arm, k - 0.25 * arm, cz},
            {.radius = 0.03, .crown = 0});
  b.within(facing({-w + 0.75 * arm, k - r, cz}, {1, 0, 0}),
           [&] { b.cylinder({}, r, 2 * w - 1.5 * arm, 0.02, 28); });
  b.mirroredX([&] { b.sphere({w - r - 0.004, k - r, cz}, r, 28); });
  const int columns = std::max(3, fitting(2 * (w - arm), 0.17, 24));
  b.cushion({-w + 0.9 * arm, k - arm - 0.09, seat - 0.06}, {w - 0.9 * arm, k - 0.5 * arm, h - 0.2 * r},
            {.radius = 0.05,
             .crown = 0.012,
             .tuftColumns = columns,
             .tuftRows = 3,
             .tuftDepth = 0.028,
             .segments = 8});
  const int seats = p.count("seats", 0) > 0 ? p.count("seats", 0) : fitting(2 * (w - arm), 0.65, 6);
  seatCushions(b, -w + arm + 0.032, w - arm - 0.032, f + 0.012, k - arm - 0.075, seat - 0.14, seat + 0.01,
               seats, true);
}

// Wing chair: high back, wings, rolled arms, cabriole-like front feet.
void wingChair(Builder& b, const Parameters& p) {
  const double w = b.width() / 2, f = b.front(), k = b.back(), h = b.height();
  const double legs = 0.17, seat = std::min(p.number("seatHeight", 0.46), 0.5 * h), arm = 0.1,
               armTop = seat + 0.19;
  b.slot("legs");
  b.mirroredX([&] {
    b.tube(
        spline({{w - 0.09, f + 0.09, legs + 0.01},
                {w - 0.062, f + 0.06, 0.72 * legs},
                {w - 0.085, f + 0.085, 0.25 * legs},
                {w - 0.07, f + 0.07, 0.0}},
               5),
        [](double t) { return 0.028 - 0.014 * std::sin(kPi * 0.5 * t) + 0.006 * std::pow(t, 6); }, 14,
        Cap::Flat);
    b.leg({w - 0.1, k - 0.2, legs + 0.01}, {w - 0.085, k - 0.08, 0}, 0.021, 0.015, LegShape::Square);
  });
  b.slot("fabric");
  const double lean = 0.17, base = legs;
  b.cushion({-w + 0.03, f + 0.06, base}, {w - 0.03, k - 0.1, seat - 0.11}, {.radius = 0.025, .crown = 0.006});
  seatCushions(b, -w + arm, w - arm, f + 0.02, k - 0.2, seat - 0.12, seat + 0.01, 1, true);
  const double tall = (h - base) / std::cos(lean) - 0.012, shift = std::sin(lean) * tall;
  Soft soft{.radius = 0.05, .crown = 0.02};
  if (p.flag("buttons", true)) soft.tuftColumns = 3, soft.tuftRows = 4, soft.tuftDepth = 0.016;
  leaningCushion(b, {-w + 0.06, k - 0.15 - shift, base}, {w - 0.06, k - shift, base + tall}, lean, soft,
                 false);
  const Vec3 foot{0, k - 0.075 - shift, base};
  b.mirroredX([&] {
    b.cushion({w - arm, f + 0.07, base}, {w - 0.02, k - 0.14, armTop - 0.05},
              {.radius = 0.03, .crown = 0.006});
    // The roll, falling a little to the back.
    b.tube({{w - arm * 0.62, f + 0.035, armTop - 0.052},
            {w - arm * 0.62, f + 0.06, armTop - 0.05},
            {w - arm * 0.6, k - 0.25, armTop - 0.06},
            {w - arm * 0.58, k - 0.12, armTop - 0.07}},
           0.056, 20);
    // The wing: a flat padded panel of curved outline, standing at the back's edge and leaning with it.
    const double top = base + tall - 0.03, low = armTop - 0.09;
    const Polygon side = fillet(spline2({{k - 0.06, top},
                                         {k - 0.2, top - 0.015},
                                         {k - 0.265, top - 0.14},
                                         {k - 0.27, top - 0.28},
                                         {k - 0.335, low + 0.06},
                                         {k - 0.33, low},
                                         {k - 0.06, low}},
                                        5),
                                0.004, 2);
    b.within(Transform::translation(foot) * Transform::rotationX(-lean) * Transform::translation(-foot) *
                 Transform::translation({0, -shift, 0}),
             [&] { b.extrudeAlongX(side, w - 0.085, w - 0.022, 0.022); });
  });
}

// A tub armchair: one shell of upholstery around back and arms.
void tubChair(Builder& b, const Parameters& p) {
  const double w = b.width() / 2, f = b.front(), k = b.back(), h = b.height(),
               legs = p.number("legHeight", 0.14);
  const double seat = std::min(p.number("seatHeight", 0.43), 0.6 * h), thick = 0.09;
  b.slot("legs");
  b.mirroredXY([&] {
    b.leg({0.62 * w, 0.62 * b.depth() / 2, legs + 0.02}, {0.78 * w, 0.78 * b.depth() / 2, 0}, 0.02, 0.011);
  });
  b.slot("fabric");
  // Ring sections along a horseshoe, its height falling from the back to the arms.
  Path way;
  const double rx = w - thick / 2, ry = (k - f) * 0.56, cy = k - thick / 2 - ry;
  way.push_back({-rx * 0.94, f + 0.1, 0});
  for (int i = 0; i <= 24; ++i) {
    const double a = kPi - kPi * i / 24;
    const double q =
        std::pow(std::pow(std::abs(std::cos(a)), 2.6) + std::pow(std::abs(std::sin(a)), 2.6), -1 / 2.6);
    way.push_back({rx * q * std::cos(a), cy + ry * q * std::sin(a), 0});
  }
  way.push_back({rx * 0.94, f + 0.1, 0});
  const double armTop = std::min(seat + 0.2, h - 0.04), z0 = legs;
  b.sweep(spline(way, 2), [&](double t) {
    const double s = std::sin(kPi * t), top = armTop + (h - armTop) * std::pow(s, 2.2);
    const double end = std::min(1.0, std::min(t, 1 - t) * 16);
    const double half = thick / 2 * (0.55 + 0.45 * std::sqrt(end));
    return roundedRectangle({-half, z0 + 0.02 * (1 - end)}, {half, top - 0.03 * (1 - std::sqrt(end))},
                            0.9 * half, 6);
  });
  b.extrude(superellipse({0, (f + k) / 2 - 0.005}, {w - 0.05, (k - f) / 2 - 0.03}, 3, 48), legs + 0.004,
            seat - 0.15 - legs, 0.02);
  const double r = w - thick;
  b.cushion({-r - 0.004, f, seat - 0.155}, {r + 0.004, k - thick - 0.012, seat + 0.01},
            {.radius = 0.055, .crown = 0.03, .bulge = 0.01, .segments = 12});
  if (p.flag("channels")) {
    // Upright rolls inside the back.
    const int n = 11;
    for (int i = 0; i < n; ++i) {
      const double t = 0.2 + 0.6 * i / (n - 1), s = std::sin(kPi * t);
      const Vec3 q = along(way, t), in = normalized(Vec3{-q.x, cy - 0.1 - q.y, 0});
      const double top = armTop + (h - armTop) * std::pow(s, 2.2) - 0.035;
      const Vec3 at = q + in * (thick / 2);
      b.tube({at + Vec3{0, 0, seat - 0.03}, at + Vec3{0, 0, top}}, 0.055, 12);
    }
  }
}

// A lounge armchair: wooden frame, loose cushions.
void frameArmchair(Builder& b, const Parameters& p) {
  const double w = b.width() / 2, f = b.front(), k = b.back(), h = b.height(),
               seat = std::min(p.number("seatHeight", 0.42), 0.6 * h);
  b.slot("wood");
  const double x = w - 0.03, armTop = seat + 0.16, lean = 0.26;
  const double y0 = f + 0.06, y1 = k - 0.1;
  b.mirroredX([&] {
    b.leg({x, y0 + 0.01, armTop - 0.016}, {x, y0, 0}, 0.018, 0.012);
    b.leg({x, y1 - 0.08, armTop - 0.02}, {x, y1 + 0.06, 0}, 0.018, 0.012);
    // The armrest: a paddle, wide in front.
    const Path way = spline({{x - 0.005, f + 0.005, armTop - 0.004},
                             {x - 0.004, f + 0.16, armTop},
                             {x + 0.004, 0.1, armTop - 0.012},
                             {x, y1 - 0.02, armTop - 0.026}},
                            6);
    b.sweep(way, [](double t) {
      const double half =
                       0.014 + 0.02 * std::exp(-std::pow((t - 0.16) / 0.3, 2)) * std::min(1.0, 0.4 + 6 * t),
                   r = 0.011;
      return roundedRectangle({-half, -0.012}, {half, 0.012}, r, 4);
    });
    b.box({x - 0.011, y0, seat - 0.13}, {x + 0.011, y1, seat - 0.085}, 0.004, Grain::Y);
  });
  b.mirroredX([&] {});
  b.box({-x, y0 + 0.0, seat - 0.14}, {x, y0 + 0.022, seat - 0.088}, 0.004);
  b.box({-x, y1 - 0.022, seat - 0.16}, {x, y1, seat - 0.11}, 0.004);
  // The back's frame with upright slats, behind the cushion.
  const Vec3 foot{0, y1 - 0.11, seat - 0.13};
  const double tall = (h - foot.z) / std::cos(lean) - 0.006;
  const auto leaning = Transform::translation(foot) * Transform::rotationX(-lean);
  b.within(leaning, [&] {
    b.mirroredX([&] { b.box({x - 0.06, 0, 0}, {x - 0.03, 0.024, tall}, 0.006, Grain::Z); });
    b.box({-x + 0.031, 0.001, tall - 0.05}, {x - 0.031, 0.023, tall - 0.002}, 0.006);
    const int slats = fitting(2 * x, 0.11, 14);
    for (int i = 1; i < slats; ++i) {
      const double sx = (-x + 0.04) + (2 * x - 0.08) * i / slats;
      b.box({sx - 0.012, 0.005, 0}, {sx + 0.012, 0.017, tall - 0.04}, 0.003, Grain::Z);
    }
    b.slot("fabric");
    b.cushion({-x + 0.045, -0.13, 0.1}, {x - 0.045, 0.002, tall - 0.02},
              {.radius = 0.045, .crown = 0.028, .bulge = 0.006, .segments = 12});
  });
  b.slot("fabric");
  b.within(Transform::translation({0, y0, seat - 0.1}) * Transform::rotationX(-0.06), [&] {
    b.cushion({-x + 0.02, -0.045, 0}, {x - 0.02, y1 - y0 - 0.16, 0.13},
              {.radius = 0.045, .crown = 0.025, .bulge = 0.006, .segments = 12});
  });
}

// Chaise longue: one long seat, a rolled end, a bolster.
void chaiseLongue(Builder& b, const Parameters& p) {
  const double w = b.width() / 2, f = b.front(), k = b.back(), h = b.height(), legs = 0.16;
  const double seat = std::min(p.number("seatHeight", 0.44), 0.7 * h);
  feet(b, p.text("legs", "tapered"), -w + 0.14, w - 0.1, f + 0.09, k - 0.09, legs);
  b.slot("fabric");
  b.cushion({-w + 0.06, f + 0.015, legs}, {w, k - 0.015, seat - 0.11}, {.radius = 0.025, .crown = 0.004});
  b.cushion({-w + 0.14, f, seat - 0.12}, {w - 0.004, k, seat + 0.012},
            {.radius = 0.045,
             .crown = 0.025,
             .tuftColumns = std::max(3, fitting(2 * w, 0.24)),
             .tuftRows = 2,
             .tuftDepth = 0.018,
             .tuftFace = {0, 0, 1},
             .segments = 10});
  // The head end curls up and over, as one ribbon of upholstery.
  const Path way = spline({{-w + 0.3, 0, seat - 0.09},
                           {-w + 0.16, 0, seat - 0.02},
                           {-w + 0.1, 0, seat + 0.5 * (h - seat)},
                           {-w + 0.075, 0, h - 0.085},
                           {-w + 0.062, 0, h - 0.062}},
                          6);
  const double half = (k - f) / 2 - 0.008;
  b.sweep(way,
          [&](double t) {
            return roundedRectangle({-half, -0.05 + 0.02 * t}, {half, 0.05 - 0.02 * t}, 0.03, 5);
          },
          {1, 0, 0.2});
  b.within(facing({-w + 0.062, -half, h - 0.062}, {0, 1, 0}),
           [&] { b.cylinder({}, 0.062, 2 * half, 0.018, 28); });
  b.slot("pillow");
  b.within(facing({-w + 0.29, -0.82 * half, seat + 0.075}, {0, 1, 0}), [&] {
    b.lathe({},
            fillet({{0, 0}, {0.085, 0}, {0.09, 0.82 * half}, {0.085, 1.64 * half}, {0, 1.64 * half}}, 0.03, 5,
                   false),
            28);
  });
}

// A pouf: "square" (a cushioned cube), "round" (with piping), "drum" (knitted, in lobes).
void pouf(Builder& b, const Parameters& p) {
  const double w = b.width() / 2, f = b.front(), k = b.back(), h = b.height();
  const std::string style = p.text("style", "round");
  if (style == "square") {
    const double legs = std::min(0.1, 0.3 * h);
    feet(b, "tapered", -w + 0.07, w - 0.07, f + 0.07, k - 0.07, legs);
    b.slot("fabric");
    b.cushion({-w + 0.01, f + 0.01, legs}, {w - 0.01, k - 0.01, 0.62 * h}, {.radius = 0.025, .crown = 0.004});
    b.cushion({-w, f, 0.6 * h}, {w, k, h}, {.radius = 0.045, .crown = 0.03, .bulge = 0.006, .segments = 12});
    b.piping({-w + 0.002, f + 0.002, 0.6 * h}, {w - 0.002, k - 0.002, h}, 0.045, 2, 0.68);
    return;
  }
  b.slot("fabric");
  const double r = std::min(w, (k - f) / 2);
  b.within(Transform::scaling({w / r, (k - f) / (2 * r), 1}), [&] {
    if (style == "drum") {
      b.surface(
          [&](double u, double v) {
            const double a = 2 * kPi * u, t = kPi * (v - 0.5);
            const double lobe = 1 - 0.09 * (1 - std::pow(std::abs(std::sin(7 * a)), 0.5)) * std::cos(t);
            const double ring = v > 0 && v < 1 ? r * std::pow(std::cos(t), 0.45) * lobe : 0;
            return Vec3{ring * std::cos(a), ring * std::sin(a),
                        h / 2 + h / 2 * (t > 0 ? 1 : -1) * std::abs(std::sin(t)) -
                            0.02 * std::exp(-std::pow(ring / (0.15 * r), 2)) * (v > 0.5 ? 1 : 0)};
          },
          128, 24, 0, true);
      return;
    }
    b.lathe({},
            fillet(spline2({{0, 0},
                            {0.93 * r, 0},
                            {0.985 * r, 0.06 * h},
                            {r, 0.4 * h},
                            {r, 0.6 * h},
                            {0.985 * r, 0.84 * h},
                            {0.9 * r, 0.96 * h},
                            {0.5 * r, 0.995 * h},
                            {0, h}},
                           5),
                   0.0, 1, false),
            48);
    for (const double z : {0.07, 0.85}) b.torus({0, 0, z * h}, 0.985 * r, 0.005, 48, 8);
    b.ellipsoid({0, 0, h - 0.002}, {0.016, 0.016, 0.006}, 14);
  });
}

}  // namespace

void addSofas(Generators& to) {
  to["modernSofa"] = modernSofa;
  to["chesterfieldSofa"] = chesterfieldSofa;
  to["wingChair"] = wingChair;
  to["tubChair"] = tubChair;
  to["frameArmchair"] = frameArmchair;
  to["chaiseLongue"] = chaiseLongue;
  to["pouf"] = pouf;
}

}  // namespace idap::parametric
