#include "catalog/parametric/casework.h"

#include <algorithm>
#include <cmath>

namespace idap::parametric {

void sheet(Builder& b, const Pane& p, double y) {
  Mesh mesh;
  for (const auto& [x, z] : {std::pair{p.x0, p.z0}, {p.x1, p.z0}, {p.x1, p.z1}, {p.x0, p.z1}}) {
    mesh.positions.push_back(toFloat(Vec3{x, y, z}));
    mesh.uvs.push_back(toFloat(Vec2{x, z}));
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  b.add(std::move(mesh));
}

void bars(Builder& b, const Pane& o, double y0, double y1, double stile, double topRail, double bottomRail,
          double bevel) {
  const double hair = 0.0004;
  b.box({o.x0, y0, o.z0}, {o.x0 + stile, y1, o.z1}, bevel, Grain::Z);
  b.box({o.x1 - stile, y0, o.z0}, {o.x1, y1, o.z1}, bevel, Grain::Z);
  const double x0 = o.x0 + stile - bevel, x1 = o.x1 - stile + bevel;
  if (topRail > 0) b.box({x0, y0 + hair, o.z1 - topRail}, {x1, y1 - hair, o.z1}, bevel, Grain::X);
  if (bottomRail > 0) b.box({x0, y0 + hair, o.z0}, {x1, y1 - hair, o.z0 + bottomRail}, bevel, Grain::X);
}

Pull pullNamed(const std::string& name) {
  if (name == "none") return Pull::None;
  if (name == "knob") return Pull::Knob;
  if (name == "cup") return Pull::Cup;
  if (name == "edge") return Pull::Edge;
  return Pull::Bar;
}

double pullDepth(Pull pull) {
  switch (pull) {
    case Pull::None:
      return 0;
    case Pull::Knob:
      return 0.0266;
    case Pull::Bar:
      return 0.035;
    case Pull::Cup:
      return 0.0325;
    case Pull::Edge:
      return 0.014;
  }
  return 0;
}

namespace {

// The board of a door or drawer. Rails narrower than the pane allows become a flat board.
void frontBoard(Builder& b, const Pane& p, double y, const FrontStyle& s, const std::string& style) {
  const double y1 = y + s.thickness;
  const double stile = std::min(0.065, 0.22 * std::min(p.width(), p.height()));
  b.slot(s.slot);
  if (style == "shaker" || style == "panelled") {
    if (style == "panelled" && p.height() > 1.2) {  // two fields, the lower one shorter
      const double split = p.z0 + 0.4 * p.height();
      bars(b, p, y, y1, stile, stile, stile);
      b.box({p.x0 + stile - 0.002, y + 0.0004, split - stile / 2},
            {p.x1 - stile + 0.002, y1 - 0.0004, split + stile / 2}, 0.002, Grain::X);
      b.box({p.x0 + stile - 0.003, y + 0.009, p.z0 + stile - 0.003},
            {p.x1 - stile + 0.003, y1 - 0.002, p.z1 - stile + 0.003}, 0, Grain::Z);
      for (const Pane& field :
           {Pane{p.x0, p.z0, p.x1, split + stile / 2}, Pane{p.x0, split - stile / 2, p.x1, p.z1}}) {
        const Pane raised = field.inset(stile + 0.022);
        if (raised.width() > 0.05 && raised.height() > 0.05)
          b.box({raised.x0, y + 0.004, raised.z0}, {raised.x1, y + 0.012, raised.z1}, 0.0035, Grain::Z);
      }
      return;
    }
    Builder::FramedPanel frame;
    frame.stile = stile;
    frame.setBack = 0.008;
    b.framedPanel({p.x0, y, p.z0}, {p.x1, y1, p.z1}, frame);
  } else if (style == "glass" || style == "mirror" || style == "cane") {
    const double edge = style == "mirror" ? 0.012 : std::min(stile, 0.05);
    bars(b, p, y, y1, edge, edge, edge, 0.002);
    b.slot(style);
    if (style == "cane") {
      const Pane q = p.inset(edge - 0.003);
      b.box({q.x0, y + 0.008, q.z0}, {q.x1, y + 0.011, q.z1}, 0);
    } else {
      sheet(b, p.inset(edge - 0.001), y + (style == "mirror" ? 0.002 : s.thickness / 2));
    }
    if (style == "mirror") {
      b.slot(s.slot);
      const Pane q = p.inset(edge - 0.003);
      b.box({q.x0, y + 0.004, q.z0}, {q.x1, y1 - 0.002, q.z1}, 0);
    }
  } else if (style == "slats") {
    b.box({p.x0, y + 0.009, p.z0}, {p.x1, y1, p.z1}, 0.001, Grain::Z);
    const int n = fitting(p.width(), 0.032, 40);
    const double each = p.width() / n;
    for (int i = 0; i < n; ++i)
      b.box({p.x0 + each * i + 0.2 * each, y, p.z0}, {p.x0 + each * (i + 1) - 0.2 * each, y + 0.01, p.z1},
            0.002, Grain::Z);
  } else if (style == "louvre") {
    bars(b, p, y, y1, std::min(stile, 0.05));
    const Pane q = p.inset(std::min(stile, 0.05) - 0.002);
    const int n = fitting(q.height(), 0.035, 64);
    for (int i = 0; i < n; ++i) {
      b.within(Transform::translation({q.midX(), y + s.thickness / 2, q.z0 + q.height() * (i + 0.5) / n}) *
                   Transform::rotationX(-0.6),
               [&] {
                 b.box({-q.width() / 2, -0.003, -0.02}, {q.width() / 2, 0.003, 0.02}, 0.001, Grain::X);
               });
    }
  } else {
    b.box({p.x0, y, p.z0}, {p.x1, y1, p.z1}, 0.0018, p.height() > 0.45 ? Grain::Z : Grain::X);
  }
}

}  // namespace

void door(Builder& b, const Pane& pane, double y, const FrontStyle& s, Hinge hinge, PullAt at) {
  const Pane p = pane.inset(s.gap / 2);
  frontBoard(b, p, y, s, s.style);
  b.slot("handle");
  const double in = s.style == "glass" || s.style == "mirror" ? 0.02 : 0.035;
  if (hinge == Hinge::Top) {
    const double z = p.z0 + 0.04;
    if (s.pull == Pull::Knob) b.knob({p.midX(), y, z});
    if (s.pull == Pull::Bar) b.barPull({p.midX(), y, z}, std::min(0.3, 0.5 * p.width()), false);
    return;
  }
  const double x = hinge == Hinge::Left ? p.x1 - in : p.x0 + in;
  const double reach = std::min(p.height() > 1.2 ? 0.3 : 0.16, 0.6 * p.height());
  const double z = at == PullAt::Top      ? p.z1 - 0.05 - reach / 2
                   : at == PullAt::Bottom ? p.z0 + 0.05 + reach / 2
                                          : std::min(p.midZ(), p.z0 + 1.0);
  switch (s.pull) {
    case Pull::None:
      break;
    case Pull::Knob:
      b.knob({x, y, at == PullAt::Top ? p.z1 - 0.07 : at == PullAt::Bottom ? p.z0 + 0.07 : z});
      break;
    case Pull::Bar:
      b.barPull({x, y, z}, reach, true);
      break;
    case Pull::Cup:
      if (p.height() > 0.9)  // within reach, and where the door is pulled
        b.cupPull({hinge == Hinge::Left ? p.x1 - in - 0.045 : p.x0 + in + 0.045, y, z});
      else
        b.cupPull({p.midX(), y, at == PullAt::Bottom ? p.z0 + 0.05 : p.z1 - 0.05});
      break;
    case Pull::Edge:
      b.box({(hinge == Hinge::Left ? p.x1 : p.x0) - 0.006, y - 0.014, z - reach / 2},
            {(hinge == Hinge::Left ? p.x1 : p.x0) + 0.001, y + 0.002, z + reach / 2}, 0.001);
      break;
  }
}

void drawer(Builder& b, const Pane& pane, double y, const FrontStyle& s) {
  const Pane p = pane.inset(s.gap / 2);
  const bool solid = s.style == "glass" || s.style == "mirror" || s.style == "cane" || s.style == "louvre";
  frontBoard(b, p, y, s, solid || p.height() < 0.11 ? "flat" : s.style);
  b.slot("handle");
  const double z = s.pull == Pull::Bar && p.height() > 0.24 ? p.z1 - 0.06 : p.midZ();
  switch (s.pull) {
    case Pull::None:
      break;
    case Pull::Knob:
      if (p.width() > 0.55)
        for (const double f : {0.22, 0.78}) b.knob({p.x0 + f * p.width(), y, p.midZ()});
      else
        b.knob({p.midX(), y, p.midZ()});
      break;
    case Pull::Bar:
      b.barPull({p.midX(), y, z}, std::clamp(0.4 * p.width(), 0.08, 0.32), false);
      break;
    case Pull::Cup:
      if (p.width() > 0.6)
        for (const double f : {0.25, 0.75}) b.cupPull({p.x0 + f * p.width(), y, p.midZ()});
      else
        b.cupPull({p.midX(), y, p.midZ()});
      break;
    case Pull::Edge: {
      const double half = std::clamp(0.2 * p.width(), 0.04, 0.12);
      b.box({p.midX() - half, y - 0.014, p.z1 - 0.004}, {p.midX() + half, y + 0.004, p.z1 + 0.0012}, 0.0008);
      b.box({p.midX() - half, y - 0.014, p.z1 - 0.014}, {p.midX() + half, y - 0.0115, p.z1 - 0.003}, 0.0008);
      break;
    }
  }
}

void carcass(Builder& b, Vec3 min, Vec3 max, const Carcass& c) {
  const double t = c.board, top = c.topOver ? max.z - t : max.z;
  b.box(min, {min.x + t, max.y, top}, kBevel, Grain::Z);
  b.box({max.x - t, min.y, min.z}, {max.x, max.y, top}, kBevel, Grain::Z);
  const double in = 0.0005;
  b.box({min.x + t - 0.001, min.y + in, min.z}, {max.x - t + 0.001, max.y - in, min.z + t}, kBevel, Grain::X);
  if (c.topOver) {
    b.box({min.x, min.y, max.z - t}, max, kBevel, Grain::X);
  } else if (c.hasTop) {
    b.box({min.x + t - 0.001, min.y + in, max.z - t}, {max.x - t + 0.001, max.y - in, max.z}, kBevel,
          Grain::X);
  }
  if (c.back > 0)
    b.box({min.x + t - 0.002, max.y - 0.004 - c.back, min.z + t - 0.002},
          {max.x - t + 0.002, max.y - 0.004, max.z - t + 0.002}, 0, Grain::Z);
}

void feet(Builder& b, const std::string& style, Vec3 min, Vec3 max, double h) {
  if (style == "none" || h <= 0.002) return;
  b.slot("legs");
  const double w = max.x - min.x, d = max.y - min.y;
  const double cx = (min.x + max.x) / 2, cy = (min.y + max.y) / 2, z = min.z;
  if (style == "plinth") {
    b.box({min.x + 0.002, min.y + 0.045, z}, {max.x - 0.002, max.y - 0.01, z + h + 0.002}, 0.001, Grain::X);
    return;
  }
  b.at({cx, cy, z}, [&] {
    if (style == "sledge") {  // bent steel runners
      b.mirroredX([&] {
        const double x = w / 2 - std::min(0.12, 0.15 * w), y = d / 2 - 0.03;
        b.tube(roundedPath({{x, -y, h}, {x, -y, 0.007}, {x, y, 0.007}, {x, y, h}}, 0.02), 0.007, 10,
               Cap::Flat);
      });
    } else if (style == "castors") {
      b.mirroredXY([&] { b.castor({w / 2 - 0.05, d / 2 - 0.05, 0}, std::min(0.028, 0.4 * h)); });
    } else if (style == "metal") {  // a frame of square bar
      const double t = 0.022;
      b.mirroredXY([&] { b.box({w / 2 - t, d / 2 - t - 0.003, 0}, {w / 2, d / 2 - 0.003, h - t}, 0.001); });
      b.mirroredY([&] {
        b.box({-w / 2, d / 2 - t - 0.003, h - t}, {w / 2, d / 2 - 0.003, h + 0.001}, 0.001);
      });
      b.mirroredX([&] { b.box({w / 2 - t, -d / 2 + t, h - t}, {w / 2 - 0.0005, d / 2 - t, h}, 0.001); });
    } else if (style == "block") {
      b.mirroredXY([&] {
        b.leg({w / 2 - 0.035, d / 2 - 0.04, h + 0.002}, {w / 2 - 0.035, d / 2 - 0.04, 0}, 0.026, 0.022,
              LegShape::Square);
      });
    } else {
      const double splay = style == "splayed" ? std::min(0.06, 0.35 * h) : 0.0;
      const double in = std::min(0.09, 0.16 * w);
      b.mirroredXY([&] {
        b.leg({w / 2 - in, d / 2 - std::min(0.09, 0.22 * d), h + 0.002},
              {w / 2 - in + splay, d / 2 - std::min(0.09, 0.22 * d) + splay, 0}, 0.02, 0.011);
      });
    }
  });
}

}  // namespace idap::parametric
