// Backward path tracing: light sampling and surface sampling joined by multiple importance sampling (power
// heuristic, Veach 1997), paths ended by Russian roulette only, so that the mean is right at any reflectance.
#pragma once

#include <cstdint>
#include <vector>

#include "render/accel/compiled_scene.h"
#include "render/cache/light_cache.h"
#include "render/emitter/light_sample.h"
#include "render/sampling/sampler.h"

namespace idap::render {

class Bsdf;

// Which strategies find light; all but Both are for checking that they agree.
enum class LightSampling { Both, SurfacesOnly, LightsOnly };

struct PathOptions {
  float clampIndirect = 0.0f;  // cd/m2; > 0 cuts off brighter indirect samples: fewer specks, some light lost
  LightSampling lightSampling = LightSampling::Both;
  bool looks = true;     // see Outlook; off only to measure what it brings
  bool hideSky = false;  // black where the camera sees nothing but sky
  // Where light that has bounced before is taken from; null: paths are followed to their end. Its light
  // counts to group 0.
  const LightCache* cache = nullptr;
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

  // Traces a path and adds what it has learned of the light to the records.
  void learn(const Ray& cameraRay, Sampler& sampler, std::vector<CacheRecord>& records) const;

  // One estimate of the illuminance (lux) at a point that faces along normal (unit).
  Rgb illuminance(Vec3f point, Vec3f normal, Sampler& sampler) const;

 private:
  struct Walk;
  struct Lesson;
  void follow(Walk& walk) const;
  bool arrive(Walk& walk) const;
  void addEmission(Walk& walk, const Hit& hit) const;
  void addSky(Walk& walk) const;
  bool passLamp(Walk& walk, const Hit& hit) const;
  bool scatter(Walk& walk) const;
  bool takeFromCache(Walk& walk, const Bsdf& bsdf) const;
  void lookOut(Walk& walk, const Bsdf& bsdf, const Receiver& here, float choice, float lookShare) const;

  const CompiledScene& scene_;
  PathOptions options_;
};

}  // namespace idap::render
