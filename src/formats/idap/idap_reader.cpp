#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/zip.h"
#include "formats/idap/idap_format.h"
#include "formats/idap/json_reader.h"
#include "formats/idap/migrations/migrations.h"
#include "model/assets.h"
#include "model/validate.h"

namespace idap {

namespace {

constexpr const char* kHomeEntry = "home.json";
constexpr std::size_t kMaxJsonBytes = std::size_t{256} << 20;

}  // namespace

bool sniffIdap(const SharedBytes& bytes, const std::string& fileName) {
  if (!looksLikeZip(*bytes)) return false;
  try {
    return ZipReader(bytes, fileName).contains(kHomeEntry);
  } catch (const Error&) {
    return false;
  }
}

ReadResult readIdap(const SharedBytes& bytes, const std::string& fileName, const Progress& progress) {
  progress.check();
  const ZipReader zip(bytes, fileName);
  if (!zip.contains(kHomeEntry)) throw ParseError(fileName, kHomeEntry, "the archive has no such entry");
  if (zip.size(kHomeEntry) > kMaxJsonBytes) throw ParseError(fileName, kHomeEntry, "the entry is too large");
  ReadResult result;
  {
    const Bytes text = zip.read(kHomeEntry);
    progress.report(0.1, "reading the home");
    nlohmann::json json = idap_format::parseJson(asText(text), fileName);
    idap_format::migrate(json, fileName);
    result.home = idap_format::fromJson(json, fileName, progress, result.report);
  }
  Assets assets;
  for (const std::string& name : assetsInUse(result.home, zip.entries())) {
    progress.check();
    if (name != kHomeEntry) assets.emplace(name, std::make_shared<const Bytes>(zip.read(name)));
  }
  result.home.assets = std::make_shared<const Assets>(std::move(assets));
  progress.report(0.9, "checking the home");
  result.home = validated(std::move(result.home), result.report);
  return result;
}

}  // namespace idap
