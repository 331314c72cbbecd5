// What a tool shows above the drawing while it is in hand: handles, guide lines, distances, fields to type
// in. In the plane's coordinates, metres; sizes on the screen are the painter's business.
#pragma once

#include <string>
#include <vector>

#include "base/translatable.h"
#include "geometry/polygon.h"
#include "geometry/vec.h"

namespace idap {

enum class HandleKind {
  Move,
  Rotate,
  ResizeWidth,
  ResizeDepth,
  ResizeHeight,
  ResizeCorner,
  Raise,
  Pitch,
  Roll,
  WallEnd,
  WallArc,
  Point,
  Offset,
  Aim,
  Height
};

struct Handle {
  HandleKind kind = HandleKind::Point;
  Vec2 at;
  double direction = 0;  // radians, along which it is dragged, for the shape of the cursor
  bool active = false;   // being dragged or under the pointer
};

struct GuideLine {  // why the pointer snapped where it did
  Vec2 from, to;
};

struct MeasureLine {  // a distance, with its length written on it by the painter in the user's unit
  Vec2 from, to;
  bool strong = false;  // the one being typed
};

struct AngleMark {  // an angle from one direction to another about a point
  Vec2 centre;
  double from = 0, to = 0;  // radians
};

struct PreviewShape {  // a line or an area that is being drawn
  std::vector<Vec2> points;
  bool closed = false, filled = false;
};

// A value the tool shows beside the pointer and takes from the keyboard at any moment.
struct Field {
  enum class Kind { Length, Angle, Text };
  const char* label = "";  // marked for translation
  Kind kind = Kind::Length;
  double value = 0;     // m or radians, as it is now
  std::string typed;    // what was typed so far; empty: shows the value
  bool active = false;  // the one that keys go to
  bool wrong = false;   // what was typed cannot be understood
};

struct Overlay {
  std::vector<Handle> handles;
  std::vector<GuideLine> guides;
  std::vector<MeasureLine> measures;
  std::vector<AngleMark> angles;
  std::vector<PreviewShape> shapes;
  std::vector<Field> fields;
  Vec2 fieldsAt;  // beside this point
  Text note;      // a word beside the pointer: what a click here would do, or why it cannot
  bool empty() const {
    return handles.empty() && guides.empty() && measures.empty() && angles.empty() && shapes.empty() &&
           fields.empty() && note.empty();
  }
};

enum class Cursor {
  Arrow,
  Cross,
  Move,
  Rotate,
  SizeHorizontal,
  SizeVertical,
  SizeDiagonal,
  SizeAntiDiagonal,
  Eraser,
  Text,
  Hand,
  Forbidden
};

}  // namespace idap
