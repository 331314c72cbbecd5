// A block of bytes, and a shared one that is never changed.
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

namespace idap {

using Bytes = std::vector<std::byte>;
using SharedBytes = std::shared_ptr<const Bytes>;

inline std::string_view asText(const Bytes& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace idap
