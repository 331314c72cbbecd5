// Whole .idap archives: whatever the bytes, the reader returns a valid home or throws one of its errors.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "base/error.h"
#include "formats/idap/idap_format.h"
#include "model/validate.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto* begin = reinterpret_cast<const std::byte*>(data);
  const auto bytes = std::make_shared<const idap::Bytes>(begin, begin + size);
  try {
    idap::requireValid(idap::readIdap(bytes, "fuzz.idap", {}).home);
  } catch (const idap::ParseError&) {
  } catch (const idap::UnsupportedVersion&) {
  }
  return 0;
}
