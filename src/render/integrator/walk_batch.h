// What the paths of one call bring, by their numbers.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "render/integrator/path.h"

namespace idap::render {

// Whom a surface point asks for light: lamps and the like, or the sky and what looks find (see Outlook).
enum class LightSource : std::size_t { Sun, Lamps, Sky };
inline constexpr std::size_t kLightSources = 3;

// A point whose light is not known yet.
struct Lesson {
  Vec3f position, normal;
  Rgb before;                                  // what the path had gathered
  Rgb scale;                                   // what it gathers from here on, of one lux there
  std::array<float, kLightSources> squares{};  // lux2, of what asking found
};

struct WalkBatch {
  std::span<PathSample> samples;
  std::span<Rgb> groups;
  std::size_t groupCount = 0;
  std::span<std::vector<Lesson>> lessons;  // empty: nothing is to be learned
  std::uint64_t rays = 0;                  // traced so far

  void add(int path, Rgb light, std::size_t group) const {
    const auto i = static_cast<std::size_t>(path);
    samples[i].radiance += light;
    if (group < groupCount) groups[i * groupCount + group] += light;
  }
};

}  // namespace idap::render
