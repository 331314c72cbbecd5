// Chairs and stools of wood and steel.
#include <algorithm>
#include <cmath>

#include "catalog/parametric/registry.h"
#include "catalog/parametric/seating.h"

namespace idap::parametric {
namespace {

// A point at a fraction of the way from a to b.
Vec3 between(Vec3 a, Vec3 b, double t) { return a + (b - a) * t; }

double seatHeightOf(const Builder& b, const Parameters& p, double fallback = 0.45) {
  return std::min(p.number("seatHeight", fallback), 0.62 * b.height());
}

// Saddle seat, splayed turned legs with an H of stretchers, and a hoop of bent wood with spindles; style
// "comb": a curved rail on straight spindles instead of the hoop.
void windsorChair(Builder& b, const Parameters& p) {
  b.slot("wood");
  const double seat = seatHeightOf(b, p), thick = 0.04;
  const double rake = std::min(0.1, 0.2 * b.depth());  // how far the back leans out behind the seat
  const double seatBack = b.back() - rake, w = b.width() / 2;
  const double depth = seatBack - b.front();
  const Polygon outline = spline2({{-0.98 * w, b.front() + 0.35 * depth},
                                   {-0.9 * w, b.front() + 0.03 * depth},
                                   {-0.45 * w, b.front() - 0.0 * depth},
                                   {0, b.front() + 0.01 * depth},
                                   {0.45 * w, b.front()},
                                   {0.9 * w, b.front() + 0.03 * depth},
                                   {0.98 * w, b.front() + 0.35 * depth},
                                   {0.88 * w, b.front() + 0.8 * depth},
                                   {0.5 * w, seatBack},
                                   {0, seatBack + 0.012},
                                   {-0.5 * w, seatBack},
                                   {-0.88 * w, b.front() + 0.8 * depth}},
                                  4, true);
  dishedSeat(b, outline, seat, thick, 0.014);

  const LegShape shape = p.text("legs", "turned") == "turned" ? LegShape::Turned : LegShape::Round;
  const Vec3 frontTop{0.58 * w, b.front() + 0.22 * depth, seat - 0.5 * thick},
      frontFoot{0.94 * w, b.front() + 0.02, 0};
  const Vec3 backTop{0.48 * w, b.front() + 0.8 * depth, seat - 0.5 * thick},
      backFoot{0.82 * w, b.back() - 0.03, 0};
  b.mirroredX([&] {
    b.leg(frontTop, frontFoot, 0.018, 0.02, shape);
    b.leg(backTop, backFoot, 0.018, 0.02, shape);
    const Vec3 a = between(frontFoot, frontTop, 0.42), c = between(backFoot, backTop, 0.42);
    b.tube({a, between(a, c, 0.5), c}, [](double t) { return 0.008 + 0.006 * std::sin(kPi * t); });
  });
  const Vec3 mid = between(between(frontFoot, frontTop, 0.42), between(backFoot, backTop, 0.42), 0.5);
  b.tube({{-mid.x, mid.y, mid.z}, {0, mid.y, mid.z}, mid},
         [](double t) { return 0.008 + 0.006 * std::sin(kPi * t); });

  const int spindles = std::max(3, p.count("spindles", 7));
  const double top = b.height();
  const double foot = seatBack - 0.025;
  const auto yAt = [&](double z) {
    return foot + (b.back() - 0.011 - foot) * std::pow((z - seat) / (top - seat), 1.15);
  };
  if (p.text("style", "bow") == "bow") {
    // The hoop is an arch in the leaning plane.
    Path hoop;
    for (const Vec2 q : {Vec2{-0.8, 0},
                         {-0.87, 0.3},
                         {-0.8, 0.66},
                         {-0.48, 0.94},
                         {0, 1.0},
                         {0.48, 0.94},
                         {0.8, 0.66},
                         {0.87, 0.3},
                         {0.8, 0}}) {
      const double z = seat - 0.012 + (top - 0.011 - seat + 0.012) * q.y;
      hoop.push_back({q.x * w * 0.92, yAt(std::max(z, seat)) - 0.03 * q.x * q.x, z});
    }
    hoop = spline(hoop, 5);
    b.tube(hoop, 0.011, 10, Cap::Flat);
    for (int i = 0; i < spindles; ++i) {
      const double s = spindles == 1 ? 0 : 2.0 * i / (spindles - 1) - 1;
      // Where the fanned spindle meets the hoop.
      const double x1 = 0.66 * w * s;
      Vec3 best = hoop[hoop.size() / 2];
      for (std::size_t k = hoop.size() / 6; k < hoop.size() - hoop.size() / 6; ++k)
        for (int m = 0; m < 4; ++m) {
          const Vec3 q = between(hoop[k], hoop[k + 1], m / 4.0);
          if (q.z > seat + 0.4 * (top - seat) && std::abs(q.x - x1) < std::abs(best.x - x1)) best = q;
        }
      const Vec3 low{0.5 * w * s, seatBack - 0.03 - 0.05 * s * s * depth * 0.5, seat - 0.015};
      b.tube(
          {low, between(low, best, 0.3), best},
          [](double t) { return 0.0055 + 0.003 * std::exp(-std::pow((t - 0.3) / 0.22, 2)); }, 8, Cap::None);
    }
  } else {
    // A curved comb on top of the spindles.
    const double z = top - 0.035;
    Path rail;
    for (int i = -6; i <= 6; ++i)
      rail.push_back({0.92 * w * i / 6.0, b.back() - 0.011 - 0.035 * i * i / 36.0, z});
    b.sweep(rail, [](double t) {
      const double h = 0.035 - 0.012 * std::pow(std::abs(2 * t - 1), 3);
      return roundedRectangle({-0.011, -h}, {0.011, h}, 0.008, 3);
    });
    for (int i = 0; i < spindles; ++i) {
      const double s = spindles == 1 ? 0 : 2.0 * i / (spindles - 1) - 1;
      const bool outer = i == 0 || i + 1 == spindles;
      const Vec3 low{0.66 * w * s, seatBack - 0.03 - 0.03 * s * s, seat - 0.015},
          high{0.8 * w * s, b.back() - 0.011 - 0.035 * 0.75 * s * s, z - 0.02};
      b.tube(
          {low, between(low, high, 0.3), high},
          [outer](double t) {
            return (outer ? 0.009 : 0.0055) + 0.004 * std::exp(-std::pow((t - 0.35) / 0.25, 2));
          },
          8, Cap::None);
    }
  }
}

// Ladder-back with a woven seat, as the Shakers made them.
void ladderBackChair(Builder& b, const Parameters& p) {
  b.slot("wood");
  const double r = 0.017, seat = seatHeightOf(b, p);
  const double wf = b.width() / 2 - r, wb = 0.86 * b.width() / 2 - r;
  const double rake = 0.06;
  const Vec3 frontFoot{wf, b.front() + r, 0}, frontTop{wf, b.front() + r, seat + 0.035};
  const double yb = b.back() - rake - r;
  const auto post = [&](double z) {  // straight up to the seat, leaning back above it
    const double t = std::max(0.0, (z - seat) / (b.height() - seat));
    return Vec3{wb, yb + rake * (0.35 * t + 0.65 * t * t), z};
  };
  const double head = b.height() - 0.045;
  b.mirroredX([&] {
    b.tube(
        {frontFoot, {wf, b.front() + r, 0.12}, {wf, b.front() + r, seat}, frontTop},
        [r](double t) { return t < 0.25 ? 0.6 * r + 1.6 * r * t : r; }, 14);
    Path path;
    for (int i = 0; i <= 12; ++i) path.push_back(post(head * i / 12.0));
    b.tube(
        path, [r](double t) { return t < 0.15 ? r * (0.65 + 2.3 * t) : r * (1.07 - 0.07 * t); }, 14);
    const Vec3 end = post(head);
    b.lathe(end + Vec3{0, 0, -0.004},
            spline2({{0, 0},
                     {0.6 * r, 0},
                     {0.5 * r, 0.008},
                     {0.78 * r, 0.018},
                     {0.8 * r, 0.03},
                     {0.42 * r, 0.045},
                     {0, 0.049}},
                    3),
            14);
    for (const double h : {0.13, 0.27})
      b.rod({wf, b.front() + r, seat * h / 0.45}, post(seat * h / 0.45), 0.0095, 10, Cap::None);
    b.rod({wf, b.front() + r, seat - 0.012}, post(seat - 0.012), 0.012, 10, Cap::None);
  });
  for (const double h : {0.17, 0.31})
    b.rod({-wf, b.front() + r, seat * h / 0.45}, {wf, b.front() + r, seat * h / 0.45}, 0.0095, 10, Cap::None);
  b.rod({-wb, yb, seat * 0.2 / 0.45}, {wb, yb, seat * 0.2 / 0.45}, 0.0095, 10, Cap::None);
  const int slats = p.count("slats", fitting(head - seat, 0.125, 6));
  for (int i = 0; i < slats; ++i) {
    const double z =
        seat + 0.09 + (head - seat - 0.13) * (slats == 1 ? 1.0 : static_cast<double>(i) / (slats - 1));
    const double half = 0.026 + 0.006 * i / std::max(1, slats - 1);
    Path path;
    for (int k = -6; k <= 6; ++k) path.push_back({wb * k / 6.0, post(z).y + 0.022 * (1 - k * k / 36.0), z});
    b.sweep(path, [half](double t) {
      // The upper edge is arched.
      const double up = half * (0.55 + 0.45 * std::sin(kPi * t));
      return Polygon{{-0.004, -0.6 * half}, {0.004, -0.6 * half}, {0.004, up}, {-0.004, up}};
    });
  }
  b.slot("seat");
  const double y0 = b.front() + 0.4 * r, y1 = yb + 0.4 * r;
  std::vector<Path> rings;
  for (const Vec3 s : {Vec3{0.9, 0.03, 0},
                       {1, 0.024, 0},
                       {1, 0.006, 0},
                       {0.97, 0, 0},
                       {0.8, 0.003, 0},
                       {0.4, 0.011, 0},
                       {0.03, 0.013, 0}}) {
    const Polygon plan = fillet({{-wf * s.x, y0 + (1 - s.x) * 0.2},
                                 {wf * s.x, y0 + (1 - s.x) * 0.2},
                                 {wb * s.x, y1 - (1 - s.x) * 0.2},
                                 {-wb * s.x, y1 - (1 - s.x) * 0.2}},
                                0.02 * s.x, 4);
    rings.push_back(atHeight(plan, seat + 0.006 - s.y));
  }
  b.loft(rings, true, 1.0);
}

// A moulded shell; legs "wood" (tapered dowels with struts), "sled" (bent wire) or "pedestal".
void shellChair(Builder& b, const Parameters& p) {
  b.slot("shell");
  const double seat = seatHeightOf(b, p, 0.46), h = b.height(), w = b.width(), d = b.depth();
  const double f = b.front(), k = b.back();
  const bool arms = p.flag("arms");
  const std::vector<Vec2> side = spline2({{f + 0.012, seat - 0.03},
                                          {f + 0.05, seat - 0.002},
                                          {f + 0.25 * d, seat - 0.012},
                                          {f + 0.52 * d, seat - 0.03},
                                          {f + 0.72 * d, seat - 0.005},
                                          {f + 0.82 * d, seat + 0.1},
                                          {k - 0.09 * d, seat + 0.6 * (h - seat)},
                                          {k - 0.006, h}},
                                         5);
  const Path profile = atDepth(side, 0);
  b.surface(
      [&](double u, double v) {
        const Vec3 q = along(profile, v);  // x holds y
        const double s = 2 * u - 1, edge = std::abs(2 * v - 1);
        double half = 0.5 * w *
                      (1.0 - 0.14 * std::exp(-std::pow((v - 0.56) / 0.16, 2)) -
                       (v > 0.62 ? 0.16 * (v - 0.62) / 0.38 : 0));
        if (arms) half = 0.5 * w * (1 - 0.12 * std::pow(edge, 4));
        half *= 1 - 0.24 * std::pow(edge, 8);
        const double rise = 0.035 * (1 - v) + (arms ? 0.16 * std::exp(-std::pow((v - 0.48) / 0.26, 2))
                                                    : 0.035 * std::exp(-std::pow((v - 0.5) / 0.2, 2)));
        const double wrap = (arms ? 0.05 : 0.08) * std::clamp((v - 0.45) / 0.35, 0.0, 1.0);
        const double c = std::pow(std::abs(s), 2.4);
        return Vec3{s * half, q.x - wrap * c, q.z + rise * c - 0.05 * c * std::pow(v, 8)};
      },
      20, 32, 0.007);
  const double under = seat - 0.045;
  const std::string legs = p.text("legs", "wood");
  if (legs == "pedestal") {
    b.slot("legs");
    b.lathe({},
            spline2({{0, 0},
                     {0.24, 0},
                     {0.245, 0.008},
                     {0.2, 0.016},
                     {0.08, 0.035},
                     {0.032, 0.1},
                     {0.024, 0.25},
                     {0.03, under - 0.06},
                     {0.1, under + 0.004},
                     {0, under + 0.005}},
                    4),
            36);
    return;
  }
  if (legs == "sled") {
    b.slot("legs");
    b.mirroredX([&] {
      const double x = 0.42 * w;
      b.tube(roundedPath({{0.3 * w, f + 0.22 * d, under + 0.01},
                          {x, f + 0.1 * d, 0.007},
                          {x, k - 0.06 * d, 0.007},
                          {0.3 * w, f + 0.66 * d, under + 0.004}},
                         0.035),
             0.007, 10, Cap::Flat);
    });
    for (const double t : {0.22, 0.66})
      b.rod({-0.3 * w, f + t * d, under + 0.006}, {0.3 * w, f + t * d, under + 0.006}, 0.006);
    return;
  }
  const Vec3 ft{0.5 * 0.62 * w, f + 0.2 * d, under + 0.01}, ff{0.5 * 0.9 * w, f + 0.03, 0},
      bt{0.5 * 0.55 * w, f + 0.62 * d, under - 0.004}, bf{0.5 * 0.86 * w, f + 0.9 * d, 0};
  b.slot("legs");
  b.mirroredX([&] {
    b.leg(ft, ff, 0.016, 0.0095);
    b.leg(bt, bf, 0.016, 0.0095);
  });
  b.slot("metal");
  b.mirroredX([&] {
    const Vec3 a = between(ff, ft, 0.55), c = between(bf, bt, 0.55), up{0.1 * w, f + 0.42 * d, under - 0.005};
    b.rod(a, up, 0.0035, 8), b.rod(c, up, 0.0035, 8);
    b.rod(a, {-bt.x * 0.8, between(bf, bt, 0.85).y, under * 0.86}, 0.0035, 8);
    b.rod(ft + Vec3{0, 0, -0.012}, bt + Vec3{0, 0, -0.002}, 0.007, 8);
  });
  b.rod({-ft.x, ft.y, ft.z - 0.012}, {ft.x, ft.y, ft.z - 0.012}, 0.007, 8);
  b.rod({-bt.x, bt.y, bt.z - 0.002}, {bt.x, bt.y, bt.z - 0.002}, 0.007, 8);
}

// Upholstered seat and back on square tapered legs; buttons: a tufted back.
void diningChair(Builder& b, const Parameters& p) {
  const double seat = seatHeightOf(b, p, 0.48), pad = 0.09;
  const double w = b.width() / 2, rake = 0.12;
  b.slot("legs");
  const double r = 0.02;
  b.mirroredX([&] {
    b.leg({w - 0.045, b.front() + 0.055, seat - pad}, {w - 0.03, b.front() + 0.03, 0}, r, 0.012,
          LegShape::Square);
    b.leg({w - 0.05, b.back() - 0.16, seat - pad}, {w - 0.04, b.back() - 0.03, 0}, r, 0.012,
          LegShape::Square);
    b.box({w - 0.075, b.front() + 0.06, seat - pad - 0.04}, {w - 0.05, b.back() - 0.15, seat - pad + 0.015});
  });
  b.box({-w + 0.05, b.front() + 0.05, seat - pad - 0.04}, {w - 0.05, b.front() + 0.072, seat - pad + 0.015});
  b.slot("fabric");
  b.cushion({-w, b.front(), seat - pad}, {w, b.back() - 0.1, seat + 0.012},
            {.radius = 0.035, .crown = 0.022, .bulge = 0.004});
  b.piping({-w + 0.002, b.front() + 0.002, seat - pad}, {w - 0.002, b.back() - 0.102, seat + 0.01}, 0.035, 2,
           0.62);
  const double angle = rake, tall = (b.height() - seat + 0.06) / std::cos(angle);
  const double thick = 0.075, y = b.back() - thick - std::sin(angle) * tall + 0.012;
  Soft soft{.radius = 0.034, .crown = 0.016};
  if (p.flag("buttons"))
    soft.tuftColumns = std::max(2, fitting(2 * w, 0.15)), soft.tuftRows = 3, soft.tuftDepth = 0.02;
  leaningCushion(b, {-w + 0.006, y, seat - 0.06}, {w - 0.006, y + thick, seat - 0.06 + tall}, angle, soft,
                 !p.flag("buttons"));
}

// One bent steel tube that springs: no back legs.
void cantileverChair(Builder& b, const Parameters& p) {
  const double seat = seatHeightOf(b, p, 0.46), r = 0.0125;
  const double x = b.width() / 2 - r, f = b.front() + r, k = b.back() - r;
  b.slot("metal");
  const double z = seat - 0.02, rake = 0.09, back = k - rake;
  Path half{{x, k, b.height() - r}, {x, back, z}, {x, f, z}, {x, f + 0.03, r}, {x, k - 0.03, r}};
  Path whole = half;
  for (std::size_t i = half.size(); i-- > 0;) whole.push_back({-half[i].x, half[i].y, half[i].z});
  b.tube(roundedPath(whole, 0.075, 8), r, 14);
  const auto frame = [&](bool upright) {
    // A bent wooden frame around cane, drawn flat in x and v.
    const double lo = upright ? seat + 0.38 * (b.height() - seat) : f + 0.03,
                 hi = upright ? b.height() - 0.005 : back - 0.03;
    const auto place = [&](double u, double v) {
      const double s = std::abs(u) / x;
      if (!upright) return Vec3{u, v, z + 0.022 - 0.012 * (1 - s * s)};
      const double t = (v - z) / (b.height() - r - z);
      return Vec3{u, back + (k - back) * t - 0.018 + 0.028 * (1 - s * s), v};
    };
    const double e = x - 0.012;
    b.slot(p.text("panelFrame", "wood"));
    Path ring;
    for (const Vec2 q : roundedRectangle({-e, lo + 0.018}, {e, hi - 0.018}, 0.05, 6)) {
      ring.push_back(place(q.x, q.y));
    }
    // More points along the straight sides, so that the frame follows the curve.
    Path fine;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec3 a = ring[i], c = ring[(i + 1) % ring.size()];
      const int n = length(c - a) > 0.1 ? 6 : 1;
      for (int j = 0; j < n; ++j) {
        const Vec3 q = between(a, c, static_cast<double>(j) / n);
        fine.push_back(upright ? place(q.x, q.z) : place(q.x, q.y));
      }
    }
    b.tube(fine, 0.014, 10, Cap::None, true);
    b.slot("seat");
    b.surface(
        [&](double u, double v) {
          const double s = upright ? 1 - 2 * u : 2 * u - 1;
          return place(s * (e - 0.004), lo + 0.02 + (hi - lo - 0.04) * v) +
                 (upright ? Vec3{0, -0.003, 0} : Vec3{0, 0, 0.003});
        },
        12, 8, 0.005);
  };
  frame(false);
  frame(true);
}

// Five-star base on castors, gas lift, seat, and a back of mesh in a frame or an upholstered one.
void officeChair(Builder& b, const Parameters& p) {
  const double seat = std::clamp(p.number("seatHeight", 0.5), 0.4, 0.55 * b.height());
  const double reach = std::min(b.width(), b.depth()) / 2 - 0.03, wheel = 0.028;
  b.slot("frame");
  for (int i = 0; i < 5; ++i) {
    const double a = kPi / 2 + 2 * kPi * i / 5;
    b.within(Transform::rotationZ(a), [&] {
      Path arm{{0.02, 0, 0.115}, {0.5 * reach, 0, 0.1}, {reach, 0, 0.068}};
      b.sweep(arm, [](double t) {
        return fillet(
            rectangle({-0.026 + 0.01 * t, -0.017 + 0.006 * t}, {0.026 - 0.01 * t, 0.013 - 0.003 * t}), 0.008,
            3);
      });
      b.slot("castors");
      b.castor({reach - 0.006, 0, 0}, wheel);
      b.slot("frame");
    });
  }
  b.cylinder({0, 0, 0.08}, 0.042, 0.06, 0.008);
  b.cylinder({0, 0, 0.13}, 0.027, 0.5 * (seat - 0.2), 0.003);
  b.slot("metal");
  b.cylinder({0, 0, 0.12}, 0.015, seat - 0.2, 0.002);
  b.slot("frame");
  b.roundedBox({-0.09, -0.12, seat - 0.1}, {0.09, 0.13, seat - 0.06}, 0.012);
  b.rod({0.08, 0.02, seat - 0.085}, {0.24, 0.0, seat - 0.09}, 0.005);
  const double w = std::min(0.52, b.width() - 0.13) / 2, f = b.front() + 0.02, k = b.back() - 0.13;
  b.slot("seat");
  b.cushion({-w, f, seat - 0.065}, {w, k, seat + 0.02},
            {.radius = 0.04, .crown = 0.02, .bulge = 0.004, .segments = 12});
  // The back: a frame bent around the body, carried by an arm from under the seat.
  const double lo = seat + 0.12, hi = b.height() - 0.012, yb = b.back() - 0.075;
  const auto curve = [&](double s, double t) {  // s -1..1 across, t 0..1 up
    const double y = yb + 0.05 * std::sin(kPi * std::min(1.0, 1.15 * t)) * -0.55 + 0.06 * t - 0.055 * s * s;
    return Vec3{s * w * (0.97 - 0.1 * t * t), y, lo + (hi - lo) * t};
  };
  b.slot("frame");
  b.sweep(spline({{0, 0.08, seat - 0.08},
                  {0, k + 0.02, seat - 0.075},
                  {0, b.back() - 0.03, seat + 0.03},
                  {0, yb + 0.03, lo + 0.12},
                  {0, yb + 0.02, lo + 0.3}},
                 5),
          roundedRectangle({-0.035, -0.009}, {0.035, 0.009}, 0.006, 3), {0, -0.3, 1});
  const bool mesh = p.text("back", "mesh") == "mesh";
  if (mesh) {
    Path ring;
    for (const Vec2 q : roundedRectangle({-1, 0}, {1, 1}, 0.22, 6)) {
      const std::size_t before = ring.size();
      if (before > 0) {
        // Follow the curve between the corners.
        const Vec3 last = ring.back(), next = curve(q.x, q.y);
        if (length(next - last) > 0.1)
          for (int i = 1; i < 6; ++i) {
            const Vec3 m = between(last, next, i / 6.0);
            const double t = (m.z - lo) / (hi - lo);
            ring.push_back(curve(m.x / (w * (0.97 - 0.1 * t * t)), t));
          }
      }
      ring.push_back(curve(q.x, q.y));
    }
    b.tube(ring, 0.011, 10, Cap::None, true);
    b.sweep({curve(-0.98, 0.3), curve(-0.5, 0.3) + Vec3{0, 0.02, 0}, curve(0, 0.3) + Vec3{0, 0.025, 0},
             curve(0.5, 0.3) + Vec3{0, 0.02, 0}, curve(0.98, 0.3)},
            roundedRectangle({-0.005, -0.02}, {0.005, 0.02}, 0.003, 2));
  }
  b.slot("back");
  const auto outline = [&](double u, double v) {
    return curve((1 - 2 * u) * (0.985 - 0.12 * std::pow(std::abs(2 * v - 1), 10)), 0.01 + 0.98 * v);
  };
  b.surface(outline, 14, 16, mesh ? 0.003 : 0.05);
  if (p.flag("arms", true)) {
    b.mirroredX([&] {
      const double x = b.width() / 2 - 0.045;
      b.slot("frame");
      b.sweep(
          roundedPath({{w - 0.12, -0.02, seat - 0.075}, {x, 0, seat - 0.07}, {x, 0.01, seat + 0.2}}, 0.05),
          roundedRectangle({-0.02, -0.008}, {0.02, 0.008}, 0.005, 3), {0.2, 0.9, 0.1});
      b.slot("armrests");
      b.cushion({x - 0.045, -0.15, seat + 0.19}, {x + 0.045, 0.13, seat + 0.225},
                {.radius = 0.016, .crown = 0.004});
    });
  }
}

// Four splayed legs, a foot ring, a round or saddle seat; with a low back where asked.
void barStool(Builder& b, const Parameters& p) {
  const bool back = p.flag("back");
  const double seat = back ? 0.76 * b.height() : b.height(), r = 0.36 * std::min(b.width(), b.depth());
  const bool padded = p.flag("padded", true);
  const double under = seat - (padded ? 0.075 : 0.035);
  b.slot("legs");
  const double wx = b.width() / 2 - 0.014, wy = b.depth() / 2 - 0.014;
  const auto at = [&](double t, double sx, double sy) {
    return Vec3{sx * (0.5 * r * t + wx * (1 - t)), sy * (0.5 * r * t + wy * (1 - t)), under * t};
  };
  const LegShape shape = p.text("legs", "round") == "square" ? LegShape::Square : LegShape::Round;
  b.mirroredXY([&] { b.leg(at(1, 1, 1), at(0, 1, 1), 0.018, 0.012, shape); });
  b.slot("metal");
  const double t = std::clamp(0.3 / under, 0.1, 0.6);
  Path ring{at(t, 1, 1), at(t, -1, 1), at(t, -1, -1), at(t, 1, -1)};
  b.tube(roundedPath(ring, 0.05, 6, true), 0.008, 10, Cap::None, true);
  b.slot("legs");
  b.cylinder({0, 0, under - 0.012}, 0.75 * r, 0.02, 0.004);
  b.slot("seat");
  if (padded) {
    b.lathe({0, 0, under},
            spline2({{0, 0},
                     {0.9 * r, 0},
                     {0.985 * r, 0.012},
                     {r, 0.035},
                     {0.96 * r, 0.06},
                     {0.8 * r, 0.072},
                     {0.4 * r, 0.075},
                     {0, 0.075}},
                    4),
            40);
    b.torus({0, 0, under + 0.012}, 0.985 * r, 0.004, 40, 8);
  } else {
    dishedSeat(b, ellipse({}, {r, r}, 40), seat, 0.035, 0.012);
  }
  if (back) {
    const double y = 0.86 * r;
    b.slot("legs");
    b.mirroredX([&] {
      b.tube(spline({{0.55 * r, y * 0.8, under + 0.01},
                     {0.7 * r, y + 0.03, seat + 0.08},
                     {0.72 * r, y + 0.06, b.height() - 0.05}},
                    5),
             0.009, 10);
    });
    b.slot("seat");
    b.surface(
        [&](double u, double v) {
          const double a = kPi * (0.5 + 0.36 * (1 - 2 * u)), s = 1.05 * r;
          return Vec3{-s * std::cos(kPi - a) * 1.02, y - s + s * std::sin(a) * 1.07 + 0.05 + 0.01 * v,
                      b.height() - 0.13 + 0.13 * v - 0.02 * std::pow(std::abs(2 * u - 1), 3) * v};
        },
        18, 6, 0.018);
  }
}

// Round top on three or four bent legs.
void stool(Builder& b, const Parameters& p) {
  const double r = std::min(b.width(), b.depth()) / 2, thick = 0.036, h = b.height();
  const int legs = p.count("legs", 3);
  b.slot("seat");
  b.within(Transform::scaling({b.width() / (2 * r), b.depth() / (2 * r), 1}), [&] {
    b.cylinder({0, 0, h - thick}, r, thick, 0.006, 48);
  });
  b.slot("legs");
  for (int i = 0; i < legs; ++i) {
    b.within(Transform::rotationZ(kPi / 2 + 2 * kPi * (i + 0.5) / legs), [&] {
      // Bent from the upright into the level under the seat.
      const double z = h - thick - 0.011;
      b.sweep(roundedPath({{0.86 * r, 0, 0}, {0.86 * r, 0, z}, {0.3 * r, 0, z}}, 0.075, 8),
              [](double t) {
                return roundedRectangle({-0.024, -0.011 - 0.003 * t}, {0.024, 0.011}, 0.003, 2);
              },
              {1, 0, 0.3});
    });
  }
}

}  // namespace

void addChairs(Generators& to) {
  to["windsorChair"] = windsorChair;
  to["ladderBackChair"] = ladderBackChair;
  to["shellChair"] = shellChair;
  to["diningChair"] = diningChair;
  to["cantileverChair"] = cantileverChair;
  to["officeChair"] = officeChair;
  to["barStool"] = barStool;
  to["stool"] = stool;
}

}  // namespace idap::parametric
