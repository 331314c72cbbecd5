#include "cli/arguments.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>

#include "cli/usage_error.h"

namespace idap::cli {

std::pair<int, int> parseSize(const std::string& text) {
  int width = 0, height = 0;
  const char* end = text.data() + text.size();
  const auto w = std::from_chars(text.data(), end, width);
  if (w.ec == std::errc() && w.ptr != end && (*w.ptr == 'x' || *w.ptr == 'X')) {
    const auto h = std::from_chars(w.ptr + 1, end, height);
    if (h.ec == std::errc() && h.ptr == end && width > 0 && height > 0) return {width, height};
  }
  throw UsageError(fmt::format("--size {}: give width x height in pixels, for instance 960x640", text));
}

std::optional<CivilTime> parseDateTime(const std::string& text) {
  CivilTime t;
  t.hour = 12;
  char separator = 'T';
  int used = 0;
  const int fields = std::sscanf(text.c_str(), "%4d-%2d-%2d%n%c%2d:%2d%n:%2d%n", &t.year, &t.month, &t.day,
                                 &used, &separator, &t.hour, &t.minute, &used, &t.second, &used);
  if ((fields != 3 && fields != 6 && fields != 7) || used != static_cast<int>(text.size()))
    return std::nullopt;
  if (separator != 'T' && separator != ' ') return std::nullopt;
  const auto within = [](int value, int low, int high) { return value >= low && value <= high; };
  if (!within(t.year, 1600, 2600) || !within(t.month, 1, 12) || !within(t.day, 1, 31) ||
      !within(t.hour, 0, 23) || !within(t.minute, 0, 59) || !within(t.second, 0, 59))
    return std::nullopt;
  return t;
}

std::optional<CivilTime> dateTimeArgument(const char* option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  const std::optional<CivilTime> time = parseDateTime(text);
  if (!time)
    throw UsageError(fmt::format("{} {}: give a date and time, for instance 2026-06-21T16:30", option, text));
  return time;
}

std::int64_t utcAtHome(const Home& home, const CivilTime& local) {
  return utcFromCivil(local, isTimeZone(home.site.timeZone) ? home.site.timeZone : "UTC");
}

Camera chooseCamera(const Home& home, const std::string& wish, double aspect, bool& fromAbove) {
  fromAbove = false;
  const auto top = [&] {
    fromAbove = true;
    return topCamera(home, aspect);
  };
  if (wish.empty()) {
    if (!home.cameras.empty()) return *home.cameras.begin()->second;
    if (home.observer) return *home.observer;
    return top();
  }
  for (const auto& [id, camera] : home.cameras) {
    if (camera->name == wish) return *camera;
  }
  if (wish == "top") return top();
  std::size_t number = 0;
  const auto parsed = std::from_chars(wish.data(), wish.data() + wish.size(), number);
  if (parsed.ec == std::errc() && parsed.ptr == wish.data() + wish.size() && number >= 1 &&
      number <= home.cameras.size())
    return *std::next(home.cameras.begin(), static_cast<std::ptrdiff_t>(number - 1))->second;
  std::string names;
  std::size_t count = 0;
  for (const auto& [id, camera] : home.cameras) names += fmt::format("{} '{}', ", ++count, camera->name);
  throw Error(fmt::format("no camera '{}' in this home; it has {}top", wish, names));
}

LampPolicy lampPolicy(const std::string& text) {
  return text == "on" ? LampPolicy::On : text == "off" ? LampPolicy::Off : LampPolicy::Auto;
}

CLI::Validator within(double low, double high) {
  const auto check = [low, high](const std::string& text) -> std::string {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc() && end == text.data() + text.size() && value >= low && value <= high) return {};
    return fmt::format("{} is not a number from {} to {}", text, low, high);
  };
  return CLI::Validator(check, fmt::format("{} to {}", low, high));
}

}  // namespace idap::cli
