// Values that a tool shows beside the pointer and that can be typed at any moment: lengths in the user's unit
// with units and sums, angles in degrees, texts. What was typed stands until clear() or a new define(); until
// then the tool asks value() for it and shows the rest as they are.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/units.h"
#include "editor/input.h"
#include "editor/overlay.h"

namespace idap {

class TypedFields {
 public:
  TypedFields() = default;
  explicit TypedFields(std::vector<Field> fields) { define(std::move(fields)); }

  // Labels, kinds and values; keys go to the one marked active, or the first. Drops what was typed.
  void define(std::vector<Field> fields);
  const std::vector<Field>& fields() const { return fields_; }

  // The value as it is now, shown while nothing is typed there.
  void show(std::size_t index, double value);
  void activate(std::size_t index);
  std::size_t active() const { return active_; }  // 0 for no fields

  bool typing() const;  // something stands typed in any of them
  bool wrong() const;   // and something of it cannot be understood
  // What was typed, m or radians; none where nothing was, or nothing that can be understood.
  std::optional<double> value(std::size_t index) const;
  std::string text(std::size_t index) const;  // of Kind::Text

  enum class Answer {
    Unused,   // not a key of fields, or Enter and Escape with nothing typed
    Changed,  // show the work as it would be now
    Apply,    // Enter: do it
    Wrong     // Enter, but what was typed cannot be understood: it stays, marked so
  };
  // Digits, signs, quotes, brackets; letters of units after the first digit; any text in a text's field, with
  // a new line for Shift+Enter. Backspace; Tab and BackTab change the field; Escape drops what was typed.
  Answer key(const KeyEvent& event, LengthUnit unit);

  void clear();  // drops what was typed, the active field stays
  void clear(std::size_t index);

  // Puts the fields into what a tool shows.
  void into(Overlay& overlay, Vec2 at) const;

 private:
  void read(std::size_t index, LengthUnit unit);

  std::vector<Field> fields_;
  std::vector<std::optional<double>> values_;
  std::size_t active_ = 0;
};

// Degrees with sums, as lengths are read: `45`, `90-22,5`, `30°`; radians. None for what cannot be
// understood.
std::optional<double> parseAngle(std::string_view text);

}  // namespace idap
