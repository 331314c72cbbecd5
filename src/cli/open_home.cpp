#include "cli/open_home.h"

namespace idap::cli {

ReadResult openHome(const std::string& file, Warnings& warnings, const Progress& progress) {
  ReadResult result = readHome(file, progress);
  warnings.add(result.report);
  return result;
}

}  // namespace idap::cli
