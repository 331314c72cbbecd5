#include "render/film/light_mix.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "base/error.h"
#include "light/color_temperature.h"

namespace idap::render {

namespace {

std::string lower(std::string_view text) {
  std::string small(text);
  for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return small;
}

std::optional<float> numberOf(std::string_view word) {
  float value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<Rgb> hexColor(std::string_view word) {
  std::uint32_t rgb = 0;
  if (word.size() != 7 || word[0] != '#' ||
      std::from_chars(word.data() + 1, word.data() + 7, rgb, 16).ptr != word.data() + 7)
    return std::nullopt;
  const auto part = [rgb](int shift) { return srgbToLinear(static_cast<float>(rgb >> shift & 0xFF) / 255); };
  const Rgb color{part(16), part(8), part(0)};
  const float l = luminance(color);
  if (!(l > 1e-4f)) return std::nullopt;
  return color / l;
}

}  // namespace

LightChange parseLightChange(std::string_view text) {
  LightChange change;
  if (text.empty()) throw RenderError("say how strong the light is to be: 0.3, off, 2700K or #ffb060");
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(','), text.size());
    const std::string word = lower(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    // Of a temperature; 0: it is none.
    const float kelvin =
        word.ends_with('k') ? numberOf(std::string_view(word).substr(0, word.size() - 1)).value_or(0) : 0;
    if (word == "off") {
      change.strength = 0;
    } else if (word == "on") {
      change.strength = 1;
    } else if (const auto number = numberOf(word); number && *number >= 0 && *number <= 1e6f) {
      change.strength = *number;
    } else if (kelvin >= 1000 && kelvin <= 25'000) {
      change.color = rgbFromTemperature(static_cast<double>(kelvin));
    } else if (const auto color = hexColor(word)) {
      change.color = *color;
    } else {
      throw RenderError(
          fmt::format("\"{}\" is neither a strength (0.3, off), a temperature from 1000K to 25000K nor a "
                      "colour (#ffb060)",
                      word));
    }
  }
  return change;
}

std::vector<std::size_t> lightsNamed(const std::vector<LightGroup>& groups, std::string_view name) {
  std::string wanted = lower(name);
  const bool begins = wanted.ends_with('*');
  if (begins) wanted.pop_back();
  std::vector<std::size_t> found;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::string one = lower(groups[g].name);
    if (begins ? one.starts_with(wanted) : one == wanted) found.push_back(g);
  }
  return found;
}

Rgb mixFactor(const LightGroup& group, const LightChange& change) {
  Rgb factor = Rgb{1, 1, 1} * change.strength;
  if (!change.color) return factor;
  if (!(luminance(group.color) > 0))
    throw RenderError(fmt::format(
        "the colour of \"{}\" is not known, so that it cannot be changed; its strength can", group.name));
  // A saturated lamp has next to nothing of one colour; what is not there cannot be made much of.
  constexpr float kMost = 50;
  for (int k = 0; k < 3; ++k)
    factor[k] *= std::min((*change.color)[k] / std::max(group.color[k], 1e-3f), kMost);
  return factor;
}

Film mixed(const Film& film, const std::vector<LightGroup>& groups, const std::vector<LightChange>& changes) {
  if (film.groups.empty()) throw RenderError("this picture keeps no light by itself");
  std::vector<Rgb> factors(film.groups.size(), Rgb{1, 1, 1});
  for (std::size_t g = 0; g < std::min(changes.size(), factors.size()); ++g)
    factors[g] = mixFactor(g < groups.size() ? groups[g] : LightGroup{}, changes[g]);
  Film mix = film;
  for (std::size_t i = 0; i < mix.pixels(); ++i) {
    Rgb sum{};
    for (std::size_t g = 0; g < factors.size(); ++g) {
      mix.groups[g][i] *= factors[g];
      sum += mix.groups[g][i];
    }
    mix.color[i] = sum;
  }
  std::ranges::fill(mix.square, 0.0f);  // how the lights' noises go together is not known
  return mix;
}

}  // namespace idap::render
