// Texts for the user in code that knows no Qt: written in English where they are used, marked for the
// translators, and put into the user's language by whoever shows them.
#pragma once

#include <string>
#include <utility>
#include <vector>

// QT_TRANSLATE_NOOP("idap", "Move") is the text itself; Qt's lupdate finds it by this name.
#ifndef QT_TRANSLATE_NOOP
#define QT_TRANSLATE_NOOP(context, text) text
#endif

namespace idap {

// A text with places %1, %2, … for what is not translated (names, lengths, counts).
struct Text {
  std::string source;
  std::vector<std::string> arguments;

  Text() = default;
  Text(const char* english) : source(english) {}
  Text(std::string english, std::vector<std::string> places = {})
      : source(std::move(english)), arguments(std::move(places)) {}
  bool empty() const { return source.empty(); }
  friend bool operator==(const Text&, const Text&) = default;
};

}  // namespace idap
