// Lamps. Every bulb marks where its light comes from; shades are thin shells, open where the real ones are.
#include <algorithm>
#include <cmath>

#include "catalog/parametric/registry.h"

namespace idap::parametric {
namespace {

// A ceiling rose at the top of the box and a cord down to z.
void cordFromCeiling(Builder& b, double x, double y, double z, double rose = 0.055) {
  const double h = b.height();
  b.lathe({x, y, h - 0.028},
          fillet({{0, 0}, {0.5 * rose, 0}, {rose, 0.02}, {rose, 0.028}, {0, 0.028}}, 0.006, 3, false), 28);
  b.rod({x, y, z}, {x, y, h - 0.02}, 0.0028, 8);
}

// How wide a lamp's round parts can be.
double spread(const Builder& b) { return std::min(b.width(), b.depth()) / 2; }

// One shade on a cord; style: "globe" (opal glass), "cone" (spun metal), "dome", "drum" (fabric), "lantern"
// (paper).
void pendantLamp(Builder& b, const Parameters& p) {
  const std::string style = p.text("style", "cone");
  const double r = spread(b);
  const double tall = std::min(style == "globe" || style == "lantern" ? 2 * r
                               : style == "drum"                      ? 1.1 * r
                               : style == "dome"                      ? 1.0 * r
                                                                      : 1.15 * r,
                               0.7 * b.height());
  b.within(Transform::scaling({b.width() / (2 * r), b.depth() / (2 * r), 1}), [&] {
    if (style == "globe" || style == "lantern") {
      const double ry = tall / 2, open = style == "globe" ? 0.16 : 0.3;
      b.slot("shade");
      // A ball with a neck left open at the top (a lantern: at both ends).
      std::vector<Vec2> out, in;
      const double t = 0.003, from = style == "lantern" ? -kPi / 2 + open : -kPi / 2, to = kPi / 2 - open;
      const int rings = style == "lantern" ? 60 : 20;
      for (int i = 0; i <= rings; ++i) {
        const double a = from + (to - from) * i / rings;
        const double rib = style == "lantern" ? 1 - 0.012 * std::abs(std::sin(kPi * i / 4.0)) : 1;
        out.push_back({i == 0 && style == "globe" ? 0.0 : r * rib * std::cos(a), ry + ry * std::sin(a)});
        in.push_back(
            {i == 0 && style == "globe" ? 0.0 : (r - t) * rib * std::cos(a), ry + (ry - t) * std::sin(a)});
      }
      std::reverse(in.begin(), in.end());
      out.insert(out.end(), in.begin(), in.end());
      if (style == "lantern") out.push_back(out.front());
      b.lathe({}, out, 40);
      b.slot("fitting");
      const double neck = r * std::sin(open) + 0.004, z = ry + ry * std::cos(open);
      b.lathe({0, 0, z - 0.012},
              fillet({{0, 0}, {neck, 0}, {neck, 0.03}, {0.3 * neck, 0.055}, {0, 0.058}}, 0.004, 3, false),
              28);
      cordFromCeiling(b, 0, 0, z + 0.04);
      b.cylinder({0, 0, ry + 0.045}, 0.016, z - 0.012 - ry - 0.045 + 0.002, 0.002, 16);
      b.light({0, 0, ry});
      return;
    }
    if (style == "drum") {
      b.slot("shade");
      b.shade({}, r, r, tall, 0.0015, 56);
      b.slot("fitting");
      for (const double z : {0.002, tall - 0.002}) b.torus({0, 0, z}, r - 0.003, 0.002, 56, 6);
      for (int i = 0; i < 3; ++i) {
        const double a = 2 * kPi * i / 3;
        b.rod({0, 0, tall - 0.03}, {(r - 0.003) * std::cos(a), (r - 0.003) * std::sin(a), tall - 0.004},
              0.0018, 6);
      }
      cordFromCeiling(b, 0, 0, tall - 0.032);
      b.bulb({0, 0, 0.45 * tall}, 0.03, false);
      b.cylinder({0, 0, 0.45 * tall + 0.07}, 0.008, tall - 0.03 - 0.45 * tall - 0.07, 0.001, 12);
      return;
    }
    // Spun metal: outside and a light inside are two slots.
    std::vector<Vec2> outside = style == "dome" ? spline2({{r, 0},
                                                           {0.99 * r, 0.12 * tall},
                                                           {0.9 * r, 0.42 * tall},
                                                           {0.68 * r, 0.7 * tall},
                                                           {0.34 * r, 0.92 * tall},
                                                           {0.1 * r, tall}},
                                                          5)
                                                : spline2({{r, 0},
                                                           {0.93 * r, 0.07 * tall},
                                                           {0.62 * r, 0.38 * tall},
                                                           {0.34 * r, 0.68 * tall},
                                                           {0.2 * r, 0.84 * tall},
                                                           {0.17 * r, tall}},
                                                          5);
    const double t = 0.0016;
    b.slot("shade");
    std::vector<Vec2> shell = outside;
    std::vector<Vec2> back;
    for (const Vec2 q : outside) back.push_back({std::max(0.004, q.x - t), std::max(0.0002, q.y - 0.4 * t)});
    std::reverse(back.begin(), back.end());
    shell.insert(shell.end(), back.begin(), back.end());
    shell.push_back(shell.front());
    b.lathe({}, shell, 48);
    b.slot("inside");
    std::vector<Vec2> lining;
    for (const Vec2 q : outside)
      lining.push_back({std::max(0.003, q.x - t - 0.0006), std::max(0.001, q.y - 0.4 * t - 0.0006)});
    std::reverse(lining.begin(), lining.end());
    b.lathe({}, lining, 48);
    b.slot("fitting");
    const double neck = outside.back().x;
    b.cylinder({0, 0, tall - 0.004}, neck + 0.003, 0.03, 0.004, 24);
    cordFromCeiling(b, 0, 0, tall + 0.02);
    b.bulb({0, 0, 0.34 * tall}, 0.03, false);
    b.cylinder({0, 0, 0.34 * tall + 0.06}, 0.012, 0.66 * tall - 0.06, 0.001, 14);
  });
}

// Arms around a turned body, a candle bulb on each; glass drops between where asked.
void chandelier(Builder& b, const Parameters& p) {
  const double r = spread(b) - 0.03, h = b.height();
  const int arms = std::max(3, p.count("arms", 6));
  const double body = std::min(0.42, 0.5 * h), z0 = 0.02;
  b.slot("metal");
  b.lathe({0, 0, 0},
          spline2({{0, 0},
                   {0.012, 0.004},
                   {0.02, 0.02},
                   {0.01, 0.04},
                   {0.05, 0.07},
                   {0.06, 0.1},
                   {0.028, 0.14},
                   {0.018, 0.2},
                   {0.034, 0.26},
                   {0.03, 0.3},
                   {0.014, 0.36},
                   {0.02, 0.38},
                   {0, 0.4}},
                  4),
          28);
  b.lathe({0, 0, h - 0.04},
          fillet({{0, 0}, {0.02, 0}, {0.06, 0.028}, {0.06, 0.04}, {0, 0.04}}, 0.008, 3, false), 28);
  // A chain of links, each turned against the next.
  const double c0 = 0.395, c1 = h - 0.035;
  const int links = std::max(1, static_cast<int>((c1 - c0) / 0.026));
  for (int i = 0; i < links; ++i) {
    const double z = c0 + (c1 - c0) * (i + 0.5) / links, half = 0.6 * (c1 - c0) / links;
    b.within(Transform::translation({0, 0, z}) * Transform::rotationZ(i % 2 ? kPi / 2 : 0) *
                 Transform::rotationX(kPi / 2) * Transform::scaling({0.55, 1, 1}),
             [&] { b.torus({}, half, 0.0022, 14, 6); });
  }
  const double tip = std::min(0.3, body);
  for (int i = 0; i < arms; ++i) {
    b.within(Transform::rotationZ(2 * kPi * (i + 0.5) / arms), [&] {
      b.slot("metal");
      b.tube(spline({{0.04, 0, 0.1},
                     {0.3 * r, 0, 0.035 + z0},
                     {0.72 * r, 0, 0.05 + z0},
                     {0.97 * r, 0, 0.13},
                     {0.98 * r, 0, tip - 0.115}},
                    7),
             0.0065, 10);
      b.tube(spline({{0.03, 0, 0.24},
                     {0.28 * r, 0, 0.29},
                     {0.42 * r, 0, 0.2},
                     {0.3 * r, 0, 0.14},
                     {0.26 * r, 0, 0.19}},
                    6),
             0.0045, 8);
      b.lathe(
          {0.98 * r, 0, tip - 0.12},
          spline2(
              {{0, 0}, {0.012, 0}, {0.034, 0.012}, {0.038, 0.02}, {0.014, 0.022}, {0.013, 0.026}, {0, 0.027}},
              3),
          20);
      b.slot("candle");
      b.cylinder({0.98 * r, 0, tip - 0.095}, 0.011, 0.085, 0.002, 16);
      b.light({0.98 * r, 0, tip + 0.025});
      if (p.flag("drops", true)) {
        b.slot("drops");
        b.lathe({0.98 * r, 0, tip - 0.17}, {{0, 0}, {0.008, 0.012}, {0.003, 0.04}, {0, 0.045}}, 6);
        b.lathe({0.72 * r, 0, z0 - 0.002}, {{0, 0}, {0.007, 0.01}, {0.003, 0.034}, {0, 0.038}}, 6);
        // A garland from arm to arm.
        const double a = 2 * kPi / arms;
        for (int k = 1; k < 10; ++k) {
          const double t = k / 10.0;
          const Vec3 q = Vec3{0.9 * r, 0, tip - 0.12} * (1 - t) +
                         Vec3{0.9 * r * std::cos(a), 0.9 * r * std::sin(a), tip - 0.12} * t;
          b.ellipsoid(q - Vec3{0, 0, 0.075 * std::sin(kPi * t)}, {0.006, 0.006, 0.006}, 8);
        }
      }
    });
  }
}

// A stem with a drum or cone shade, for the floor and for tables. base: "disc", "tripod", "vase", "ball".
void standingLamp(Builder& b, const Parameters& p) {
  const double h = b.height(), r = spread(b);
  const double shadeTall = p.number("shade", 0.26) * h, z = h - shadeTall, taper = p.number("taper", 0.75);
  const std::string base = p.text("base", "disc");
  b.slot("base");
  if (base == "tripod") {
    for (int i = 0; i < 3; ++i) {
      const double a = kPi / 2 + 2 * kPi * i / 3;
      const double reach = 0.92 * r;
      b.leg({0.02 * std::cos(a), 0.02 * std::sin(a), z - 0.04}, {reach * std::cos(a), reach * std::sin(a), 0},
            0.014, 0.011);
    }
    b.slot("fitting");
    b.cylinder({0, 0, z - 0.07}, 0.04, 0.045, 0.006);
  } else if (base == "vase" || base == "ball") {
    const double k = 0.62 * r, top = z - 0.02;
    if (base == "vase")
      b.lathe({},
              spline2({{0, 0},
                       {0.55 * k, 0},
                       {0.58 * k, 0.03 * top},
                       {0.8 * k, 0.25 * top},
                       {k, 0.55 * top},
                       {0.86 * k, 0.8 * top},
                       {0.4 * k, 0.94 * top},
                       {0.22 * k, top},
                       {0, top}},
                      5),
              40);
    else
      b.lathe({},
              spline2({{0, 0},
                       {0.45 * k, 0},
                       {0.8 * k, 0.14 * top},
                       {k, 0.45 * top},
                       {0.82 * k, 0.78 * top},
                       {0.35 * k, 0.97 * top},
                       {0, top}},
                      6),
              40);
    b.slot("fitting");
    b.cylinder({0, 0, top - 0.01}, 0.018, 0.05, 0.003, 20);
  } else {
    b.lathe({}, fillet({{0, 0}, {0.6 * r, 0}, {0.6 * r, 0.014}, {0.05, 0.022}, {0, 0.022}}, 0.006, 3, false),
            48);
    b.slot("fitting");
    b.cylinder({0, 0, 0.018}, 0.011, z + 0.1 * shadeTall - 0.018, 0.001, 16);
  }
  b.slot("fitting");
  const double bulbZ = z + 0.42 * shadeTall;
  b.cylinder({0, 0, z - 0.03}, 0.007, bulbZ - z - 0.02, 0.001, 12);
  b.bulb({0, 0, bulbZ}, 0.03);
  const double top = taper * r, ring = h - 0.012;
  b.torus({0, 0, ring}, top - 0.003, 0.0018, 48, 6);
  b.torus({0, 0, z + 0.002}, r - 0.003, 0.0018, 48, 6);
  for (int i = 0; i < 3; ++i) {
    const double a = 2 * kPi * i / 3;
    b.rod({0.012 * std::cos(a), 0.012 * std::sin(a), ring - 0.01},
          {(top - 0.003) * std::cos(a), (top - 0.003) * std::sin(a), ring}, 0.0016, 6);
    // The harp that carries the shade, from the socket up around the bulb.
    b.tube(spline({{0.016 * std::cos(a), 0.016 * std::sin(a), bulbZ - 0.06},
                   {0.048 * std::cos(a), 0.048 * std::sin(a), bulbZ},
                   {0.04 * std::cos(a), 0.04 * std::sin(a), bulbZ + 0.05},
                   {0.01 * std::cos(a), 0.01 * std::sin(a), ring - 0.01}},
                  4),
           0.0014, 6);
  }
  b.slot("shade");
  b.within(Transform::scaling({b.width() / (2 * r), b.depth() / (2 * r), 1}), [&] {
    b.shade({0, 0, z}, r, top, shadeTall, 0.0015, 56);
  });
}

// A great arc from a marble foot, with a metal dome at its end.
void arcLamp(Builder& b, const Parameters& p) {
  const double l = b.left(), r = b.right(), h = b.height();
  const double dome = std::min({0.16, 0.48 * b.depth(), 0.2 * b.width()}),
               foot = std::min(0.13, 0.45 * b.depth());
  b.slot("base");
  b.roundedBox({l, -foot, 0}, {l + 2 * foot, foot, 0.12}, 0.012, 4);
  b.slot("metal");
  const double x0 = l + foot, x1 = r - dome, drop = p.number("drop", 0.22) * h;
  const Path arc = spline({{x0, 0, 0.11},
                           {x0, 0, 0.3 * h},
                           {x0 + 0.06 * (x1 - x0), 0, 0.66 * h},
                           {x0 + 0.36 * (x1 - x0), 0, 0.94 * h},
                           {x0 + 0.62 * (x1 - x0), 0, h - 0.009},
                           {x0 + 0.9 * (x1 - x0), 0, 0.93 * h},
                           {x1, 0, h - drop}},
                          10);
  b.tube(arc, 0.011, 14);
  b.cylinder({x0, 0, 0.11}, 0.022, 0.05, 0.004, 20);
  const double top = h - drop, tall = 0.95 * dome;
  b.within(Transform::translation({x1, 0, top - tall}), [&] {
    b.slot("shade");
    std::vector<Vec2> shell, back;
    for (int i = 0; i <= 14; ++i) {
      const double a = kPi / 2 * i / 14;
      shell.push_back({std::max(0.012, dome * std::cos(a)), tall * std::sin(a)});
      back.push_back(
          {std::max(0.01, (dome - 0.002) * std::cos(a)), std::max(0.0, (tall - 0.002) * std::sin(a))});
    }
    std::reverse(back.begin(), back.end());
    shell.insert(shell.end(), back.begin(), back.end());
    shell.push_back(shell.front());
    b.lathe({}, shell, 44);
    b.slot("metal");
    b.cylinder({0, 0, tall - 0.012}, 0.024, 0.03, 0.004, 20);
    b.bulb({0, 0, 0.38 * tall}, 0.03, false);
  });
}

// An articulated desk lamp: weighted foot, two arms with springs, a conical head.
void deskLamp(Builder& b, const Parameters&) {
  const double l = b.left(), r = b.right(), h = b.height();
  const double foot = std::min({0.095, 0.48 * b.depth(), 0.22 * b.width()});
  const double head = std::min({0.085, 0.48 * b.depth()});
  b.slot("body");
  b.lathe({l + foot, 0, 0},
          fillet({{0, 0}, {foot, 0}, {foot, 0.016}, {0.03, 0.026}, {0, 0.026}}, 0.007, 3, false), 40);
  const Vec3 a{l + foot, 0, 0.055}, elbow{l + 0.3 * foot + 0.02, 0, 0.6 * h},
      wrist{r - head * 1.45, 0, h - 0.03};
  b.cylinder({a.x, 0, 0.024}, 0.014, 0.05, 0.002, 16);
  const auto arm = [&](Vec3 from, Vec3 to) {
    for (const double y : {-0.011, 0.011})
      b.rod(from + Vec3{0, y, 0}, to + Vec3{0, y, 0}, 0.0042, 10, Cap::Round);
    b.slot("metal");
    // The spring: a helix beside the arm's foot.
    Path helix;
    const Vec3 d = normalized(to - from);
    const Transform t = facing(from + d * 0.03, d);
    const double run = std::min(0.12, 0.4 * length(to - from));
    for (int i = 0; i <= 110; ++i) {
      const double q = 2 * kPi * i / 10;
      helix.push_back(t.point({0.0055 * std::cos(q), 0.0055 * std::sin(q), run * i / 110}));
    }
    b.tube(helix, 0.0011, 5, Cap::None);
    b.slot("joints");
    for (const Vec3 q : {from, to})
      b.within(facing(q - Vec3{0, 0.018, 0}, {0, 1, 0}), [&] { b.cylinder({}, 0.013, 0.036, 0.003, 18); });
    b.slot("body");
  };
  arm(a, elbow);
  arm(elbow, wrist);
  // The head looks down and forward.
  const Vec3 look = normalized(Vec3{0.42, 0, -0.9});
  b.within(facing(wrist + Vec3{0.012, 0, -0.006}, look), [&] {
    b.slot("body");
    const double tall = head * 1.75;
    std::vector<Vec2>
        out = spline2(
            {{0.018, 0}, {0.03, 0.008}, {0.034, 0.34 * tall}, {0.6 * head, 0.55 * tall}, {head, tall}}, 5),
        shell;
    // Going from the mouth back up, the solid is on the left.
    for (auto it = out.rbegin(); it != out.rend(); ++it) shell.push_back({it->x - 0.0015, it->y});
    for (const Vec2 q : out) shell.push_back(q);
    std::reverse(shell.begin(), shell.end());
    shell.push_back(shell.front());
    std::reverse(shell.begin(), shell.end());
    b.lathe({}, shell, 36);
    b.cylinder({0, 0, -0.004}, 0.02, 0.014, 0.003, 20);
    b.cylinder({0, 0, 0.01}, 0.016, 0.3 * tall, 0.002, 16);
    b.light({0, 0, 0.66 * tall});
  });
}

// On a wall (its back at +y): "uplight" (a half bowl that throws light up), "arm" (a shade on a bracket),
// "cylinder" (light up and down).
void wallLamp(Builder& b, const Parameters& p) {
  const std::string style = p.text("style", "uplight");
  const double w = b.width() / 2, f = b.front(), k = b.back(), h = b.height();
  if (style == "uplight") {
    b.slot("shade");
    // A half bowl against a back plate.
    b.surface(
        [&](double u, double v) {
          const double a = kPi * u, t = std::pow(v, 0.75), ring = 0.12 + 0.88 * std::sin(kPi / 2 * t);
          return Vec3{w * ring * -std::cos(a), k - 0.012 - (k - 0.012 - f) * ring * std::sin(a), h * v};
        },
        32, 14, 0.004);
    b.slot("fitting");
    b.roundedBox({-0.98 * w, k - 0.012, 0.84 * h}, {0.98 * w, k, 0.99 * h}, 0.004, 2);
    b.roundedBox({-0.3 * w, k - 0.0115, 0.25 * h}, {0.3 * w, k - 0.0005, 0.86 * h}, 0.004, 2);
    b.bulb({0, k - 0.5 * (k - f), 0.72 * h}, 0.022);
    b.rod({0, k - 0.5 * (k - f), 0.4 * h}, {0, k - 0.01, 0.4 * h}, 0.006);
    return;
  }
  if (style == "cylinder") {
    const double r = std::min(w, (k - f - 0.03) / 2), y = f + r;
    b.slot("body");
    b.lathe({0, y, 0},
            {{r, 0.001},
             {r, h - 0.001},
             {r - 0.001, h},
             {r - 0.003, h},
             {r - 0.003, 0},
             {r - 0.001, 0},
             {r, 0.001}},
            40);
    b.cylinder({0, y, 0.35 * h}, r - 0.002, 0.3 * h, 0, 32);
    b.slot("fitting");
    b.box({-0.03, y + 0.9 * r, 0.38 * h}, {0.03, k, 0.62 * h}, 0.003);
    b.light({0, y, 0.8 * h});
    b.light({0, y, 0.2 * h});
    return;
  }
  const double r = std::min(w, 0.42 * (k - f)), y = f + r, tall = 0.62 * h;
  b.slot("shade");
  b.shade({0, y, h - tall}, r, 0.62 * r, tall, 0.0015, 44);
  b.slot("fitting");
  b.within(facing({0, k, 0.34 * h}, {0, -1, 0}), [&] {
    b.lathe({}, fillet({{0, 0}, {0.05, 0}, {0.05, 0.008}, {0.02, 0.018}, {0, 0.018}}, 0.004, 3, false), 28);
  });
  b.tube(spline({{0, k - 0.012, 0.34 * h},
                 {0, k - 0.4 * (k - y), 0.22 * h},
                 {0, y, 0.012 + 0.04 * h},
                 {0, y - 0.0, 0.3 * h}},
                7),
         0.006, 12);
  b.cylinder({0, y, 0.28 * h}, 0.02, 0.01, 0.003, 20);
  b.bulb({0, y, h - 0.55 * tall}, 0.024);
  b.rod({0, y, 0.28 * h}, {0, y, h - 0.55 * tall - 0.045}, 0.006);
  for (int i = 0; i < 3; ++i) {
    const double a = 2 * kPi * i / 3;
    b.rod({0.01 * std::cos(a), y + 0.01 * std::sin(a), h - 0.55 * tall - 0.035},
          {0.72 * r * std::cos(a), y + 0.72 * r * std::sin(a), h - 0.3 * tall}, 0.0014, 6);
  }
}

// Close to the ceiling: "flush" (a shallow opal bowl in a rim), "spots" (turnable heads on a bar),
// "downlight" (recessed look), "panel" (a flat LED panel in a frame).
void ceilingLamp(Builder& b, const Parameters& p) {
  const std::string style = p.text("style", "flush");
  const double w = b.width() / 2, d = b.depth() / 2, h = b.height(), r = spread(b);
  if (style == "flush") {
    b.within(Transform::scaling({w / r, d / r, 1}), [&] {
      b.slot("shade");
      b.lathe(
          {},
          spline2(
              {{0, 0}, {0.45 * r, 0.04 * h}, {0.8 * r, 0.2 * h}, {0.95 * r, 0.48 * h}, {0.965 * r, 0.72 * h}},
              6),
          48);
      b.slot("fitting");
      b.lathe({},
              {{0.93 * r, 0.66 * h},
               {0.998 * r, 0.66 * h},
               {r, 0.68 * h},
               {r, h - 0.002},
               {0.998 * r, h},
               {0.93 * r, h},
               {0.93 * r, 0.66 * h}},
              48);
      b.cylinder({0, 0, h - 0.006}, 0.94 * r, 0.0055, 0, 40);
      b.light({0, 0, 0.5 * h});
    });
    return;
  }
  if (style == "panel") {
    b.slot("fitting");
    const double t = std::min(0.012, 0.2 * w);
    b.mirroredX([&] { b.box({w - t, -d, 0}, {w, d, h}, 0.001); });
    b.mirroredY([&] { b.box({-w + t, d - t, 0.0004}, {w - t, d, h - 0.0004}, 0.001); });
    b.box({-w + t, -d + t, h - 0.004}, {w - t, d - t, h - 0.0006}, 0);
    b.slot("panel");
    b.box({-w + t - 0.001, -d + t - 0.001, 0.0015}, {w - t + 0.001, d - t + 0.001, 0.0035}, 0);
    b.light({0, 0, 0.5 * h});
    return;
  }
  if (style == "downlight") {
    b.within(Transform::scaling({w / r, d / r, 1}), [&] {
      b.slot("fitting");
      b.lathe({},
              fillet({{0.76 * r, 0.0},
                      {0.99 * r, 0.0},
                      {r, 0.003},
                      {r, h},
                      {0, h},
                      {0, h - 0.002},
                      {0.6 * r, h - 0.002},
                      {0.76 * r, 0}},
                     0.0, 1, false),
              44);
      b.light({0, 0, 0.5 * h});
    });
    return;
  }
  // Spots on a bar.
  b.slot("body");
  b.roundedBox({-w, -0.022, h - 0.028}, {w, 0.022, h}, 0.006, 2);
  const int spots = p.count("spots", fitting(2 * w, 0.3, 10));
  const double head = std::min({0.036, d, 0.3 * h}), tall = std::min(2.4 * head, h - 0.055);
  for (int i = 0; i < spots; ++i) {
    const double x = -w + 2 * w * (i + 0.5) / spots;
    const double tilt = (i % 2 ? 0.3 : -0.3), top = h - 0.062;
    b.slot("fitting");
    b.cylinder({x, 0, top - 0.012}, 0.007, 0.05, 0.001, 12);
    b.within(Transform::translation({x, 0, top - 0.012}) * Transform::rotationX(tilt) *
                 Transform::translation({0, 0, -0.92 * tall}),
             [&] {
               b.slot("body");
               b.lathe({},
                       {{head, 0.001},
                        {head, tall - 0.006},
                        {head - 0.006, tall},
                        {0, tall},
                        {0, 0.45 * tall},
                        {0.55 * head, 0.45 * tall},
                        {head - 0.003, 0.0},
                        {head - 0.001, 0.0},
                        {head, 0.001}},
                       32);
               b.light({0, 0, 0.3 * tall});
             });
  }
}

// Candles on a plate or in holders.
void candlePlate(Builder& b, const Parameters& p) {
  const double r = spread(b), h = b.height();
  b.slot("holder");
  b.within(Transform::scaling({b.width() / (2 * r), b.depth() / (2 * r), 1}), [&] {
    b.lathe({},
            fillet({{0, 0}, {0.8 * r, 0}, {r, 0.014}, {r - 0.002, 0.016}, {0.78 * r, 0.006}, {0, 0.006}},
                   0.002, 2, false),
            44);
  });
  const int n = p.count("candles", 3);
  for (int i = 0; i < n; ++i) {
    const double a = 2 * kPi * i / n + 0.6, q = n > 1 ? 0.44 * r : 0;
    const double c = std::min(0.034, 0.32 * r), flame = 0.03,
                 tall = (h - 0.006 - flame - 0.008) * (1 - 0.26 * i);
    const Vec3 at{q * std::cos(a), q * std::sin(a), 0.0065};
    b.slot("wax");
    b.lathe(
        at,
        fillet(
            {{0, 0}, {c, 0}, {c, tall}, {0.86 * c, tall + 0.001}, {0.6 * c, tall - 0.006}, {0, tall - 0.007}},
            0.002, 2, false),
        28);
    b.slot("wick");
    b.tube(
        {at + Vec3{0, 0, tall - 0.008}, at + Vec3{0.001, 0, tall + 0.004}, at + Vec3{0.003, 0, tall + 0.01}},
        0.001, 6);
    b.slot("flame");
    b.lathe(at + Vec3{0.001, 0, tall + 0.002},
            spline2({{0, 0}, {0.0035, 0.004}, {0.0055, 0.011}, {0.0035, 0.022}, {0, flame + 0.006}}, 4), 14);
    b.light(at + Vec3{0.001, 0, tall + 0.014});
  }
}

}  // namespace

void addLights(Generators& to) {
  to["pendantLamp"] = pendantLamp;
  to["chandelier"] = chandelier;
  to["standingLamp"] = standingLamp;
  to["arcLamp"] = arcLamp;
  to["deskLamp"] = deskLamp;
  to["wallLamp"] = wallLamp;
  to["ceilingLamp"] = ceilingLamp;
  to["candlePlate"] = candlePlate;
}

}  // namespace idap::parametric
