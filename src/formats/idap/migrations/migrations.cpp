#include "formats/idap/migrations/migrations.h"

#include <array>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace idap::idap_format {

namespace {

using Step = void (*)(nlohmann::json&);
constexpr std::array<Step, kCurrentVersion - 1> kSteps = {migrate1To2};  // [0]: from version 1

}  // namespace

void migrate(nlohmann::json& home, const std::string& fileName) {
  if (!home.is_object()) throw ParseError(fileName, "home.json#", "expected an object");
  const auto found = home.find("version");
  if (found == home.end() || !found->is_number_integer())
    throw ParseError(fileName, "home.json#/version", "expected the version of the format, a whole number");
  const auto version = found->is_number_unsigned() ? found->get<std::uint64_t>() : 0;
  if (version > kCurrentVersion)
    throw UnsupportedVersion(fileName + ": this home was saved in version " + std::to_string(version) +
                             " of the format; this program reads up to version " +
                             std::to_string(kCurrentVersion) +
                             ". Open it with a newer IDAP, or save it there in an older format.");
  if (version < 1)
    throw UnsupportedVersion(fileName + ": version " + found->dump() + " of the format never existed");
  for (auto step = static_cast<std::size_t>(version - 1); step < kSteps.size(); ++step) kSteps[step](home);
  home["version"] = kCurrentVersion;
}

}  // namespace idap::idap_format
