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

namespace idap::render {

// What one path found out at one of the surfaces it met.
struct CacheRecord {
  Vec3f position;        // m
  std::uint32_t facing;  // LightCache::facing() of the normal
  Rgb irradiance;        // lux, an estimate: of all light but what comes straight from the sun
};

class LightCache {
 public:
  LightCache() = default;
  // The order of the records is changed.
  explicit LightCache(std::vector<CacheRecord>& records);

  struct Neighbourhood {
    float size = 0.0f;       // m, its longest side
    Rgb irradiance{};        // lux, mean
    float deviation = 0.0f;  // lux, standard, of the luminance of single paths' estimates
    bool known = false;
  };
  // Null where too little is known.
  const Neighbourhood* at(Vec3f position, Vec3f normal) const;
  bool empty() const { return neighbourhoods_.empty(); }

  // Which of six ways a surface mainly faces.
  static std::uint32_t facing(Vec3f normal);

 private:
  struct Cell {
    std::uint32_t children = 0;  // of the first of two; 0: a leaf
    std::uint32_t axis = 0;      // that it is divided across; of a leaf the index of its neighbourhood
    float middle = 0.0f;
  };
  using Cells = std::vector<Cell>;  // a kd-tree; the root first
  void divide(Cells& cells, std::size_t index, std::span<CacheRecord> records);

  std::size_t most_ = 0;        // records of a neighbourhood that is not divided
  std::array<Cells, 6> cells_;  // by facing
  std::vector<Neighbourhood> neighbourhoods_;
};

}  // namespace idap::render
