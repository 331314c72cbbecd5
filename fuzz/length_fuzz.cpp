// Lengths as text: a finite number or a ParseError.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "base/error.h"
#include "base/units.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const double metres = idap::parseLength({reinterpret_cast<const char*>(data), size});
    if (!std::isfinite(metres)) std::abort();
    for (const auto unit : {idap::LengthUnit::Metre, idap::LengthUnit::FeetInches})
      idap::formatLength(metres, unit);
  } catch (const idap::ParseError&) {
  }
  return 0;
}
