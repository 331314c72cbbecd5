// Dressing tables with real mirrors, their stools, and mirrors to stand or hang.
#include <algorithm>
#include <cmath>

#include "catalog/parametric/casework.h"

namespace idap::parametric {

namespace {

// A mirror in a moulded frame of any closed outline, facing -y, around the origin of x-z.
void framedMirror(Builder& b, const Polygon& outline, double frame, double depth) {
  b.slot("frame");
  Path path = atDepth(outline, 0);
  const double r = frame / 2;
  b.sweep(path, ellipse({}, {r, depth / 2}, 14), {0, -1, 0}, true);
  b.slot("frame");
  b.extrudeAlongY(outline, 0.001, depth / 2 - 0.0005, 0);
  b.slot("mirror");
  Mesh glass;
  Vec2 middle;
  for (const Vec2 q : outline) middle += q / static_cast<double>(outline.size());
  const auto vertex = [&](Vec2 q) {
    glass.positions.push_back(toFloat(Vec3{q.x, -0.001, q.y}));
    glass.uvs.push_back(toFloat(q));
  };
  vertex(middle);
  for (const Vec2 q : outline) vertex(q);
  const auto n = static_cast<std::uint32_t>(outline.size());
  for (std::uint32_t i = 0; i < n; ++i) glass.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  b.add(std::move(glass));
}

void dressingTable(Builder& b, const Parameters& p) {
  const std::string mirror = p.text("mirror", "oval");
  const double table = std::min(p.number("tableHeight", 0.76), 0.7 * b.height()), t = 0.022;
  const double box = p.number("drawerHeight", 0.13);
  FrontStyle style;
  style.style = p.text("front", "flat");
  style.pull = pullNamed(p.text("handle", "knob"));
  const double face = b.front() + std::max(0.012, pullDepth(style.pull)), inner = face + 0.021;
  const double x0 = b.left() + 0.012, x1 = b.right() - 0.012;
  b.slot("wood");
  b.box({b.left(), b.front() + 0.002, table - t}, {b.right(), b.back(), table}, 0.005, Grain::X);
  // Pedestals of drawers, or an apron on legs.
  const int drawers = std::clamp(p.count("drawers", 2), 1, 8);
  if (p.flag("pedestals")) {
    const double w = std::min(0.34, 0.3 * b.width());
    b.mirroredX([&] {
      b.slot("wood");
      carcass(b, {x1 - w, inner, 0.06}, {x1, b.back() - 0.01, table - t});
      feet(b, "plinth", {x1 - w, inner, 0}, {x1, b.back(), 0}, 0.06);
      for (int i = 0; i < drawers; ++i) {
        const double h = (table - t - 0.062) / drawers;
        drawer(b, {x1 - w, 0.06 + h * i, x1, 0.06 + h * (i + 1)}, face, style);
      }
    });
    b.slot("wood");
    b.box({x0 + w, b.back() - 0.04, table - t - 0.25}, {x1 - w, b.back() - 0.022, table - t}, 0.001,
          Grain::X);
  } else {
    b.slot("wood");
    const double z = table - t - box;
    carcass(b, {x0, inner, z}, {x1, b.back() - 0.01, table - t + 0.001}, {0.016, 0.006, false, false});
    for (int i = 0; i < drawers; ++i)
      drawer(b, {x0 + (x1 - x0) * i / drawers, z, x0 + (x1 - x0) * (i + 1) / drawers, table - t - 0.001},
             face, style);
    b.slot("legs");
    const LegShape shape = p.text("legs", "round") == "turned" ? LegShape::Turned : LegShape::Round;
    const double in = 0.045;
    b.mirroredX([&] {
      b.leg({x1 - in, inner + in, z + 0.002}, {x1 - 0.6 * in, inner + 0.5 * in, 0}, 0.021, 0.012, shape);
      b.leg({x1 - in, b.back() - 0.01 - in, z + 0.002}, {x1 - 0.6 * in, b.back() - 0.01 - 0.5 * in, 0}, 0.021,
            0.012, shape);
    });
  }
  const double room = b.height() - table, y = b.back() - 0.03;
  if (room < 0.2) return;
  if (mirror == "trifold") {
    const double high = room - 0.02, mid = 0.46 * b.width(), wing = 0.25 * b.width();
    b.slot("frame");
    b.box({-mid / 2, y - 0.03, table - 0.001}, {mid / 2, y + 0.012, table + 0.022}, 0.003, Grain::X);
    b.at({0, y, table + 0.02}, [&] {
      const auto outline = [&](double w, double h) {
        return fillet({{-w / 2 + 0.009, 0.009},
                       {w / 2 - 0.009, 0.009},
                       {w / 2 - 0.009, h - 0.009},
                       {-w / 2 + 0.009, h - 0.009}},
                      0.06, 6);
      };
      framedMirror(b, outline(mid, high), 0.018, 0.02);
      b.mirroredX([&] {
        b.within(Transform::translation({mid / 2 + 0.004, -0.002, 0}) * Transform::rotationZ(-0.5) *
                     Transform::translation({wing / 2, 0, 0}),
                 [&] { framedMirror(b, outline(wing, 0.9 * high), 0.016, 0.018); });
      });
    });
  } else if (mirror == "round" || mirror == "oval") {
    const double rz = 0.5 * (room - 0.06) - 0.011,
                 rx = std::min(mirror == "round" ? rz : 0.72 * rz, 0.44 * b.width());
    const double cz = b.height() - rz - 0.011;
    b.at({0, y, cz}, [&] { framedMirror(b, ellipse({}, {rx, rz}, 64), 0.022, 0.022); });
    b.slot("frame");
    b.mirroredX([&] {  // arms that hold it
      b.tube(spline({{0.55 * rx, y + 0.008, table},
                     {rx * 0.9, y + 0.008, table + 0.3 * (cz - table)},
                     {rx + 0.018, y + 0.004, cz - 0.2 * rz},
                     {rx + 0.014, y, cz}},
                    8),
             0.008, 10);
      b.sphere({rx + 0.014, y, cz}, 0.012, 12);
    });
  } else {
    const double w = 0.4 * b.width();
    b.at({0, y, table}, [&] {
      framedMirror(b, fillet({{-w, 0.012}, {w, 0.012}, {w, room - 0.012}, {-w, room - 0.012}}, 0.02, 3), 0.02,
                   0.022);
    });
  }
}

void stool(Builder& b, const Parameters& p) {
  const double pad = std::min(0.1, 0.25 * b.height()), h = b.height();
  const bool round = p.flag("round");
  b.slot("fabric");
  if (round) {
    const double r = std::min(b.width(), b.depth()) / 2;
    b.within(Transform::scaling({b.width() / 2 / r, b.depth() / 2 / r, 1}), [&] {
      b.lathe({0, 0, h - pad},
              spline2({{0, 0},
                       {0.85 * r, 0},
                       {0.98 * r, 0.2 * pad},
                       {r, 0.55 * pad},
                       {0.93 * r, 0.86 * pad},
                       {0.6 * r, 0.98 * pad},
                       {0, pad}},
                      5),
              40);
    });
  } else {
    Soft soft;
    soft.radius = 0.035;
    soft.crown = 0.02;
    soft.tuftColumns = p.flag("tufted") ? 4 : 0;
    soft.tuftRows = p.flag("tufted") ? 3 : 0;
    soft.tuftFace = {0, 0, 1};
    soft.segments = p.flag("tufted") ? 28 : 10;
    b.cushion({b.left(), b.front(), h - pad}, {b.right(), b.back(), h}, soft);
  }
  b.slot("legs");
  const double x = b.width() / 2 * (round ? 0.68 : 0.86), y = b.depth() / 2 * (round ? 0.68 : 0.82);
  if (!round) {
    b.mirroredY([&] {
      b.box({-x, y - 0.01, h - pad - 0.045}, {x, y + 0.01, h - pad + 0.006}, 0.002, Grain::X);
    });
    b.mirroredX([&] {
      b.box({x - 0.01, -y + 0.01, h - pad - 0.045}, {x + 0.01, y - 0.01, h - pad + 0.006}, 0.002, Grain::Y);
    });
  }
  b.mirroredXY([&] { b.leg({x, y, h - pad + 0.01}, {x + 0.02, y + 0.02, 0}, 0.019, 0.011); });
}

// A tall mirror that leans in its stand, or hangs on the wall.
void mirror(Builder& b, const Parameters& p) {
  const std::string shape = p.text("shape", "rectangle");
  const double frame = p.number("frame", 0.03), w = b.width() / 2 - frame / 2, h = b.height();
  const auto outline = [&](double z0, double z1) {
    if (shape == "round") return ellipse({0, (z0 + z1) / 2}, {w, (z1 - z0) / 2}, 72);
    if (shape == "arch") {
      Polygon arch{{-w, z0}, {w, z0}};
      for (int i = 0; i <= 32; ++i)
        arch.push_back({w * std::cos(kPi * i / 32), z1 - w + w * std::sin(kPi * i / 32)});
      return arch;
    }
    return fillet({{-w, z0}, {w, z0}, {w, z1}, {-w, z1}}, p.number("radius", 0.01), 8);
  };
  if (!p.flag("standing")) {
    b.at({0, b.back() - b.depth() / 2, 0},
         [&] { framedMirror(b, outline(frame / 2, h - frame / 2), frame, b.depth()); });
    return;
  }
  const double lean = std::atan2(0.3 * b.depth(), h), depth = 0.03;
  b.within(Transform::translation({0, b.front() + depth / 2, 0}) * Transform::rotationX(-lean),
           [&] { framedMirror(b, outline(frame / 2, h / std::cos(lean) - frame / 2), frame, depth); });
  b.slot("frame");  // the prop behind
  b.mirroredX([&] {
    b.rod({0.7 * w, b.front() + 0.24 * b.depth() + 0.035, 0.72 * h}, {0.85 * w, b.back() - 0.012, 0.008},
          0.011);
  });
  b.rod({-0.85 * w, b.back() - 0.02, 0.12 * h}, {0.85 * w, b.back() - 0.02, 0.12 * h}, 0.008);
}

}  // namespace

void addVanities(Generators& to) {
  to["dressingTable"] = dressingTable;
  to["vanityStool"] = stool;
  to["mirror"] = mirror;
}

}  // namespace idap::parametric
