// An element of Home.xml: its attributes as numbers, lengths and colours, with what cannot be read put on the
// report.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "model/finish.h"
#include "model/import_report.h"

namespace idap {

inline constexpr double kCentimetre = 0.01;
// Numbers beyond this (10 000 km in the file's centimetres) mean nothing and are refused.
inline constexpr double kSh3dMaxNumber = 1e9;

class Sh3dElement {
 public:
  Sh3dElement(pugi::xml_node node, ImportReport& report) : node_(node), report_(&report) {}

  pugi::xml_node node() const { return node_; }
  ImportReport& report() const { return *report_; }
  std::string_view kind() const { return node_.name(); }
  // The element for the user: its name and kind, or its id.
  std::string place() const;

  bool has(const char* name) const { return !node_.attribute(name).empty(); }
  std::string text(const char* name) const { return node_.attribute(name).as_string(); }
  bool flag(const char* name, bool fallback) const;

  // Absent, or not a plausible number (which is reported).
  std::optional<double> number(const char* name) const;
  double number(const char* name, double fallback) const { return number(name).value_or(fallback); }
  std::optional<double> length(const char* name) const;  // cm in the file, m here
  double length(const char* name, double fallback) const { return length(name).value_or(fallback); }

  // A point of the plan, whose y runs down in the file. Nothing when either is missing.
  std::optional<Vec2> point(const char* x, const char* y) const;

  struct ColorValue {
    Color color;
    bool transparent = false;  // alpha 0
  };
  std::optional<ColorValue> colorValue(const char* name) const;
  std::optional<Color> color(const char* name) const;

  // The first child of that kind whose attribute "attribute" is as given (null: any).
  std::optional<Sh3dElement> child(const char* kind, const char* attribute = nullptr) const;

 private:
  pugi::xml_node node_;
  ImportReport* report_;
};

}  // namespace idap
