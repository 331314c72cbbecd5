// What the commands say on standard error: whole lines, safe for a terminal whatever a file put into them.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "model/import_report.h"

namespace idap::cli {

// The text as one line: valid UTF-8, no control characters (which a terminal would obey), of bearable length.
std::string oneLine(std::string_view text);

// "idap: TEXT" on standard error; silent where that cannot be written.
void printMessage(std::string_view text);

// Warnings about one home. Equal ones are printed once, and at most ten altogether; when it goes, it says how
// many more there were.
class Warnings {
 public:
  // beforePrinting clears the place, for instance wipes a progress bar.
  explicit Warnings(std::string file, std::function<void()> beforePrinting = {});
  ~Warnings();
  Warnings(const Warnings&) = delete;
  Warnings& operator=(const Warnings&) = delete;

  void add(const std::vector<std::string>& texts);
  void add(const ImportReport& report);

 private:
  void print(const std::string& text, std::size_t count);

  std::string file_;
  std::function<void()> beforePrinting_;
  std::set<std::string> known_;
  std::size_t shown_ = 0, more_ = 0;
};

}  // namespace idap::cli
