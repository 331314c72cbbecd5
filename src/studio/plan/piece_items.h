// The pieces and openings that one view draws, in order from the farthest to the nearest, with what is worth
// keeping of each: its outline, its symbol, its colours. Kept in step change by change.
#pragma once

#include <QColor>
#include <memory>
#include <unordered_map>
#include <vector>

#include "catalog/catalog.h"
#include "editor/plane.h"
#include "editor/symbol/symbol.h"
#include "model/diff.h"
#include "model/home.h"
#include "studio/plan/painter.h"

namespace idap {

class SymbolStore;

struct PieceItem {
  std::uint64_t id = 0;
  std::shared_ptr<const Furniture> furniture;  // one of the two
  std::shared_ptr<const Opening> opening;
  Polygon outline;           // of its box, on the plane
  Box2 box;                  // of that and of the swings of its leaves
  double near = 0, far = 0;  // nearness of its nearest and its farthest point
  double order = 0;          // smaller ones are drawn first
  double turn = 0;           // radians, of the symbol on the plane
  Vec2 place;                // of the symbol's origin
  SymbolKey key;
  SymbolPtr symbol;           // null: not there yet
  bool exact = false;         // it is the symbol of this very key, not one of another size
  std::vector<Color> colors;  // of the symbol's slots, with the piece's finishes
  const Piece& piece() const { return furniture ? static_cast<const Piece&>(*furniture) : *opening; }
};

class PieceItems {
 public:
  PieceItems(Plane plane, std::shared_ptr<const Catalog> catalog, std::shared_ptr<SymbolStore> symbols);

  void rebuild(const Home& home, LevelId level, Pictures& pictures);
  // After some elements changed; the level is the same.
  void update(const HomeDiff& diff, const Home& home, Pictures& pictures);
  // Symbols that have come in the meantime: takes them, and tells where. Colours that have come too.
  void takeSymbols(const Home& home, Pictures& pictures, DirtyBoxes& dirty);
  void takeColors(const Home& home, Pictures& pictures);
  // Waits for all symbols: for printing.
  void completeSymbols(const Home& home, Pictures& pictures);

  const std::vector<const PieceItem*>& items() const { return order_; }  // farthest first
  const PieceItem* find(std::uint64_t id) const;
  Box2 bounds() const;

 private:
  void put(std::uint64_t id, std::shared_ptr<const Furniture> furniture,
           std::shared_ptr<const Opening> opening, const Home& home, Pictures& pictures);
  void symbolOf(PieceItem& item, const Home& home, Pictures& pictures);
  void sort();

  Plane plane_;
  LevelId level_;
  std::shared_ptr<const Catalog> catalog_;
  std::shared_ptr<SymbolStore> symbols_;
  std::unordered_map<std::uint64_t, std::unique_ptr<PieceItem>> byId_;
  std::vector<const PieceItem*> order_;
  std::size_t waiting_ = 0;
};

}  // namespace idap
