#include "base/units.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/error.h"

namespace idap {

namespace {

constexpr double kInch = 0.0254, kFoot = 12 * kInch;  // m, by definition since 1959
constexpr int kMaxDepth = 100;

double metresPer(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::Metre:
      return 1;
    case LengthUnit::Centimetre:
      return 0.01;
    case LengthUnit::Millimetre:
      return 0.001;
    case LengthUnit::FeetInches:
      return kFoot;
  }
  return 1;
}

// A number on its own, or a length: 2*60 is a number of the bare unit, 2*60cm a length.
struct Quantity {
  double value = 0;
  bool isLength = false;
};

class Parser {
 public:
  Parser(std::string_view text, double bare) : text_(text), bare_(bare) {}

  double parse() {
    const Quantity result = sum();
    if (at_ < text_.size()) fail("this does not belong to a length");
    const double metres = result.isLength ? result.value : result.value * bare_;
    if (!std::isfinite(metres)) fail("the length is too large");
    return metres;
  }

 private:
  [[noreturn]] void fail(const char* reason) const {
    throw ParseError("\"" + std::string(text_) + "\"", "position " + std::to_string(at_ + 1), reason);
  }

  void skipSpace() {
    for (;;) {
      if (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t'))
        ++at_;
      else if (text_.substr(at_).starts_with("\xC2\xA0"))  // no-break space
        at_ += 2;
      else
        return;
    }
  }
  bool take(std::string_view what) {
    skipSpace();
    if (!text_.substr(at_).starts_with(what)) return false;
    at_ += what.size();
    return true;
  }
  bool takeAny(std::initializer_list<std::string_view> words) {
    for (const std::string_view word : words)
      if (take(word)) return true;
    return false;
  }

  Quantity sum() {
    Quantity left = product();
    for (;;) {
      const bool plus = take("+");
      if (!plus && !takeAny({"-", "\xE2\x88\x92"})) break;
      Quantity right = product();
      if (left.isLength != right.isLength) {  // 2m + 3: the 3 counts in the bare unit
        (left.isLength ? right : left).value *= bare_;
        left.isLength = true;
      }
      left.value += plus ? right.value : -right.value;
    }
    skipSpace();
    return left;
  }

  Quantity product() {
    Quantity left = factor();
    for (;;) {
      if (takeAny({"*", "\xC3\x97"})) {
        const Quantity right = factor();
        if (left.isLength && right.isLength) fail("a length times a length is an area");
        left = {left.value * right.value, left.isLength || right.isLength};
      } else if (takeAny({"/", "\xC3\xB7"})) {
        const Quantity right = factor();
        if (right.isLength) fail("a length can only be divided by a number");
        if (right.value == 0) fail("division by zero");
        left.value /= right.value;
      } else {
        return left;
      }
    }
  }

  Quantity factor() {
    if (++depth_ > kMaxDepth) fail("nested too deeply");
    Quantity result;
    if (takeAny({"-", "\xE2\x88\x92"})) {
      result = factor();
      result.value = -result.value;
    } else if (take("+")) {
      result = factor();
    } else if (take("(")) {
      result = sum();
      if (!take(")")) fail("a closing bracket is missing");
    } else {
      result = length();
    }
    --depth_;
    return result;
  }

  Quantity length() {
    const double first = number();
    if (takeInches()) return {first * kInch, true};
    if (takeFeet()) return {first * kFoot + inchesAfterFeet(), true};
    // "8 1/2"" is eight and a half inches; "8 1/2" alone is no length.
    if (const auto inches = tryMixedInches(first)) return {*inches * kInch, true};
    if (take("mm")) return {first * 0.001, true};
    if (take("cm")) return {first * 0.01, true};
    if (take("dm")) return {first * 0.1, true};
    if (take("m")) return {first, true};
    return {first, false};
  }

  bool takeInches() { return takeAny({"\"", "''", "\xE2\x80\xB3", "\xE2\x80\x9D", "in"}); }
  bool takeFeet() { return takeAny({"'", "\xE2\x80\xB2", "\xE2\x80\x99", "ft"}); }

  bool startsNumber() {
    skipSpace();
    return at_ < text_.size() && (isDigit(text_[at_]) || text_[at_] == '.');
  }

  // The inches after feet: 8", 8 1/2", 1/2", or 8 with no sign.
  double inchesAfterFeet() {
    if (!startsNumber()) return 0;
    const double inches = number();
    if (takeInches()) return inches * kInch;
    const std::size_t before = at_;
    if (const auto mixed = tryMixedInches(inches)) return *mixed * kInch;
    at_ = before;
    return inches * kInch;
  }

  // After a number: `1/2"` more inches, or `/2"` that makes it a fraction of an inch.
  std::optional<double> tryMixedInches(double first) {
    const std::size_t before = at_;
    double whole = first, numerator = 0;
    if (startsNumber()) {
      numerator = number();
    } else {
      numerator = first;
      whole = 0;
    }
    if (take("/") && startsNumber()) {
      const double denominator = number();
      if (takeInches() && denominator != 0) return whole + numerator / denominator;
    }
    at_ = before;
    return std::nullopt;
  }

  static bool isDigit(char c) { return c >= '0' && c <= '9'; }

  double number() {
    if (!startsNumber()) fail("a number is missing");
    std::string digits;  // with a point, whichever sign the text has
    while (at_ < text_.size() && (isDigit(text_[at_]) || text_[at_] == '.' || text_[at_] == ',')) {
      digits += text_[at_] == ',' ? '.' : text_[at_];
      ++at_;
    }
    double value = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (read.ec != std::errc() || read.ptr != digits.data() + digits.size()) fail("this is not a number");
    return value;
  }

  std::string_view text_;
  double bare_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

std::string trimmed(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string feetInches(double metres) {
  const double sixteenths = std::round(std::abs(metres) / kInch * 16);
  if (!(sixteenths < 1e15)) return trimmed(metres / kFoot, 0) + "'";
  auto rest = static_cast<long long>(sixteenths);
  const long long feet = rest / (12 * 16);
  rest %= 12 * 16;
  const long long inches = rest / 16, fraction = rest % 16;
  std::string text = metres < 0 && sixteenths > 0 ? "-" : "";
  if (feet > 0) text += std::to_string(feet) + "'";
  if (inches == 0 && fraction == 0) return feet > 0 ? text : "0\"";
  if (feet > 0) text += ' ';
  if (inches > 0) text += std::to_string(inches);
  if (fraction > 0) {
    const long long common = std::gcd(fraction, 16LL);
    text += fmt::format("{}{}/{}", inches > 0 ? " " : "", fraction / common, 16 / common);
  }
  return text + '"';
}

}  // namespace

double parseLength(std::string_view text, LengthUnit bare) { return Parser(text, metresPer(bare)).parse(); }

std::string formatLength(double metres, LengthUnit unit, int decimals) {
  switch (unit) {
    case LengthUnit::Metre:
      return trimmed(metres, decimals < 0 ? 4 : decimals) + " m";
    case LengthUnit::Centimetre:
      return trimmed(metres * 100, decimals < 0 ? 2 : decimals) + " cm";
    case LengthUnit::Millimetre:
      return trimmed(metres * 1000, decimals < 0 ? 1 : decimals) + " mm";
    case LengthUnit::FeetInches:
      return feetInches(metres);
  }
  return {};
}

}  // namespace idap
