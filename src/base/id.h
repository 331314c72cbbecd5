// Strong id types: a WallId is not a RoomId. Value 0 means "none".
#pragma once

#include <compare>
#include <cstdint>
#include <functional>

namespace idap {

template <class Tag>
struct Id {
  std::uint64_t value = 0;

  explicit operator bool() const { return value != 0; }
  friend auto operator<=>(const Id&, const Id&) = default;
};

}  // namespace idap

template <class Tag>
struct std::hash<idap::Id<Tag>> {
  std::size_t operator()(idap::Id<Tag> id) const noexcept { return std::hash<std::uint64_t>()(id.value); }
};
