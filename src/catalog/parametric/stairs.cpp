// Stairs. They rise from the front to the back; the box holds the flight and its railing, so that the upper
// floor lies `railing` below its top.
#include <algorithm>
#include <cmath>

#include "catalog/parametric/casework.h"

namespace idap::parametric {

namespace {

constexpr double kTread = 0.04;  // m thick

struct Flight {
  int risers;
  double rise, going;
};

Flight flightOf(const Parameters& p, double height, double run) {
  // The last riser ends on the upper floor: one tread fewer than risers.
  const int risers = std::max(2, p.count("steps", 0) > 1 ? p.count("steps", 0) : fitting(height, 0.178, 60));
  return {risers, height / risers, run / (risers - 1)};
}

// Posts, balusters and a handrail along a line that climbs from a to b (on the tread noses).
void railing(Builder& b, Vec3 from, Vec3 to, double high, int balusters) {
  b.slot("rail");
  const Vec3 up{0, 0, high};
  const Vec3 way = (to - from) * (1 / length(to - from));
  b.sweep({from + up - way * 0.02, to + up}, roundedRectangle({-0.021, -0.035}, {0.021, 0}, 0.012, 4));
  b.slot("baluster");
  for (int i = 0; i < balusters; ++i) {
    const Vec3 at = from + (to - from) * ((i + 0.5) / balusters);
    b.rod(at, at + Vec3{0, 0, high - 0.02}, 0.008, 8);
  }
  b.slot("rail");
  for (const Vec3& at : {from + way * 0.03, to - way * 0.03})
    b.box(at - Vec3{0.025, 0.025, at.z > 0.3 ? 0.2 : at.z}, at + Vec3{0.025, 0.025, high - 0.015}, 0.004,
          Grain::Z);
}

void straight(Builder& b, const Parameters& p) {
  const double rail = std::min(p.number("railing", 0.9), 0.4 * b.height()), h = b.height() - rail;
  const bool closed = p.flag("closed");
  const std::string sides = p.text("sides", "both");
  const Flight f = flightOf(p, h, b.depth());
  const double string = 0.045, x0 = b.left() + string, x1 = b.right() - string;
  const double nose = closed ? 0.02 : 0.03;
  for (int i = 0; i + 1 < f.risers; ++i) {
    const double y = b.front() + f.going * i, z = f.rise * (i + 1);
    b.slot("tread");
    const double y0 = i == 0 ? y : y - nose;
    b.box({closed ? b.left() : x0 - 0.012, y0, z - kTread},
          {closed ? b.right() : x1 + 0.012, y + f.going + (closed ? 0.001 : 0), z}, 0.006, Grain::X);
    if (closed) {
      b.slot("riser");
      b.box({b.left() + 0.004, y + 0.004, z - f.rise}, {b.right() - 0.004, y + 0.022, z - kTread + 0.001},
            0.001, Grain::X);
    }
  }
  b.slot(closed ? "wall" : "string");
  if (closed) {
    b.slot("riser");
    b.box({b.left() + 0.004, b.back() - 0.02, h - f.rise}, {b.right() - 0.004, b.back(), h}, 0.001, Grain::X);
    // Solid below: cheeks cut to the steps.
    b.slot("wall");
    Polygon cheek{{b.front() + 0.004, 0}};
    for (int i = 0; i + 1 < f.risers; ++i) {
      cheek.push_back({b.front() + f.going * i + 0.004, f.rise * (i + 1) - kTread});
      cheek.push_back({b.front() + f.going * (i + 1) + 0.004, f.rise * (i + 1) - kTread});
    }
    const double thick = 0.18;
    cheek.back().x = b.back();
    cheek.push_back({b.back(), std::max(0.0, f.rise * (f.risers - 1) - kTread - thick - 0.12)});
    const double slope = f.rise / f.going;
    cheek.push_back({b.front() + std::min(0.5 * b.depth(), (thick + 0.12) / slope + 0.02), 0});
    b.extrudeAlongX(cheek, b.left() + 0.006, b.right() - 0.006, 0);
  } else {
    const double slope = f.rise / f.going, w = 0.26;
    // Strings run along the pitch, cut level at the floor and plumb at the top.
    const double lift = f.rise + 0.03;
    const Polygon side{{b.front(), 0},       {b.front() + w / slope * 0.9, 0},
                       {b.back(), h - w},    {b.back(), h},
                       {b.back() - 0.02, h}, {b.front(), lift}};
    b.mirroredX([&] { b.extrudeAlongX(side, x1, b.right(), 0.003); });
  }
  const double z1 = h, lean = closed ? 0.0 : 0.02;
  const Vec3 foot{0, b.front() + 0.03, f.rise + lean}, head{0, b.back() - 0.03, z1};
  for (const double s : {-1.0, 1.0}) {
    if ((s < 0 && sides == "right") || (s > 0 && sides == "left") || sides == "none") continue;
    const Vec3 by{s * (b.width() / 2 - 0.028), 0, 0};
    railing(b, foot + by, head + by, rail, std::max(2, (f.risers - 1) * 2));
  }
}

// Winds clockwise or counter-clockwise around a post; each tread a wedge.
void spiral(Builder& b, const Parameters& p) {
  const double rail = std::min(p.number("railing", 0.95), 0.4 * b.height()), h = b.height() - rail;
  const int risers = std::max(3, p.count("steps", 0) > 2 ? p.count("steps", 0) : fitting(h, 0.19, 40));
  const double turn = p.number("turn", 360) * kPi / 180 * (p.flag("clockwise") ? -1 : 1);
  const double step = turn / risers, rise = h / risers, radius = std::min(b.width(), b.depth()) / 2,
               post = 0.055;
  const Transform fit = Transform::scaling({b.width() / 2 / radius, b.depth() / 2 / radius, 1});
  b.within(fit, [&] {
    b.slot("post");
    b.cylinder({}, post, b.height(), 0.004, 32);
    b.cylinder({}, 2.2 * post, 0.012, 0.003, 32);
    const double outer = radius, start = -kPi / 2;
    const auto nose = [&](double i, double r) {
      return Vec2{r * std::cos(start + step * i), r * std::sin(start + step * i)};
    };
    for (int i = 0; i < risers; ++i) {
      const double z = rise * (i + 1), over = 0.12;
      Polygon wedge = arc({}, outer, start + step * (i - over), start + step * (i + 1), 8);
      const Vec2 a = nose(i + 1.0, post * 0.9), c = nose(i - over, post * 0.9);
      wedge.push_back(a);
      wedge.push_back(c);
      const bool last = i + 1 == risers;
      if (last) {  // a landing, a little wider than a tread
        wedge = arc({}, outer, start + step * (i - over), start + step * (i + 1.6), 12);
        wedge.push_back(nose(i + 1.6, post * 0.9));
        wedge.push_back(c);
      }
      b.slot("tread");
      b.extrude(wedge, z - kTread, kTread, 0.004);
      b.slot("post");
      b.cylinder({0, 0, z - kTread - 0.03}, 1.45 * post, kTread + 0.034, 0.004, 28);
      b.slot("baluster");
      for (const double f : {0.08, 0.58}) {
        const Vec2 at = nose(i + f, outer - 0.03);
        b.rod({at.x, at.y, z - 0.01}, {at.x, at.y, z + rail - 0.03 + rise * (f - 0.5)}, 0.009, 8);
      }
    }
    b.slot("rail");
    Path path;
    const int n = risers * 4;
    for (int i = 0; i <= n; ++i) {
      const double k = risers * static_cast<double>(i) / n;
      const Vec2 at = nose(k, outer - 0.03);
      path.push_back({at.x, at.y, std::min(h + rail - 0.024, rise * (k + 0.5) + rail - 0.03)});
    }
    b.tube(path, 0.022, 14);
  });
}

// Two flights at a right angle with a landing between them: up to the back, then to the right.
void quarterTurn(Builder& b, const Parameters& p) {
  const double rail = std::min(p.number("railing", 0.9), 0.4 * b.height()), h = b.height() - rail;
  const double w = std::min({p.number("flight", 0.95), 0.6 * b.width(), 0.6 * b.depth()});
  const double run1 = b.depth() - w, run2 = b.width() - w;
  const int risers = std::max(4, fitting(h, 0.178, 60));
  // As many risers to a flight as its run asks for.
  const int first = std::clamp(static_cast<int>(std::lround(risers * run1 / (run1 + run2))), 2, risers - 2);
  const double rise = h / risers, landing = rise * first;
  const double left = b.left(), back = b.back();
  const auto flight = [&](int steps, double run, double z0, bool railLeft,
                          bool railRight) {  // along +y from the origin, x centred
    const double going = run / steps;
    for (int i = 0; i < steps; ++i) {
      const double y = going * i, z = z0 + rise * (i + 1);
      b.slot("tread");
      b.box({-w / 2, std::max(0.0, y - 0.02), z - kTread}, {w / 2, y + going, z}, 0.005, Grain::X);
      b.slot("riser");
      b.box({-w / 2 + 0.004, y + 0.003, z - rise}, {w / 2 - 0.004, y + 0.02, z - kTread + 0.001}, 0.001,
            Grain::X);
    }
    b.slot("string");
    const double slope = rise / going;
    b.mirroredX([&] {
      b.extrudeAlongX({{0.0, std::max(0.0, z0 - 0.12)},
                       {z0 > 0 ? 0.0 : 0.22 / slope, std::max(0.0, z0 - 0.12)},
                       {run, z0 + rise * steps - 0.3},
                       {run, z0 + rise * steps},
                       {run - 0.02, z0 + rise * steps},
                       {0.0, z0 + rise}},
                      w / 2 - 0.04, w / 2 + 0.0005, 0.002);
    });
    const Vec3 foot{0, 0.03, z0 + rise}, head{0, run - 0.03, z0 + rise * (steps + 1)};
    if (railLeft)
      railing(b, foot + Vec3{-w / 2 + 0.03, 0, 0}, head + Vec3{-w / 2 + 0.03, 0, 0}, rail, steps * 2);
    if (railRight)
      railing(b, foot + Vec3{w / 2 - 0.03, 0, 0}, head + Vec3{w / 2 - 0.03, 0, 0}, rail, steps * 2);
  };
  b.at({left + w / 2, b.front(), 0}, [&] { flight(first - 1, run1, 0, false, true); });
  b.slot("tread");
  b.box({left, back - w - 0.02, landing - kTread}, {left + w, back, landing}, 0.005, Grain::X);
  b.slot("riser");
  b.box({left + 0.004, back - w + 0.003, landing - rise},
        {left + w - 0.004, back - w + 0.02, landing - kTread + 0.001}, 0.001, Grain::X);
  b.slot("string");
  b.box({left + 0.01, back - w, landing - kTread - 0.16},
        {left + w - 0.01, back - 0.002, landing - kTread + 0.001}, 0.002);
  b.box({left + 0.01, back - 0.08, 0}, {left + 0.08, back - 0.01, landing - kTread}, 0.003, Grain::Z);
  b.within(Transform::translation({left + w, back - w / 2, 0}) * Transform::rotationZ(-kPi / 2),
           [&] { flight(risers - first - 1, run2, landing, false, true); });
  b.slot("riser");
  b.box({b.right() - 0.018, back - w, h - rise}, {b.right(), back, h}, 0.001, Grain::Y);
}

}  // namespace

void addStairs(Generators& to) {
  to["straightStairs"] = straight;
  to["spiralStairs"] = spiral;
  to["quarterTurnStairs"] = quarterTurn;
}

}  // namespace idap::parametric
