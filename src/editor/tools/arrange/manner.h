// How people put a piece into a room: a bed with its head to a wall, a lamp on a table, a rug in the middle.
// Told from its words and its size, since libraries say no more.
#pragma once

#include <string>

#include "catalog/catalog.h"
#include "model/furniture.h"

namespace idap {

enum class Manner {
  Ceiling,    // hangs from the ceiling, in the middle
  OnWall,     // hangs on a wall at its height
  AtWindow,   // curtains
  OnTop,      // on a table or a cabinet
  Floor,      // lies flat: rugs
  Bed,        // its head to a wall
  BesideBed,  // night tables
  Sofa,       // its back to the middle of a wall
  Screen,     // what is watched from a sofa
  Desk,       // its back to a wall, or by a window
  Storage,    // its back to a wall, out of the way
  Table,      // stands free
  LowTable,   // in front of a sofa
  Seat,       // at a table
  Corner      // plants, standing lamps
};

Manner mannerOf(const CatalogPiece& piece);
Manner mannerOf(const Furniture& piece);

// The piece's name and id (and tags) in lower case between blanks, to ask says().
std::string wordsOf(const CatalogPiece& piece);
std::string wordsOf(const Furniture& piece);
// True when one of the wanted words (separated by blanks) is among them.
bool says(const std::string& words, const char* wanted);

// Things can be put on it, at this height above its base; 0: they cannot.
double topOf(const Furniture& piece, Manner manner, const std::string& words);

}  // namespace idap
