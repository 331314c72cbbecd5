// Wardrobes, chests, sideboards, night tables and the like: one case whose columns are filled as a line of
// text says.
//
// layout: columns from left to right separated by '|', cells from top to bottom, each a letter after an
// optional weight: r drawer, d door, D pair of doors, g glass door, G pair of them, m mirror door, o open, O
// open with books. "d|rrr|d", "1o3D".
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "catalog/parametric/casework.h"

namespace idap::parametric {

namespace {

struct Cell {
  char kind;
  double weight;
};
using Column = std::vector<Cell>;

std::vector<Column> parseLayout(const std::string& text) {
  std::vector<Column> columns(1);
  double weight = 1;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '|') {
      columns.emplace_back();
    } else if ((c >= '0' && c <= '9') || c == '.') {
      std::size_t used = 0;
      weight = std::stod(text.substr(i), &used);
      i += used - 1;
    } else if (c != ' ') {
      columns.back().push_back({c, weight});
      weight = 1;
    }
  }
  return columns;
}

std::string repeated(const std::string& column, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += (i ? "|" : "") + column;
  return all;
}

struct Case {
  std::string layout;
  FrontStyle front;
  double board = 0.018;
  double legHeight = 0.1;
  std::string legs = "plinth";
  double top = 0;       // m, thickness of a top board of its own (slot "top"); 0: the carcass's
  double overhang = 0;  // m, of the top over the sides and the front
  double cornice = 0;   // m, height of a moulding instead
  int shelves = 2;      // behind glass and in open cells
  PullAt pullAt = PullAt::Middle;
};

Case caseOf(const Parameters& p) {
  Case c;
  c.front.style = p.text("front", "flat");
  c.front.pull = pullNamed(p.text("handle", "bar"));
  c.board = p.number("board", c.board);
  c.legs = p.text("legs", c.legs);
  c.legHeight = c.legs == "none" ? 0 : p.number("legHeight", c.legHeight);
  c.top = p.number("top", 0);
  c.overhang = p.number("overhang", 0);
  c.cornice = p.number("cornice", 0);
  c.shelves = p.count("shelves", c.shelves);
  c.layout = p.text("layout", "d");
  const std::string at = p.text("handleAt", "middle");
  c.pullAt = at == "top" ? PullAt::Top : at == "bottom" ? PullAt::Bottom : PullAt::Middle;
  return c;
}

void fill(Builder& b, const Cell& cell, const Pane& opening, const Pane& cover, double face, double inner,
          double back, const Case& c, bool hingeLeft, int key) {
  const bool open = cell.kind == 'o' || cell.kind == 'O', glass = cell.kind == 'g' || cell.kind == 'G';
  if (open || glass) {
    const int n = std::max(0, std::min(c.shelves, static_cast<int>(opening.height() / 0.16)));
    for (int i = 0; i <= n; ++i) {
      const double z = opening.z0 + opening.height() * i / (n + 1);
      if (i > 0) {
        b.slot(glass && c.front.style == "glass-shelves" ? "glass" : "wood");
        b.box({opening.x0 - 0.001, inner + 0.02, z - 0.009}, {opening.x1 + 0.001, back, z + 0.009}, 0.001,
              Grain::X);
      }
      const double floor = i > 0 ? z + 0.009 : z, room = opening.height() / (n + 1) - 0.02;
      if (cell.kind == 'O')
        books(b, opening.x0, opening.x1, inner + 0.06, floor, back - inner - 0.07, room, key + i, 0.7);
      if (glass) {
        const int things = fitting(opening.width(), 0.22, 5);
        for (int k = 0; k < things; ++k)
          ornament(b, {opening.x0 + opening.width() * (k + 0.5) / things, (inner + back) / 2, floor},
                   std::min(room, 0.3), key * 7 + i * 3 + k);
      }
    }
    if (open) return;
  }
  if (cell.kind == 'r') {
    drawer(b, cover, face, c.front);
    return;
  }
  FrontStyle style = c.front;
  if (glass) style.style = "glass";
  if (cell.kind == 'm') style.style = "mirror";
  if (cell.kind == 'D' || cell.kind == 'G') {
    door(b, {cover.x0, cover.z0, cover.midX(), cover.z1}, face, style, Hinge::Left, c.pullAt);
    door(b, {cover.midX(), cover.z0, cover.x1, cover.z1}, face, style, Hinge::Right, c.pullAt);
  } else {
    door(b, cover, face, style, hingeLeft ? Hinge::Left : Hinge::Right, c.pullAt);
  }
}

void build(Builder& b, const Case& c) {
  const std::vector<Column> columns = parseLayout(c.layout);
  const bool fronts = c.layout.find_first_of("rdDgGm") != std::string::npos;
  const double out = fronts ? pullDepth(c.front.pull) : 0;
  // The top hangs over the fronts; handles stand out beyond whichever is further.
  const double face = b.front() + std::max(out, c.overhang),
               inner = face + (fronts ? c.front.thickness + 0.002 : 0);
  const double x0 = b.left() + c.overhang, x1 = b.right() - c.overhang;
  const double topZ = b.height() - c.top - c.cornice;
  const double z0 = c.legHeight;
  feet(b, c.legs, {x0, inner, 0}, {x1, b.back(), 0}, c.legHeight);

  b.slot("wood");
  Carcass style;
  style.board = c.board;
  style.topOver = c.top <= 0 && c.cornice <= 0 && !fronts;
  carcass(b, {x0, inner, z0}, {x1, b.back(), topZ}, style);
  if (c.top > 0) {
    b.slot("top");
    b.box({b.left(), face - c.overhang, topZ}, {b.right(), b.back(), b.height()},
          std::min(0.003, 0.2 * c.top), Grain::X);
  }
  if (c.cornice > 0) {
    b.slot("wood");
    const double o = std::max(c.overhang, 0.001), h = c.cornice;
    for (const auto& [lo, hi, by] : {std::tuple{0.0, 0.3, 0.3}, {0.3, 0.7, 0.65}, {0.7, 1.0, 1.0}})
      b.box({x0 - by * o, face - by * o, topZ + lo * h}, {x1 + by * o, b.back(), topZ + hi * h}, 0.12 * h,
            Grain::X);
  }

  const double back = b.back() - 0.012, t = c.board;
  const double count = static_cast<double>(columns.size());
  const double columnWidth = (x1 - x0 - t) / count;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double left = x0 + columnWidth * static_cast<double>(i);
    if (i > 0) {
      b.slot("wood");
      b.box({left, inner + 0.0005, z0 + t - 0.001}, {left + t, back, topZ - t + 0.001}, 0.001, Grain::Z);
    }
    // Fronts cover the edges of the boards: half of those they share.
    const double coverLeft = i == 0 ? x0 : left + t / 2;
    const double coverRight = i + 1 == columns.size() ? x1 : left + columnWidth + t / 2;
    double total = 0;
    for (const Cell& cell : columns[i]) total += cell.weight;
    double z = topZ;
    const double room = topZ - z0;
    for (std::size_t k = 0; k < columns[i].size(); ++k) {
      const Cell& cell = columns[i][k];
      const double next = z - room * cell.weight / total;
      const bool last = k + 1 == columns[i].size();
      if (!last) {
        b.slot("wood");
        b.box({left + t - 0.001, inner + 0.0005, next - t / 2},
              {left + columnWidth + 0.001, back, next + t / 2}, 0.001, Grain::X);
      }
      const Pane opening{left + t, last ? z0 + t : next + t / 2, left + columnWidth,
                         k == 0 ? topZ - t : z - t / 2};
      const Pane cover{coverLeft, next, coverRight, z};
      // Pairs of columns open away from each other.
      fill(b, cell, opening, cover, face, inner, back, c, i % 2 == 0 && columns.size() > 1,
           static_cast<int>(i * 10 + k));
      z = next;
    }
  }
}

void cabinet(Builder& b, const Parameters& p) { build(b, caseOf(p)); }

// Drawers in columns, the upper ones lower.
void chest(Builder& b, const Parameters& p) {
  Case c = caseOf(p);
  std::string column;
  const int drawers = std::clamp(p.count("drawers", 4), 1, 12);
  for (int i = 0; i < drawers; ++i) column += i == 0 && drawers > 2 ? "0.72r" : "r";
  c.layout = repeated(column, std::clamp(p.count("columns", 1), 1, 6));
  build(b, c);
}

void wardrobe(Builder& b, const Parameters& p) {
  Case c = caseOf(p);
  const int doors = std::clamp(p.count("doors", fitting(b.width(), 0.5)), 1, 8);
  const int drawers = std::clamp(p.count("drawers", 0), 0, 3), mirrored = p.count("mirrorDoor", 0);
  c.layout.clear();
  for (int i = 0; i < doors; ++i) {
    c.layout += i ? "|" : "";
    c.layout += "8";
    c.layout += i + 1 == mirrored ? "m" : "d";
    for (int k = 0; k < drawers; ++k) c.layout += "r";
  }
  build(b, c);
}

// Tall panels on tracks, each a little behind its neighbour.
void slidingWardrobe(Builder& b, const Parameters& p) {
  const int doors = std::clamp(p.count("doors", fitting(b.width(), 1.0)), 2, 5);
  const double depth = 0.025, face = b.front() + 0.004, inner = face + 2 * depth + 0.01, h = b.height();
  b.slot("wood");
  carcass(b, {b.left(), b.front(), 0}, {b.right(), b.back(), h}, {0.022, 0.006, false, true});
  b.box({b.left() + 0.02, b.front() + 0.03, 0.018}, {b.right() - 0.02, b.front() + 0.05, 0.06}, 0.001,
        Grain::X);
  b.box({b.left() + 0.02, inner + 0.01, h - 0.35}, {b.right() - 0.02, b.back() - 0.01, h - 0.332}, 0.001,
        Grain::X);
  const double x0 = b.left() + 0.022, x1 = b.right() - 0.022, lap = 0.04;
  const double w = (x1 - x0 + lap * (doors - 1)) / doors;
  const int mirrored = p.count("mirrorDoor", 2);
  const double bar = 0.03;
  for (int i = 0; i < doors; ++i) {
    const double left = x0 + i * (w - lap), y = face + (i % 2 ? 0 : depth + 0.004);
    const Pane pane{left, 0.062, left + w, h - 0.026};
    b.slot("handle");
    bars(b, pane, y, y + depth, bar, 0.02, 0.035, 0.003);
    const Pane field{pane.x0 + bar - 0.001, pane.z0 + 0.034, pane.x1 - bar + 0.001, pane.z1 - 0.019};
    if (i + 1 == mirrored || mirrored < 0) {
      b.slot("mirror");
      sheet(b, field, y + 0.008);
      b.slot("front");
      b.box({field.x0, y + 0.01, field.z0}, {field.x1, y + 0.018, field.z1}, 0);
    } else {
      b.slot("front");
      b.box({field.x0, y + 0.008, field.z0}, {field.x1, y + 0.018, field.z1}, 0, Grain::Z);
    }
  }
}

// Tilting flaps, shallow.
void shoeCabinet(Builder& b, const Parameters& p) {
  Case c = caseOf(p);
  const int flaps = std::clamp(p.count("flaps", fitting(b.height() - c.legHeight, 0.38)), 1, 6);
  c.layout =
      repeated(std::string(static_cast<std::size_t>(flaps), 'r'), std::clamp(p.count("columns", 1), 1, 4));
  build(b, c);
}

}  // namespace

void addCabinets(Generators& to) {
  to["cabinet"] = cabinet;
  to["chestOfDrawers"] = chest;
  to["wardrobe"] = wardrobe;
  to["slidingWardrobe"] = slidingWardrobe;
  to["shoeCabinet"] = shoeCabinet;
}

}  // namespace idap::parametric
