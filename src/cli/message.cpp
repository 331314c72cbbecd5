#include "cli/message.h"

#include <fmt/format.h>

#include <cstdio>
#include <map>
#include <utility>

#include "base/utf8.h"

namespace idap::cli {

namespace {

constexpr std::size_t kMaxLineBytes = 600;
constexpr std::size_t kShown = 10;

}  // namespace

std::string oneLine(std::string_view text) {
  // Cut early, so that a text of many megabytes costs nothing; the last character may be mended below.
  const bool cut = text.size() > kMaxLineBytes;
  const std::string valid = toValidUtf8(text.substr(0, kMaxLineBytes));
  std::string line;
  for (std::size_t i = 0; i < valid.size(); ++i) {
    const auto byte = static_cast<unsigned char>(valid[i]);
    // U+0080 to U+009F are control characters too, in two bytes.
    const bool second =
        byte == 0xC2 && i + 1 < valid.size() && static_cast<unsigned char>(valid[i + 1]) < 0xA0;
    if (second) ++i;
    line += byte < 0x20 || byte == 0x7F || second ? ' ' : valid[i];
  }
  while (!line.empty() && line.back() == ' ') line.pop_back();
  return cut ? line + " ..." : line;
}

void printMessage(std::string_view text) {
  const std::string line = "idap: " + oneLine(text) + '\n';
  std::fputs(line.c_str(), stderr);  // not fmt::print, which throws where standard error is full or closed
}

Warnings::Warnings(std::string file, std::function<void()> beforePrinting)
    : file_(std::move(file)), beforePrinting_(std::move(beforePrinting)) {}

Warnings::~Warnings() {
  if (more_ == 0) return;
  if (beforePrinting_) beforePrinting_();
  printMessage(fmt::format("{}: and {} more", file_, more_));
}

void Warnings::add(const std::vector<std::string>& texts) {
  std::map<std::string_view, std::size_t> counts;
  for (const std::string& text : texts) ++counts[text];
  for (const std::string& text : texts) {  // in the order in which they came
    if (const std::size_t count = std::exchange(counts[text], 0)) print(text, count);
  }
}

void Warnings::add(const ImportReport& report) {
  for (const ImportReport::Entry& entry : report.entries) print(entry.place + ": " + entry.what, entry.count);
}

void Warnings::print(const std::string& text, std::size_t count) {
  if (!known_.insert(text).second) return;
  if (shown_ == kShown) {
    ++more_;
    return;
  }
  ++shown_;
  if (beforePrinting_) beforePrinting_();
  printMessage(count > 1 ? fmt::format("{}: {} ({} times)", file_, text, count) : file_ + ": " + text);
}

}  // namespace idap::cli
