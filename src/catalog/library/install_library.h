// Taking a furniture library file into a folder of libraries, after a look at whether it is one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"
#include "catalog/catalog.h"

namespace idap {

struct LibraryPreview {
  std::string name, description, license;
  std::size_t pieces = 0;
  std::vector<std::string> names;   // of the first pieces
  std::vector<std::string> faults;  // pieces whose models are missing, in words; the others can be used
};

// Reads the file's tables and looks at its models' entries. Throws IoError; ParseError where it is no
// furniture library or has no piece that could be used.
LibraryPreview previewLibrary(const std::filesystem::path& file, const Progress& progress = {});

// Where installLibrary() will put it.
std::filesystem::path installedLibrary(const std::filesystem::path& file,
                                       const std::filesystem::path& folder);

// Copies the file there; one of the same name is replaced. Throws IoError.
void installLibrary(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace idap
