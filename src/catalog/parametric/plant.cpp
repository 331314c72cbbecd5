// Plants in pots, and flowers in a vase. They grow into the box they are given: the pot keeps its shape,
// stems and leaves follow the size.
#include <algorithm>
#include <cmath>

#include "catalog/parametric/registry.h"

namespace idap::parametric {
namespace {

double roll(const char* what, int i) {
  int key = i * 131;
  for (const char* c = what; *c; ++c) key = key * 31 + *c;
  return Builder::random(key);
}

double between(double a, double b, double t) { return a + (b - a) * t; }

Vec3 onCircle(double angle, double radius, double z = 0) {
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

struct Ground {
  double radius = 0;  // of the soil
  double z = 0;       // its surface
};

// A pot for the plant in this box; styles: "tapered", "cylinder", "belly", "rimmed".
Ground plantPot(Builder& b, const Parameters& p, double share) {
  const double r =
      std::min(p.number("potRadius", p.number("potShare", 0.36) * std::min(b.width(), b.depth())),
               std::min(b.width(), b.depth()) / 2);
  const double tall = std::min(p.number("potHeight", 1.8 * r), share * b.height());
  const std::string style = p.text("pot", "tapered");
  if (style == "belly") {
    b.slot("pot");
    b.lathe({},
            spline2({{0, 0},
                     {0.55 * r, 0},
                     {0.86 * r, 0.22 * tall},
                     {r, 0.52 * tall},
                     {0.9 * r, 0.82 * tall},
                     {0.76 * r, tall - 0.004},
                     {0.74 * r, tall},
                     {0.71 * r, tall - 0.004},
                     {0.8 * r, 0.86 * tall},
                     {0, 0.86 * tall}},
                    4),
            40);
    b.slot("soil");
    b.cone({0, 0, 0.862 * tall}, 0.78 * r, 0.5 * r, 0.02 * tall, 0, 24);
    return {0.7 * r, 0.87 * tall};
  }
  if (style == "cylinder")
    b.pot({}, 0.985 * r, r, tall);
  else if (style == "rimmed")
    b.pot({}, 0.68 * r, r, tall, 0.06 * r);
  else
    b.pot({}, 0.7 * r, r, tall);
  return {0.8 * r, 0.88 * tall};
}

// Rubber plant or ficus: upright stems with alternate oval leaves.
void ficus(Builder& b, const Parameters& p) {
  const Ground ground = plantPot(b, p, 0.32);
  b.fitted({b.left(), b.front(), ground.z - 0.01}, {b.right(), b.back(), b.height()}, [&] {
    const double R = std::min(b.width(), b.depth()) / 2, h = b.height();
    const int stems = p.count("stems", 3);
    const double leaf = p.number("leaf", 0.24);
    for (int s = 0; s < stems; ++s) {
      const double a = 2 * kPi * s / stems + 0.5,
                   top = h * (s == 0 ? 0.93 : between(0.68, 0.88, roll("top", s)));
      const Path stem =
          spline({onCircle(a, 0.2 * ground.radius, ground.z - 0.01),
                  onCircle(a + 0.3, 0.5 * ground.radius, between(ground.z, top, 0.35)),
                  onCircle(a, 0.26 * R, between(ground.z, top, 0.7)), onCircle(a + 0.2, 0.3 * R, top)},
                 6);
      b.slot("stem");
      b.tube(
          stem, [](double t) { return 0.011 - 0.007 * t; }, 10);
      const int leaves = std::max(5, static_cast<int>((top - ground.z) / (0.3 * leaf)));
      for (int i = 0; i < leaves; ++i) {
        const double t = between(0.22, 1.0, static_cast<double>(i) / (leaves - 1)), around = i * 2.4 + s;
        const double size = leaf * (1.05 - 0.35 * t) * between(0.85, 1.15, roll("size", 31 * s + i));
        const Vec3 at = along(stem, t);
        const double rise = i + 1 == leaves ? 1.3 : between(0.25, 0.75, t) + 0.25 * roll("rise", 17 * s + i);
        const Vec3 d{std::cos(around) * std::cos(rise), std::sin(around) * std::cos(rise), std::sin(rise)};
        const Vec3 base = at + d * (0.16 * leaf);
        b.slot("stem");
        b.tube({at, base}, 0.0028, 6, Cap::None);
        b.slot("leaf");
        b.leaf(base, d, {0, 0, 1},
               {.length = size,
                .width = 0.5 * size,
                .droop = 0.7 + 0.4 * roll("droop", i + 7 * s),
                .fold = 0.22,
                .widest = 0.48,
                .tip = 1.15});
      }
    }
  });
}

// Swiss cheese plant: big cut leaves on long arching stalks from the middle.
void monstera(Builder& b, const Parameters& p) {
  const Ground ground = plantPot(b, p, 0.34);
  b.fitted({b.left(), b.front(), ground.z - 0.01}, {b.right(), b.back(), b.height()}, [&] {
    const double R = std::min(b.width(), b.depth()) / 2, h = b.height();
    const int leaves = p.count("leaves", 13);
    for (int i = 0; i < leaves; ++i) {
      const double t = static_cast<double>(i) / std::max(1, leaves - 1), a = i * 2.399;
      const double top = between(0.95, 0.42, std::pow(t, 1.1)) * h,
                   reach = between(0.25, 0.6, std::sqrt(t)) * R;
      const Vec3 root = onCircle(a, 0.25 * ground.radius, ground.z - 0.01), tip = onCircle(a, reach, top);
      b.slot("stem");
      b.tube(
          spline({root, onCircle(a, 0.25 * reach, between(ground.z, top, 0.5)), tip}, 8),
          [](double u) { return 0.0065 - 0.003 * u; }, 8);
      const double size = std::min(0.62 * R, 0.3 * h) * between(0.8, 1.1, roll("monstera", i));
      b.slot("leaf");
      const double down = between(0.1, 0.45, t);
      b.leaf(tip, {std::cos(a) * std::cos(down), std::sin(a) * std::cos(down), -std::sin(down)}, {0, 0, 1},
             {.length = size,
              .width = 0.92 * size,
              .droop = 0.9,
              .fold = 0.2,
              .widest = 0.33,
              .tip = 1.0,
              .lobes = i % 4 == 3 ? 0 : 5,
              .lobeDepth = 0.68,
              .segments = 12});
    }
  });
}

// Areca-like palm: arching fronds with two rows of leaflets.
void palm(Builder& b, const Parameters& p) {
  const Ground ground = plantPot(b, p, 0.28);
  b.fitted({b.left(), b.front(), ground.z - 0.01}, {b.right(), b.back(), b.height()}, [&] {
    const double R = std::min(b.width(), b.depth()) / 2, h = b.height();
    const int fronds = p.count("fronds", 13);
    for (int i = 0; i < fronds; ++i) {
      const double t = static_cast<double>(i) / fronds, a = i * 2.399 + 0.2;
      const double reach = between(0.35, 0.97, std::sqrt(t)) * R, top = between(0.97, 0.62, t) * h;
      const Path rib =
          spline({onCircle(a, 0.2 * ground.radius, ground.z - 0.01),
                  onCircle(a, 0.16 * reach, between(ground.z, top, 0.55)), onCircle(a, 0.52 * reach, top),
                  onCircle(a, reach, between(ground.z, top, 0.72))},
                 8);
      b.slot("stem");
      b.tube(
          rib, [](double u) { return 0.0075 - 0.0062 * u; }, 7);
      b.slot("leaf");
      const int pairs = std::max(8, p.count("leaflets", 20));
      const double reachOf = 0.3 * R + 0.09;
      for (int k = 0; k < pairs; ++k) {
        const double u = between(0.38, 0.985, static_cast<double>(k) / (pairs - 1));
        const Vec3 at = along(rib, u),
                   d = normalized(along(rib, std::min(1.0, u + 0.03)) - along(rib, u - 0.03));
        const Vec3 side = normalized(cross(d, Vec3{0, 0, 1}));
        const double size = reachOf * std::sin(kPi * between(0.2, 0.9, static_cast<double>(k) / (pairs - 1)));
        for (const double s : {-1.0, 1.0})
          b.leaf(at, side * s + d * 0.75 + Vec3{0, 0, 0.22}, {0, 0, 1},
                 {.length = size,
                  .width = 0.022 + 0.03 * size,
                  .droop = 1.0,
                  .fold = 0.35,
                  .widest = 0.35,
                  .tip = 1.2,
                  .segments = 5});
      }
    }
  });
}

// A rosette of thick leaves.
void rosette(Builder& b, const Parameters& p) {
  const Ground ground = plantPot(b, p, 0.45);
  const double R = std::min(b.width(), b.depth()) / 2;
  b.fitted({b.left(), b.front(), ground.z - 0.01}, {b.right(), b.back(), b.height()}, [&] {
    b.slot("leaf");
    const int leaves = p.count("leaves", 34);
    for (int i = 0; i < leaves; ++i) {
      const double t = static_cast<double>(i) / leaves, a = i * 2.399963,
                   rise = between(1.35, 0.12, std::pow(t, 0.8));
      const double size = between(0.35, 1.0, std::pow(t, 0.6)) * R, thick = 0.055 * R + 0.004;
      b.within(
          Transform::translation({0, 0, ground.z}) * Transform::rotationZ(a) * Transform::rotationY(-rise),
          [&] {
            // A plump leaf with a pointed end.
            std::vector<Path> rings;
            for (int k = 0; k <= 10; ++k) {
              const double u = k / 10.0,
                           wide =
                               0.17 * size * std::pow(std::sin(kPi * std::min(0.98, 0.12 + 0.84 * u)), 0.8),
                           lift = 0.16 * size * u * u;
              Path ring;
              for (const Vec2 q :
                   ellipse({},
                           {std::max(0.0006, wide),
                            std::max(0.0005,
                                     thick * std::pow(std::sin(kPi * std::min(0.985, 0.2 + 0.8 * u)), 0.7))},
                           12))
                ring.push_back({u * size, q.x, q.y + lift});
              rings.push_back(ring);
            }
            b.loft(rings, true, 1.6);
          });
    }
  });
}

// Ribbed columns with spines; arms reach to the sides of the box, the pot from its front to its back.
void cactus(Builder& b, const Parameters& p) {
  const Ground ground = plantPot(b, p, 0.45);
  const double R = b.width() / 2, h = b.height();
  const auto column = [&](const Path& way, double radius) {
    b.slot("cactus");
    const double total = pathLength(way);
    const int ribs = 11;
    const auto radiusAt = [&](double t) {
      const double left = (1 - t) * total, cap = std::min(1.0, left / radius);
      return radius * (0.82 + 0.18 * std::min(1.0, 4 * t)) *
             std::max(0.05, std::sqrt(1 - (1 - cap) * (1 - cap)));
    };
    Path fine;
    for (int i = 0; i <= 24; ++i) fine.push_back(along(way, std::sin(kPi / 2 * i / 24.0)));
    b.sweep(fine,
            [&](double t) {
              Polygon section;
              for (int i = 0; i < 5 * ribs; ++i) {
                const double a = 2 * kPi * i / (5 * ribs),
                             r = radiusAt(t) * (1 - 0.13 * std::pow(std::abs(std::sin(ribs * a / 2)), 1.4));
                section.push_back({r * std::cos(a), r * std::sin(a)});
              }
              return section;
            },
            {0.02, 1, 0.01});
    b.slot("spines");
    const int rows = std::max(4, static_cast<int>(total / (0.55 * radius)));
    for (int k = 1; k < rows; ++k) {
      const double t = static_cast<double>(k) / rows;
      const Vec3 at = along(way, t),
                 d = normalized(along(way, std::min(1.0, t + 0.02)) - along(way, t - 0.02));
      const Transform frame = facing(at, d);
      for (int i = 0; i < ribs; i += 1) {
        const double a = 2 * kPi * i / ribs;
        const Vec3 out = frame.vector(onCircle(a, 1));
        for (const double s : {-0.5, 0.5}) {
          const Vec3 tip = normalized(out + frame.vector({-std::sin(a), std::cos(a), 0}) * s + d * 0.3);
          b.tube(
              {at + out * (0.97 * radiusAt(t)), at + out * (0.97 * radiusAt(t)) + tip * (0.2 * radius)},
              [](double u) { return 0.0007 * (1.1 - u); }, 3, Cap::None);
        }
      }
    }
  };
  const double r = std::min({0.3 * R, 0.16 * h, 0.8 * ground.radius});
  column({{0, 0, ground.z - 0.01}, {0, 0, h}}, r);
  if (p.flag("arms", true)) {
    const double z = between(ground.z, h, 0.3);
    column(spline({{0.6 * r, 0, z},
                   {0.72 * R - r, 0.03 * R, z + 0.05 * R},
                   {R - 0.75 * r, 0.0, z + 0.12 * h},
                   {R - 0.75 * r, 0, between(z, h, 0.62)}},
                  6),
           0.72 * r);
    column(spline({{-0.6 * r, 0, z + 0.1 * h},
                   {-0.6 * R + 0.6 * r, 0.0, z + 0.13 * h},
                   {-R + 0.7 * r, 0, z + 0.22 * h},
                   {-R + 0.7 * r, 0, between(z, h, 0.85)}},
                  6),
           0.66 * r);
  }
}

// Snake plant: stiff upright swords.
void snakePlant(Builder& b, const Parameters& p) {
  const Ground ground = plantPot(b, p, 0.38);
  b.fitted({b.left(), b.front(), ground.z - 0.01}, {b.right(), b.back(), b.height()}, [&] {
    const double R = std::min(b.width(), b.depth()) / 2, h = b.height();
    b.slot("leaf");
    const int leaves = p.count("leaves", 17);
    for (int i = 0; i < leaves; ++i) {
      const double t = static_cast<double>(i) / leaves, a = i * 2.399,
                   q = 0.85 * ground.radius * std::sqrt(t);
      const double tall = (h - ground.z) * between(1.0, 0.55, t) * between(0.85, 1.0, roll("snake", i)),
                   lean = 1.05 * t * (R - q) / tall,
                   half = between(0.024, 0.034, roll("wide", i)) * std::min(1.4, std::max(0.5, h / 0.8));
      const double twist = a + kPi / 2 + roll("twist", i), turn = 0.5 * (roll("turn", i) - 0.5);
      b.surface(
          [&](double u, double v) {
            const double s = 2 * u - 1,
                         wide = half * std::min(1.0, 0.62 + 0.9 * v) * std::max(0.0, 1 - std::pow(v, 2.6));
            const double at = twist + turn * v;
            const double wave = 0.006 * std::sin(9 * v + i);
            return Vec3{q * std::cos(a) + s * wide * std::cos(at) + std::cos(a) * lean * v * v * tall -
                            std::sin(at) * (0.35 * half * s * s + wave),
                        q * std::sin(a) + s * wide * std::sin(at) + std::sin(a) * lean * v * v * tall +
                            std::cos(at) * (0.35 * half * s * s + wave),
                        ground.z - 0.01 + tall * v};
          },
          6, 14, 0.003);
    }
  });
}

// Basil and its kin: a dense tuft of small leaves.
void herb(Builder& b, const Parameters& p) {
  const Ground ground = plantPot(b, p, 0.5);
  b.fitted({b.left(), b.front(), ground.z - 0.01}, {b.right(), b.back(), b.height()}, [&] {
    const double R = std::min(b.width(), b.depth()) / 2, h = b.height();
    const int stems = p.count("stems", 15);
    for (int s = 0; s < stems; ++s) {
      const double t = static_cast<double>(s) / stems, a = s * 2.399;
      const double top = between(0.97, 0.7, t) * h, reach = 0.72 * R * std::sqrt(t);
      const Path stem =
          spline({onCircle(a, 0.6 * ground.radius * std::sqrt(t), ground.z - 0.005),
                  onCircle(a, 0.75 * reach, between(ground.z, top, 0.6)), onCircle(a + 0.2, reach, top)},
                 4);
      b.slot("stem");
      b.tube(
          stem, [&](double u) { return (0.008 - 0.005 * u) * h * 0.6; }, 6);
      b.slot("leaf");
      const int levels = 4;
      for (int k = 0; k < levels; ++k) {
        const double u = between(0.35, 1.0, static_cast<double>(k) / (levels - 1));
        for (int m = 0; m < 3; ++m) {
          const double d = a + m * 2.1 + k * 1.05,
                       size = between(0.2, 0.13, u) * h * between(0.8, 1.2, roll("herb", 12 * s + 3 * k + m)),
                       rise = between(0.2, 0.7, u);
          b.leaf(along(stem, u), {std::cos(d) * std::cos(rise), std::sin(d) * std::cos(rise), std::sin(rise)},
                 {0, 0, 1},
                 {.length = size,
                  .width = 0.62 * size,
                  .droop = 1.0,
                  .fold = -0.25,
                  .widest = 0.42,
                  .tip = 1.0,
                  .segments = 6});
        }
      }
    }
  });
}

// A vase of cut flowers: "tulip" or "daisy".
void flowerVase(Builder& b, const Parameters& p) {
  const double R = std::min(b.width(), b.depth()) / 2, h = b.height();
  const double tall = 0.52 * h, r = std::min(0.52 * R, 0.24 * h), neck = 0.5 * r;
  b.slot("vase");
  b.lathe({},
          spline2({{0, 0},
                   {0.6 * r, 0},
                   {0.72 * r, 0.02 * tall},
                   {0.95 * r, 0.25 * tall},
                   {r, 0.42 * tall},
                   {0.8 * r, 0.68 * tall},
                   {neck, 0.88 * tall},
                   {1.15 * neck, tall - 0.001},
                   {1.12 * neck, tall},
                   {1.06 * neck, tall - 0.002},
                   {0.92 * neck, 0.88 * tall},
                   {0.7 * r, 0.68 * tall},
                   {0.9 * r, 0.42 * tall},
                   {0.84 * r, 0.25 * tall},
                   {0.5 * r, 0.05 * tall},
                   {0, 0.05 * tall}},
                  4),
          40);
  const int flowers = p.count("flowers", 9);
  const bool tulip = p.text("style", "tulip") == "tulip";
  for (int i = 0; i < flowers; ++i) {
    const double t = static_cast<double>(i) / flowers, a = i * 2.399;
    const double reach = 0.8 * R * std::sqrt(t), top = between(0.93, 0.72, t) * h,
                 head = std::min(0.2 * R + 0.018, 0.12 * h);
    const Path stem = spline(
        {onCircle(a + 2.6, 0.3 * r * std::sqrt(t), 0.1 * tall), onCircle(a, 0.55 * neck * std::sqrt(t), tall),
         onCircle(a, 0.6 * reach, between(tall, top, 0.6)), onCircle(a, reach, top - 0.6 * head)},
        6);
    b.slot("stem");
    b.tube(stem, 0.0026, 7);
    const Vec3 at = stem.back(), d = normalized(at - stem[stem.size() - 4]);
    const Transform frame = facing(at, d);
    b.slot("petal");
    b.within(frame, [&] {
      if (tulip) {
        for (int k = 0; k < 6; ++k) {
          const double c = 2 * kPi * k / 6, in = k % 2 ? 0.9 : 1.0;
          b.surface(
              [&](double u, double v) {
                const double s = (2 * u - 1) * 0.62 * std::sqrt(std::max(0.0, 1 - std::pow(v, 4))),
                             ring = 0.45 * head * in * std::sin(kPi * (0.12 + 0.6 * v)) + 0.001;
                return Vec3{ring * std::cos(c + s), ring * std::sin(c + s),
                            1.15 * head * v * (1 - 0.06 * s * s)};
              },
              6, 8);
        }
      } else {
        for (int k = 0; k < 16; ++k)
          b.leaf(onCircle(2 * kPi * k / 16, 0.14 * head), onCircle(2 * kPi * k / 16, 1, 0.25), {0, 0, 1},
                 {.length = 0.6 * head,
                  .width = 0.2 * head,
                  .droop = 0.5,
                  .fold = 0.12,
                  .widest = 0.6,
                  .tip = 0.7,
                  .segments = 5});
        b.slot("heart");
        b.ellipsoid({}, {0.2 * head, 0.2 * head, 0.11 * head}, 14);
      }
    });
    b.slot("leaf");
    if (i % 2 == 0) {
      const Vec3 from = along(stem, 0.62);
      b.leaf(from, Vec3{std::cos(a + 1), std::sin(a + 1), 1.6}, {std::cos(a + 1), std::sin(a + 1), -0.2},
             {.length = 0.28 * h,
              .width = 0.05 * h,
              .droop = -0.9,
              .fold = 0.35,
              .widest = 0.4,
              .tip = 1.1,
              .segments = 8});
    }
  }
}

}  // namespace

void addPlants(Generators& to) {
  to["ficus"] = ficus;
  to["monstera"] = monstera;
  to["palm"] = palm;
  to["rosette"] = rosette;
  to["cactus"] = cactus;
  to["snakePlant"] = snakePlant;
  to["herb"] = herb;
  to["flowerVase"] = flowerVase;
}

}  // namespace idap::parametric
