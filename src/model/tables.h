// Doing one thing with every table of a home, so that a new kind of element is added in one place.
#pragma once

#include "model/diff.h"
#include "model/home.h"

namespace idap {

// Calls f(&Home::table, &HomeDiff::changes, "wall") for each kind. Levels, groups and walls come
// first: the others refer to them.
template <class F>
void forEachTable(F&& f) {
  f(&Home::levels, &HomeDiff::levels, "level");
  f(&Home::groups, &HomeDiff::groups, "group");
  f(&Home::walls, &HomeDiff::walls, "wall");
  f(&Home::rooms, &HomeDiff::rooms, "room");
  f(&Home::openings, &HomeDiff::openings, "opening");
  f(&Home::furniture, &HomeDiff::furniture, "furniture");
  f(&Home::cameras, &HomeDiff::cameras, "camera");
  f(&Home::dimensions, &HomeDiff::dimensions, "dimension");
  f(&Home::labels, &HomeDiff::labels, "label");
  f(&Home::polylines, &HomeDiff::polylines, "polyline");
  f(&Home::pictures, &HomeDiff::pictures, "picture");
}

}  // namespace idap
