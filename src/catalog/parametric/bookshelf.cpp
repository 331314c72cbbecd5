// Shelves, with books and things on them.
#include <algorithm>
#include <cmath>

#include "catalog/parametric/casework.h"

namespace idap::parametric {

namespace {

// What stands on one shelf: mostly books, here and there an ornament.
void stock(Builder& b, double x0, double x1, double y0, double y1, double z, double room, int key,
           double amount) {
  if (amount <= 0 || room < 0.1) return;
  b.slot("vase");  // there even when no ornament happens to be
  const double w = x1 - x0;
  const bool split = w > 0.5 && Builder::random(key * 13 + 1) < 0.6;
  const double deep = std::min(y1 - y0, 0.26), things = std::min({room, 0.95 * (y1 - y0), 0.8 * w});
  if (!split && w < 0.5 && Builder::random(key * 13 + 2) > 0.35 + 0.5 * amount) {
    ornament(b, {(x0 + x1) / 2, (y0 + y1) / 2, z}, things, key);
    return;
  }
  const double end = split ? x0 + w * (0.45 + 0.2 * Builder::random(key * 13 + 3)) : x1;
  books(b, x0, end, y0 + 0.02, z, deep - 0.02, room, key, std::clamp(0.35 + 0.6 * amount, 0.1, 0.97));
  if (split) {
    if (const double pick = Builder::random(key * 13 + 4); pick < 0.18 && x1 - end > 0.32)
      bookPile(b, {(end + x1) / 2, (y0 + y1) / 2, z}, key);
    else if (pick < 0.55)
      ornament(b, {(end + x1) / 2, (y0 + y1) / 2, z}, things, key + 3);
    else
      books(b, end + 0.06, x1, y0 + 0.02, z, deep - 0.02, room, key + 7, 0.5 + 0.45 * amount);
  }
}

// A case with uprights and shelves in equal fields.
void bookcase(Builder& b, const Parameters& p) {
  const double t = p.number("board", 0.022);
  const int columns = std::clamp(p.count("columns", fitting(b.width(), 0.85)), 1, 8);
  const int shelves = std::clamp(p.count("shelves", 4), 1, 12);
  const double amount = p.number("books", 0.8);
  const double plinth = p.number("plinth", 0.06);
  const double o = p.number("overhang", 0);
  const bool backed = p.flag("back", true);
  const double x0 = b.left() + o, x1 = b.right() - o, y0 = b.front() + o, top = b.height() - t;
  const std::string legs = p.text("legs", "plinth");
  feet(b, legs, {x0, y0, 0}, {x1, b.back(), 0}, plinth);
  b.slot("wood");
  b.box({b.left(), b.front(), top}, {b.right(), b.back(), b.height()}, o > 0 ? 0.004 : kBevel, Grain::X);
  const double w = (x1 - x0 - t) / columns;
  for (int i = 0; i <= columns; ++i)
    b.box({x0 + w * i, y0, plinth}, {x0 + w * i + t, b.back(), top + 0.0005}, kBevel, Grain::Z);
  if (backed) {
    b.slot("back");
    b.box({x0 + t - 0.003, b.back() - 0.01, plinth + 0.002}, {x1 - t + 0.003, b.back() - 0.003, top + 0.002},
          0, Grain::Z);
  }
  // Lower fields are a little higher, as big books stand there.
  const double room = top - plinth - t, growth = p.number("growth", 0.12);
  double total = 0;
  for (int k = 0; k <= shelves; ++k) total += 1 + growth * (shelves - k) / std::max(1, shelves);
  double z = plinth;
  for (int k = 0; k <= shelves; ++k) {
    const double field = room * (1 + growth * (shelves - k) / std::max(1, shelves)) / total;
    for (int i = 0; i < columns; ++i) {
      const double left = x0 + w * i + t, right = x0 + w * (i + 1);
      b.slot("wood");
      b.box({left - 0.001, y0 + 0.001, z}, {right + 0.001, b.back() - 0.011, z + t}, kBevel, Grain::X);
      stock(b, left, right, y0, b.back() - 0.014, z + t, field - t, 17 * k + i + 1, amount);
    }
    z += field;
  }
}

// Equal square fields with boards of one thickness.
void cubes(Builder& b, const Parameters& p) {
  const double t = p.number("board", 0.03);
  const int columns = std::clamp(p.count("columns", fitting(b.width(), 0.37)), 1, 10);
  const int rows = std::clamp(p.count("rows", fitting(b.height(), 0.37)), 1, 10);
  const double w = (b.width() - t) / columns, h = (b.height() - t) / rows;
  b.slot("wood");
  for (const double x : {b.left(), b.right() - t})
    b.box({x, b.front(), t - 0.0005}, {x + t, b.back(), b.height() - t + 0.0005}, kBevel, Grain::Z);
  for (const double z : {0.0, b.height() - t})
    b.box({b.left(), b.front(), z}, {b.right(), b.back(), z + t}, kBevel, Grain::X);
  for (int i = 1; i < columns; ++i)
    b.box({b.left() + w * i, b.front() + 0.001, t - 0.001},
          {b.left() + w * i + t, b.back() - 0.001, b.height() - t + 0.001}, kBevel, Grain::Z);
  for (int k = 1; k < rows; ++k)
    b.box({b.left() + t - 0.001, b.front() + 0.0015, h * k},
          {b.right() - t + 0.001, b.back() - 0.0015, h * k + t}, kBevel, Grain::X);
  const double amount = p.number("books", 0.6);
  for (int k = 0; k < rows; ++k) {
    for (int i = 0; i < columns; ++i) {
      const int key = k * 11 + i + 2;
      const double x0 = b.left() + w * i + t, x1 = b.left() + w * (i + 1), z0 = h * k + t;
      const double pick = Builder::random(key * 5 + 3);
      if (k < (rows + 1) / 2 && pick > 0.62) {  // a basket
        b.slot("basket");
        const double g = 0.012, high = (h - t) * 0.82;
        const auto ring = [&](double in, double z) {
          return atHeight(roundedRectangle({x0 + g + in, b.front() + 0.015 + in},
                                           {x1 - g - in, b.back() - 0.02 - in}, 0.02, 3),
                          z0 + z);
        };
        b.loft({ring(0.02, 0), ring(0.012, 0.0), ring(0, high), ring(0.008, high), ring(0.018, 0.02)}, true,
               0.5);
      } else if (pick > 0.12) {
        stock(b, x0, x1, b.front(), b.back(), z0, h - t, key, amount);
      }
    }
  }
}

// Two leaning posts on each side carry shelves that grow deeper downwards.
void ladderShelf(Builder& b, const Parameters& p) {
  const int shelves = std::clamp(p.count("shelves", 5), 2, 9);
  const double t = 0.02, post = 0.03, h = b.height(), lean = b.depth() - 0.13;
  b.slot("frame");
  b.mirroredX([&] {
    const double x0 = b.right() - post, x1 = b.right();
    // The front post leans to the wall, the rear one stands.
    b.extrudeAlongX(
        {{b.front(), 0}, {b.front() + post, 0}, {b.front() + lean + post, h}, {b.front() + lean, h}}, x0, x1,
        0.002);
    b.box({x0 + 0.0005, b.back() - post, 0}, {x1 - 0.0005, b.back(), h}, 0.002, Grain::Z);
  });
  for (int k = 0; k < shelves; ++k) {
    const double z = 0.12 + (h - 0.2) * k / (shelves - 1);
    const double y0 = b.front() + lean * z / h + 0.004;
    b.slot("wood");
    b.box({b.left() + post - 0.002, y0, z}, {b.right() - post + 0.002, b.back() - 0.002, z + t}, kBevel,
          Grain::X);
    b.box({b.left() + post, b.back() - 0.014, z + t - 0.001},
          {b.right() - post, b.back() - 0.004, z + t + 0.035}, 0.001, Grain::X);
    const double room = (h - 0.2) / (shelves - 1) - t - 0.02;
    if (k + 1 < shelves)
      stock(b, b.left() + post, b.right() - post, y0, b.back() - 0.016, z + t, room, k + 31,
            p.number("books", 0.5));
    else
      ornament(b, {0.1 * b.width(), (y0 + b.back()) / 2, z + t}, h - z - t, 4);
  }
}

// Boards on the wall, on hidden or on steel brackets; a bookend closes the uppermost.
void wallShelf(Builder& b, const Parameters& p) {
  const int boards = std::clamp(p.count("boards", 1), 1, 6);
  const double amount = p.number("books", 0.7), top = b.height();
  const double room = top / boards, t = std::min(p.number("board", 0.035), room);
  const bool brackets = p.flag("brackets");
  for (int k = 0; k < boards; ++k) {
    const double z = room * k + (brackets ? std::min(0.12, 0.3 * room) : 0);
    b.slot("wood");
    b.box({b.left(), b.front(), z}, {b.right(), b.back(), z + t}, 0.002, Grain::X);
    if (brackets) {
      b.slot("bracket");
      for (const double f : {0.14, 0.86}) {
        const double x = b.left() + f * b.width(), w = 0.012;
        b.box({x - w, b.back() - 0.006, room * k}, {x + w, b.back() - 0.001, z + 0.001}, 0.001);
        b.box({x - w, b.front() + 0.02, z - 0.005}, {x + w, b.back() - 0.004, z + 0.0005}, 0.001);
        b.rod({x, b.back() - 0.005, room * k + 0.015}, {x, b.front() + 0.06, z - 0.003}, 0.005, 8);
      }
    }
    const double left = room * (k + 1) - z - t;
    if (amount <= 0 || left < 0.08) continue;
    stock(b, b.left() + 0.05, b.right() - 0.05, b.front(), b.back(), z + t, left - 0.005, k + 3, amount);
    if (k + 1 == boards) {
      b.slot("bracket");
      const double x = b.left() + 0.045;
      b.box({x, b.front() + 0.03, z + t}, {x + 0.003, b.back() - 0.05, top}, 0.0008);
    }
  }
}

// Steel posts and thick boards.
void rackShelf(Builder& b, const Parameters& p) {
  const int shelves = std::clamp(p.count("shelves", 5), 2, 9);
  const double post = 0.025, t = 0.03, h = b.height();
  b.slot("frame");
  b.mirroredXY([&] {
    b.box({b.right() - post, b.back() - post, 0}, {b.right(), b.back(), h}, 0.0012, Grain::Z);
  });
  b.mirroredX([&] {
    for (const double z : {0.06, h - post})
      b.box({b.right() - post + 0.0005, b.front() + post - 0.001, z},
            {b.right() - 0.0005, b.back() - post + 0.001, z + post}, 0.001, Grain::Y);
  });
  if (b.width() > 0.5) {  // crossed rods stiffen the back
    const double y = b.back() - 0.006, x = b.width() / 2 - post / 2;
    b.rod({-x, y, 0.1}, {x, y, h - 0.1}, 0.004, 8);
    b.rod({-x, y - 0.009, h - 0.1}, {x, y - 0.009, 0.1}, 0.004, 8);
  }
  for (int k = 0; k < shelves; ++k) {
    const double z = 0.085 + (h - 0.085 - t - 0.002) * k / (shelves - 1);
    b.slot("wood");
    b.box({b.left() + post * 0.4, b.front() + 0.006, z}, {b.right() - post * 0.4, b.back() - 0.02, z + t},
          0.002, Grain::X);
    if (k + 1 < shelves)
      stock(b, b.left() + post + 0.02, b.right() - post - 0.02, b.front() + 0.02, b.back() - 0.03, z + t,
            (h - 0.115) / (shelves - 1) - t - 0.02, k + 51, p.number("books", 0.55));
  }
}

}  // namespace

void addBookshelves(Generators& to) {
  to["bookcase"] = bookcase;
  to["cubeShelf"] = cubes;
  to["ladderShelf"] = ladderShelf;
  to["wallShelf"] = wallShelf;
  to["rackShelf"] = rackShelf;
}

}  // namespace idap::parametric
