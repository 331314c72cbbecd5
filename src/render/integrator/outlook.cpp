#include "render/integrator/outlook.h"

#include "render/material/bsdf.h"
#include "render/sampling/warp.h"

namespace idap::render {

namespace {

constexpr float kPatchShare = 0.5f;  // of looks, where patches of sun are in view
constexpr int kMostVeils = 8;        // that let light by as well as scattering it, on a look's way

// What part of the light goes straight through the surfaces.
LaneVec straightThrough(LaneMask active, const LaneVec& direction, const LanePoints& points) {
  LaneArray3 through(spread<Floats>({}));
  forLanes(active, [&](int k) {
    const SurfaceData& surface = *points.surface[k];
    if (surface.opaqueToShadows) return;
    const SurfaceValues values{lane(points.shading.baseColor, k), lane(points.shading.roughness, k),
                               lane(points.opacity, k)};
    const float cosine = std::min(std::fabs(dot(lane(points.shading.ng, k), lane(direction, k))), 1.0f);
    through.set(k, straightTransmittance(surface, values, cosine));
  });
  return through;
}

}  // namespace

template <class F>
OutlookT<F>::OutlookT(const CompiledScene& scene, const ReceiverT<F>& at)
    : daylight_(scene.lights().daylight()), at_(at), patches_(scene.lights().sunPatches(), at) {
  patchShare_ = only(!patches_.empty(), F(daylight_.hasSky() ? kPatchShare : 1.0f));
}

template <class F>
Mask<F> OutlookT<F>::sample(F choice, const Vec2T<F>& u, Vec3T<F>& direction, F& pdf) const {
  const Mask<F> aims = choice < patchShare_;
  Mask<F> found = aims;
  direction = patches_.sample(F(choice / patchShare_), u);
  pdf = 0.0f;
  if (daylight_.hasSky()) {
    const F rest = lane_math::clamp(F((choice - patchShare_) / (1.0f - patchShare_)), 0.0f, kOneMinusEpsilon);
    const auto sky = daylight_.chooseSky<F>(at_, rest, u);
    found = found || sky.found;
    direction = select(aims, direction, sky.wi);
    pdf = (1.0f - patchShare_) * daylight_.pdfSky<F>(at_, direction, sky, !aims);
  }
  pdf += only(patchShare_ > 0.0f, patchShare_ * patches_.pdf(direction));
  return found && pdf > 0.0f;
}

template <class F>
F OutlookT<F>::pdf(const Vec3T<F>& direction) const {
  const F patches = only(patchShare_ > 0.0f, patchShare_ * patches_.pdf(direction));
  return daylight_.hasSky() ? (1.0f - patchShare_) * daylight_.pdfSky(at_, direction) + patches : patches;
}

template class OutlookT<float>;
template class OutlookT<Floats>;

Seen look(const CompiledScene& scene, LaneMask active, const LaneVec& origin, const LaneVec& direction,
          const LookDraws& draws, std::uint64_t& rays) {
  const auto count = [&](LaneMask lanes) {
    rays += static_cast<std::uint64_t>(std::popcount(bitsOf(lanes)));
  };
  const Daylight& daylight = scene.lights().daylight();
  const SunPatches& patches = scene.lights().sunPatches();
  Seen seen{spread<Floats>({}), spread<Floats>({}), spread<Floats>({})};
  LaneVec through = spread<Floats>({1, 1, 1});
  LaneRays ray{origin, direction};
  for (int sheet = 0; sheet <= kMostVeils && any(active); ++sheet) {
    LaneHits hits;
    LaneVec sheets;
    count(active);
    scene.look(active, ray, hits, sheets);
    through *= sheets;
    const LaneMask out = active && !hits.found;
    if (any(out)) seen.sky = select(out, daylight.skyRadiance(direction) * through, seen.sky);
    active = active && hits.found;
    if (!any(active)) break;
    LanePoints at;
    scene.points(active, ray, hits, at);
    const BsdfT<Floats> bsdf(at.shading, -direction);
    LightSampleT<Floats> sun;
    const LaneReceiver here{at.position, at.shading.ng, bsdf.seesBehind()};
    LaneMask lit = active && bsdf.scatters() && daylight.sampleSun(here, draws.sun, sun);
    if (any(lit)) {
      const LaneVec value =
          bsdf.eval(sun.wi).value * sun.weight * through * Floats(at.opacity * at.terminatorFor(sun.wi));
      lit = lit && maxComponent(value) > 0.0f;
      if (any(lit)) {
        count(lit);
        seen.sun += only(lit, value * scene.transmittance(lit, {at.originTowards(sun.wi), sun.wi}));
      }
    }
    if (patches.hasLamps()) {
      LightSampleT<Floats> light;
      LaneMask near = active && bsdf.scatters() && patches.nearLamps(at.position);
      if (any(near)) near = scene.lights().local().sample(near, here, draws.lampChoice, draws.lamp, light);
      if (any(near)) {
        const BsdfValueT<Floats> f = bsdf.eval(light.wi);
        LaneVec value = f.value * light.weight * through * Floats(at.opacity * at.terminatorFor(light.wi));
        value *= select(light.pdf > 0.0f, share(light.pdf, f.pdf), Floats(1.0f));
        near = near && maxComponent(value) > 0.0f;
        count(near);
        if (any(near)) {
          value *= scene.transmittance(
              near, {at.originTowards(light.wi), light.wi, 0.0f, light.distance * (1 - 5e-5f) - at.offset});
          seen.lamp = select(near, value, seen.lamp);
          seen.lampGroup = select(near, light.lightGroup, seen.lampGroup);
        }
      }
    }
    through *= straightThrough(active, direction, at);
    active = active && maxComponent(through) > 1e-4f;
    ray.tMin = hits.t * 1.000002f + 1e-7f;
  }
  return seen;
}

}  // namespace idap::render
