// The binary chunk of a .glb file: bytes in, buffer views and accessors of the JSON out.
#pragma once

#include <cstring>
#include <nlohmann/json.hpp>
#include <span>

#include "base/bytes.h"
#include "geometry/vec.h"

namespace idap {

class GlbBuffer {
 public:
  using Json = nlohmann::ordered_json;

  // Each returns the index of what it added.
  std::size_t addView(std::span<const std::byte> bytes, int target = 0) {
    while (data_.size() % 4 != 0) data_.push_back(std::byte{0});
    Json view{{"buffer", 0}, {"byteOffset", data_.size()}, {"byteLength", bytes.size()}};
    if (target != 0) view["target"] = target;
    data_.insert(data_.end(), bytes.begin(), bytes.end());
    views_.push_back(std::move(view));
    return views_.size() - 1;
  }
  std::size_t addPositions(std::span<const Vec3f> values);  // with the bounds that glTF wants of them
  std::size_t addVectors(std::span<const Vec3f> values) { return addFloats(values, "VEC3"); }
  std::size_t addVectors(std::span<const Vec2f> values) { return addFloats(values, "VEC2"); }
  std::size_t addIndices(std::span<const std::uint32_t> values);

  const Json& views() const { return views_; }
  const Json& accessors() const { return accessors_; }
  const Bytes& data() const { return data_; }

 private:
  static constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;
  static constexpr int kUnsignedInt = 5125, kFloat = 5126;

  template <typename T>
  std::size_t addFloats(std::span<const T> values, const char* type) {
    const std::size_t view = addView(std::as_bytes(values), kArrayBuffer);
    accessors_.push_back(
        {{"bufferView", view}, {"componentType", kFloat}, {"count", values.size()}, {"type", type}});
    return accessors_.size() - 1;
  }

  Json views_ = Json::array(), accessors_ = Json::array();
  Bytes data_;
};

inline std::size_t GlbBuffer::addPositions(std::span<const Vec3f> values) {
  const std::size_t index = addFloats(values, "VEC3");
  Vec3f low = values[0], high = values[0];
  for (const Vec3f& v : values) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
  accessors_[index]["min"] = {low.x, low.y, low.z};
  accessors_[index]["max"] = {high.x, high.y, high.z};
  return index;
}

inline std::size_t GlbBuffer::addIndices(std::span<const std::uint32_t> values) {
  const std::size_t view = addView(std::as_bytes(values), kElementArrayBuffer);
  accessors_.push_back(
      {{"bufferView", view}, {"componentType", kUnsignedInt}, {"count", values.size()}, {"type", "SCALAR"}});
  return accessors_.size() - 1;
}

}  // namespace idap
