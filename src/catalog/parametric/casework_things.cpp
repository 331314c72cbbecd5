// What belongs to cases but is not joinery: books, ornaments, taps, basins.
#include <algorithm>
#include <array>
#include <cmath>

#include "catalog/parametric/casework.h"

namespace idap::parametric {

namespace {

const std::array<const char*, 4> kBookSlots{"book-a", "book-b", "book-c", "book-d"};

// Standing at the origin's right, spine to -y.
void book(Builder& b, double thick, double deep, double tall, int seed) {
  b.slot(kBookSlots[static_cast<std::size_t>(seed) % kBookSlots.size()]);
  const double board = 0.0022;
  b.box({0, 0, 0}, {thick, 0.0035, tall}, 0.0015);
  b.box({0, 0.003, 0}, {board, deep, tall}, 0);
  b.box({thick - board, 0.003, 0}, {thick, deep, tall}, 0);
  b.slot("paper");
  b.box({board, 0.003, 0.003}, {thick - board, deep - 0.004, tall - 0.004}, 0);
}

}  // namespace

void books(Builder& b, double x0, double x1, double y, double z, double depth, double room, int seed,
           double fill) {
  for (const char* name : kBookSlots) b.slot(name);  // the same slots however many fit
  b.slot("paper");
  double x = x0 + 0.004;
  const double end = x0 + (x1 - x0) * fill;
  int key = seed * 971;
  // Runs of one height, as sets of books have.
  double tall = 0, deep = 0;
  int run = 0, color = 0;
  while (true) {
    if (run-- <= 0) {
      run = 1 + static_cast<int>(5 * Builder::random(++key));
      tall = std::min(room - 0.015, 0.17 + 0.13 * Builder::random(++key));
      deep = std::min(depth - 0.01, 0.62 * tall + 0.03 * Builder::random(++key));
      color = static_cast<int>(4 * Builder::random(++key));
    }
    const double thick = 0.014 + 0.028 * Builder::random(++key);
    if (x + thick > end) break;
    if (Builder::random(++key) < 0.45) color = static_cast<int>(4 * Builder::random(++key));
    b.at({x, y + 0.004 * Builder::random(++key), z},
         [&] { book(b, thick, deep, tall - 0.012 * Builder::random(++key), color); });
    x += thick + 0.0008;
  }
  // The last one leans where there is room.
  const double lean = 0.22, h = std::min(room - 0.02, 0.21), thick = 0.024;
  if (x1 - x > h * std::sin(lean) + thick + 0.02) {
    b.within(Transform::translation({x + 0.003 + h * std::sin(lean), y, z}) * Transform::rotationY(-lean),
             [&] { book(b, thick, std::min(depth - 0.01, 0.15), h, seed); });
  }
}

void bookPile(Builder& b, Vec3 base, int seed) {
  double z = 0;
  for (int i = 0; i < 3; ++i) {
    const double t = 0.02 + 0.014 * Builder::random(seed * 37 + i), w = 0.25 - 0.02 * i;
    b.within(Transform::translation(base + Vec3{-w / 2, -0.08, z}) * Transform::rotationY(kPi / 2) *
                 Transform::translation({-t, 0, 0}),
             [&] { book(b, t, 0.16, w, seed + i); });
    z += t;
  }
}

void ornament(Builder& b, Vec3 base, double room, int seed) {
  const int kind = static_cast<int>(3 * Builder::random(seed * 37 + 5));
  const double h = std::min(0.8 * room, 0.16 + 0.1 * Builder::random(seed * 37 + 6));
  b.slot("vase");
  if (kind == 0) {
    const double r = 0.3 * h;
    b.lathe(base, spline2({{0, 0},
                           {0.62 * r, 0},
                           {r, 0.3 * h},
                           {0.85 * r, 0.62 * h},
                           {0.34 * r, 0.86 * h},
                           {0.46 * r, h},
                           {0.4 * r, 0.995 * h},
                           {0.26 * r, 0.86 * h},
                           {0, 0.82 * h}},
                          5));
  } else if (kind == 1) {
    const double r = 0.55 * h;
    b.lathe(base, spline2({{0, 0},
                           {0.5 * r, 0},
                           {0.5 * r, 0.05 * h},
                           {0.9 * r, 0.3 * h},
                           {r, 0.5 * h},
                           {0.95 * r, 0.5 * h},
                           {0.8 * r, 0.3 * h},
                           {0.4 * r, 0.1 * h},
                           {0, 0.08 * h}},
                          4));
  } else {
    b.sphere(base + Vec3{0, 0, 0.28 * h}, 0.28 * h);
  }
}

void tap(Builder& b, Vec3 base, double height, double reach) {
  b.at(base, [&] {
    b.cylinder({0, 0, 0}, 0.025, 0.008, 0.002);
    const double r = 0.011, rise = height - r, bow = std::min(0.5 * reach, 0.3 * height);
    Path path{{0, 0, 0}, {0, 0, rise - bow}};
    for (int i = 1; i <= 10; ++i) {
      const double a = kPi * i / 10 * 0.95;
      path.push_back({0, -reach / 2 * (1 - std::cos(a)), rise - bow + bow * std::sin(a)});
    }
    b.tube(spline(path, 3), r, 14, Cap::Flat);
    b.cylinder({0, 0, 0.006}, 0.018, 0.05, 0.003);
    // The lever, to the right.
    b.rod({0.012, 0, 0.04}, {0.034, 0, 0.04}, 0.009);
    b.tube({{0.03, 0, 0.04}, {0.05, -0.012, 0.075}, {0.062, -0.02, 0.1}}, 0.0042, 8);
  });
}

void basin(Builder& b, Vec2 c, Vec2 half, double z, double depth, double exponent, double wall) {
  // From the rim's outer edge over the rim down the inside to the waste.
  const auto ring = [&](double scale, double drop, double grow) {
    return atHeight(superellipse(c, {half.x * scale + grow, half.y * scale + grow}, exponent, 48), z - drop);
  };
  std::vector<Path> rings{ring(1, 0.012, wall), ring(1, 0.003, wall), ring(1, 0, wall - 0.003),
                          ring(1, 0, 0.002), ring(1, 0.004, -0.001)};
  for (const auto& [s, d] :
       {std::pair{0.985, 0.2}, {0.96, 0.5}, {0.9, 0.78}, {0.78, 0.93}, {0.5, 0.985}, {0.08, 1.0}})
    rings.push_back(ring(s, depth * d, 0));
  b.loft(rings, false, 1.2);
}

}  // namespace idap::parametric
