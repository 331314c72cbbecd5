// Noise that repeats: what the procedural textures are made of. Deterministic on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/vec.h"

namespace idap {

// A well mixed 32-bit hash of three integers (finalizer of MurmurHash3).
inline std::uint32_t mixHash(std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0) {
  std::uint32_t h = a * 0x9E3779B1u ^ (b + 0x7F4A7C15u) * 0x85EBCA77u ^ (c + 0x165667B1u) * 0xC2B2AE3Du;
  h ^= h >> 16;
  h *= 0x85EBCA6Bu;
  h ^= h >> 13;
  h *= 0xC2B2AE35u;
  return h ^ (h >> 16);
}

// A number in [0, 1) from three integers.
inline float randomAt(std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0) {
  return static_cast<float>(mixHash(a, b, c) >> 8) * (1.0f / 16777216.0f);
}

inline float fractionOf(float v) { return v - std::floor(v); }
inline int wrapped(int i, int n) { return ((i % n) + n) % n; }
inline float smoothStep(float from, float to, float v) {
  const float t = std::fmin(1.0f, std::fmax(0.0f, (v - from) / (to - from)));
  return t * t * (3.0f - 2.0f * t);
}

// Gradient noise (Perlin's of 2002: quintic blend) on a lattice of nx by ny cells a tile. Coordinates are in
// tiles, any real number; values lie within about -1..1 with mean 0.
class PeriodicNoise {
 public:
  PeriodicNoise(int nx, int ny, std::uint32_t seed)
      : nx_(nx < 1 ? 1 : nx), ny_(ny < 1 ? 1 : ny), gradients_(static_cast<std::size_t>(nx_ * ny_)) {
    for (std::size_t i = 0; i < gradients_.size(); ++i) {
      const float angle = 6.2831853f * randomAt(static_cast<std::uint32_t>(i), seed, 77u);
      gradients_[i] = {1.5f * std::cos(angle), 1.5f * std::sin(angle)};
    }
  }

  float operator()(float u, float v) const {
    const float x = fractionOf(u) * static_cast<float>(nx_), y = fractionOf(v) * static_cast<float>(ny_);
    int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
    const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
    if (x0 >= nx_) x0 = 0;  // u a hair below a whole number can round up
    if (y0 >= ny_) y0 = 0;
    const int x1 = x0 + 1 == nx_ ? 0 : x0 + 1, y1 = y0 + 1 == ny_ ? 0 : y0 + 1;
    const Vec2f* const row0 = gradients_.data() + y0 * nx_;
    const Vec2f* const row1 = gradients_.data() + y1 * nx_;
    const float sx = fx * fx * fx * (fx * (fx * 6.0f - 15.0f) + 10.0f);
    const float sy = fy * fy * fy * (fy * (fy * 6.0f - 15.0f) + 10.0f);
    const float a = row0[x0].x * fx + row0[x0].y * fy;
    const float b = row0[x1].x * (fx - 1.0f) + row0[x1].y * fy;
    const float c = row1[x0].x * fx + row1[x0].y * (fy - 1.0f);
    const float d = row1[x1].x * (fx - 1.0f) + row1[x1].y * (fy - 1.0f);
    const float top = a + sx * (b - a), bottom = c + sx * (d - c);
    return top + sy * (bottom - top);
  }

 private:
  int nx_, ny_;
  std::vector<Vec2f> gradients_;
};

// Octaves of noise, each twice as fine and half as strong.
class PeriodicFbm {
 public:
  PeriodicFbm(int nx, int ny, int octaves, std::uint32_t seed) {
    for (int i = 0; i < octaves; ++i)
      octaves_.emplace_back(nx << i, ny << i, seed + static_cast<std::uint32_t>(i) * 131u);
  }
  float operator()(float u, float v) const {
    float sum = 0, weight = 0.6f;
    for (const PeriodicNoise& octave : octaves_) {
      sum += weight * octave(u, v);
      weight *= 0.5f;
    }
    return sum;
  }

 private:
  std::vector<PeriodicNoise> octaves_;
};

// Cellular noise (Worley 1996): one jittered point in every cell of an nx by ny lattice that repeats.
class PeriodicCells {
 public:
  struct Sample {
    float nearest, second;  // distances in cells
    std::uint32_t id;       // of the nearest point; equal across repeats
    Vec2f offset;           // from the nearest point, in cells
  };

  PeriodicCells(int nx, int ny, std::uint32_t seed, float jitter = 0.9f) : nx_(nx), ny_(ny) {
    points_.resize(static_cast<std::size_t>(nx * ny));
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const auto n = static_cast<std::uint32_t>(i);
      points_[i] = {0.5f + jitter * (randomAt(n, seed, 1) - 0.5f),
                    0.5f + jitter * (randomAt(n, seed, 2) - 0.5f)};
    }
  }

  Sample operator()(float u, float v) const {
    const float x = fractionOf(u) * static_cast<float>(nx_), y = fractionOf(v) * static_cast<float>(ny_);
    const int cx = static_cast<int>(x), cy = static_cast<int>(y);
    Sample s{1e9f, 1e9f, 0, {}};
    for (int j = -1; j <= 1; ++j) {
      for (int i = -1; i <= 1; ++i) {
        const int px = cx + i < 0 ? nx_ - 1 : (cx + i) % nx_, py = cy + j < 0 ? ny_ - 1 : (cy + j) % ny_;
        const auto cell = static_cast<std::size_t>(py * nx_ + px);
        const Vec2f d{x - static_cast<float>(cx + i) - points_[cell].x,
                      y - static_cast<float>(cy + j) - points_[cell].y};
        const float distance = d.x * d.x + d.y * d.y;
        if (distance < s.nearest) {
          s.second = s.nearest;
          s.nearest = distance;
          s.id = static_cast<std::uint32_t>(cell);
          s.offset = d;
        } else if (distance < s.second) {
          s.second = distance;
        }
      }
    }
    s.nearest = std::sqrt(s.nearest);
    s.second = std::sqrt(s.second);
    return s;
  }

 private:
  int nx_, ny_;
  std::vector<Vec2f> points_;
};

}  // namespace idap
