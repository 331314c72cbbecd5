// Doors, closed, with their frames. The frame lines the cut-out through the whole depth of the box; the leaf
// hangs near the front, so that handles stay within the wall's thickness where it allows.
//
// rows: what a leaf shows from top to bottom, each a letter after an optional weight: p panel, g glass,
// "0.8p1.2p".
#include <algorithm>
#include <cmath>

#include "catalog/parametric/casework.h"

namespace idap::parametric {

namespace {

constexpr double kLeafThickness = 0.042;

struct Row {
  char kind;
  double weight;
};

std::vector<Row> parseRows(const std::string& text) {
  std::vector<Row> rows;
  double weight = 1;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((text[i] >= '0' && text[i] <= '9') || text[i] == '.') {
      std::size_t used = 0;
      weight = std::stod(text.substr(i), &used);
      i += used - 1;
    } else if (text[i] == 'p' || text[i] == 'g') {
      rows.push_back({text[i], weight});
      weight = 1;
    }
  }
  return rows;
}

struct LeafStyle {
  std::vector<Row> rows;  // empty: a flush leaf
  int columns = 1;
  double stile = 0.11;
  double bar = 0.028;  // between panes
  int paneColumns = 1, paneRows = 1;
};

void leafBoards(Builder& b, const Pane& p, double y0, double y1, const LeafStyle& s) {
  b.slot("leaf");
  if (s.rows.empty()) {
    b.box({p.x0, y0, p.z0}, {p.x1, y1, p.z1}, 0.002, Grain::Z);
    return;
  }
  const double stile = std::min(s.stile, 0.2 * p.width()), bottom = 1.6 * stile, mid = (y0 + y1) / 2;
  bars(b, p, y0, y1, stile, stile, bottom);
  const double room = p.height() - stile - bottom - stile * static_cast<double>(s.rows.size() - 1);
  double total = 0;
  for (const Row& row : s.rows) total += row.weight;
  double z = p.z1 - stile;
  for (std::size_t i = 0; i < s.rows.size(); ++i) {
    const Row& row = s.rows[i];
    const double next = z - room * row.weight / total;
    if (i > 0) {
      b.slot("leaf");
      b.box({p.x0 + stile - 0.002, y0 + 0.0005, z}, {p.x1 - stile + 0.002, y1 - 0.0005, z + stile}, 0.003,
            Grain::X);
    }
    const Pane across{p.x0 + stile, next, p.x1 - stile, z};
    if (row.kind == 'g') {
      b.slot("glass");
      sheet(b, across.inset(-0.004), mid);
      b.slot("leaf");
      for (int k = 1; k < s.paneColumns; ++k) {
        const double x = across.x0 + across.width() * k / s.paneColumns;
        b.box({x - s.bar / 2, mid - 0.014, next - 0.002}, {x + s.bar / 2, mid + 0.014, z + 0.002}, 0.004,
              Grain::Z);
      }
      for (int k = 1; k < s.paneRows; ++k) {
        const double at = next + across.height() * k / s.paneRows;
        b.box({across.x0 - 0.002, mid - 0.0135, at - s.bar / 2},
              {across.x1 + 0.002, mid + 0.0135, at + s.bar / 2}, 0.004, Grain::X);
      }
    } else {
      b.slot("leaf");
      const double muntin = 0.8 * stile, w = (across.width() - muntin * (s.columns - 1)) / s.columns;
      b.box({across.x0 - 0.004, mid - 0.006, next - 0.004}, {across.x1 + 0.004, mid + 0.006, z + 0.004}, 0,
            Grain::Z);
      for (int k = 0; k < s.columns; ++k) {
        const double x = across.x0 + k * (w + muntin);
        if (k > 0) b.box({x - muntin, y0 + 0.001, next - 0.002}, {x, y1 - 0.001, z + 0.002}, 0.003, Grain::Z);
        const Pane field = Pane{x, next, x + w, z}.inset(std::min(0.03, 0.15 * w));
        b.box({field.x0, mid - 0.013, field.z0}, {field.x1, mid + 0.013, field.z1}, 0.006, Grain::Z);
      }
    }
    z = next - stile;
  }
}

// At (0, 0, 0) of the leaf's face, standing out to -y by at most `room`, its lever towards `side`.
void handle(Builder& b, const std::string& kind, Vec3 at, double side, double room) {
  const double out = std::min(0.055, room - 0.002);
  if (kind == "none" || out < 0.012) return;
  b.slot("handle");
  b.at(at, [&] {
    if (kind == "knob") {
      b.within(facing({}, {0, -1, 0}), [&] {
        const double k = out / 0.055;
        b.lathe({}, spline2({{0, 0},
                             {0.027, 0},
                             {0.026, 0.006 * k},
                             {0.011, 0.012 * k},
                             {0.011, 0.022 * k},
                             {0.024, 0.032 * k},
                             {0.026, 0.043 * k},
                             {0.016, 0.054 * k},
                             {0, 0.055 * k}},
                            4));
      });
    } else if (kind == "bar") {
      b.barPull({0, 0, 0.15}, 0.9, true, 0.011, out - 0.011);
    } else if (kind == "pull") {
      b.barPull({0, 0, 0.05}, 0.3, true, 0.008, out - 0.008);
    } else {
      b.within(facing({}, {0, -1, 0}), [&] { b.cylinder({}, 0.025, 0.008, 0.002); });
      b.within(facing({0, 0, -0.075}, {0, -1, 0}), [&] { b.cylinder({}, 0.016, 0.006, 0.0015); });
      const double r = 0.0085, y = -(out - r);
      b.tube(roundedPath({{0, -0.004, 0}, {0, y, 0}, {side * 0.12, y, 0}}, 0.018), r, 12);
    }
  });
}

// Hinges show as knuckles on the front.
void hinges(Builder& b, double x, double y, const Pane& p) {
  b.slot("handle");
  for (const double f : {0.1, 0.5, 0.9}) {
    if (f == 0.5 && p.height() < 1.9) continue;
    b.cylinder({x, y, p.z0 + f * p.height() - 0.045}, 0.007, 0.09, 0.001, 12);
  }
}

struct Frame {
  double bar = 0.04;
  double face = 0;  // y of the leaf's front face
};

// The lining with its stop, and a moulding on both edges of the wall that stays within the cut-out.
Frame frame(Builder& b, double leafThickness, bool threshold) {
  Frame f;
  const double w = b.width(), h = b.height();
  f.bar = std::min(0.04, 0.06 * w);
  const double spare = b.depth() - leafThickness;
  f.face = b.front() + std::clamp(0.5 * spare, 0.003, 0.06);
  b.slot("frame");
  const double t = f.bar - 0.012, stop = f.face + leafThickness + 0.002;
  const auto three = [&](double y0, double y1, double bar) {
    b.box({b.left(), y0, 0}, {b.left() + bar, y1, h}, 0.002, Grain::Z);
    b.box({b.right() - bar, y0, 0}, {b.right(), y1, h}, 0.002, Grain::Z);
    b.box({b.left() + bar - 0.002, y0 + 0.0004, h - bar}, {b.right() - bar + 0.002, y1 - 0.0004, h}, 0.002,
          Grain::X);
  };
  three(b.front(), b.back(), t);
  if (stop + 0.012 < b.back()) three(stop, std::min(stop + 0.03, b.back() - 0.001), f.bar + 0.006);
  if (threshold) {
    b.slot("threshold");
    b.box({b.left() + t - 0.002, b.front() + 0.002, 0}, {b.right() - t + 0.002, b.back() - 0.002, 0.018},
          0.006, Grain::X);
  }
  f.bar = t;
  return f;
}

void door(Builder& b, const Parameters& p) {
  const int leaves = std::clamp(p.count("leaves", 1), 1, 2);
  const bool hingeRight = p.flag("hingeRight");
  const bool threshold = p.flag("threshold");
  LeafStyle style;
  style.rows = parseRows(p.text("rows"));
  style.columns = std::clamp(p.count("columns", 1), 1, 4);
  style.stile = p.number("stile", 0.11);
  style.paneColumns = std::clamp(p.count("paneColumns", 1), 1, 6);
  style.paneRows = std::clamp(p.count("paneRows", 1), 1, 8);
  const double thick = std::min(p.number("leafThickness", kLeafThickness), 0.8 * b.depth());
  const Frame f = frame(b, thick, threshold);
  const double gap = 0.003, y0 = f.face, y1 = y0 + thick;
  double x0 = b.left() + f.bar + gap, x1 = b.right() - f.bar - gap, z1 = b.height() - f.bar - gap;
  const double z0 = threshold ? 0.02 : 0.006;

  // Fixed lights above the leaf and beside it.
  if (const double above = p.number("transom", 0); above > 0.1 && z1 - above > 1.6) {
    b.slot("frame");
    b.box({x0 - gap - 0.001, b.front() + 0.003, z1 - above},
          {x1 + gap + 0.001, b.back() - 0.003, z1 - above + 0.05}, 0.003, Grain::X);
    b.slot("glass");
    sheet(b, {x0 - gap, z1 - above + 0.049, x1 + gap, z1 + gap}, (y0 + y1) / 2);
    z1 -= above + gap;
  }
  if (const double beside = p.number("sidelight", 0); beside > 0.1 && x1 - x0 - beside > 0.6) {
    b.slot("frame");
    b.box({x1 - beside, b.front() + 0.0035, 0}, {x1 - beside + 0.05, b.back() - 0.0035, z1 + gap + 0.001},
          0.003, Grain::Z);
    b.box({x1 - beside + 0.05, y0, 0}, {x1 + gap + 0.001, y1, 0.14}, 0.003, Grain::X);
    b.slot("glass");
    sheet(b, {x1 - beside + 0.049, 0.139, x1 + gap, z1 + gap}, (y0 + y1) / 2);
    x1 -= beside + gap;
  }

  const std::string kind = p.text("handle", "lever");
  for (int i = 0; i < leaves; ++i) {
    const double w = (x1 - x0 - gap * (leaves - 1)) / leaves;
    const double left = x0 + i * (w + gap);
    const Pane pane{left, z0, left + w, z1};
    const bool right = leaves == 2 ? i == 1 : hingeRight;
    leafBoards(b, pane, y0, y1, style);
    hinges(b, right ? pane.x1 + 0.002 : pane.x0 - 0.002, y0 - 0.004, pane);
    const double side = right ? 1 : -1;  // the lever points to the hinges
    const double x = right ? pane.x0 + 0.06 : pane.x1 - 0.06;
    handle(b, kind, {x, y0, 1.02}, side, y0 - b.front());
    b.within(Transform::translation({0, y0 + y1, 0}) * Transform::scaling({1, -1, 1}), [&] {
      handle(b, kind, {x, y0, 1.02}, side, b.back() - y1);
    });
  }
}

// Panels that pass each other on a track: glass in slim frames.
void slidingDoor(Builder& b, const Parameters& p) {
  const int leaves = std::clamp(p.count("leaves", 2), 2, 6);
  const double bar = std::min(0.05, 0.05 * b.width()), stile = p.number("stile", 0.055);
  const double thick = std::min(0.035, 0.35 * b.depth()), mid = 0;
  b.slot("frame");
  b.box({b.left(), b.front(), 0}, {b.left() + bar, b.back(), b.height()}, 0.002, Grain::Z);
  b.box({b.right() - bar, b.front(), 0}, {b.right(), b.back(), b.height()}, 0.002, Grain::Z);
  b.box({b.left() + bar - 0.001, b.front() + 0.0005, b.height() - bar},
        {b.right() - bar + 0.001, b.back() - 0.0005, b.height()}, 0.002, Grain::X);
  b.box({b.left() + bar - 0.001, b.front() + 0.0005, 0}, {b.right() - bar + 0.001, b.back() - 0.0005, 0.022},
        0.002, Grain::X);
  const double x0 = b.left() + bar - 0.004, x1 = b.right() - bar + 0.004, lap = stile;
  const double w = (x1 - x0 + lap * (leaves - 1)) / leaves;
  LeafStyle style;
  style.rows = parseRows(p.text("rows", "g"));
  style.stile = stile;
  style.paneColumns = std::clamp(p.count("paneColumns", 1), 1, 6);
  style.paneRows = std::clamp(p.count("paneRows", 1), 1, 8);
  for (int i = 0; i < leaves; ++i) {
    const double left = x0 + i * (w - lap), y = i % 2 ? mid + 0.002 : mid - 0.002 - thick;
    const Pane pane{left, 0.02, left + w, b.height() - bar + 0.004};
    leafBoards(b, pane, y, y + thick, style);
    if (i == 0 || i + 1 == leaves) {
      const double x = i == 0 ? pane.x0 + stile / 2 : pane.x1 - stile / 2;
      handle(b, "pull", {x, y, 1.0}, 1, y - b.front());
    }
  }
}

}  // namespace

void addDoors(Generators& to) {
  to["door"] = door;
  to["slidingDoor"] = slidingDoor;
}

}  // namespace idap::parametric
