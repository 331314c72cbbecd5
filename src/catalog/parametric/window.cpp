// Windows with frame, sashes, single sheets of glass, handles and an inner sill. Inside is the front (-y):
// the frame sits towards the back of the box, the sill board fills the reveal before it.
#include <algorithm>
#include <cmath>

#include "catalog/parametric/casework.h"

namespace idap::parametric {

namespace {

struct Style {
  double frame = 0.05, sash = 0.055;  // m, widths of the bars
  double depth = 0.06;                // m, of frame and sash
  double bar = 0.022;
  int paneColumns = 1, paneRows = 1;
};

Style styleOf(Builder& b, const Parameters& p) {
  Style s;
  const double least = std::min(b.width(), b.height());
  s.frame = std::min(p.number("frame", s.frame), 0.12 * least);
  s.sash = std::min(p.number("sash", s.sash), 0.12 * least);
  s.depth = std::min(p.number("frameDepth", s.depth), 0.7 * b.depth());
  s.paneColumns = std::clamp(p.count("paneColumns", 1), 1, 8);
  s.paneRows = std::clamp(p.count("paneRows", 1), 1, 10);
  return s;
}

void paneBars(Builder& b, const Pane& glass, double y, const Style& s) {
  for (int i = 1; i < s.paneColumns; ++i) {
    const double x = glass.x0 + glass.width() * i / s.paneColumns;
    b.box({x - s.bar / 2, y - 0.012, glass.z0 - 0.002}, {x + s.bar / 2, y + 0.012, glass.z1 + 0.002}, 0.004,
          Grain::Z);
  }
  for (int i = 1; i < s.paneRows; ++i) {
    const double z = glass.z0 + glass.height() * i / s.paneRows;
    b.box({glass.x0 - 0.002, y - 0.0115, z - s.bar / 2}, {glass.x1 + 0.002, y + 0.0115, z + s.bar / 2}, 0.004,
          Grain::X);
  }
}

void sashWithGlass(Builder& b, const Pane& p, double y0, double y1, double width, const Style& s) {
  b.slot("sash");
  bars(b, p, y0, y1, width, width, width, 0.005);
  const Pane glass = p.inset(width);
  paneBars(b, glass, (y0 + y1) / 2, s);
  b.slot("glass");
  sheet(b, glass.inset(-0.004), (y0 + y1) / 2);
}

// A lever that hangs down when shut.
void lever(Builder& b, Vec3 at, double room) {
  if (room < 0.02) return;
  const double out = std::min(0.045, room);
  b.slot("handle");
  b.at(at, [&] {
    b.box({-0.014, -0.008, -0.032}, {0.014, 0.001, 0.032}, 0.003);
    b.tube(roundedPath({{0, -0.004, 0}, {0, -out + 0.008, 0}, {0, -out + 0.008, -0.11}}, 0.014), 0.0075, 10);
  });
}

// Inner board and outer flashing: together they fill the depth before and behind the frame.
void sills(Builder& b, double y0, double y1, double thick) {
  b.slot("sill");
  if (y0 - b.front() > 0.005)
    b.box({b.left(), b.front(), 0}, {b.right(), y0 + 0.002, thick}, 0.004, Grain::X);
  if (b.back() - y1 > 0.005) {
    b.slot("flashing");
    const double x0 = b.left(), x1 = b.right();
    b.extrudeAlongX({{y1 - 0.002, 0}, {b.back(), 0}, {b.back(), 0.008}, {y1 - 0.002, thick}}, x0, x1, 0);
  }
}

struct Setting {
  double y0, y1;  // of the frame
  double sill;    // its thickness
};

Setting setting(const Builder& b, const Parameters& p, const Style& s) {
  const double outside = std::min(0.04, 0.5 * (b.depth() - s.depth));
  return {b.back() - outside - s.depth, b.back() - outside, p.flag("sill", true) ? 0.022 : 0.0};
}

// Casements side by side; transom: height of a fixed light above them. A door-high one is a French window.
void casement(Builder& b, const Parameters& p) {
  const Style s = styleOf(b, p);
  const Setting f = setting(b, p, s);
  const int sashes = std::clamp(p.count("sashes", fitting(b.width(), 0.7)), 1, 6);
  const bool fixed = p.flag("fixed");
  if (f.sill > 0) sills(b, f.y0, f.y1, f.sill);
  const Pane all{b.left(), f.sill, b.right(), b.height()};
  b.slot("frame");
  bars(b, all, f.y0, f.y1, s.frame);
  if (f.sill <= 0) {  // nothing else fills the depth: a threshold does
    b.slot("sill");
    b.box({b.left() + s.frame, b.front(), 0}, {b.right() - s.frame, b.back(), 0.02}, 0.004, Grain::X);
  }
  Pane in = all.inset(s.frame);
  if (const double above = p.number("transom", 0); above > 0.1 && in.height() - above > 0.3) {
    b.slot("frame");
    const double z = in.z1 - above;
    b.box({in.x0 - 0.003, f.y0 + 0.0004, z}, {in.x1 + 0.003, f.y1 - 0.0004, z + s.frame}, 0.003, Grain::X);
    const Pane light{in.x0, z + s.frame, in.x1, in.z1};
    Style plain = s;
    plain.paneRows = 1;
    paneBars(b, light, (f.y0 + f.y1) / 2, plain);
    b.slot("glass");
    sheet(b, light.inset(-0.004), (f.y0 + f.y1) / 2);
    in.z1 = z;
  }
  const double mullion = p.number("mullion", 0), gap = mullion > 0 ? mullion : 0.003;
  const double w = (in.width() - gap * (sashes - 1)) / sashes;
  for (int i = 0; i < sashes; ++i) {
    const double x = in.x0 + i * (w + gap);
    if (mullion > 0 && i > 0) {
      b.slot("frame");
      b.box({x - gap, f.y0 + 0.0006, in.z0 - 0.003}, {x, f.y1 - 0.0006, in.z1 + 0.003}, 0.003, Grain::Z);
    }
    const Pane pane{x, in.z0, x + w, in.z1};
    if (fixed) {
      paneBars(b, pane, (f.y0 + f.y1) / 2, s);
      b.slot("glass");
      sheet(b, pane.inset(-0.004), (f.y0 + f.y1) / 2);
      continue;
    }
    const double proud = std::min(0.012, f.y0 - b.front());
    const Pane cut = mullion > 0 || sashes == 1 ? pane.inset(0.002) : pane;
    sashWithGlass(b, cut, f.y0 - proud, f.y1 - 0.012, s.sash, s);
    const bool hingeRight = sashes == 1 ? p.flag("hingeRight") : i % 2 == 1;
    const bool handled = sashes == 1 || mullion > 0 || i % 2 == 1 || i + 1 == sashes;
    if (handled)
      lever(b,
            {hingeRight ? cut.x0 + s.sash / 2 : cut.x1 - s.sash / 2, f.y0 - proud,
             std::min(cut.midZ(), cut.z0 + 1.0)},
            f.y0 - proud - b.front());
  }
}

// Two or more sashes in two tracks.
void slidingWindow(Builder& b, const Parameters& p) {
  const Style s = styleOf(b, p);
  const Setting f = setting(b, p, s);
  if (f.sill > 0) sills(b, f.y0, f.y1, f.sill);
  const Pane all{b.left(), f.sill, b.right(), b.height()};
  b.slot("frame");
  bars(b, all, f.y0, f.y1, 0.7 * s.frame);
  const Pane in = all.inset(0.7 * s.frame - 0.002);
  const int sashes = std::clamp(p.count("sashes", 2), 2, 4);
  const double lap = s.sash, half = s.depth / 2 - 0.004;
  const bool vertical = p.flag("vertical");
  for (int i = 0; i < sashes; ++i) {
    Pane pane = in;
    if (vertical) {
      const double h = (in.height() + lap * (sashes - 1)) / sashes;
      pane.z0 = in.z0 + i * (h - lap), pane.z1 = pane.z0 + h;
    } else {
      const double w = (in.width() + lap * (sashes - 1)) / sashes;
      pane.x0 = in.x0 + i * (w - lap), pane.x1 = pane.x0 + w;
    }
    const double y = i % 2 ? f.y1 - 0.002 - half : f.y0 + 0.002;
    sashWithGlass(b, pane, y, y + half, s.sash, s);
    if (!vertical && i == 0) {
      b.slot("handle");
      b.box({pane.x0 + 0.3 * s.sash, y - 0.004, pane.midZ() - 0.07},
            {pane.x0 + 0.7 * s.sash, y + 0.001, pane.midZ() + 0.07}, 0.002);
    }
  }
}

// The closed outline of an opening with a curved head, counter-clockwise, inset by `in`.
Polygon archOutline(const Builder& b, double head, double z0, double in) {
  Polygon outline{{b.left() + in, z0 + in}, {b.right() - in, z0 + in}};
  const double spring = b.height() - head;
  for (int i = 0; i <= 32; ++i) {
    const double a = kPi * i / 32;
    outline.push_back({(b.width() / 2 - in) * std::cos(a), spring + (head - in) * std::sin(a)});
  }
  return outline;
}

void curvedGlass(Builder& b, const Polygon& outline, double y) {
  Mesh mesh;
  Vec2 middle;
  for (const Vec2 p : outline) middle += p / static_cast<double>(outline.size());
  const auto vertex = [&](Vec2 p) {
    mesh.positions.push_back(toFloat(Vec3{p.x, y, p.y}));
    mesh.uvs.push_back(toFloat(p));
  };
  vertex(middle);
  for (const Vec2 p : outline) vertex(p);
  const auto n = static_cast<std::uint32_t>(outline.size());
  for (std::uint32_t i = 0; i < n; ++i) mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  b.add(std::move(mesh));
}

// A ring between two outlines of equal point counts, from y0 to y1.
void curvedFrame(Builder& b, const Polygon& outer, const Polygon& inner, double y0, double y1) {
  std::vector<Path> rings;
  for (const auto& [outline, y] :
       {std::pair{&outer, y0}, {&inner, y0}, {&inner, y1}, {&outer, y1}, {&outer, y0}})
    rings.push_back(atDepth(*outline, y));
  b.loft(rings, false, 0.5);
}

// Round (an ellipse of the box) or, with head, an arch over straight sides; head is a fraction of the height.
void curvedWindow(Builder& b, const Parameters& p) {
  const Style s = styleOf(b, p);
  const Setting f = setting(b, p, s);
  const bool round = p.text("shape", "round") == "round";
  const double head = std::clamp(p.number("head", 0.3), 0.05, 0.9) * b.height();
  const double z0 = round ? 0 : f.sill;
  if (!round) sills(b, f.y0, f.y1, f.sill);
  const auto outline = [&](double in) {
    return round ? ellipse({0, b.height() / 2}, {b.width() / 2 - in, b.height() / 2 - in}, 64)
                 : archOutline(b, head, z0, in);
  };
  const double bar = s.frame + (p.flag("fixed") ? 0.0 : 0.5 * s.sash);
  b.slot("frame");
  if (round) {  // a lining through the wall, so that the reveal is round as well
    curvedFrame(b, outline(0), outline(0.012), b.front(), b.back());
  }
  curvedFrame(b, outline(round ? 0.011 : 0), outline(bar), f.y0, f.y1);
  const double mid = (f.y0 + f.y1) / 2;
  const double top = b.height() - bar;
  b.slot("frame");
  if (p.flag("cross", round)) {
    b.box({-s.bar / 2, mid - 0.015, z0 + bar - 0.004}, {s.bar / 2, mid + 0.015, top + 0.003}, 0.004,
          Grain::Z);
    const double z = round ? b.height() / 2 : b.height() - head;
    b.box({b.left() + bar - 0.004, mid - 0.0145, z - s.bar / 2},
          {b.right() - bar + 0.004, mid + 0.0145, z + s.bar / 2}, 0.004, Grain::X);
  }
  b.slot("glass");
  curvedGlass(b, outline(bar - 0.004), mid);
}

}  // namespace

void addWindows(Generators& to) {
  to["casementWindow"] = casement;
  to["slidingWindow"] = slidingWindow;
  to["curvedWindow"] = curvedWindow;
}

}  // namespace idap::parametric
