// The building kit of parametric furniture: a Builder that collects solids, bent and turned wood, cushions,
// cloth, panels and leaves into one mesh with named material slots.
//
// Object space of model/piece.h: x right, y to the back (the front faces -y), z up, origin in the middle of
// the base; metres. Texture coordinates are metres too, so that pictures keep their scale; u runs along the
// grain of wood (the long axis of a part). Every part gets its own texture offset, so that two boards differ.
// Solids are closed, wound outward, and have bevels where the real thing has.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "catalog/parametric/paths.h"
#include "geometry/box.h"
#include "geometry/mesh.h"
#include "geometry/polygon.h"
#include "geometry/transform.h"

namespace idap::parametric {

inline constexpr double kBevel = 0.0015;  // m, of a sanded edge

enum class Grain { Auto, X, Y, Z };  // Auto: along the longest side

enum class Cap { None, Flat, Round };

enum class LegShape { Round, Square, Turned };

// How a soft body departs from a rounded box. All lengths in metres; it always fills the box it is given.
struct Soft {
  double radius = 0.04;  // of its edges; at most half its thinnest side
  double crown = 0.02;   // how much higher its middle is than its border, on both faces of the thin axis
  double bulge = 0.0;    // how much its sides swell
  double wrinkle = 0.0;  // height of irregular soft folds
  double wrinkleLength = 0.25;        // m from fold to fold
  int tuftColumns = 0, tuftRows = 0;  // diamond tufting of the face towards tuftFace
  double tuftDepth = 0.02;
  Vec3 tuftFace{0, -1, 0};  // unit axis vector: which face is tufted
  bool pinched = false;     // corners drawn out as a pillow's: two faces meet in a seam all around
  int segments = 10;        // grid cells along the longer sides of a face
};

// A cloth laid over a box: it covers the top, hangs over the sides named, in soft folds.
struct Drape {
  double left = 0.2, right = 0.2, front = 0.2, back = 0;  // m hanging down each side; 0: ends at the edge
  double thickness = 0.012;                               // m of the cloth (a duvet: 0.04)
  double radius = 0.05;                                   // m it bends over the edge with
  double fold = 0.012;                                    // m the hanging part swings in and out
  double foldLength = 0.22;                               // m from fold to fold
  double crown = 0.0;                                     // m the middle is higher
  double wrinkle = 0.004;                                 // m of soft unevenness on top
  int segments = 36;
};

struct Leaf {
  double length = 0.2, width = 0.08;
  double droop = 0.6;      // radians the leaf bends down from base to tip
  double fold = 0.3;       // radians each half is raised from flat along the midrib
  double widest = 0.4;     // 0..1 along the length
  double tip = 1.0;        // >1: more pointed
  double wave = 0.0;       // m of ripple along the border
  int lobes = 0;           // cuts on each side, as of a monstera
  double lobeDepth = 0.6;  // share of the half width that a cut goes in
  int segments = 8;
};

using Surface = std::function<Vec3(double u, double v)>;  // u and v in 0..1

class Builder {
 public:
  explicit Builder(Vec3 size) : size_(size) {}

  // The box to fill.
  Vec3 size() const { return size_; }
  double width() const { return size_.x; }
  double depth() const { return size_.y; }
  double height() const { return size_.z; }
  double left() const { return -size_.x / 2; }
  double right() const { return size_.x / 2; }
  double front() const { return -size_.y / 2; }
  double back() const { return size_.y / 2; }

  // Parts that follow belong to this material slot.
  void slot(const std::string& name);

  // Parts made inside f are moved by t (after the transforms around it). t may mirror.
  template <class F>
  void within(const Transform& t, F&& f) {
    const Transform outer = std::exchange(transform_, transform_ * t);
    f();
    transform_ = outer;
  }
  template <class F>
  void at(Vec3 origin, F&& f) {
    within(Transform::translation(origin), std::forward<F>(f));
  }
  // f as it is and once more with left and right exchanged.
  template <class F>
  void mirroredX(F&& f) {
    f();
    within(Transform::scaling({-1, 1, 1}), f);
  }
  // f as it is and once more with front and back exchanged.
  template <class F>
  void mirroredY(F&& f) {
    f();
    within(Transform::scaling({1, -1, 1}), f);
  }
  template <class F>
  void mirroredXY(F&& f) {
    mirroredX([&] { mirroredY(f); });
  }

  // Parts made inside f, stretched together to fill a box (given in the transform of the outermost level):
  // for what grows freely, so that what carries it keeps its shape.
  template <class F>
  void fitted(Vec3 min, Vec3 max, F&& f) {
    const std::size_t vertices = mesh_.positions.size(), lights = lights_.size();
    f();
    stretch(vertices, lights, min, max);
  }

  // --- Solids (kit_solids.cpp) ---
  // A board or block with a small round on every edge.
  void box(Vec3 min, Vec3 max, double bevel = kBevel, Grain grain = Grain::Auto);
  // A block with rounded edges and corners; segments in a quarter turn.
  void roundedBox(Vec3 min, Vec3 max, double radius, int segments = 4, Grain grain = Grain::Auto);
  // Turned about the z axis through base: points are (radius, height above base), solid to the left of the
  // way they go (up the outside, for a bowl then down the inside). Corners sharper than 40 degrees stay
  // crisp; round them with fillet().
  void lathe(Vec3 base, const std::vector<Vec2>& profile, int sides = 28);
  void cylinder(Vec3 base, double radius, double height, double bevel = kBevel, int sides = 28);
  void cone(Vec3 base, double bottomRadius, double topRadius, double height, double bevel = kBevel,
            int sides = 28);
  void sphere(Vec3 centre, double radius, int sides = 24);
  void ellipsoid(Vec3 centre, Vec3 radii, int sides = 24);
  void torus(Vec3 centre, double ringRadius, double radius, int ringSides = 36, int sides = 12);  // lies flat
  // A prism over a polygon (counter-clockwise or not; no holes needed) from z to z + height, its rims
  // bevelled.
  void extrude(const Polygon& polygon, double z, double height, double bevel = kBevel,
               Grain grain = Grain::Auto);
  void extrude(const Region& region, double z, double height, double bevel = kBevel,
               Grain grain = Grain::Auto);
  // The same standing up: polygon points are (x, z), thickness from y0 to y1; or (y, z), from x0 to x1.
  void extrudeAlongY(const Polygon& xz, double y0, double y1, double bevel = kBevel);
  void extrudeAlongX(const Polygon& yz, double x0, double x1, double bevel = kBevel);

  // --- Swept parts (kit_sweep.cpp) ---
  // A round bar along a path; give corners a radius with roundedPath() or use spline().
  void tube(const Path& path, double radius, int sides = 12, Cap cap = Cap::Round, bool closed = false);
  // radius as a function of 0..1 along the path.
  void tube(const Path& path, const std::function<double(double)>& radius, int sides = 12,
            Cap cap = Cap::Round);
  void rod(Vec3 from, Vec3 to, double radius, int sides = 12, Cap cap = Cap::Flat) {
    tube({from, to}, radius, sides, cap);
  }
  // Any section along a path. Section points: x to the side, y along up (as far as square to the path);
  // counter-clockwise seen against the way of the path. The same number of points all along.
  void sweep(const Path& path, const std::function<Polygon(double)>& section, Vec3 up = {0, 0, 1},
             bool closed = false);
  void sweep(const Path& path, const Polygon& section, Vec3 up = {0, 0, 1}, bool closed = false);
  // A leg whose ends are cut level, so that it stands flat however much it splays. Radii: half its thickness.
  void leg(Vec3 top, Vec3 foot, double topRadius, double footRadius, LegShape shape = LegShape::Round);
  // Closed rings of equal point counts joined into a skin, counter-clockwise seen from the last ring; both
  // ends closed flat where capped.
  void loft(const std::vector<Path>& rings, bool capped = true, double crease = 0.7);

  // --- Soft and thin parts (kit_soft.cpp) ---
  void cushion(Vec3 min, Vec3 max, const Soft& soft = {});
  // Piping around a cushion of that box, square to its axis (0 x, 1 y, 2 z), at a fraction of it.
  void piping(Vec3 min, Vec3 max, double cornerRadius, int axis = 2, double fraction = 0.5,
              double radius = 0.004);
  void drape(Vec3 min, Vec3 max, const Drape& drape = {});  // cloth over that box
  // A surface; its front is where dP/du x dP/dv points. thickness 0: a single open sheet (leaves, shades);
  // otherwise a closed shell whose back lies that far behind the surface, with a rounded rim.
  void surface(const Surface& f, int cellsU, int cellsV, double thickness = 0, bool closedU = false,
               bool closedV = false);
  // A leaf that grows from base along direction; up: its upper side.
  void leaf(Vec3 base, Vec3 direction, Vec3 up, const Leaf& leaf = {});
  // Clay or porcelain pot, open at the top, filled with earth (slots "pot" and "soil" by name).
  void pot(Vec3 base, double bottomRadius, double topRadius, double height, double rim = 0.0);
  // A lampshade: open at both ends, of that wall thickness.
  void shade(Vec3 base, double bottomRadius, double topRadius, double height, double thickness = 0.0012,
             int sides = 40);

  // --- Joinery (kit_joinery.cpp); fronts face -y, their visible face at min.y ---
  // A frame of four bars around a panel set back (shaker), or around nothing but a pane: panelSlot empty
  // keeps the slot. The panel is panelThickness thick, in the middle of the frame's depth unless set back.
  struct FramedPanel {
    double stile = 0.06;     // m, width of the frame's bars
    double setBack = 0.008;  // m from the frame's face to the panel's
    double panelThickness = 0.008;
    int columns = 1, rows = 1;  // panes
    double bar = 0.025;         // m, width of the bars between panes
    double bevel = kBevel;
    std::string panelSlot;
  };
  void framedPanel(Vec3 min, Vec3 max, const FramedPanel& style);
  void knob(Vec3 at, double radius = 0.014);  // sticks out to -y
  void barPull(Vec3 centre, double length, bool vertical, double radius = 0.005, double standOff = 0.03);
  void cupPull(Vec3 centre, double width = 0.09, double height = 0.035);
  void castor(Vec3 floor, double radius = 0.025);  // twin wheel on a stem, touching the floor at that point
  void bulb(Vec3 centre, double radius = 0.03, bool up = true);  // a lamp bulb's glass; also marks the light

  // Where a lamp's light comes from.
  void light(Vec3 position);

  // A part of one's own: positions, optional uvs, triangles wound outward. Normals are made where absent,
  // smooth up to crease radians. fixedUvs: texture coordinates stay as given (a painting in its frame).
  void add(Mesh part, double crease = 0.7, bool fixedUvs = false);

  // Deterministic variation, 0..1: the same for equal keys.
  static double random(int key);

  struct Result {
    Mesh mesh;
    std::vector<std::string> slots;
    std::vector<Vec3> lights;
    Vec3 fit{1, 1, 1};  // how much the parts together had to be stretched to fill the box
  };
  // Everything so far, stretched to fill the box exactly. Generators aim at the box themselves: the stretch
  // is for the last millimetres, and for plants and the like that grow freely.
  Result finish();

 private:
  // Vertices and lights from these on; returns the factors.
  Vec3 stretch(std::size_t firstVertex, std::size_t firstLight, Vec3 min, Vec3 max);

  Vec3 size_;
  Transform transform_;
  Mesh mesh_;
  std::vector<std::string> slots_;
  std::uint32_t slot_ = 0;
  std::vector<Vec3> lights_;
  int parts_ = 0;
};

}  // namespace idap::parametric
