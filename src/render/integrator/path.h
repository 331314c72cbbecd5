// Backward path tracing: light sampling and surface sampling joined by multiple importance sampling (power
// heuristic, Veach 1997), paths ended by Russian roulette only, so that the mean is right at any reflectance.
#pragma once

#include <cstdint>

#include "render/accel/compiled_scene.h"
#include "render/sampling/sampler.h"

namespace idap::render {

// Which strategies find light; all but Both are for checking that they agree.
enum class LightSampling { Both, SurfacesOnly, LightsOnly };

struct PathOptions {
  float clampIndirect = 0.0f;  // cd/m2; > 0 cuts off brighter indirect samples: fewer specks, some light lost
  LightSampling lightSampling = LightSampling::Both;
  bool hideSky = false;  // black where the camera sees nothing but sky
};

// What one path brings. Features are those of the first surface that is not clear glass or a mirror.
struct PathSample {
  Rgb radiance{};
  Rgb albedo{};
  Vec3f normal{};
  float depth = 0.0f;          // to the first surface of any kind, m
  std::uint32_t objectId = 0;  // of that surface
  std::uint32_t rays = 0;
};

class PathTracer {
 public:
  explicit PathTracer(const CompiledScene& scene, PathOptions options = {})
      : scene_(scene), options_(options) {}

  // groups: null, or one sum a light group, to which the path's light is added.
  PathSample trace(const Ray& cameraRay, Sampler& sampler, Rgb* groups = nullptr,
                   std::size_t groupCount = 0) const;

  // One estimate of the illuminance (lux) at a point that faces along normal (unit).
  Rgb illuminance(Vec3f point, Vec3f normal, Sampler& sampler) const;

 private:
  struct Walk;
  void follow(Walk& walk) const;
  bool arrive(Walk& walk) const;
  void addEmission(Walk& walk, const Hit& hit) const;
  void addSky(Walk& walk) const;
  bool passLamp(Walk& walk, const Hit& hit) const;
  bool scatter(Walk& walk) const;

  const CompiledScene& scene_;
  PathOptions options_;
};

}  // namespace idap::render
