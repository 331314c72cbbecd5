// One painter for each kind of element. To draw a new kind: write its painter and add one line in
// painters.cpp.
#pragma once

#include <string>
#include <vector>

#include "editor/plane.h"
#include "editor/settings.h"
#include "model/diff.h"
#include "model/home.h"
#include "studio/plan/canvas.h"

namespace idap {

class PieceItems;
class Pictures;

// What is drawn: a home on a plane, at a level.
struct Drawing {
  const Home& home;
  Plane plane = Plane::XY;
  LevelId level;
  const EditorSettings& settings;
  PieceItems& pieces;
  Pictures& pictures;
  double section = 0;  // XZ, YZ: where the building is cut, as nearness; walls nearer than that are left open

  double elevation() const { return elevationOf(home, level); }
};

// What has to be painted anew.
struct DirtyBoxes {
  std::vector<Box2> boxes;
  bool all = false;
  void add(const Box2& box) {
    if (!box.empty()) boxes.push_back(box);
  }
};

class Painter {
 public:
  virtual ~Painter() = default;
  // All of its kind within canvas.area.
  virtual void paint(const Drawing& drawing, Canvas& canvas) const = 0;
  // Where elements of its kind were or are that differ.
  virtual void changed(const HomeDiff&, const Drawing& before, const Drawing& after, DirtyBoxes&) const {
    (void)before, (void)after;
  }
  // What there is to be seen of its kind, for fitting it into the view.
  virtual void extend(const Drawing&, Box2&) const {}
};

// From the lowest to the uppermost. onPaper: without what only helps on the screen.
std::vector<const Painter*> painters(Plane plane, bool onPaper);

// For changed(): box(drawing, element) of all elements of a table that differ.
template <class IdType, class T, class BoxBefore, class BoxAfter>
void addChanged(const Changes<IdType>& changes, const Table<IdType, T>& before, const Table<IdType, T>& after,
                const BoxBefore& boxBefore, const BoxAfter& boxAfter, DirtyBoxes& dirty) {
  for (const auto* ids : {&changes.changed, &changes.removed, &changes.added})
    for (const IdType id : *ids) {
      if (const T* element = before.find(id)) dirty.add(boxBefore(id, *element));
      if (const T* element = after.find(id)) dirty.add(boxAfter(id, *element));
    }
}

}  // namespace idap
