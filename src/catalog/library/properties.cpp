#include "catalog/library/properties.h"

#include <cstdint>

namespace idap {

namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\f'; }
bool isLineEnd(char c) { return c == '\n' || c == '\r'; }

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

void appendUtf8(std::string& text, std::uint32_t code) {
  const auto put = [&](std::uint32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xC0 | code >> 6);
    put(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    put(0xE0 | code >> 12);
    put(0x80 | (code >> 6 & 0x3F));
    put(0x80 | (code & 0x3F));
  } else {
    put(0xF0 | code >> 18);
    put(0x80 | (code >> 12 & 0x3F));
    put(0x80 | (code >> 6 & 0x3F));
    put(0x80 | (code & 0x3F));
  }
}

class PropertiesReader {
 public:
  explicit PropertiesReader(std::string_view text) : text_(text) {}

  bool next(std::string& key, std::string& value) {
    while (true) {
      while (at_ < text_.size() && (isBlank(text_[at_]) || isLineEnd(text_[at_]))) ++at_;
      if (at_ == text_.size()) return false;
      if (text_[at_] != '#' && text_[at_] != '!') break;
      while (at_ < text_.size() && !isLineEnd(text_[at_])) ++at_;
    }
    key.clear();
    value.clear();
    while (at_ < text_.size() && !isLineEnd(text_[at_]) && !isBlank(text_[at_]) && text_[at_] != '=' &&
           text_[at_] != ':')
      character(key);
    skipBlanks();
    if (at_ < text_.size() && (text_[at_] == '=' || text_[at_] == ':')) {
      ++at_;
      skipBlanks();
    }
    while (at_ < text_.size() && !isLineEnd(text_[at_])) character(value);
    return true;
  }

 private:
  void skipBlanks() {
    while (at_ < text_.size() && isBlank(text_[at_])) ++at_;
  }

  // One character, one escape, or nothing where a line is continued.
  void character(std::string& to) {
    const char c = text_[at_++];
    if (c != '\\') {
      appendUtf8(to, static_cast<unsigned char>(c));
      return;
    }
    if (at_ == text_.size()) return;
    const char escaped = text_[at_++];
    switch (escaped) {
      case 't':
        to += '\t';
        break;
      case 'n':
        to += '\n';
        break;
      case 'r':
        to += '\r';
        break;
      case 'f':
        to += '\f';
        break;
      case 'u':
        unicode(to);
        break;
      case '\r':
        if (at_ < text_.size() && text_[at_] == '\n') ++at_;
        [[fallthrough]];
      case '\n':
        skipBlanks();
        break;
      default:
        appendUtf8(to, static_cast<unsigned char>(escaped));
        break;
    }
  }

  // Four hexadecimal digits at the cursor, or -1.
  int unit(std::size_t at) const {
    int code = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const int digit = at + i < text_.size() ? hexDigit(text_[at + i]) : -1;
      if (digit < 0) return -1;
      code = code * 16 + digit;
    }
    return code;
  }

  void unicode(std::string& to) {
    const int first = unit(at_);
    if (first < 0) return;
    at_ += 4;
    auto code = static_cast<std::uint32_t>(first);
    if (code >= 0xD800 && code < 0xDC00 && text_.substr(at_, 2) == "\\u") {
      const int second = unit(at_ + 2);
      if (second >= 0xDC00 && second < 0xE000) {
        at_ += 6;
        code = 0x10000 + ((code - 0xD800) << 10) + (static_cast<std::uint32_t>(second) - 0xDC00);
      }
    }
    if (code >= 0xD800 && code < 0xE000) code = 0xFFFD;  // half of a pair
    appendUtf8(to, code);
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

void readProperties(std::string_view text,
                    const std::function<void(std::string_view key, std::string_view value)>& entry) {
  PropertiesReader reader(text);
  for (std::string key, value; reader.next(key, value);) entry(key, value);
}

}  // namespace idap
