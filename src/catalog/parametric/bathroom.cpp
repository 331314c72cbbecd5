// Sanitary ware: lofted and turned porcelain, chrome taps, glass screens.
#include <algorithm>
#include <cmath>

#include "catalog/parametric/casework.h"

namespace idap::parametric {

namespace {

// The plan of a pan: round in front, straight towards the back.
Polygon panOutline(double halfWidth, double y0, double y1) {
  Polygon outline;
  const double nose = std::min(halfWidth * 1.35, 0.75 * (y1 - y0));
  for (int i = 0; i <= 28; ++i) {
    const double a = kPi + kPi * i / 28;
    outline.push_back({halfWidth * std::cos(a), y0 + nose + nose * std::sin(a)});
  }
  for (int i = 1; i <= 6; ++i) outline.push_back({halfWidth, y0 + nose + (y1 - y0 - nose) * i / 6.0});
  for (int i = 0; i <= 6; ++i) outline.push_back({-halfWidth, y1 - (y1 - y0 - nose) * i / 6.0});
  outline.pop_back();
  return outline;
}

// Foot, belly, rim and bowl of a toilet or bidet. rimZ: upper side.
void pan(Builder& b, double half, double y0, double y1, double rimZ, bool wallHung) {
  b.slot("ceramic");
  const auto ring = [&](double z, double w, double front, double back) {
    return atHeight(panOutline(half * w, y0 + front, y1 - back), z);
  };
  const double l = y1 - y0;
  std::vector<Path> rings;
  if (wallHung) {
    const double z0 = 0;
    rings = {ring(z0, 0.5, 0.5 * l, 0), ring(z0, 0.6, 0.42 * l, 0),
             ring(z0 + 0.2 * (rimZ - z0), 0.8, 0.22 * l, 0), ring(z0 + 0.5 * (rimZ - z0), 0.93, 0.09 * l, 0)};
  } else {
    rings = {ring(0, 0.58, 0.24 * l, 0.03), ring(0.012, 0.6, 0.23 * l, 0.03),
             ring(0.3 * rimZ, 0.57, 0.24 * l, 0.03), ring(0.52 * rimZ, 0.68, 0.17 * l, 0.02),
             ring(0.76 * rimZ, 0.9, 0.055 * l, 0.005)};
  }
  for (const auto& [z, in] : {std::pair{0.93, 0.008}, {0.99, 0.0}, {1.0, 0.012}})
    rings.push_back(ring(z * rimZ, 1 - in / half, in, in * 0.5));
  for (const auto& [z, in, back] : {std::tuple{0.995, 0.04, 0.14},
                                    {0.93, 0.048, 0.15},
                                    {0.8, 0.058, 0.16},
                                    {0.62, 0.09, 0.18},
                                    {0.52, 0.13, 0.2}})
    rings.push_back(ring(z * rimZ, 1 - in / half, in, back));
  b.loft(rings, true, 0.9);
}

void toilet(Builder& b, const Parameters& p) {
  const bool wallHung = p.flag("wallHung");
  const double half = std::min(0.185, 0.48 * b.width()),
               rim = std::min(p.number("rim", 0.4), 0.6 * b.height());
  const double tankDepth = wallHung ? 0.0 : 0.17, y0 = b.front(), y1 = b.back() - (wallHung ? 0 : 0.02);
  pan(b, half, y0, y1, rim, wallHung);
  // Seat and lid over the pan; the lid stands closed.
  b.slot("seat");
  const double seatBack = y1 - tankDepth - 0.02;
  b.extrude(panOutline(half + 0.004, y0 + 0.002, seatBack), rim + 0.002, 0.018, 0.006);
  b.extrude(panOutline(half + 0.002, y0 + 0.004, seatBack + 0.005), rim + 0.022, 0.016, 0.007);
  b.slot("chrome");
  b.mirroredX([&] {
    b.rod({0.05, seatBack + 0.012, rim + 0.02}, {0.11, seatBack + 0.012, rim + 0.02}, 0.011);
  });
  if (wallHung) {
    b.slot("plate");
    b.box({-0.12, b.back() - 0.012, b.height() - 0.165}, {0.12, b.back(), b.height()}, 0.004);
    b.slot("chrome");
    b.box({-0.1, b.back() - 0.016, b.height() - 0.145}, {0.015, b.back() - 0.01, b.height() - 0.02}, 0.002);
    b.box({0.022, b.back() - 0.016, b.height() - 0.145}, {0.1, b.back() - 0.01, b.height() - 0.02}, 0.002);
    return;
  }
  b.slot("ceramic");
  const double w = b.width() / 2, z0 = rim - 0.01;
  const auto tank = [&](double in, double z) {
    return atHeight(
        roundedRectangle({-w + in, b.back() - tankDepth - 0.012 + in}, {w - in, b.back()}, 0.045, 6), z);
  };
  b.loft({tank(0.05, z0), tank(0.02, z0 + 0.03), tank(0.006, b.height() - 0.06),
          tank(0.006, b.height() - 0.045)},
         true, 0.7);
  b.loft({tank(0.002, b.height() - 0.047), tank(0, b.height() - 0.04), tank(0, b.height() - 0.02),
          tank(0.008, b.height() - 0.012)},
         true, 0.9);
  b.slot("chrome");
  b.cylinder({0, b.back() - tankDepth / 2, b.height() - 0.014}, 0.022, 0.014, 0.003);
}

void bidet(Builder& b, const Parameters&) {
  const double half = b.width() / 2, tapHeight = std::min(0.1, 0.25 * b.height());
  const double rim = b.height() - tapHeight;
  pan(b, half, b.front(), b.back(), rim, false);
  b.slot("chrome");
  b.cylinder({0, b.back() - 0.08, rim - 0.002}, 0.02, 0.6 * tapHeight, 0.004);
  b.tube(spline({{0, b.back() - 0.08, rim + 0.5 * tapHeight},
                 {0, b.back() - 0.13, rim + 0.55 * tapHeight},
                 {0, b.back() - 0.18, rim + 0.3 * tapHeight}}),
         0.01, 12);
  b.rod({0, b.back() - 0.075, rim + 0.5 * tapHeight}, {0, b.back() - 0.055, rim + tapHeight - 0.006}, 0.006);
}

// The bowl of a washbasin: a rounded block hollowed from above, with a ledge for the tap.
void washbowl(Builder& b, double z, double high, double ledge, double exponent) {
  const double w = b.width() / 2, d = b.depth() / 2, front = b.front();
  b.slot("ceramic");
  const auto outer = [&](double k, double drop) {
    return atHeight(superellipse({0, -d * 0 + (1 - k) * d * 0.55}, {w * k, d * k}, exponent + 1.5, 64),
                    z - drop);
  };
  const Vec2 c{0, front + d - ledge / 2};
  const auto inner = [&](double k, double drop) {
    return atHeight(superellipse(c, {(w - 0.022) * k, (d - 0.02 - ledge / 2) * k}, exponent, 64), z - drop);
  };
  std::vector<Path> rings{outer(0.34, high),       outer(0.45, high * 0.98), outer(0.72, high * 0.8),
                          outer(0.9, high * 0.52), outer(0.985, high * 0.2), outer(1, 0.012),
                          outer(0.997, 0.003),     outer(0.985, 0)};
  for (const auto& [k, f] : {std::pair{1.0, 0.0},
                             {0.985, 0.02},
                             {0.96, 0.12},
                             {0.9, 0.4},
                             {0.76, 0.68},
                             {0.5, 0.82},
                             {0.07, 0.86}})
    rings.push_back(inner(k, f * high));
  b.loft(rings, true, 1.0);
  b.slot("chrome");
  b.cylinder({c.x, c.y, z - 0.862 * high}, 0.024, 0.004, 0.0015);
}

void washbasin(Builder& b, const Parameters& p) {
  const double tapHeight = std::min(p.number("tapHeight", 0.17), 0.3 * b.height()),
               z = b.height() - tapHeight;
  const double high = std::min(0.19, 0.3 * z), exponent = p.number("squareness", 2.6);
  washbowl(b, z, high, 0.11, exponent);
  b.slot("chrome");
  tap(b, {0, b.back() - 0.055, z - 0.002}, tapHeight + 0.002, 0.14);
  if (p.flag("pedestal", true)) {
    b.slot("ceramic");
    const double y = 0.2 * b.depth();
    const auto ring = [&](double r, double at) {
      return atHeight(superellipse({0, y}, {r, r * 1.05}, 3, 40), at);
    };
    b.loft({ring(0.105, 0), ring(0.106, 0.015), ring(0.085, 0.12), ring(0.074, 0.4),
            ring(0.085, z - high - 0.06), ring(0.11, z - high - 0.01), ring(0.12, z - 0.9 * high)},
           true, 0.9);
  }
}

// A cabinet with a basin on it and a mirror above, as one piece.
void basinCabinet(Builder& b, const Parameters& p) {
  const double counter = p.number("counter", 0.85), t = 0.03;
  FrontStyle style;
  style.style = p.text("front", "flat");
  style.pull = pullNamed(p.text("handle", "edge"));
  const double face = b.front() + std::max(0.015, pullDepth(style.pull)), inner = face + 0.021;
  const double z0 = p.flag("wallHung", true) ? 0 : 0.08;  // hung: the box begins at its underside
  if (z0 > 0) feet(b, "plinth", {b.left(), inner, 0}, {b.right(), b.back(), 0}, z0);
  b.slot("wood");
  carcass(b, {b.left() + 0.005, inner, z0}, {b.right() - 0.005, b.back(), counter - t});
  const int columns = std::clamp(p.count("basins", b.width() > 1.15 ? 2 : 1), 1, 3);
  const double w = (b.width() - 0.01) / columns, mid = (z0 + counter - t) / 2;
  for (int i = 0; i < columns; ++i) {
    const double x = b.left() + 0.005 + w * i;
    drawer(b, {x, z0, x + w, mid}, face, style);
    drawer(b, {x, mid, x + w, counter - t - 0.002}, face, style);
  }
  b.slot("worktop");
  b.box({b.left(), b.front(), counter - t}, {b.right(), b.back(), counter}, 0.003, Grain::X);
  for (int i = 0; i < columns; ++i) {
    const double x = b.left() + 0.005 + w * (i + 0.5);
    const double half = std::min(0.23, 0.4 * w), deep = std::min(0.17, 0.34 * b.depth()), high = 0.13;
    const Vec2 c{x, b.front() + 0.05 + deep};
    b.slot("ceramic");
    const auto ring = [&](double grow, double k, double z) {
      return atHeight(superellipse(c, {half * k + grow, deep * k + grow}, 3, 56), counter + z);
    };
    std::vector<Path> rings{ring(0, 0.72, 0),           ring(0, 0.76, 0.004), ring(0, 0.9, 0.35 * high),
                            ring(0, 0.99, 0.94 * high), ring(0, 1, high),     ring(-0.008, 1, high)};
    for (const auto& [k, f] : {std::pair{0.98, 0.9}, {0.88, 0.4}, {0.7, 0.16}, {0.4, 0.1}, {0.06, 0.095}})
      rings.push_back(ring(-0.008, k, f * high));
    b.loft(rings, true, 0.9);
    b.slot("chrome");
    b.cylinder({c.x, c.y, counter + 0.094 * high}, 0.022, 0.004, 0.001);
    tap(b, {x, b.back() - 0.05, counter}, 0.28, 0.16);
  }
  // Mirror, a thin frame around it and a shelf of light behind its upper edge.
  const double m0 = counter + 0.3, m1 = b.height();
  if (m1 - m0 > 0.25) {
    const double y = b.back() - 0.03, edge = 0.008;
    const Pane pane{b.left() + 0.02, m0, b.right() - 0.02, m1};
    b.slot("frame");
    bars(b, pane, y, b.back(), edge);
    b.box({pane.x0 + edge - 0.001, y + 0.006, pane.z0 + edge - 0.001},
          {pane.x1 - edge + 0.001, b.back() - 0.001, pane.z1 - edge + 0.001}, 0);
    b.slot("mirror");
    sheet(b, pane.inset(edge - 0.001), y + 0.004);
  }
}

void bathtub(Builder& b, const Parameters& p) {
  const bool freestanding = p.flag("freestanding");
  const double tapHeight = freestanding ? 0 : std::min(0.1, 0.15 * b.height()), z = b.height() - tapHeight;
  const double w = b.width() / 2, d = b.depth() / 2, depth = std::min(0.44, 0.8 * z);
  b.slot("tub");
  if (freestanding) {
    // Higher at the ends, as a slipper bath.
    const auto outer = [&](double k, double f) {
      Path ring = atHeight(superellipse({}, {w * k, d * k}, 2.4, 72), 0);
      for (Vec3& q : ring) q.z = f * (z - 0.05 * (1 - std::pow(std::fabs(q.x / (w * k)), 2.0)) * f);
      return ring;
    };
    const auto inner = [&](double k, double f) {
      Path ring = atHeight(superellipse({}, {(w - 0.03) * k, (d - 0.03) * k}, 2.4, 72), 0);
      for (Vec3& q : ring)
        q.z = z - depth * f - 0.05 * (1 - f) * (1 - std::pow(std::fabs(q.x / ((w - 0.03) * k)), 2.0));
      return ring;
    };
    b.loft({outer(0.74, 0), outer(0.755, 0.01), outer(0.8, 0.3), outer(0.88, 0.7), outer(0.97, 0.94),
            outer(1, 0.985), outer(0.996, 0.997), outer(0.985, 1), inner(1.01, 0), inner(1.0, 0.005),
            inner(0.985, 0.04), inner(0.9, 0.4), inner(0.82, 0.8), inner(0.74, 0.95), inner(0.5, 1),
            inner(0.05, 1.0)},
           true, 0.9);
  } else {
    // A rim around a hollow, an apron below it.
    const double rim = std::min(0.07, 0.1 * b.depth());
    b.box({b.left() + 0.012, b.front() + 0.012, 0}, {b.right() - 0.012, b.back() - 0.012, z - 0.03}, 0.006);
    const auto ring = [&](double in, double drop, double r) {
      return atHeight(
          roundedRectangle({b.left() + in, b.front() + in}, {b.right() - in, b.back() - in}, r, 10),
          z - drop);
    };
    const auto hollow = [&](double k, double drop) {
      return atHeight(roundedRectangle({b.left() + rim + 0.06 * k, b.front() + rim + 0.045 * k},
                                       {b.right() - rim - 0.22 * k, b.back() - rim - 0.045 * k}, 0.13, 10),
                      z - drop);
    };
    b.loft({ring(0, 0.034, 0.03), ring(0, 0.006, 0.03), ring(0.003, 0.001, 0.03), ring(0.008, 0, 0.03),
            hollow(-0.06, 0), hollow(0, 0.004), hollow(0.1, 0.03), hollow(0.6, 0.6 * depth),
            hollow(1, 0.92 * depth), hollow(1.5, depth), hollow(2.2, depth + 0.004)},
           false, 0.9);
    // The floor of the hollow.
    const Path floor = hollow(2.2, depth + 0.004);
    Polygon outline;
    for (const Vec3 q : floor) outline.push_back({q.x, q.y});
    b.extrude(outline, z - depth - 0.008, 0.0045, 0);
    b.slot("chrome");
    b.at({b.left() + 0.35 * b.width(), b.back() - rim / 2 - 0.005, z}, [&] {
      b.mirroredX([&] {
        b.cylinder({0.075, 0, -0.001}, 0.018, 0.045, 0.003);
        b.cylinder({0.075, 0, 0.044}, 0.022, 0.02, 0.004);
      });
      b.rod({-0.075, 0, 0.03}, {0.075, 0, 0.03}, 0.015);
      b.tube(roundedPath(
                 {{0, 0, 0.03}, {0, 0, tapHeight - 0.012}, {0, -0.12, tapHeight - 0.012}, {0, -0.12, 0.05}},
                 0.03),
             0.012, 14);
    });
  }
  b.slot("chrome");
  b.cylinder({freestanding ? 0.0 : 0.3 * b.width(), 0, z - depth - 0.001}, 0.03, 0.004, 0.001);
}

// A tray, glass on the sides named, a rain shower on a riser.
void shower(Builder& b, const Parameters& p) {
  const double tray = 0.05, h = b.height(), post = 0.022;
  const bool walkIn = p.flag("walkIn");
  b.slot("tray");
  const auto ring = [&](double in, double z) {
    return atHeight(
        roundedRectangle({b.left() + in, b.front() + in}, {b.right() - in, b.back() - in}, 0.02, 4), z);
  };
  b.loft({ring(0, 0), ring(0, tray - 0.003), ring(0.003, tray), ring(0.05, tray), ring(0.06, tray - 0.012),
          ring(0.2, tray - 0.016), ring(0.44 * std::min(b.width(), b.depth()), tray - 0.018)},
         true, 0.6);
  b.slot("chrome");
  b.cylinder({0, 0, tray - 0.019}, 0.05, 0.004, 0.001);
  const double glassTop = std::min(h, 2.0), y = b.front() + 0.03, x = b.left() + 0.03;
  const auto pane = [&](double from, double to) {  // along x at y = 0, framed by slim rails
    b.slot("frame");
    b.box({from, -0.008, tray}, {to, 0.008, tray + 0.02}, 0.002);
    b.box({from, -0.008, glassTop - 0.02}, {to, 0.008, glassTop}, 0.002);
    b.slot("glass");
    sheet(b, {from + 0.002, tray + 0.019, to - 0.002, glassTop - 0.019}, 0);
  };
  b.slot("frame");
  const auto upright = [&](double px, double py) {
    b.box({px - post / 2, py - post / 2, tray}, {px + post / 2, py + post / 2, glassTop}, 0.002);
  };
  const double right = b.right() - 0.03;
  upright(x, y);
  upright(x, b.back() - 0.012);
  upright(right, y);
  b.at({0, y, 0}, [&] {
    const double split = walkIn ? 0.15 * b.width() : 0.0;
    pane(x, split);
    if (!walkIn) b.at({0, 0.022, 0}, [&] { pane(split - 0.03, right); });
  });
  b.within(Transform::translation({x, 0, 0}) * Transform::rotationZ(kPi / 2),
           [&] { pane(y, b.back() - 0.01); });
  if (p.flag("closedRight")) {
    upright(right, b.back() - 0.012);
    b.within(Transform::translation({right, 0, 0}) * Transform::rotationZ(kPi / 2),
             [&] { pane(y, b.back() - 0.01); });
  }
  b.slot("chrome");
  if (!walkIn) b.at({0.07, y + 0.02, 1.05}, [&] { b.barPull({}, 0.3, true, 0.008, 0.04); });
  // The riser stands on the back wall.
  const double sx = 0.15 * b.width(), sy = b.back() - 0.045, top = h - 0.012;
  b.tube(roundedPath({{sx, sy, 1.05}, {sx, sy, top}, {sx, sy - std::min(0.35, 0.4 * b.depth()), top}}, 0.06),
         0.011, 14);
  const double hy = sy - std::min(0.35, 0.4 * b.depth());
  b.rod({sx, hy, top}, {sx, hy, top - 0.05}, 0.009);
  b.cylinder({sx, hy, top - 0.062}, 0.12, 0.012, 0.003, 40);
  b.rod({sx - 0.13, sy, 1.05}, {sx + 0.13, sy, 1.05}, 0.02, 20);
  for (const double f : {-0.08, 0.08}) b.rod({sx + f, sy, 1.05}, {sx + f, b.back(), 1.05}, 0.016);
  b.rod({sx, sy, top - 0.4}, {sx, b.back(), top - 0.4}, 0.008);
}

void towelRail(Builder& b, const Parameters& p) {
  const int bars = std::clamp(p.count("bars", fitting(b.height(), 0.07)), 3, 40);
  const double r = 0.016, y = b.front() + 0.021, wall = b.back();
  b.slot("rail");
  b.mirroredX([&] { b.rod({b.right() - r, y, 0}, {b.right() - r, y, b.height()}, r, 16); });
  int inRow = 0;
  for (int i = 0; i < bars; ++i) {
    if (++inRow == 7) {  // a gap to hang a towel in
      inRow = 0;
      continue;
    }
    const double z = b.height() * (i + 0.6) / bars;
    b.rod({b.left() + r, y, z}, {b.right() - r, y, z}, 0.011, 12);
  }
  b.mirroredX([&] {
    for (const double f : {0.1, 0.9})
      b.rod({b.right() - 0.1, y, f * b.height()}, {b.right() - 0.1, wall, f * b.height()}, 0.01);
  });
  if (p.flag("towel", true)) {
    b.slot("towel");
    const double z = 0.78 * b.height(), w = 0.32 * b.width();
    b.surface(
        [&](double u, double v) {
          const double swing = 0.003 * std::sin(9 * u) * (v < 0.5 ? 1 - 2 * v : 2 * v - 1);
          const double s = (v - 0.5) * 2, drop = std::max(0.0, std::fabs(s) - 0.06) * 0.42 * b.height();
          const double bow = std::min(1.0, std::fabs(s) / 0.06);
          return Vec3{(2 * u - 1) * w, y + (s < 0 ? -1 : 1) * 0.017 * bow - 0.0 + swing,
                      z + 0.018 * (1 - bow * bow) - drop};
        },
        14, 60, 0.006);
  }
}

}  // namespace

void addBathroom(Generators& to) {
  to["toilet"] = toilet;
  to["bidet"] = bidet;
  to["washbasin"] = washbasin;
  to["basinCabinet"] = basinCabinet;
  to["bathtub"] = bathtub;
  to["shower"] = shower;
  to["towelRail"] = towelRail;
}

}  // namespace idap::parametric
