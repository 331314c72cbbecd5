// The text of home.json, without the archive that a fuzzer seldom gets past. What was read must be valid, and
// must be the same after writing and reading it again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "formats/idap/idap_format.h"
#include "formats/idap/json_reader.h"
#include "formats/idap/migrations/migrations.h"
#include "model/validate.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  idap::ImportReport report;
  idap::Home home;
  try {
    nlohmann::json json = idap::idap_format::parseJson(text, "fuzz.idap");
    idap::idap_format::migrate(json, "fuzz.idap");
    home = idap::idap_format::fromJson(json, "fuzz.idap", {}, report);
  } catch (const idap::ParseError&) {
    return 0;
  } catch (const idap::UnsupportedVersion&) {
    return 0;
  }
  const idap::Home valid = idap::validated(std::move(home), report);
  const auto bytes = std::make_shared<const idap::Bytes>(idap::writeIdap(valid, {}));
  if (!(idap::readIdap(bytes, "again.idap", {}).home == valid)) std::abort();
  return 0;
}
