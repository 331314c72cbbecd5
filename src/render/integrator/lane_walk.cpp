#include "render/integrator/lane_walk.h"

#include "render/emitter/lights.h"
#include "render/integrator/outlook.h"
#include "render/material/bsdf.h"
#include "render/sampling/warp.h"

namespace idap::render {

namespace {

constexpr int kRouletteAfter = 2;       // bounces that are always followed
constexpr int kRouletteWithGuide = 8;   // the same where the guide does not know the surface
constexpr float kWorth = 0.7f;          // of what the first surface shows: always followed
constexpr float kLeastSurvival = 0.1f;  // of a path that the guide expects nothing of
constexpr float kMostSurvival = 0.98f;
constexpr float kLocalShare = 0.5f;       // of questions, where either lamps or the sky are asked
constexpr float kCacheReach = 1.5f;       // times a neighbourhood's size; what is nearer is looked at closely
constexpr std::size_t kMostLessons = 24;  // bounces of a path that a cache learns from
constexpr float kLeastDiffuse = 0.25f;    // of a surface's scattering, for looks and caches to make sense
constexpr int kMostSegments = 4096;       // a guard against endless loops, far beyond what roulette lets live

}  // namespace

WalkState<float> beginWalk(const PathStart& start) {
  WalkState<float> s{};
  s.origin = start.ray.origin;
  s.direction = start.ray.direction;
  s.tMin = start.ray.tMin;
  s.throughput = {1, 1, 1};
  s.etaScale = s.pdf = s.localShare = s.skyShare = 1;
  s.sampler = start.sampler;
  s.flags = kSharp;
  return s;
}

Floats LaneWalk::draw1D(LaneMask wanted) {
  if (any(wanted)) return state.sampler.get1D();
  state.sampler.dimension += 1u;
  return 0.0f;
}

LaneVec2 LaneWalk::draw2D(LaneMask wanted) {
  if (any(wanted)) return state.sampler.get2D();
  state.sampler.dimension += 1u;
  return {Floats(0.0f), Floats(0.0f)};
}

// What indirect light is to be multiplied by.
Floats LaneWalk::clamped(const LaneVec& light, LaneMask indirect) const {
  using namespace lane_math;
  if (!(options_.clampIndirect > 0)) return 1.0f;
  return select(indirect, min(options_.clampIndirect / max(luminance(light), 1e-20f), 1.0f), Floats(1.0f));
}

void LaneWalk::add(LaneMask lanes, const LaneVec& light, const Ints& group) {
  state.radiance += only(lanes, light);
  if (batch_.groupCount == 0) return;
  forLanes(lanes, [&](int k) {
    const auto g = static_cast<std::size_t>(lane(group, k));
    if (g < batch_.groupCount)
      batch_.groups[static_cast<std::size_t>(path[k]) * batch_.groupCount + g] += lane(light, k);
  });
}

void LaneWalk::addMet(int k, Rgb light, std::uint16_t group) {
  if (options_.clampIndirect > 0 && lane(state.bounces, k) > 1)
    light *= std::min(1.0f, options_.clampIndirect / std::max(luminance(light), 1e-20f));
  const auto i = static_cast<std::size_t>(k);
  state.radiance.x[i] += light.x;
  state.radiance.y[i] += light.y;
  state.radiance.z[i] += light.z;
  if (group < batch_.groupCount)
    batch_.groups[static_cast<std::size_t>(path[k]) * batch_.groupCount + group] += light;
}

LaneMask LaneWalk::step(LaneMask active) {
  using namespace lane_math;
  active = active && toMask(state.segments <= kMostSegments);
  const LaneMask primary = active && toMask(state.bounces == 0);
  state.segments += 1;
  state.rays = select(active, state.rays + 1, state.rays);
  const LaneRays rays{state.origin, state.direction, state.tMin};
  LaneHits hits;
  scene_.intersect(active, rays, hits, select(primary, Words(kCameraRay), Words(kBounceRay)));

  const LaneMask out = active && !hits.found;
  if (any(out)) addSky(options_.hideSky ? out && !(primary && !has(kDepthKnown)) : out);
  if (any(hits.lamp)) addLamps(hits.lamp, hits);
  LaneMask met = hits.found && !hits.lamp, passed = hits.lamp;
  LaneMask goesOn(false);
  if (any(met)) {
    LanePoints at;
    scene_.points(met, rays, hits, at);
    const LaneMask mayPass = met && at.mayPass;
    const LaneMask through = mayPass && draw1D(mayPass) >= at.opacity;
    met = met && !through;
    passed = passed || through;

    const LaneMask first = met && primary && !has(kDepthKnown);
    forLanes(first, [&](int k) {
      PathSample& sample = batch_.samples[static_cast<std::size_t>(path[k])];
      sample.depth = hits.hit[k].t;
      sample.objectId = at.objectId[k];
    });
    set(first, kDepthKnown);
    const LaneMask emits = met && at.emits;
    if (any(emits)) addEmission(emits, hits, at);
    if (any(met)) goesOn = scatter(met, at);
  }
  // On along the same ray, behind what it has hit.
  state.tMin = select(passed, hits.t * 1.000002f + 1e-7f, state.tMin);
  return passed || goesOn;
}

void LaneWalk::addEmission(LaneMask lanes, const LaneHits& hits, const LanePoints& at) {
  const LocalLights& local = scene_.lights().local();
  forLanes(lanes, [&](int k) {
    float weight = 1;
    if (!has(kSharp, k) && options_.lightSampling != LightSampling::SurfacesOnly) {
      const Ray ray{lane(state.origin, k), lane(state.direction, k)};
      const float light = local.pdfTriangle(receiver(k), ray, hits.hit[k], lane(at.shading.frontFace, k)) *
                          lane(state.localShare, k);
      if (options_.lightSampling == LightSampling::LightsOnly)
        weight = light > 0 ? 0.0f : 1.0f;
      else
        weight = share(lane(state.pdf, k), light);
    }
    addMet(k, lane(state.throughput, k) * at.surface[k]->emission * weight, at.lightGroup[k]);
  });
}

void LaneWalk::addSky(LaneMask lanes) {
  const Daylight& daylight = scene_.lights().daylight();
  if ((!daylight.hasSky() && !daylight.hasSun()) || !any(lanes)) return;
  const LaneMask sharp = has(kSharp);
  // lightPdf: of finding the same by light sampling; asked only where it could.
  const auto weigh = [&](LaneMask seen, const auto& lightPdf) {
    const LaneMask asked = seen && !sharp;
    if (options_.lightSampling == LightSampling::SurfacesOnly || !any(asked)) return Floats(1.0f);
    const Floats pdf = lightPdf(asked);
    const Floats weight = options_.lightSampling == LightSampling::LightsOnly
                              ? only(!(pdf > 0.0f), Floats(1.0f))
                              : share(state.pdf, pdf);
    return select(sharp, Floats(1.0f), weight);
  };
  LaneVec fromSky = spread<Floats>({}), fromSun = fromSky;
  if (daylight.hasSky()) {
    const LaneVec sky = daylight.skyRadiance(state.direction);
    const LaneMask seen = lanes && maxComponent(sky) > 0.0f;
    const Floats weight = weigh(seen, [&](LaneMask asked) {
      const LaneMask looked = has(kLooked);
      Floats pdf = 0.0f;
      if (any(asked && looked)) pdf = OutlookT<Floats>(scene_, receiver()).pdf(state.direction);
      if (any(asked && !looked)) pdf = select(looked, pdf, daylight.pdfSky(receiver(), state.direction));
      return Floats(pdf * state.skyShare);
    });
    fromSky = only(seen, sky * weight);
  }
  if (daylight.hasSun()) {
    const LaneVec sun = daylight.sunRadiance(state.direction);
    const LaneMask seen = lanes && maxComponent(sun) > 0.0f;
    if (any(seen)) {
      const Floats weight = weigh(seen, [&](LaneMask) { return daylight.pdfSun(receiver()); });
      fromSun = only(seen, sun * weight);
    }
  }
  LaneVec throughput = state.throughput;
  throughput *= clamped((fromSky + fromSun) * throughput, toMask(state.bounces > 1));
  add(lanes, fromSky * throughput, Ints(0));
  const LaneMask sunny = lanes && maxComponent(fromSun) > 0.0f;
  if (any(sunny)) add(sunny, fromSun * throughput, Ints(std::int32_t{daylight.sunGroup()}));
}

void LaneWalk::addLamps(LaneMask lanes, const LaneHits& hits) {
  const LocalLights& local = scene_.lights().local();
  forLanes(lanes, [&](int k) {
    const Lamp& lamp = scene_.scene().lamps[hits.hit[k].lamp];
    const Vec3f direction = lane(state.direction, k);
    const Vec3f p = lane(state.origin, k) + direction * hits.hit[k].t;
    if (dot(p - lamp.position, direction) >= 0) return;  // going out, not coming in
    float weight = 1;
    if (!has(kSharp, k) && options_.lightSampling == LightSampling::Both) {
      weight =
          share(lane(state.pdf, k), local.pdfLamp(receiver(k), hits.hit[k].lamp) * lane(state.localShare, k));
    }
    if (!has(kSharp, k) && options_.lightSampling == LightSampling::LightsOnly) weight = 0;
    const Rgb light = local.lampRadiance(hits.hit[k].lamp, direction);
    addMet(k, lane(state.throughput, k) * light * weight, lamp.lightGroup);
  });
}

void LaneWalk::noteFeatures(LaneMask lanes, const LanePoints& at, const BsdfT<Floats>& bsdf) {
  using lane_math::min;
  set(lanes, kFeaturesKnown);
  const LaneVec own = select(at.emits, spread<Floats>({1, 1, 1}), bsdf.albedo());
  const LaneVec& t = state.throughput;
  const LaneVec albedo{own.x * min(t.x, 1.0f), own.y * min(t.y, 1.0f), own.z * min(t.z, 1.0f)};
  forLanes(lanes, [&](int k) {
    PathSample& sample = batch_.samples[static_cast<std::size_t>(path[k])];
    sample.normal = lane(at.shading.ns, k);
    sample.albedo = lane(albedo, k);
  });
}

// Adds the light of the samples where nothing is in between. byLooks: what a bounce has led to, a look from
// the point before could have found as well.
void LaneWalk::connect(LaneMask lanes, const LanePoints& at, const BsdfT<Floats>& bsdf,
                       const LightSampleT<Floats>& light, LaneMask byLooks) {
  const BsdfValueT<Floats> f = bsdf.eval(light.wi);
  LaneVec value = state.throughput * f.value * light.weight * at.terminatorFor(light.wi);
  if (options_.lightSampling == LightSampling::Both)
    value *= select(light.pdf > 0.0f, share(light.pdf, f.pdf), Floats(1.0f));
  lanes = lanes && maxComponent(value) > 0.0f;
  if (!any(lanes)) return;
  state.rays = select(lanes, state.rays + 1, state.rays);
  value *= scene_.transmittance(
      lanes, {at.originTowards(light.wi), light.wi, 0.0f, light.distance * (1 - 5e-5f) - at.offset});
  lanes = lanes && maxComponent(value) > 0.0f;
  byLooks = byLooks && lanes;
  if (any(byLooks)) {
    const Floats looks = state.skyShare * OutlookT<Floats>(scene_, receiver()).pdf(state.direction);
    value *= select(byLooks, share(state.pdf, looks), Floats(1.0f));
  }
  value *= clamped(value, toMask(state.bounces > 0));
  add(lanes, value, light.lightGroup);
}

// Adds what one look from each point finds of sky and sunlit surfaces.
void LaneWalk::lookOut(LaneMask lanes, const LanePoints& at, const BsdfT<Floats>& bsdf,
                       const LaneReceiver& here, const Floats& choice, const Floats& lookShare) {
  const LaneVec2 u = draw2D(lanes);
  LookDraws draws{draw2D(lanes), {}, 0.0f};
  if (scene_.lights().sunPatches().hasLamps()) draws.lamp = draw2D(lanes), draws.lampChoice = draw1D(lanes);
  if (!any(lanes)) return;
  LaneVec wi;
  Floats pdf;
  lanes = lanes && OutlookT<Floats>(scene_, here).sample(choice, u, wi, pdf);
  pdf *= lookShare;
  const BsdfValueT<Floats> f = bsdf.eval(wi);
  LaneVec value = state.throughput * f.value * Floats(at.terminatorFor(wi) / pdf);
  const bool both = options_.lightSampling == LightSampling::Both;
  if (both) value *= share(pdf, f.pdf);
  lanes = lanes && maxComponent(value) > 0.0f;
  if (!any(lanes)) return;
  const Seen seen = look(scene_, lanes, at.originTowards(wi), wi, draws, state.rays);
  const LaneVec sky = seen.sky * value, sun = seen.sun * value, lamp = seen.lamp * value;
  add(lanes && maxComponent(sky) > 0.0f, sky * clamped(sky, toMask(state.bounces > 0)), Ints(0));
  if (!both) return;
  add(lanes && maxComponent(sun) > 0.0f, sun * clamped(sun, LaneMask(true)),
      Ints(std::int32_t{scene_.lights().daylight().sunGroup()}));
  const LaneMask lit = lanes && maxComponent(lamp) > 0.0f;
  if (any(lit)) add(lit, lamp * clamped(lamp, LaneMask(true)), seen.lampGroup);
}

void LaneWalk::askLamps(LaneMask lanes, const LanePoints& at, const BsdfT<Floats>& bsdf,
                        const LaneReceiver& here, const Floats& choice, const Floats& localShare,
                        LaneMask byLooks) {
  const LaneVec2 u = draw2D(lanes);
  if (!any(lanes)) return;
  LightSampleT<Floats> light;
  lanes = scene_.lights().local().sample(lanes, here, choice, u, light);
  if (!any(lanes)) return;
  light.pdf *= localShare;
  light.weight *= 1.0f / localShare;
  connect(lanes, at, bsdf, light, byLooks);
}

// Ends paths with what is known of the light there: the lanes where enough is.
LaneMask LaneWalk::takeFromCache(LaneMask lanes, const LanePoints& at, const BsdfT<Floats>& bsdf) {
  LaneArray3 irradiance(spread<Floats>({}));
  LaneArray taken(0.0f);
  forLanes(lanes, [&](int k) {
    const Vec3f p = lane(at.position, k);
    const LightCache::Neighbourhood* known = options_.cache->at(p, lane(at.shading.ng, k));
    if (!known || length(p - lane(state.fromPosition, k)) <= kCacheReach * known->size) return;
    irradiance.set(k, known->irradiance);
    taken[k] = 1;
  });
  const LaneMask ended = lanes && Floats(taken) > 0.0f;
  if (any(ended))
    add(ended, state.throughput * bsdf.albedo() * LaneVec(irradiance) * Floats(1 / kPiF), Ints(0));
  return ended;
}

// Roulette by what a path is expected to bring, beside what its first surface shows or how noisy that is,
// whichever is less: @cite vorba2016adjoint, without the splitting; the noise after @cite rath2022ears. A
// path that has come to a dark place mostly ends, one on its way to a bright one never does. Returns the
// lanes that the guide knows, which other roulette is to leave alone.
LaneMask LaneWalk::judge(LaneMask lanes, const LanePoints& at, const BsdfT<Floats>& bsdf, LaneMask& ended) {
  using namespace lane_math;
  LaneArray lux(0.0f), shown(0.0f);
  forLanes(lanes, [&](int k) {
    const LightCache::Neighbourhood* known = options_.guide->at(lane(at.position, k), lane(at.shading.ng, k));
    if (!known) return;
    lux[k] = luminance(known->irradiance);
    shown[k] = std::min(lux[k], known->deviation);
  });
  const LaneMask known = lanes && Floats(shown) > 0.0f;
  const Floats carries = luminance(state.throughput * bsdf.albedo()) / (kPiF * state.etaScale);
  const LaneMask first = known && state.worth <= 0.0f;
  state.worth = select(first, kWorth * Floats(shown) * carries, state.worth);
  const LaneMask judged = known && !first;
  const Floats fate = draw1D(judged);
  // Among white walls nothing else might ever end a path.
  const Floats most = select(toMask(state.bounces > kRouletteWithGuide), Floats(kMostSurvival), Floats(1.0f));
  const Floats survival = max(min(Floats(lux) * carries / state.worth, most), kLeastSurvival);
  ended = judged && fate >= survival;
  state.throughput *= select(judged, 1.0f / survival, Floats(1.0f));
  return known;
}

LaneMask LaneWalk::scatter(LaneMask active, const LanePoints& at) {
  using namespace lane_math;
  const BsdfT<Floats> bsdf(at.shading, -state.direction);
  const LaneMask showing = active && !has(kFeaturesKnown) && !bsdf.mostlySharp();
  if (any(showing)) noteFeatures(showing, at, bsdf);

  const LocalLights& locals = scene_.lights().local();
  const Daylight& daylight = scene_.lights().daylight();
  const LaneReceiver here{at.position, at.shading.ng, bsdf.seesBehind()};
  const LaneMask indirect = toMask(state.bounces > 0), sharp = has(kSharp);
  Floats localShare = 1.0f, skyShare = 1.0f;
  LaneMask scatters = active && bsdf.scatters();
  const LaneMask widely = scatters && bsdf.diffuseShare() > kLeastDiffuse;
  LaneMask known(false);  // to the guide
  const LaneMask looksOut = widely && LaneMask(scene_.lights().looks() && options_.looks);
  const bool both = options_.lightSampling == LightSampling::Both;
  // What has been found here could have been by a look.
  const LaneMask looked = has(kLooked) && !sharp && LaneMask(both);
  LaneMask inLamp(false);
  if (scene_.lights().sunPatches().hasLamps())
    inLamp = active && scene_.lights().sunPatches().nearLamps(at.position);

  if (options_.lightSampling != LightSampling::SurfacesOnly) {
    // The sun is asked everywhere, since missing it costs most; lamps and the sky both where the picture
    // shows the answer, and one of them where light has yet to bounce on.
    if (daylight.hasSun()) {
      const LaneVec2 u = draw2D(scatters);
      LightSampleT<Floats> light;
      const LaneMask sunny = scatters && daylight.sampleSun(here, u, light);
      if (any(sunny)) connect(sunny, at, bsdf, light, looked);
    }
    if (!batch_.lessons.empty())
      forLanes(widely, [&](int k) {
        std::vector<Lesson>& lessons = batch_.lessons[static_cast<std::size_t>(path[k])];
        if (lessons.size() >= kMostLessons) return;
        lessons.push_back({lane(at.position, k), lane(at.shading.ng, k), lane(state.radiance, k),
                           lane(state.throughput, k) * lane(bsdf.albedo(), k) * (1 / kPiF)});
      });
    if (options_.cache) {
      const LaneMask ended = takeFromCache(widely && indirect && !sharp && !(inLamp && looked), at, bsdf);
      active = active && !ended;
      scatters = scatters && !ended;
    }
    if (options_.guide) {
      LaneMask ended;
      known = judge(widely && active, at, bsdf, ended);
      active = active && !ended;
      scatters = scatters && !ended;
    }
    LaneMask askLocal = scatters && LaneMask(!locals.empty());
    LaneMask askSky = scatters && (LaneMask(daylight.hasSky()) || looksOut);
    Floats choice = draw1D(scatters);
    const LaneMask either = askLocal && askSky && indirect && !inLamp;  // in there as looks ask
    const LaneMask local = has(kAsksLamps);
    localShare = select(either, Floats(kLocalShare), localShare);
    skyShare = select(either, Floats(1 - kLocalShare), skyShare);
    askLocal = askLocal && (local || !either);
    askSky = askSky && !(either && local);
    if (!locals.empty()) askLamps(askLocal, at, bsdf, here, choice, localShare, looked && inLamp);
    if (daylight.hasSky() || scene_.lights().looks()) {
      const Floats other = draw1D(askSky && askLocal);
      choice = select(askLocal, other, choice);
      if (scene_.lights().looks()) lookOut(askSky && looksOut, at, bsdf, here, choice, skyShare);
      if (daylight.hasSky()) {
        LaneMask asks = askSky && !looksOut;
        const LaneVec2 u = draw2D(asks);
        LightSampleT<Floats> light;
        if (any(asks)) {
          asks = asks && daylight.sampleSky(here, choice, u, light);
          light.pdf *= skyShare;
          light.weight *= 1.0f / skyShare;
          connect(asks, at, bsdf, light, LaneMask(false));
        }
      }
    }
  }

  const Floats lobe = draw1D(active);
  const LaneVec2 u = draw2D(active);
  const BsdfSampleT<Floats> s = bsdf.sample(lobe, u);
  active = active && s.pdf > 0.0f;
  const LaneMask turns = active && !s.straight;
  state.throughput *= select(active, s.weight, spread<Floats>({1, 1, 1}));
  state.throughput *= select(turns && !s.delta, at.terminatorFor(s.wi), Floats(1.0f));
  const Floats passing = dot(at.position - state.origin, state.direction) * 1.000002f + 1e-7f;
  state.tMin = select(s.straight, passing, select(turns, Floats(0.0f), state.tMin));
  state.origin = select(turns, at.originTowards(s.wi), state.origin);
  state.direction = select(turns, s.wi, state.direction);
  state.fromPosition = select(turns, at.position, state.fromPosition);
  state.fromNormal = select(turns, at.shading.ng, state.fromNormal);
  state.pdf = select(turns, s.pdf, state.pdf);
  state.localShare = select(turns, localShare, state.localShare);
  state.skyShare = select(turns, skyShare, state.skyShare);
  state.etaScale *= select(turns, s.etaScale, Floats(1.0f));
  state.bounces = select(turns, state.bounces + 1, state.bounces);
  const auto flag = [](LaneMask m, WalkFlag f) { return select(m, Ints(f), Ints(0)); };
  const Ints kept = state.flags & Ints(kFeaturesKnown | kDepthKnown);
  state.flags = select(
      turns, kept | flag(here.bothSides, kFromBothSides) | flag(looksOut, kLooked) | flag(s.delta, kSharp),
      state.flags);
  active = active && maxComponent(state.throughput) > 0.0f;

  const int always = options_.guide ? kRouletteWithGuide : kRouletteAfter;
  const LaneMask judged = active && !known && (toMask(state.bounces > always) || toMask(state.segments > 16));
  const Floats fate = draw1D(judged);
  const Floats survival = min(maxComponent(state.throughput) / state.etaScale, kMostSurvival);
  active = active && !(judged && fate >= survival);
  state.throughput *= select(judged, 1.0f / survival, Floats(1.0f));
  set(turns && draw1D(active) < kLocalShare, kAsksLamps);
  return active;
}

}  // namespace idap::render
