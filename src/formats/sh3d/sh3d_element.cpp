#include "formats/sh3d/sh3d_element.h"

#include <charconv>
#include <cmath>
#include <cstdint>

namespace idap {

std::string Sh3dElement::place() const {
  std::string what(kind());
  if (has("name")) return what + " \"" + text("name") + "\"";
  if (has("id")) return what + " " + text("id");
  return what;
}

bool Sh3dElement::flag(const char* name, bool fallback) const {
  const std::string_view value = node_.attribute(name).as_string();
  if (value == "true") return true;
  if (value == "false") return false;
  return fallback;
}

std::optional<double> Sh3dElement::number(const char* name) const {
  const pugi::xml_attribute attribute = node_.attribute(name);
  if (!attribute) return std::nullopt;
  const std::string_view value = attribute.as_string();
  double result = 0;
  const auto [stop, error] = std::from_chars(value.data(), value.data() + value.size(), result);
  if (error != std::errc{} || stop != value.data() + value.size() || !std::isfinite(result) ||
      std::abs(result) > kSh3dMaxNumber) {
    report_->add(place(), std::string(name) + " is not a usable number (" + std::string(value.substr(0, 40)) +
                              "): ignored");
    return std::nullopt;
  }
  return result;
}

std::optional<double> Sh3dElement::length(const char* name) const {
  const auto centimetres = number(name);
  return centimetres ? std::optional(*centimetres * kCentimetre) : std::nullopt;
}

std::optional<Vec2> Sh3dElement::point(const char* x, const char* y) const {
  const auto right = length(x), down = length(y);
  if (!right || !down) return std::nullopt;
  return Vec2{*right, -*down};
}

std::optional<Sh3dElement::ColorValue> Sh3dElement::colorValue(const char* name) const {
  std::string_view value = node_.attribute(name).as_string();
  if (value.empty()) return std::nullopt;
  if (value.front() == '#') value.remove_prefix(1);
  std::uint64_t argb = 0;
  const auto [stop, error] = std::from_chars(value.data(), value.data() + value.size(), argb, 16);
  if (error != std::errc{} || stop != value.data() + value.size()) {
    report_->add(place(), std::string(name) + " is not a colour: ignored");
    return std::nullopt;
  }
  const auto channel = [&](int shift) { return float((argb >> shift) & 0xFF) / 255; };
  return ColorValue{{channel(16), channel(8), channel(0)}, ((argb >> 24) & 0xFF) == 0};
}

std::optional<Color> Sh3dElement::color(const char* name) const {
  const auto value = colorValue(name);
  return value ? std::optional(value->color) : std::nullopt;
}

std::optional<Sh3dElement> Sh3dElement::child(const char* kind, const char* attribute) const {
  for (const pugi::xml_node node : node_.children(kind))
    if (!attribute || std::string_view(node.attribute("attribute").as_string()) == attribute)
      return Sh3dElement(node, *report_);
  return std::nullopt;
}

}  // namespace idap
