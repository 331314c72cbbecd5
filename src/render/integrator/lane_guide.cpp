// What a walk is told by the light cache and the guide, and what it finds out for them.
#include "render/integrator/lane_walk.h"
#include "render/sampling/warp.h"

namespace idap::render {

namespace {

constexpr float kCacheReach = 1.5f;       // times a neighbourhood's size; what is nearer is looked at closely
constexpr std::size_t kMostLessons = 24;  // bounces of a path that a cache learns from
constexpr float kWorth = 0.7f;            // of what the first surface shows: always followed
constexpr float kLeastSurvival = 0.1f;    // of a path that the guide expects nothing of
constexpr float kAskedAlways = 1.0f;      // a light that may bring this much of what the first surface shows
constexpr float kLeastAsked = 0.1f;       // of the times, a light that the guide expects nothing of

}  // namespace

// Ends paths with what is known of the light there: the lanes where enough is.
LaneMask LaneWalk::takeFromCache(LaneMask lanes, const LanePoints& at, const BsdfT<Floats>& bsdf) {
  LaneArray3 irradiance(spread<Floats>({}));
  LaneArray taken(0.0f);
  const LaneVec way = at.position - state.fromPosition;
  const LaneArray way2(dot(way, way));
  options_.cache->visit(lanes, at.position, at.shading.ng,
                        [&](int k, const LightCache::Neighbourhood& known) {
                          const float reach = kCacheReach * known.size;
                          if (way2.value[k] <= reach * reach) return;
                          irradiance.set(k, known.irradiance);
                          taken[k] = 1;
                        });
  const LaneMask ended = lanes && Floats(taken) > 0.0f;
  if (any(ended))
    add(ended, state.throughput * bsdf.albedo() * LaneVec(irradiance) * Floats(1 / kPiF), Ints(0));
  return ended;
}

LaneWalk::Guided LaneWalk::askGuide(LaneMask lanes, const LanePoints& at, const BsdfT<Floats>& bsdf) {
  using namespace lane_math;
  LaneArray lux(0.0f), shown(0.0f), asked[kLightSources];
  for (LaneArray& a : asked) a = Floats(0.0f);
  guide_->visit(lanes, at.position, at.shading.ng, [&](int k, const LightCache::Neighbourhood& known) {
    lux[k] = known.lux;
    shown[k] = std::min(known.lux, known.deviation);
    for (std::size_t i = 0; i < kLightSources; ++i) asked[i][k] = known.asked[i];
  });
  Guided g;
  g.known = lanes && Floats(shown) > 0.0f;
  g.lux = lux;
  for (std::size_t i = 0; i < kLightSources; ++i) g.asked[i] = asked[i];
  g.carries = luminance(state.throughput * bsdf.albedo()) / (kPiF * state.etaScale);
  state.worth = select(g.known && state.worth <= 0.0f, Floats(shown) * g.carries, state.worth);
  return g;
}

// Roulette by what a path is expected to bring, beside what its first surface shows or how noisy that is,
// whichever is less: @cite vorba2016adjoint, without the splitting; the noise after @cite rath2022ears. A
// path that has come to a dark place mostly ends, one on its way to a bright one never does. Returns the
// lanes that end.
LaneMask LaneWalk::judge(LaneMask lanes, Guided& g) {
  using namespace lane_math;
  const LaneMask judged = lanes && g.known && toMask(state.bounces > 0);
  const Floats fate = draw1D(judged);
  // Among white walls nothing else might ever end a path.
  const Floats most = select(toMask(state.bounces > kRouletteWithGuide), Floats(kMostSurvival), Floats(1.0f));
  const Floats survival = max(min(g.lux * g.carries / (kWorth * state.worth), most), kLeastSurvival);
  const Floats scale = select(judged, 1.0f / survival, Floats(1.0f));
  state.throughput *= scale;
  g.carries *= scale;
  return judged && fate >= survival;
}

// How likely a light is to be asked: by the root mean square of what it brings here, since rays are best
// spent where they take most of the variance (@cite rath2022ears).
Floats LaneWalk::rate(const Guided& g, LightSource source) const {
  using namespace lane_math;
  const Floats most = g.asked[static_cast<std::size_t>(source)] * g.carries / (kAskedAlways * state.worth);
  return select(g.known, max(min(most, 1.0f), kLeastAsked), Floats(1.0f));
}

LaneMask LaneWalk::learn(LaneMask lanes, const LanePoints& at, const BsdfT<Floats>& bsdf) {
  const LaneVec scale = state.throughput * bsdf.albedo() * Floats(1 / kPiF);
  LaneArray learns(0.0f);
  forLanes(lanes, [&](int k) {
    const auto i = static_cast<std::size_t>(pathOf(k));
    if (batch_.lessons[i].size() >= kMostLessons) return;
    batch_.lessons[i].push_back(
        {lane(at.position, k), lane(at.shading.ng, k), batch_.samples[i].radiance, lane(scale, k)});
    learns[k] = 1;
  });
  return Floats(learns) > 0.0f;
}

}  // namespace idap::render
