#include "base/data_path.h"

#include <cstdlib>

namespace idap {

namespace {

bool isFolder(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored);
}

}  // namespace

std::filesystem::path dataFolder() {
  if (const char* chosen = std::getenv("IDAP_DATA"); chosen && *chosen && isFolder(chosen)) return chosen;
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error && program.has_parent_path()) {
    const std::filesystem::path installed = program.parent_path().parent_path() / "share" / "idap";
    if (isFolder(installed)) return installed;
  }
  return IDAP_SHARE_DIR;
}

}  // namespace idap
