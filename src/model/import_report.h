// What a reader had to drop or mend, in words for the user.
#pragma once

#include <string>
#include <vector>

namespace idap {

struct ImportReport {
  struct Entry {
    std::string place;  // the element, by id or name
    std::string what;   // what was done about what: "zero length: dropped"
    std::size_t count = 1;
  };
  std::vector<Entry> entries;

  void add(std::string place, std::string what) { entries.push_back({std::move(place), std::move(what)}); }
  bool empty() const { return entries.empty(); }
};

}  // namespace idap
