// What makes a room lived in: rugs, curtains, pictures, cushions, vases, clocks, books, bowls.
#include <algorithm>
#include <cmath>

#include "catalog/parametric/casework.h"

namespace idap::parametric {

namespace {

Region ringBetween(const Polygon& outer, const Polygon& inner) {
  Region region{outer, {inner}};
  std::reverse(region.holes[0].begin(), region.holes[0].end());
  return region;
}

// Bands of border around a field; fringes at the short ends.
void rug(Builder& b, const Parameters& p) {
  const double h = b.height(), fringe = p.flag("fringe") ? 0.06 : 0.0;
  const bool round = p.text("shape") == "round";
  const double wide = std::min(b.width(), b.depth());
  const auto outline = [&](double in) {
    if (round) return ellipse({}, {b.width() / 2 - in, b.depth() / 2 - in}, 72);
    return roundedRectangle({b.left() + fringe + in, b.front() + in},
                            {b.right() - fringe - in, b.back() - in}, 0.006, 2);
  };
  const double band = p.number("border", 0.06) * wide;
  b.slot("rug");
  if (band <= 0) {
    b.extrude(outline(0), 0, h, 0.4 * h);
  } else {
    b.extrude(ringBetween(outline(0), outline(0.6 * band)), 0, h, 0.3 * h);
    b.slot("border");
    b.extrude(ringBetween(outline(0.6 * band), outline(1.6 * band)), 0, h, 0.1 * h);
    b.slot("rug");
    b.extrude(ringBetween(outline(1.6 * band), outline(2.0 * band)), 0, h, 0.1 * h);
    b.slot("border");
    b.extrude(ringBetween(outline(2.0 * band), outline(2.15 * band)), 0, h, 0.1 * h);
    b.slot("rug");
    b.extrude(outline(2.15 * band), 0, h, 0.1 * h);
  }
  if (fringe <= 0) return;
  b.slot("fringe");
  const int n = fitting(b.depth(), 0.016, 300);
  for (int i = 0; i < n; ++i) {
    const double y = b.front() + b.depth() * (i + 0.5) / n;
    for (const double s : {-1.0, 1.0}) {
      const double x0 = s * (b.width() / 2 - fringe), sway = 0.012 * (Builder::random(i * 2 + (s > 0)) - 0.5);
      b.tube({{x0 - s * 0.003, y, 0.5 * h},
              {x0 + s * 0.5 * fringe, y + 0.5 * sway, 0.3 * h},
              {x0 + s * fringe, y + sway, 0.003}},
             0.0025, 5, Cap::Flat);
    }
  }
}

// Two panels of cloth in soft folds on a rod. open: 0 closed, 1 drawn fully aside.
void curtain(Builder& b, const Parameters& p) {
  const double h = b.height(), rod = 0.012, z = h - 0.03, open = std::clamp(p.number("open", 0.7), 0.0, 1.0);
  const int panels = std::clamp(p.count("panels", 2), 1, 2);
  const double reach = b.width() / panels - 0.03, w = reach * (1 - 0.72 * open) - 0.01,
               deep = b.depth() / 2 - 0.004;
  const auto panel = [&](double x0, double side, int key) {  // hangs from x0 towards side
    b.slot("fabric");
    const int folds = std::max(3, static_cast<int>(std::lround(reach / 0.16)));
    b.surface(
        [&](double u, double v) {
          const double settle = 0.75 + 0.25 * std::sin(1.3 * folds * u + key);
          const double fall = 1 - v;  // 0 at the rod
          const double a = 2 * kPi * folds * u + 0.35 * fall * std::sin(5 * u + key);
          const double amplitude = deep * std::min(1.0, 0.55 + 0.5 * fall) * settle;
          const double x = w * (u + 0.012 * std::sin(a * 2) / folds) * (1 + 0.02 * fall);
          return Vec3{x0 + side * x, amplitude * std::sin(a), 0.008 + (z - 0.005) * v};
        },
        folds * 12, 14, 0);
  };
  if (panels == 2) {
    panel(b.left() + 0.02, 1, 0);
    panel(b.right() - 0.02, -1, 3);
  } else {
    panel(b.left() + 0.02, 1, 0);
  }
  b.slot("rod");
  b.rod({b.left() + 0.02, 0, z}, {b.right() - 0.02, 0, z}, rod, 16);
  b.mirroredX([&] {
    b.sphere({b.right() - 0.02, 0, z}, 0.02, 16);
    b.rod({b.right() - 0.09, 0, z}, {b.right() - 0.09, b.back(), z}, 0.007);
    b.box({b.right() - 0.105, b.back() - 0.006, z - 0.03}, {b.right() - 0.075, b.back(), z + 0.03}, 0.002);
  });
}

void rollerBlind(Builder& b, const Parameters& p) {
  const double r = std::min(0.022, b.depth() / 2 - 0.002), h = b.height(),
               drop = std::clamp(p.number("drop", 1), 0.1, 1.0);
  b.slot("rod");
  b.rod({b.left() + 0.012, 0, h - r - 0.004}, {b.right() - 0.012, 0, h - r - 0.004}, 0.6 * r, 16);
  b.mirroredX([&] {
    b.box({b.right() - 0.01, b.front(), h - 2 * r - 0.008}, {b.right(), b.back(), h}, 0.002);
  });
  b.slot("fabric");
  b.rod({b.left() + 0.02, 0, h - r - 0.004}, {b.right() - 0.02, 0, h - r - 0.004}, r, 20);
  const double z0 = (1 - drop) * (h - 0.1);
  sheet(b, {b.left() + 0.02, z0 + 0.01, b.right() - 0.02, h - r - 0.004}, r - 0.001);
  b.slot("rod");
  b.box({b.left() + 0.018, r - 0.006, z0}, {b.right() - 0.018, r + 0.004, z0 + 0.022}, 0.003, Grain::X);
  if (z0 > 0.05) b.tube({{b.right() - 0.03, -0.5 * r, h - r}, {b.right() - 0.03, -0.5 * r, 0}}, 0.0015, 6);
}

void picture(Builder& b, const Parameters& p) {
  const double bar = std::min(p.number("frame", 0.025), 0.2 * std::min(b.width(), b.height()));
  const double mat = p.number("mat", 0.06) * std::min(b.width(), b.height());
  const Pane outer{b.left(), 0, b.right(), b.height()};
  b.slot("frame");
  bars(b, outer, b.front(), b.back(), bar, bar, bar, 0.003);
  const double y = b.front() + std::min(0.01, 0.5 * b.depth());
  const Pane in = outer.inset(bar - 0.001);
  b.box({in.x0, y + 0.003, in.z0}, {in.x1, b.back() - 0.001, in.z1}, 0);
  if (mat > 0) {
    b.slot("mat");
    bars(b, in, y, y + 0.0025, mat, mat, mat, 0.0006);
  }
  const Pane art = in.inset(std::max(0.0, mat - 0.001));
  b.slot("picture");
  Mesh canvas;
  for (const auto& [u, v] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
    canvas.positions.push_back(
        toFloat(Vec3{art.x0 + u * art.width(), y + 0.0015, art.z0 + v * art.height()}));
    canvas.uvs.push_back(toFloat(Vec2{u, v}));
  }
  canvas.triangles = {{0, 1, 2}, {0, 2, 3}};
  b.add(std::move(canvas), 0.7, true);
}

void cushion(Builder& b, const Parameters&) {
  Soft soft;
  soft.pinched = true;
  soft.wrinkle = 0.004;
  soft.segments = 22;
  b.slot("fabric");
  const Vec3 lo{b.left(), b.front(), 0}, hi{b.right(), b.back(), b.height()};
  b.cushion(lo, hi, soft);
}

void vase(Builder& b, const Parameters& p) {
  const std::string style = p.text("style", "bottle");
  const bool stems = p.flag("stems");
  const double h = stems ? b.height() * p.number("vaseHeight", 0.42) : b.height();
  const double r =
      stems ? std::min(0.32 * h, std::min(b.width(), b.depth()) / 2) : std::min(b.width(), b.depth()) / 2;
  const double mouth = style == "bottle" ? 0.3 : style == "urn" ? 0.62 : 0.8, wall = 0.05 * r + 0.002;
  std::vector<Vec2> outside, inside;
  if (style == "bottle")
    outside = {{0.6 * r, 0},        {0.9 * r, 0.12 * h},  {r, 0.3 * h},  {0.75 * r, 0.55 * h},
               {0.3 * r, 0.72 * h}, {0.26 * r, 0.85 * h}, {mouth * r, h}};
  else if (style == "urn")
    outside = {{0.45 * r, 0},        {0.55 * r, 0.06 * h},  {0.9 * r, 0.45 * h},      {r, 0.68 * h},
               {0.85 * r, 0.86 * h}, {mouth * r, 0.95 * h}, {mouth * r + 0.05 * r, h}};
  else
    outside = {{0.9 * r, 0}, {0.97 * r, 0.03 * h}, {r, 0.3 * h}, {0.92 * r, 0.7 * h}, {mouth * r, h}};
  std::vector<Vec2> profile{{0, 0}};
  const std::vector<Vec2> skin = spline2(outside, 7);
  profile.insert(profile.end(), skin.begin(), skin.end());
  for (auto it = skin.rbegin(); it != skin.rend(); ++it)
    if (it->y > 0.2 * h)
      profile.push_back(
          {std::max(0.004, it->x - wall), it == skin.rbegin() ? it->y - 0.001 : it->y - 0.3 * wall});
  profile.push_back({0, 0.2 * h});
  b.slot("vase");
  b.lathe({}, profile, 44);
  if (!stems) return;
  const int n = std::clamp(p.count("stems", 9), 1, 30);
  for (int i = 0; i < n; ++i) {
    const double a = 2 * kPi * (i + 0.6 * Builder::random(i)) / n,
                 out = 0.25 + 0.75 * Builder::random(i + 40);
    const double top = b.height() * (0.82 + 0.18 * Builder::random(i + 80)) - 0.02;
    const double reach = out * std::min(b.width(), b.depth()) * 0.5;
    const Path stem = spline({{0.3 * mouth * r * std::cos(a), 0.3 * mouth * r * std::sin(a), 0.4 * h},
                              {0.7 * mouth * r * std::cos(a), 0.7 * mouth * r * std::sin(a), h},
                              {0.6 * reach * std::cos(a), 0.6 * reach * std::sin(a), (h + top) / 2},
                              {reach * std::cos(a), reach * std::sin(a), top}},
                             5);
    b.slot("stem");
    b.tube(stem, 0.0018, 5, Cap::None);
    b.slot("grass");  // a plume
    const Vec3 end = stem.back(), way = normalized(end - along(stem, 0.85));
    for (int k = 0; k < 22; ++k) {
      const double f = 0.68 + 0.32 * k / 22.0, turn = 2.4 * k + i;
      Leaf leaf;
      leaf.length = 0.05 + 0.03 * Builder::random(i * 31 + k);
      leaf.width = 0.009;
      leaf.droop = 0.7;
      leaf.segments = 3;
      b.leaf(along(stem, f), way * 1.1 + Vec3{std::cos(turn) * 0.6, std::sin(turn) * 0.6, 0}, {0, 0, 1},
             leaf);
    }
  }
}

void wallClock(Builder& b, const Parameters&) {
  const double r = std::min(b.width(), b.height()) / 2, d = b.depth();
  b.within(Transform::translation({0, b.back(), b.height() / 2}) *
               Transform::scaling({b.width() / 2 / r, 1, b.height() / 2 / r}) * facing({}, {0, -1, 0}),
           [&] {
             b.slot("frame");
             b.lathe({},
                     fillet({{0, 0},
                             {r, 0},
                             {r, 0.8 * d},
                             {0.97 * r, d},
                             {0.93 * r, d},
                             {0.9 * r, 0.55 * d},
                             {0, 0.55 * d}},
                            0.1 * d, 3),
                     72);
             b.slot("face");
             b.cylinder({0, 0, 0.55 * d - 0.001}, 0.9 * r, 0.002, 0, 72);
             b.slot("hands");
             const double z = 0.55 * d + 0.001;
             for (int i = 0; i < 12; ++i)
               b.within(Transform::rotationZ(kPi / 6 * i), [&] {
                 const double w = (i % 3 ? 0.012 : 0.024) * r, l = (i % 3 ? 0.08 : 0.13) * r;
                 b.box({-w, 0.84 * r - l, z - 0.0005}, {w, 0.84 * r, z + 0.0008}, 0);
               });
             for (const auto& [turn, length, width] : {std::tuple{-0.98, 0.5, 0.028}, {1.07, 0.74, 0.018}})
               b.within(Transform::rotationZ(turn), [&, width = width, length = length] {
                 b.box({-width * r, -0.1 * r, z + 0.002}, {width * r, length * r, z + 0.0032}, 0.0004);
               });
             b.cylinder({0, 0, z}, 0.035 * r, 0.006, 0.001, 20);
           });
}

void bookStack(Builder& b, const Parameters& p) {
  const int n = std::clamp(p.count("books", 4), 1, 12);
  const char* const slots[] = {"book-a", "book-b", "book-c", "book-d"};
  const double each = b.height() / n;
  for (int i = 0; i < n; ++i) {
    const double k = i == 0 ? 1.0 : 0.97 - 0.2 * Builder::random(i * 3 + 1) * i / n, t = each;
    const double w = k * b.width() / 2, d = k * b.depth() / 2, z = each * i;
    b.within(Transform::rotationZ(i == 0 ? 0 : 0.22 * (Builder::random(i * 3 + 2) - 0.5)), [&] {
      b.slot(slots[i % 4]);
      b.box({-w, -d, z}, {w, d, z + 0.0026}, 0.0008);
      b.box({-w, -d, z + t - 0.0026}, {w, d, z + t - 0.0002}, 0.0008);
      b.box({-w, -d, z + 0.001}, {w, -d + 0.003, z + t - 0.001}, 0.001);
      b.slot("paper");
      b.box({-w + 0.004, -d + 0.002, z + 0.0024}, {w - 0.004, d - 0.004, z + t - 0.0024}, 0);
    });
  }
}

void fruitBowl(Builder& b, const Parameters& p) {
  const double r = std::min(b.width(), b.depth()) / 2, h = b.height() * 0.62;
  b.slot("bowl");
  b.lathe({},
          spline2({{0, 0},
                   {0.42 * r, 0},
                   {0.44 * r, 0.04 * h},
                   {0.8 * r, 0.45 * h},
                   {r, h},
                   {0.965 * r, h},
                   {0.76 * r, 0.5 * h},
                   {0.4 * r, 0.12 * h},
                   {0, 0.08 * h}},
                  5),
          56);
  const int n = std::clamp(p.count("fruits", 6), 0, 12);
  for (int i = 0; i < n; ++i) {
    const bool top = i + 1 == n && n > 3;
    const double size = 0.26 * r, a = 2 * kPi * i / std::max(1, n - 1);
    b.slot(i % 3 == 1 ? "lemon" : i % 3 == 2 ? "pear" : "apple");
    const Vec3 at = top ? Vec3{0, 0, b.height() - size}
                        : Vec3{0.47 * r * std::cos(a), 0.47 * r * std::sin(a), 0.38 * h + size};
    b.at(at, [&] {
      if (i % 3 == 1)
        b.ellipsoid({}, {1.15 * size, 0.85 * size, 0.85 * size}, 20);
      else
        b.lathe({0, 0, -size},
                spline2({{0, 0.12 * size},
                         {0.3 * size, 0},
                         {0.85 * size, 0.45 * size},
                         {size, 1.1 * size},
                         {0.75 * size, 1.7 * size},
                         {0.3 * size, 1.92 * size},
                         {0, 1.78 * size}},
                        4),
                24);
    });
  }
}

void candles(Builder& b, const Parameters& p) {
  const int n = std::clamp(p.count("candles", 3), 1, 7);
  const double r = 0.5 * b.width() / n * 0.86;
  for (int i = 0; i < n; ++i) {
    const double x = b.left() + b.width() * (i + 0.5) / n, tall = b.height() * (1 - 0.24 * ((i * 2) % 3));
    const double rr = std::min(r, b.depth() / 2 - 0.002);
    b.slot("holder");
    b.cylinder({x, 0, 0}, rr * 1.15 > b.depth() / 2 ? b.depth() / 2 : rr * 1.15, 0.008, 0.002);
    b.slot("wax");
    b.lathe({x, 0, 0.007},
            fillet({{0, 0},
                    {rr, 0},
                    {rr, tall - 0.022},
                    {0.9 * rr, tall - 0.019},
                    {0.5 * rr, tall - 0.026},
                    {0, tall - 0.028}},
                   0.003, 3),
            28);
    b.slot("holder");
    b.rod({x, 0, tall - 0.03}, {x, 0, tall}, 0.0012, 6);
  }
}

}  // namespace

void addDecor(Generators& to) {
  to["rug"] = rug;
  to["curtain"] = curtain;
  to["rollerBlind"] = rollerBlind;
  to["picture"] = picture;
  to["decorCushion"] = cushion;
  to["vase"] = vase;
  to["wallClock"] = wallClock;
  to["bookStack"] = bookStack;
  to["fruitBowl"] = fruitBowl;
  to["candles"] = candles;
}

}  // namespace idap::parametric
