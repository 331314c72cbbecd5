// A cursor over lines of words and numbers, for OBJ, MTL and their like. Never leaves its text and copies
// nothing.
#pragma once

#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

namespace idap {

class TextScan {
 public:
  explicit TextScan(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

  bool atEnd() const { return at_ == end_; }
  char peek() const { return at_ == end_ ? '\0' : *at_; }
  void skip() { ++at_; }
  std::size_t left() const { return std::size_t(end_ - at_); }

  // The text up to the next line end, without it; the cursor moves past it. Takes \n and \r\n.
  TextScan line() {
    const char* begin = at_;
    const auto* found =
        at_ == end_ ? nullptr : static_cast<const char*>(std::memchr(at_, '\n', std::size_t(end_ - at_)));
    const char* stop = found ? found : end_;
    at_ = found ? found + 1 : end_;
    if (stop > begin && stop[-1] == '\r') --stop;
    return TextScan(begin, stop);
  }

  void skipBlanks() {
    while (at_ != end_ && (*at_ == ' ' || *at_ == '\t')) ++at_;
  }

  std::string_view word() {
    skipBlanks();
    const char* begin = at_;
    while (at_ != end_ && *at_ != ' ' && *at_ != '\t') ++at_;
    return {begin, std::size_t(at_ - begin)};
  }

  // What is left, without blanks around it.
  std::string_view rest() {
    skipBlanks();
    const char* stop = end_;
    while (stop != at_ && (stop[-1] == ' ' || stop[-1] == '\t' || stop[-1] == '\r')) --stop;
    return {at_, std::size_t(stop - at_)};
  }

  // False, and no move, where no number stands. A number out of range comes out infinite or zero.
  template <class Float>
  bool number(Float& value) {
    skipBlanks();
    const char* from = at_ != end_ && *at_ == '+' ? at_ + 1 : at_;
    const auto [stop, error] = std::from_chars(from, end_, value);
    if (error == std::errc::invalid_argument) return false;
    if (error == std::errc::result_out_of_range) value = std::numeric_limits<Float>::infinity();
    at_ = stop;
    return true;
  }

  bool integer(std::int64_t& value) {
    const char* at = at_;
    const bool negative = at != end_ && *at == '-';
    if (at != end_ && (*at == '-' || *at == '+')) ++at;
    const char* digits = at;
    std::int64_t sum = 0;
    for (; at != end_ && *at >= '0' && *at <= '9'; ++at)
      if (sum < std::int64_t{1} << 40) sum = sum * 10 + (*at - '0');
    if (at == digits) return false;
    at_ = at;
    value = negative ? -sum : sum;
    return true;
  }

 private:
  TextScan(const char* begin, const char* end) : at_(begin), end_(end) {}

  const char* at_;
  const char* end_;
};

}  // namespace idap
