// What light brings to every neighbourhood, the sun's own apart, learned from paths traced beforehand, so
// that later paths can stop there: far fewer rays and far less noise, for a small and smooth error. For the
// live view, films and quick pictures; a picture that is to be right does without. Source of the idea: Ward,
// Rubinstein and Clear 1988, "A ray tracing solution for diffuse interreflection"; unlike there, what the eye
// sees directly always gathers its light with rays of its own.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "light/rgb.h"
#include "render/lanes/lanes.h"

namespace idap::render {

// What one path found out at one of the surfaces it met.
struct CacheRecord {
  Vec3f position;                  // m
  std::uint32_t facing;            // LightCache::facing() of the normal
  Rgb irradiance;                  // lux, an estimate: of all light but what comes straight from the sun
  std::array<float, 3> squares{};  // lux2, of what asking each LightSource found
};

class LightCache {
 public:
  LightCache() = default;
  // The order of the records is changed.
  explicit LightCache(std::vector<CacheRecord>& records);

  struct Neighbourhood {
    float size = 0.0f;             // m, its longest side
    Rgb irradiance{};              // lux, mean
    float lux = 0.0f;              // its luminance
    float deviation = 0.0f;        // lux, standard, of the luminance of single paths' estimates
    std::array<float, 3> asked{};  // lux, root mean squares of what asking each LightSource found
    bool known = false;
  };
  // Null where too little is known.
  const Neighbourhood* at(Vec3f position, Vec3f normal) const;
  // The same, one a lane; of lanes that the mask has not, anything. f(lane, neighbourhood) where it is known.
  template <class Function>
  void visit(LaneMask lanes, const LaneVec& position, const LaneVec& normal, Function&& f) const {
    if (empty()) return;
    const Ints found = find(position, normal);
    forLanes(lanes, [&](int k) {
      const Neighbourhood& n = neighbourhoods_[static_cast<std::size_t>(lane(found, k))];
      if (n.known) f(k, n);
    });
  }
  bool empty() const { return neighbourhoods_.empty(); }

  // Which of six ways a surface mainly faces.
  static std::uint32_t facing(Vec3f normal);

 private:
  // Of eight bytes, for the gathers.
  struct Cell {
    static constexpr std::uint32_t kLeaf = 3;
    std::uint32_t word = kLeaf;  // the first of two children * 4 + axis, or the neighbourhood * 4 + kLeaf
    float middle = 0.0f;

    std::uint32_t axis() const { return word & 3u; }
    std::uint32_t index() const { return word >> 2; }
  };
  void divide(std::size_t index, std::span<CacheRecord> records);
  Ints find(const LaneVec& position, const LaneVec& normal) const;  // neighbourhoods

  std::size_t most_ = 0;     // records of a neighbourhood that is not divided
  std::vector<Cell> cells_;  // six kd-trees, by facing; their roots first
  std::vector<Neighbourhood> neighbourhoods_;
};

}  // namespace idap::render
