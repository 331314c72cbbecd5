// Several pieces of a home, finishes and all, made into one model: what "Save as furniture" keeps.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/progress.h"
#include "catalog/catalog.h"
#include "model/edits/element_edits.h"
#include "model/home.h"

namespace idap {

struct BakedFurniture {
  // An OBJ with its materials and pictures, by file name. Y up and the front towards +Z, as furniture
  // libraries have it; metres; the middle of the base at the origin.
  std::map<std::string, SharedBytes> files;
  std::string main;                // which of them is the model
  Vec3 size;                       // m: width, depth, height
  double elevation = 0;            // m, of the base above the floor
  std::vector<std::string> slots;  // names of the materials, as in the OBJ
  std::optional<Lamp> lamp;        // of the first lamp, with the places of all of them
};

// The pieces among the elements, members of groups too. Equal materials become one slot. Throws Error where
// nothing of them has a shape; Cancelled. The largest piece looks to the front.
BakedFurniture bakeFurniture(const Home& home, const Catalog& catalog, const Elements& elements,
                             const Progress& progress = {});

}  // namespace idap
