#include "render/integrator/path.h"

#include <algorithm>
#include <optional>

#include "render/emitter/lights.h"
#include "render/integrator/outlook.h"
#include "render/material/bsdf.h"
#include "render/sampling/warp.h"

namespace idap::render {

namespace {

constexpr int kRouletteAfter = 2;         // bounces that are always followed
constexpr float kLocalShare = 0.5f;       // of questions, where either lamps or the sky are asked
constexpr float kCacheReach = 1.5f;       // times a neighbourhood's size; what is nearer is looked at closely
constexpr std::size_t kMostLessons = 24;  // bounces of a path that a cache learns from
constexpr float kLeastDiffuse = 0.25f;    // of a surface's scattering, for looks and caches to make sense
constexpr int kMostSegments = 4096;       // a guard against endless loops, far beyond what roulette lets live

// Power heuristic with exponent 2; b may be 0.
float share(float a, float b) {
  const float r = b / a;
  return 1 / (1 + r * r);
}

}  // namespace

// A point whose light is not known yet.
struct PathTracer::Lesson {
  Vec3f position, normal;
  Rgb before;  // what the path had gathered
  Rgb scale;   // what it gathers from here on, of one lux there
};

struct PathTracer::Walk {
  Sampler& sampler;
  PathSample& out;
  Rgb* groups;
  std::size_t groupCount;

  Ray ray{};
  Rgb throughput{1, 1, 1};
  float etaScale = 1.0f;  // undoes the squeezing of radiance in glass where roulette judges the throughput
  Receiver from{};        // where the ray was scattered, and the density with which
  float pdf = 0.0f;
  bool looked = false;                       // whether looks from there could have found the same
  float localShare = 1.0f, skyShare = 1.0f;  // how likely light sampling asked lamps and the sky there
  bool sharp = true;  // camera or delta lobe: no light sampling could have found the same
  int bounces = 0;
  int segments = 0;
  bool featuresKnown = false;
  std::vector<Lesson>* lessons = nullptr;

  Interaction at{};
  SurfaceValues values{};

  void add(Rgb light, std::uint16_t group) {
    out.radiance += light;
    if (group < groupCount) groups[group] += light;
  }
  // Goes on along the same ray, behind what it has hit.
  void pass(float t) { ray.tMin = t * 1.000002f + 1e-7f; }
};

PathSample PathTracer::trace(const Ray& cameraRay, Sampler& sampler, Rgb* groups,
                             std::size_t groupCount) const {
  PathSample out;
  Walk walk{sampler, out, groups, groups ? groupCount : 0};
  walk.ray = cameraRay;
  if (arrive(walk)) follow(walk);
  return out;
}

void PathTracer::learn(const Ray& cameraRay, Sampler& sampler, std::vector<CacheRecord>& records) const {
  PathSample out;
  std::vector<Lesson> lessons;
  lessons.reserve(kMostLessons);
  Walk walk{sampler, out, nullptr, 0};
  walk.ray = cameraRay;
  walk.lessons = &lessons;
  if (arrive(walk)) follow(walk);
  for (const Lesson& l : lessons) {
    Rgb irradiance{};
    for (int k = 0; k < 3; ++k)
      if (l.scale[k] > 0) irradiance[k] = (out.radiance[k] - l.before[k]) / l.scale[k];
    if (std::isfinite(maxComponent(irradiance)))
      records.push_back({l.position, LightCache::facing(l.normal), irradiance});
  }
}

Rgb PathTracer::illuminance(Vec3f point, Vec3f normal, Sampler& sampler) const {
  // A white Lambertian surface sends out the illuminance it receives over pi.
  SurfaceData white;
  white.baseColor = {1, 1, 1};
  white.ior = 1;
  white.f0 = white.f90 = 0;
  PathSample out;
  Walk walk{sampler, out, nullptr, 0};
  walk.featuresKnown = true;
  walk.at.position = point;
  walk.at.ng = walk.at.ns = normal;
  walk.at.surface = &white;
  walk.at.offset = 1e-5f * std::max({std::fabs(point.x), std::fabs(point.y), std::fabs(point.z), 1.0f});
  walk.values = {white.baseColor, 1.0f, 1.0f};
  walk.ray.direction = -normal;
  follow(walk);
  return out.radiance * kPiF;
}

void PathTracer::follow(Walk& walk) const {
  while (scatter(walk) && arrive(walk)) {
  }
}

// Follows the ray to the next surface that stops it, gathering the light it meets. False at the path's end.
bool PathTracer::arrive(Walk& walk) const {
  for (;; ++walk.segments) {
    if (walk.segments > kMostSegments) return false;
    const bool primary = walk.bounces == 0;
    Hit hit;
    ++walk.out.rays;
    if (!scene_.intersect(walk.ray, hit, primary ? kCameraRay : kBounceRay, primary)) {
      if (!options_.hideSky || !primary || walk.out.depth > 0) addSky(walk);
      return false;
    }
    if (hit.isLamp()) {
      passLamp(walk, hit);
      continue;
    }
    walk.at = scene_.interaction(walk.ray, hit);
    walk.values = valuesAt(*walk.at.surface, walk.at.uv);
    if (walk.at.surface->mayPass && walk.sampler.get1D() >= walk.values.opacity) {
      walk.pass(hit.t);
      continue;
    }
    if (walk.out.depth == 0 && primary) {
      walk.out.depth = hit.t;
      walk.out.objectId = walk.at.objectId;
    }
    if (walk.at.surface->emits) addEmission(walk, hit);
    return true;
  }
}

void PathTracer::addEmission(Walk& walk, const Hit& hit) const {
  const SurfaceData& surface = *walk.at.surface;
  float weight = 1;
  if (!walk.sharp && options_.lightSampling != LightSampling::SurfacesOnly) {
    const float light =
        scene_.lights().local().pdfTriangle(walk.from, walk.ray, hit, walk.at) * walk.localShare;
    if (options_.lightSampling == LightSampling::LightsOnly)
      weight = light > 0 ? 0.0f : 1.0f;
    else
      weight = share(walk.pdf, light);
  }
  Rgb light = walk.throughput * surface.emission * weight;
  if (options_.clampIndirect > 0 && walk.bounces > 1)
    light *= std::min(1.0f, options_.clampIndirect / std::max(luminance(light), 1e-20f));
  walk.add(light, walk.at.lightGroup);
}

void PathTracer::addSky(Walk& walk) const {
  const Daylight& daylight = scene_.lights().daylight();
  const auto weigh = [&](float lightPdf) {
    if (walk.sharp || options_.lightSampling == LightSampling::SurfacesOnly) return 1.0f;
    if (options_.lightSampling == LightSampling::LightsOnly) return lightPdf > 0 ? 0.0f : 1.0f;
    return share(walk.pdf, lightPdf);
  };
  Rgb fromSky{}, fromSun{};
  if (daylight.hasSky()) {
    const Rgb sky = daylight.skyRadiance(walk.ray.direction);
    if (maxComponent(sky) > 0)
      fromSky = sky * weigh(walk.sharp    ? 0.0f
                            : walk.looked ? walk.skyShare * Outlook(scene_, walk.from).pdf(walk.ray.direction)
                                          : walk.skyShare * daylight.pdfSky(walk.from, walk.ray.direction));
  }
  if (daylight.hasSun()) {
    const Rgb sun = daylight.sunRadiance(walk.ray.direction);
    if (maxComponent(sun) > 0) fromSun = sun * weigh(walk.sharp ? 0.0f : daylight.pdfSun(walk.from));
  }
  Rgb throughput = walk.throughput;
  if (options_.clampIndirect > 0 && walk.bounces > 1) {
    const Rgb light = (fromSky + fromSun) * throughput;
    throughput *= std::min(1.0f, options_.clampIndirect / std::max(luminance(light), 1e-20f));
  }
  walk.add(fromSky * throughput, 0);
  if (maxComponent(fromSun) > 0) walk.add(fromSun * throughput, daylight.sunGroup());
}

bool PathTracer::passLamp(Walk& walk, const Hit& hit) const {
  const Lamp& lamp = scene_.scene().lamps[hit.lamp];
  const Vec3f p = walk.ray.origin + walk.ray.direction * hit.t;
  if (dot(p - lamp.position, walk.ray.direction) < 0) {  // coming in, not going out
    const LocalLights& local = scene_.lights().local();
    float weight = 1;
    if (!walk.sharp && options_.lightSampling == LightSampling::Both)
      weight = share(walk.pdf, local.pdfLamp(walk.from, hit.lamp) * walk.localShare);
    if (!walk.sharp && options_.lightSampling == LightSampling::LightsOnly) weight = 0;
    Rgb light = walk.throughput * local.lampRadiance(hit.lamp, walk.ray.direction) * weight;
    if (options_.clampIndirect > 0 && walk.bounces > 1)
      light *= std::min(1.0f, options_.clampIndirect / std::max(luminance(light), 1e-20f));
    walk.add(light, lamp.lightGroup);
  }
  walk.pass(hit.t);
  return true;
}

// Adds what one look from the point finds of sky and sunlit surfaces.
void PathTracer::lookOut(Walk& walk, const Bsdf& bsdf, const Receiver& here, float choice,
                         float lookShare) const {
  const Interaction& at = walk.at;
  const Outlook outlook(scene_, here);
  Vec3f wi;
  float pdf = 0;
  const Vec2f u = walk.sampler.get2D(), onSun = walk.sampler.get2D();
  if (!outlook.sample(choice, u, wi, pdf)) return;
  pdf *= lookShare;
  const BsdfValue f = bsdf.eval(wi);
  Rgb value = walk.throughput * f.value * (1 / pdf);
  if (options_.lightSampling == LightSampling::Both) value *= share(pdf, f.pdf);
  if (at.smooth) value *= terminator(at, wi);
  if (!(maxComponent(value) > 0)) return;
  const Outlook::Seen seen = Outlook::look(scene_, at.originTowards(wi), wi, onSun, walk.out.rays);
  const auto add = [&](Rgb light, std::uint16_t group, bool indirect) {
    if (!(maxComponent(light) > 0)) return;
    light *= value;
    if (options_.clampIndirect > 0 && indirect)
      light *= std::min(1.0f, options_.clampIndirect / std::max(luminance(light), 1e-20f));
    walk.add(light, group);
  };
  add(seen.sky, 0, walk.bounces > 0);
  if (options_.lightSampling == LightSampling::Both)
    add(seen.sun, scene_.lights().daylight().sunGroup(), true);
}

// Ends the path with what is known of the light here. False where that is not enough.
bool PathTracer::takeFromCache(Walk& walk, const Bsdf& bsdf) const {
  const LightCache::Neighbourhood* known = options_.cache->at(walk.at.position, walk.at.ng);
  if (!known || length(walk.at.position - walk.from.position) <= kCacheReach * known->size) return false;
  walk.add(walk.throughput * bsdf.albedo() * known->irradiance * (1 / kPiF), 0);
  return true;
}

// Adds the light that reaches the point directly and chooses where the path goes on. False at the path's end.
bool PathTracer::scatter(Walk& walk) const {
  const Interaction& at = walk.at;
  const Vec3f wo = -walk.ray.direction;
  const Bsdf bsdf(at, walk.values, wo);

  if (!walk.featuresKnown && !bsdf.mostlySharp()) {
    walk.featuresKnown = true;
    walk.out.normal = at.ns;
    const Rgb a = at.surface->emits ? Rgb{1, 1, 1} : bsdf.albedo();
    walk.out.albedo = {a.x * std::min(walk.throughput.x, 1.0f), a.y * std::min(walk.throughput.y, 1.0f),
                       a.z * std::min(walk.throughput.z, 1.0f)};
  }

  const Receiver here{at.position, at.ng, bsdf.seesBehind()};
  float localShare = 1, skyShare = 1;

  const bool widely = bsdf.scatters() && bsdf.diffuseShare() > kLeastDiffuse;
  const bool looksOut = scene_.lights().daylight().looksOut() && widely && options_.looks;
  if (bsdf.scatters() && options_.lightSampling != LightSampling::SurfacesOnly) {
    // byLooks: what a bounce has led to, a look from the point before could have found as well.
    const auto connect = [&](const LightSample& light, bool byLooks = false) {
      const BsdfValue f = bsdf.eval(light.wi);
      Rgb value = walk.throughput * f.value * light.weight;
      if (options_.lightSampling == LightSampling::Both && light.pdf > 0) value *= share(light.pdf, f.pdf);
      if (at.smooth) value *= terminator(at, light.wi);
      if (!(maxComponent(value) > 0)) return;
      ++walk.out.rays;
      value *= scene_.transmittance(
          {at.originTowards(light.wi), light.wi, 0.0f, light.distance * (1 - 5e-5f) - at.offset});
      if (byLooks && maxComponent(value) > 0)
        value *= share(walk.pdf, walk.skyShare * Outlook(scene_, walk.from).pdf(walk.ray.direction));
      if (options_.clampIndirect > 0 && walk.bounces > 0)
        value *= std::min(1.0f, options_.clampIndirect / std::max(luminance(value), 1e-20f));
      walk.add(value, light.lightGroup);
    };
    const LocalLights& locals = scene_.lights().local();
    const Daylight& daylight = scene_.lights().daylight();
    LightSample light;
    // The sun is asked everywhere, since missing it costs most; lamps and the sky both where the picture
    // shows the answer, and one of them where light has yet to bounce on.
    if (daylight.hasSun() && daylight.sampleSun(here, walk.sampler.get2D(), light))
      connect(light, walk.looked && !walk.sharp && options_.lightSampling == LightSampling::Both);
    if (widely) {
      if (walk.lessons && walk.lessons->size() < kMostLessons)
        walk.lessons->push_back(
            {here.position, here.normal, walk.out.radiance, walk.throughput * bsdf.albedo() * (1 / kPiF)});
      if (options_.cache && walk.bounces > 0 && !walk.sharp && takeFromCache(walk, bsdf)) return false;
    }
    bool askLocal = !locals.empty(), askSky = daylight.hasSky() || looksOut;
    float choice = walk.sampler.get1D();
    if (askLocal && askSky && walk.bounces > 0) {
      localShare = kLocalShare;
      skyShare = 1 - kLocalShare;
      askLocal = choice < localShare;
      askSky = !askLocal;
      choice = askLocal ? choice / localShare : std::min((choice - localShare) / skyShare, kOneMinusEpsilon);
    }
    if (askLocal && locals.sample(here, choice, walk.sampler.get2D(), light)) {
      light.pdf *= localShare;
      light.weight *= 1 / localShare;
      connect(light);
    }
    if (askSky) {
      if (askLocal) choice = walk.sampler.get1D();
      if (looksOut) {
        lookOut(walk, bsdf, here, choice, skyShare);
      } else if (daylight.sampleSky(here, choice, walk.sampler.get2D(), light)) {
        light.pdf *= skyShare;
        light.weight *= 1 / skyShare;
        connect(light);
      }
    }
  }

  const float lobe = walk.sampler.get1D();
  const Vec2f u = walk.sampler.get2D();
  const BsdfSample s = bsdf.sample(lobe, u);
  if (!(s.pdf > 0)) return false;
  walk.throughput *= s.weight;
  if (s.straight) {
    walk.pass(dot(at.position - walk.ray.origin, walk.ray.direction));
  } else {
    if (at.smooth && !s.delta) walk.throughput *= terminator(at, s.wi);
    walk.ray = {at.originTowards(s.wi), s.wi};
    walk.from = here;
    walk.pdf = s.pdf;
    walk.localShare = localShare;
    walk.skyShare = skyShare;
    walk.looked = looksOut;
    walk.sharp = s.delta;
    walk.etaScale *= s.etaScale;
    ++walk.bounces;
  }
  if (!(maxComponent(walk.throughput) > 0)) return false;

  if (walk.bounces > kRouletteAfter || walk.segments > 16) {
    const float survival = std::min(0.98f, maxComponent(walk.throughput) / walk.etaScale);
    if (walk.sampler.get1D() >= survival) return false;
    walk.throughput *= 1 / survival;
  }
  ++walk.segments;
  return true;
}

}  // namespace idap::render
