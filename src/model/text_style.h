// How text stands on the plan.
#pragma once

#include <optional>
#include <string>

#include "model/finish.h"

namespace idap {

enum class TextAlignment { Left, Centre, Right };

struct TextStyle {
  std::string font;    // empty: the program's
  double size = 0.18;  // m on the plan, height of a line
  bool bold = false, italic = false;
  TextAlignment alignment = TextAlignment::Centre;
  std::optional<Color> color;
  friend bool operator==(const TextStyle&, const TextStyle&) = default;
};

}  // namespace idap
