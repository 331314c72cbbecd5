#include "cli/open_home.h"

#include <fmt/format.h>

#include <cstdio>

namespace idap::cli {

ReadResult openHome(const std::string& file, const Progress& progress) {
  ReadResult result = readHome(file, progress);
  constexpr std::size_t kShown = 10;
  const auto& entries = result.report.entries;
  for (std::size_t i = 0; i < entries.size() && i < kShown; ++i) {
    const std::string times = entries[i].count > 1 ? fmt::format(" ({} times)", entries[i].count) : "";
    fmt::print(stderr, "idap: {}: {}: {}{}\n", file, entries[i].place, entries[i].what, times);
  }
  if (entries.size() > kShown) fmt::print(stderr, "idap: {}: and {} more\n", file, entries.size() - kShown);
  return result;
}

}  // namespace idap::cli
