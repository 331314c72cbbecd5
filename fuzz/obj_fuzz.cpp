// Feeds bytes to the OBJ and MTL parsers and to the mesh builder behind them.
#include <cstddef>
#include <cstdint>

#include "base/error.h"
#include "catalog/model_file_mesh.h"
#include "catalog/model_file_obj.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace idap;
  const auto* begin = reinterpret_cast<const std::byte*>(data);
  const auto bytes = std::make_shared<const Bytes>(begin, begin + size);
  const ModelFileOptions options;
  try {
    const auto self = [&](const std::string&) -> SharedBytes { return bytes; };
    surfaceModelOf(parseObj(asText(*bytes), "fuzz.obj", self), options.rotation, true);
  } catch (const Error&) {
    // Refusing is right; crashing is not.
  }
  return 0;
}
