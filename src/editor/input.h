// What the views tell the tool in hand: pointer and keys, free of any toolkit.
#pragma once

#include <string>

#include "editor/plane.h"

namespace idap {

struct Modifiers {
  bool shift = false;    // keep proportions, add to the selection
  bool control = false;  // copy while dragging, toggle the selection
  bool alt = false;      // no snapping while it is held
  friend bool operator==(const Modifiers&, const Modifiers&) = default;
};

struct PointerEvent {
  enum class Kind { Press, Move, Release, DoubleClick, Leave };
  enum class Button { None, Left, Right };
  Kind kind = Kind::Move;
  Plane plane = Plane::XY;
  Vec2 at;              // m, on the plane
  double pixel = 0.01;  // m that one pixel of the view covers: what is "near" is a matter of the screen
  Button button = Button::None;  // of Press, Release and DoubleClick; of Move: the one that is held
  Modifiers modifiers;
};

enum class Key {
  Character,
  Enter,
  Escape,
  Tab,
  BackTab,
  Backspace,
  Delete,
  Left,
  Right,
  Up,
  Down,
  PageUp,
  PageDown
};

struct KeyEvent {
  Key key = Key::Character;
  std::string text;  // UTF-8, of Key::Character
  Modifiers modifiers;
};

}  // namespace idap
