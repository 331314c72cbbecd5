// The files of share/catalog as they were when the program was built, so that the built-in catalog needs
// none.
#pragma once

#include <string_view>
#include <vector>

namespace idap {

struct EmbeddedFile {
  std::string_view name;  // "materials.json"
  std::string_view text;
};

const std::vector<EmbeddedFile>& embeddedCatalogFiles();  // by name
// Empty when there is no such file.
std::string_view embeddedCatalogFile(std::string_view name);

}  // namespace idap
