#include "render/integrator/lane_walk.h"

#include "render/emitter/lights.h"
#include "render/material/bsdf.h"
#include "render/sampling/warp.h"

namespace idap::render {

namespace {

constexpr int kRouletteAfter = 2;       // bounces that are always followed
constexpr float kLocalShare = 0.5f;     // of questions, where either lamps or the sky are asked
constexpr float kLeastDiffuse = 0.25f;  // of a surface's scattering, for looks and caches to make sense
constexpr int kMostSegments = 4096;     // a guard against endless loops, far beyond what roulette lets live

Ints flagged(LaneMask lanes, std::int32_t flag) { return select(lanes, Ints(flag), Ints(0)); }

}  // namespace

WalkState beginWalk(const PathStart& start, const Ints& path) {
  WalkState s{};
  s.origin = start.origin;
  s.direction = start.direction;
  s.throughput = spread<Floats>({1, 1, 1});
  s.etaScale = s.pdf = s.localShare = s.skyShare = 1.0f;
  s.sampler = start.sampler;
  s.flags = std::int32_t{kSharp};
  s.path = path;
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

void LaneWalk::add(LaneMask lanes, const LaneVec& light, const Ints& group) {
  forLanes(lanes && maxComponent(light) > 0.0f,
           [&](int k) { batch_.add(pathOf(k), lane(light, k), static_cast<std::size_t>(lane(group, k))); });
}

void LaneWalk::addMet(int k, Rgb light, std::uint16_t group) {
  if (options_.clampIndirect > 0 && lane(state.bounces, k) > 1)
    light *= std::min(1.0f, options_.clampIndirect / std::max(luminance(light), 1e-20f));
  batch_.add(pathOf(k), light, group);
}

LaneMask LaneWalk::step(LaneMask active) {
  using namespace lane_math;
  active = active && toMask(state.segments <= kMostSegments);
  const LaneMask primary = active && toMask(state.bounces == 0);
  state.segments += 1;
  batch_.rays += static_cast<std::uint64_t>(std::popcount(bitsOf(active)));
  const LaneRays rays{state.origin, state.direction, state.tMin};
  LaneHits hits;
  scene_.intersect(active, rays, hits, select(primary, Words(kCameraRay), Words(kBounceRay)));

  const LaneMask out = active && !hits.found;
  const Daylight& daylight = scene_.lights().daylight();
  if (any(out) && (daylight.hasSky() || daylight.hasSun())) {
    Ask ask = askAlong();
    ask.flags |= flagged(has(kSharp), kAskSharp) | flagged(has(kLooked), kAskByLooks);
    direct_.meetSky(options_.hideSky ? out && !(primary && !has(kDepthKnown)) : out, ask);
  }
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
      PathSample& sample = batch_.samples[static_cast<std::size_t>(pathOf(k))];
      sample.depth = lane(hits.t, k);
      sample.objectId = at.objectId[k];
    });
    set(first, kDepthKnown);
    const LaneMask emits = met && at.emits;
    if (any(emits)) addEmission(emits, hits, at);
    if (any(met)) goesOn = scatter(met, at);
  }
  // On along the same ray, behind what it has hit.
  state.tMin = select(passed, hits.t * 1.000002f + 1e-7f, state.tMin);
  return goesOn || passed;
}

void LaneWalk::addEmission(LaneMask lanes, const LaneHits& hits, const LanePoints& at) {
  const LocalLights& local = scene_.lights().local();
  forLanes(lanes, [&](int k) {
    float weight = 1;
    if (!has(kSharp, k) && options_.lightSampling != LightSampling::SurfacesOnly) {
      const Ray ray{lane(state.origin, k), lane(state.direction, k)};
      const float light = local.pdfTriangle(receiver(k), ray, hits.hit(k), lane(at.shading.frontFace, k)) *
                          lane(state.localShare, k);
      if (options_.lightSampling == LightSampling::LightsOnly)
        weight = light > 0 ? 0.0f : 1.0f;
      else
        weight = share(lane(state.pdf, k), light);
    }
    addMet(k, lane(state.throughput, k) * at.surface[k]->emission * weight, at.lightGroup[k]);
  });
}

void LaneWalk::addLamps(LaneMask lanes, const LaneHits& hits) {
  const LocalLights& local = scene_.lights().local();
  forLanes(lanes, [&](int k) {
    const Lamp& lamp = scene_.scene().lamps[hits.index[k]];
    const Vec3f direction = lane(state.direction, k);
    const Vec3f p = lane(state.origin, k) + direction * lane(hits.t, k);
    if (dot(p - lamp.position, direction) >= 0) return;  // going out, not coming in
    float weight = 1;
    if (!has(kSharp, k) && options_.lightSampling == LightSampling::Both) {
      weight =
          share(lane(state.pdf, k), local.pdfLamp(receiver(k), hits.index[k]) * lane(state.localShare, k));
    }
    if (!has(kSharp, k) && options_.lightSampling == LightSampling::LightsOnly) weight = 0;
    const Rgb light = local.lampRadiance(hits.index[k], direction);
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
    PathSample& sample = batch_.samples[static_cast<std::size_t>(pathOf(k))];
    sample.normal = lane(at.shading.ns, k);
    sample.albedo = lane(albedo, k);
  });
}

// What of an ask the ray under way says.
Ask LaneWalk::askAlong() const {
  Ask ask{};
  ask.direction = state.direction, ask.throughput = state.throughput;
  ask.fromPosition = state.fromPosition, ask.fromNormal = state.fromNormal;
  ask.fromPdf = state.pdf, ask.fromSkyShare = state.skyShare;
  ask.path = state.path;
  ask.flags = flagged(has(kFromBothSides), kAskFromBothSides) |
              flagged(toMask(state.bounces > 0), kAskIndirect) |
              flagged(toMask(state.bounces > 1), kAskFarther);
  return ask;
}

Ask LaneWalk::askAt(const LanePoints& at, const LaneReceiver& here) const {
  Ask ask = askAlong();
  const ShadingPoint<Floats>& s = at.shading;
  ask.position = at.position, ask.ng = s.ng, ask.ns = s.ns, ask.baseColor = s.baseColor;
  ask.offset = at.offset, ask.roughness = s.roughness, ask.metalness = s.metalness, ask.ior = s.ior;
  ask.f0 = s.f0, ask.f90 = s.f90, ask.transmission = s.transmission, ask.translucency = s.translucency;
  ask.share = 1.0f;
  ask.sampler = state.sampler;
  ask.flags |= flagged(s.thin, kAskThin) | flagged(s.frontFace, kAskFront) | flagged(at.smooth, kAskSmooth) |
               flagged(here.bothSides, kAskBothSides);
  return ask;
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
  const LaneMask looksOut = widely && LaneMask(scene_.lights().looks() && options_.looks);
  Guided guided;
  if (guide_) guided = askGuide(widely, at, bsdf);
  const LaneMask known = guided.known;

  if (options_.lightSampling != LightSampling::SurfacesOnly) {
    Ask ask = askAt(at, here);
    // What has been found here could have been by a look.
    const LaneMask looked = has(kLooked) && !sharp && LaneMask(options_.lightSampling == LightSampling::Both);
    LaneMask inLamp(false);
    if (scene_.lights().sunPatches().hasLamps())
      inLamp = active && scene_.lights().sunPatches().nearLamps(at.position);
    if (!batch_.lessons.empty()) ask.flags |= flagged(learn(widely, at, bsdf), kAskLearns);
    const Ints flags = ask.flags;
    // One number decides on all sources, turned between them; paths' ends do not depend on it.
    const Floats chance = draw1D(scatters);
    const auto turned = [&](float by) {
      const Floats c = chance + by;
      return Floats(c - floor(c));
    };
    // The sun is asked even where a path ends.
    if (daylight.hasSun()) {
      ask.share = rate(guided, LightSource::Sun);
      ask.flags = flags | flagged(looked, kAskByLooks);
      direct_.ask(LightSource::Sun, scatters && chance < ask.share, ask);
    }
    if (options_.cache) {
      const LaneMask ended = takeFromCache(widely && indirect && !sharp && !(inLamp && looked), at, bsdf);
      active = active && !ended;
      scatters = scatters && !ended;
    }
    if (guide_) {
      const LaneMask ended = judge(widely && active, guided);
      active = active && !ended;
      scatters = scatters && !ended;
      ask.throughput = state.throughput;
    }
    // Lamps and the sky: each as often as the guide says. Where it says nothing, both where the picture shows
    // the answer, and one of them where light has yet to bounce on. In lamps as looks ask.
    LaneMask askLocal = scatters && LaneMask(!locals.empty());
    LaneMask askSky = scatters && (LaneMask(daylight.hasSky()) || looksOut);
    const LaneMask rated = known && !inLamp;
    const LaneMask either = askLocal && askSky && indirect && !inLamp && !rated;
    localShare = select(rated, rate(guided, LightSource::Lamps), select(either, Floats(kLocalShare), 1.0f));
    skyShare = select(rated, rate(guided, LightSource::Sky), select(either, Floats(1 - kLocalShare), 1.0f));
    const Floats one = turned(1 / 3.0f);
    askLocal = askLocal && one < localShare;
    askSky = askSky && select(either, 1.0f - one, turned(2 / 3.0f)) <= skyShare;
    ask.share = localShare;
    ask.flags = flags | flagged(looked && inLamp, kAskByLooks);
    direct_.ask(LightSource::Lamps, askLocal, ask);
    ask.share = skyShare;
    ask.flags = flags;
    direct_.ask(LightSource::Sky, askSky && !looksOut, ask);
    direct_.askByLook(askSky && looksOut, ask);
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
  const Ints kept = state.flags & Ints(kFeaturesKnown | kDepthKnown);
  state.flags = select(
      turns,
      kept | flagged(here.bothSides, kFromBothSides) | flagged(looksOut, kLooked) | flagged(s.delta, kSharp),
      state.flags);
  active = active && maxComponent(state.throughput) > 0.0f;

  const int always = guide_ ? kRouletteWithGuide : kRouletteAfter;
  const LaneMask judged = active && !known && (toMask(state.bounces > always) || toMask(state.segments > 16));
  const Floats fate = draw1D(judged);
  const Floats survival = min(maxComponent(state.throughput) / state.etaScale, kMostSurvival);
  active = active && !(judged && fate >= survival);
  state.throughput *= select(judged, 1.0f / survival, Floats(1.0f));
  return active;
}

}  // namespace idap::render
