// Where a point that the user draws is meant to be: at an end, on a line, at a right angle, on the grid.
// Snaps are inferred from what is there; the Alt key turns them off.
#pragma once

#include <optional>
#include <vector>

#include "editor/editor.h"

namespace idap {

struct SnapRequest {
  Plane plane = Plane::XY;
  Vec2 at;
  double tolerance = 0.1;       // m
  std::optional<Vec2> from;     // the line being drawn starts here: angles in 15-degree steps count from it
  std::optional<double> along;  // and so do angles against this direction (the last wall's), radians
  std::vector<Vec2> own;        // points of what is being drawn, to close it
  std::vector<Vec2> marks;      // what it may line up with, beside what is there
  Elements ignored;             // what is being moved
  bool wallFaces = false;  // also onto the faces of walls (rooms, dimensions), not only their centre lines
};

struct SnappedPoint {
  enum class To { Nothing, End, Own, Crossing, Line, Angle, Alignment, Grid };
  Vec2 at;
  To to = To::Nothing;
  std::vector<GuideLine> guides;
};

// off: the Alt key is held. Also off where the settings say so; the grid then counts still, if it is set to.
SnappedPoint snapPoint(const Editor& editor, const SnapRequest& request, bool off);

// Where a piece being moved or placed comes to lie: its back against a wall (turned to it when mayTurn), its
// sides and centre lines against those of other pieces, on a table. In XZ and YZ its height snaps too.
struct PieceSnapRequest {
  Plane plane = Plane::XY;
  Piece piece;              // where the pointer wants it; z relative to its level
  double tolerance = 0.15;  // m
  bool mayTurn = false;     // turn its back to the wall
  bool mayStack = true;     // stand on what is below
  bool hangs = false;       // its height is its own (a lamp at the ceiling, a picture): never stacked
  Elements ignored;         // the piece itself and those that move with it
};
struct SnappedPiece {
  Vec3 position;
  double angle = 0;
  bool onWall = false, stacked = false;
  std::vector<GuideLine> guides;
};
SnappedPiece snapPiece(const Editor& editor, const PieceSnapRequest& request, bool off);

// The nearest walls or pieces to the left and right, front and back of a piece (in XZ and YZ: beside, above
// and below), as lines to measure by, at most four.
std::vector<MeasureLine> clearances(const Editor& editor, Plane plane, const Piece& piece,
                                    const Elements& ignored);

// A door or window near a wall jumps into it: set in its thickness, turned along it, its front to the side of
// the pointer. Nothing where no wall is within reach.
// ignored: openings that it may overlap (itself, while it is moved). Its depth becomes that of the wall.
std::optional<Opening> snapOpening(const Editor& editor, Opening opening, Vec2 at, double reach,
                                   const Elements& ignored = {});

// The step of the grid that points snap to, m: the smallest round length that is no less than a tolerance.
double gridStep(double tolerance, LengthUnit unit);

}  // namespace idap
