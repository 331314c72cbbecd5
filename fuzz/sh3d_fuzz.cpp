// Feeds bytes to the reader of Sweet Home 3D's homes: as an archive, and as the Home.xml of one.
#include <cstddef>
#include <cstdint>

#include "base/error.h"
#include "base/zip.h"
#include "formats/sh3d/sh3d_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace idap;
  const auto* begin = reinterpret_cast<const std::byte*>(data);
  const auto bytes = std::make_shared<const Bytes>(begin, begin + size);
  const auto read = [](const SharedBytes& archive) {
    try {
      readSh3d(archive, "fuzz.sh3d", Progress{});
    } catch (const Error&) {
      // Refusing is right; crashing is not.
    }
  };
  read(bytes);
  read(std::make_shared<const Bytes>(writeZip({{"Home.xml", bytes}, {"1", bytes}})));
  return 0;
}
