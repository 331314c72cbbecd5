#include <nlohmann/json.hpp>

#include "base/zip.h"
#include "formats/idap/idap_format.h"
#include "formats/idap/json_writer.h"
#include "formats/idap/migrations/migrations.h"
#include "model/assets.h"
#include "model/validate.h"

namespace idap {

Bytes writeIdap(const Home& home, const Progress& progress) {
  progress.check();
  requireValid(home);
  nlohmann::json json = idap_format::toJson(home);
  json["version"] = idap_format::kCurrentVersion;
  const std::string text = idap_format::printJson(json);
  progress.report(0.5, "packing the home");
  progress.check();

  std::vector<std::string> names;
  for (const auto& [name, bytes] : *home.assets) names.push_back(name);
  std::map<std::string, SharedBytes> entries;
  for (const std::string& name : assetsInUse(home, names)) entries.emplace(name, home.assets->at(name));
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  entries["home.json"] = std::make_shared<const Bytes>(begin, begin + text.size());
  return writeZip(entries);
}

}  // namespace idap
