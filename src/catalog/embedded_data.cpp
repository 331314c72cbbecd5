#include "catalog/embedded_data.h"

namespace idap {

std::string_view embeddedCatalogFile(std::string_view name) {
  for (const EmbeddedFile& file : embeddedCatalogFiles())
    if (file.name == name) return file.text;
  return {};
}

}  // namespace idap
