#include "render/cache/light_cache.h"

#include <algorithm>
#include <cmath>

#include "geometry/box.h"

namespace idap::render {

namespace {

// Of a neighbourhood that is not divided: more where more is known altogether, so that the many rare bright
// paths it takes to be right are in every one.
constexpr std::size_t kLeastMost = 150, kMostMost = 1200, kNeighbourhoods = 400;
constexpr std::size_t kFewestRecords = 32;  // of one that is believed
constexpr float kSmallestCell = 0.05f;      // m, longest side of one that is divided

float along(Vec3f p, std::uint32_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

}  // namespace

std::uint32_t LightCache::facing(Vec3f n) {
  const float x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
  if (z >= x && z >= y) return n.z >= 0 ? 4 : 5;
  if (x >= y) return n.x >= 0 ? 0 : 1;
  return n.y >= 0 ? 2 : 3;
}

LightCache::LightCache(std::vector<CacheRecord>& records)
    : most_(std::clamp(records.size() / kNeighbourhoods, kLeastMost, kMostMost)) {
  auto first = records.begin();
  cells_.resize(6);
  for (std::uint32_t way = 0; way < 6; ++way) {
    const auto last =
        std::partition(first, records.end(), [&](const CacheRecord& r) { return r.facing == way; });
    divide(way, {first, last});
    first = last;
  }
}

void LightCache::divide(std::size_t index, std::span<CacheRecord> records) {
  Box3f box;
  for (const CacheRecord& r : records) box.add(r.position);
  const Vec3f size = records.empty() ? Vec3f{} : box.size();
  const float longest = std::max({size.x, size.y, size.z});
  if (records.size() > most_ && longest > kSmallestCell) {
    const std::uint32_t axis = longest == size.x ? 0 : longest == size.y ? 1 : 2;
    const auto half = records.begin() + static_cast<std::ptrdiff_t>(records.size() / 2);
    std::ranges::nth_element(records, half, {},
                             [&](const CacheRecord& r) { return along(r.position, axis); });
    const float middle = along(half->position, axis);
    const auto above = std::partition(records.begin(), records.end(),
                                      [&](const CacheRecord& r) { return along(r.position, axis) < middle; });
    if (above != records.begin()) {
      const auto children = static_cast<std::uint32_t>(cells_.size());
      cells_[index] = {children << 2 | axis, middle};
      cells_.resize(cells_.size() + 2);
      divide(children, {records.begin(), above});
      divide(children + 1, {above, records.end()});
      return;
    }
  }
  cells_[index] = {static_cast<std::uint32_t>(neighbourhoods_.size()) << 2 | Cell::kLeaf, 0};
  Neighbourhood& n = neighbourhoods_.emplace_back();
  n.size = longest;
  n.known = records.size() >= kFewestRecords;
  if (!n.known) return;
  Vec3 sum{};
  double squares = 0;
  std::array<double, 3> asked{};
  for (const CacheRecord& r : records) {
    sum += toDouble(r.irradiance);
    squares += std::pow(static_cast<double>(luminance(r.irradiance)), 2);
    for (std::size_t k = 0; k < asked.size(); ++k) asked[k] += static_cast<double>(r.squares[k]);
  }
  const auto count = static_cast<double>(records.size());
  n.irradiance = toFloat(sum / count);
  for (std::size_t k = 0; k < asked.size(); ++k) n.asked[k] = static_cast<float>(std::sqrt(asked[k] / count));
  n.lux = luminance(n.irradiance);
  const auto mean = static_cast<double>(n.lux);
  n.deviation = static_cast<float>(std::sqrt(std::max(0.0, squares / count - mean * mean)));
}

const LightCache::Neighbourhood* LightCache::at(Vec3f position, Vec3f normal) const {
  if (empty()) return nullptr;
  const Cell* cell = &cells_[facing(normal)];
  while (cell->axis() != Cell::kLeaf)
    cell = &cells_[cell->index() + (along(position, cell->axis()) >= cell->middle ? 1u : 0u)];
  const Neighbourhood& n = neighbourhoods_[cell->index()];
  return n.known ? &n : nullptr;
}

Ints LightCache::find(const LaneVec& p, const LaneVec& n) const {
  using namespace lane_math;
  static_assert(sizeof(Cell) == 2 * sizeof(float));
  const auto* words = reinterpret_cast<const float*>(cells_.data());
  const Floats x = abs(n.x), y = abs(n.y), z = abs(n.z);
  const LaneMask up = z >= x && z >= y, wide = x >= y;
  const Floats side = select(up, n.z, select(wide, n.x, n.y));
  Ints index = select(up, Ints(4), select(wide, Ints(0), Ints(2))) + select(side >= 0.0f, Ints(0), Ints(1));
  for (;;) {
    const Ints at = index + index, word = std::bit_cast<Ints>(gather(words, at));
    const Ints axis = word & 3, below = word >> 2;
    const LaneMask divided = toMask(axis != static_cast<std::int32_t>(Cell::kLeaf));
    if (!any(divided)) return below;
    const Floats along = select(toMask(axis == 0), p.x, select(toMask(axis == 1), p.y, p.z));
    const Ints next = below + select(along >= gather(words, at + 1), Ints(1), Ints(0));
    index = select(divided, next, index);
  }
}

}  // namespace idap::render
