// Cabinet making on top of the kit: carcasses, doors and drawer fronts in several styles, handles, feet,
// panes of glass and mirror, and what stands on shelves. Everything faces -y. Slots are named where they are
// used.
#pragma once

#include <string>

#include "catalog/parametric/kit.h"
#include "catalog/parametric/registry.h"

namespace idap::parametric {

// A rectangle of the x-z plane.
struct Pane {
  double x0, z0, x1, z1;
  double width() const { return x1 - x0; }
  double height() const { return z1 - z0; }
  double midX() const { return (x0 + x1) / 2; }
  double midZ() const { return (z0 + z1) / 2; }
  Pane inset(double by) const { return {x0 + by, z0 + by, x1 - by, z1 - by}; }
};

// One sheet, no thickness: so that light meets glass once.
void sheet(Builder& b, const Pane& pane, double y);

// Bars around a pane, mitred by eye: stiles run through, rails between them. From y0 (front) to y1.
void bars(Builder& b, const Pane& outer, double y0, double y1, double stile, double topRail,
          double bottomRail, double bevel = 0.003);
inline void bars(Builder& b, const Pane& outer, double y0, double y1, double width) {
  bars(b, outer, y0, y1, width, width, width);
}

enum class Pull { None, Knob, Bar, Cup, Edge };
Pull pullNamed(const std::string& name);  // "none", "knob", "bar", "cup", "edge"; unknown: bar
double pullDepth(Pull pull);              // m it stands out

// How doors and drawers look. Styles: "flat", "shaker", "glass", "mirror", "slats", "cane", "louvre",
// "panelled". Slots: "front", "glass", "mirror", "cane", "handle".
struct FrontStyle {
  std::string style = "flat";
  Pull pull = Pull::Bar;
  double thickness = 0.019;
  double gap = 0.003;  // all around
  std::string slot = "front";
};
enum class Hinge { Left, Right, Top };
enum class PullAt { Top, Middle, Bottom };

// Fills the pane (less the gap); y is the face, the board lies behind it.
void door(Builder& b, const Pane& pane, double y, const FrontStyle& style, Hinge hinge,
          PullAt at = PullAt::Middle);
void drawer(Builder& b, const Pane& pane, double y, const FrontStyle& style);

// Sides, bottom, top and back of boards; open in front. topOver: the top lies on the sides.
struct Carcass {
  double board = 0.018;
  double back = 0.006;
  bool topOver = false;
  bool hasTop = true;
};
void carcass(Builder& b, Vec3 min, Vec3 max, const Carcass& style = {});

// What a case stands on, from the floor to `height`: "plinth", "tapered", "splayed", "block", "metal",
// "sledge", "castors", "none". Slot: "legs".
void feet(Builder& b, const std::string& style, Vec3 min, Vec3 max, double height);

// A row of books on a shelf, spines to the front; fills about `fill` of the width. Slots "book-a" … "book-d"
// and "paper".
void books(Builder& b, double x0, double x1, double y, double z, double depth, double room, int seed,
           double fill = 0.85);
// Three of them lying; slots as above.
void bookPile(Builder& b, Vec3 base, int seed);
// A small vase, bowl or ball, by seed. Slot "vase".
void ornament(Builder& b, Vec3 base, double room, int seed);

// A spout with a lever, its foot at `base`, reaching `reach` towards -y. The slot stays as it is.
void tap(Builder& b, Vec3 base, double height, double reach);

// A cup-shaped hollow: a rounded rectangle of a counter sunk by `depth`, drawn as an open shell whose inner
// face is seen from above. Rim at z.
void basin(Builder& b, Vec2 centre, Vec2 half, double z, double depth, double exponent, double wall = 0.012);

}  // namespace idap::parametric
