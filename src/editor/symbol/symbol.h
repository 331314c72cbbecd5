// How a piece looks on a plane: a line drawing made from its model, with its areas by material. Vectors, so
// that it is sharp at any scale and prints. Pure functions: any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "catalog/surface_model.h"
#include "editor/plane.h"
#include "model/home.h"

namespace idap {

class Catalog;

using SymbolRing = std::vector<Vec2f>;

struct SymbolSlot {  // a material slot of the model
  std::string name;
  Color color;
  SharedBytes picture;  // its mean colour multiplies color; null: none
  float clear = 0;      // 0 opaque .. 1 glass
};

struct SymbolArea {  // what is seen of a slot
  std::uint32_t slot = 0;
  bool sloped = false;            // turned away from the eye: to be drawn a little darker
  std::vector<SymbolRing> rings;  // even-odd
};

struct SymbolLine {
  std::vector<Vec2f> points;
  float length = 0;      // m
  bool outline = false;  // nothing of the piece lies on its other side
};

// Metres. XY: about the piece's origin before its angle and position; the others: about its origin, with all
// its rotations.
struct Symbol {
  std::vector<SymbolSlot> slots;
  std::vector<SymbolRing> outline;  // of all that is seen, even-odd
  SymbolRing coarse;  // the largest ring of it with few points, for when it is small on the screen
  std::vector<SymbolArea> areas;  // the largest first
  std::vector<SymbolLine> lines;  // the longest first
  Vec2 size{1, 1};  // of the piece's own size on the plane: to stretch it while a better one is made
  bool empty() const { return outline.empty(); }
};
using SymbolPtr = std::shared_ptr<const Symbol>;

// The piece's placement counts, its position does not.
Symbol makeSymbol(const SurfaceModel& model, const Piece& piece, Plane plane);

// What a symbol depends on, as far as a piece says it. asset: of its model, by its address.
using SymbolKey = std::string;
SymbolKey symbolKey(const Piece& piece, Plane plane, const Assets& assets, const Catalog* catalog);

}  // namespace idap
