#include "render/integrator/direct_light.h"

#include "render/emitter/lights.h"
#include "render/integrator/outlook.h"

namespace idap::render {

namespace {

// Of the random numbers of a step, beyond those of the walk itself.
constexpr std::uint32_t kFirstDraw[kLightSources] = {12, 13, 15};

template <class Asked>
LaneMask hasFlag(const Asked& asked, AskFlag flag) {
  return toMask((asked.flags & Ints(flag)) != 0);
}

}  // namespace

// The surface point again.
struct DirectLight::Point {
  LanePoints at;
  BsdfT<Floats> bsdf;
  LaneReceiver receiver;
  LaneSampler sampler;

  Point(const Ask& ask, LightSource source)
      : at(pointOf(ask)),
        bsdf(at.shading, -ask.direction),
        receiver{at.position, at.shading.ng, hasFlag(ask, kAskBothSides)},
        sampler(ask.sampler) {
    sampler.dimension += kFirstDraw[static_cast<std::size_t>(source)];
  }
  static LanePoints pointOf(const Ask& ask) {
    LanePoints at;
    at.position = ask.position;
    at.offset = ask.offset;
    at.shading = {
        ask.ng, ask.ns,  ask.baseColor,    ask.roughness,    ask.metalness,          ask.ior,
        ask.f0, ask.f90, ask.transmission, ask.translucency, hasFlag(ask, kAskThin), hasFlag(ask, kAskFront)};
    at.smooth = hasFlag(ask, kAskSmooth);
    return at;
  }
};

void DirectLight::answer() {
  const auto queue = [&](LightSource s) -> LaneQueue<Ask>& { return queues_[static_cast<std::size_t>(s)]; };
  queue(LightSource::Sun).visit([&](LaneMask lanes, const Ask& ask) { askSun(lanes, ask); });
  queue(LightSource::Lamps).visit([&](LaneMask lanes, const Ask& ask) { askLamps(lanes, ask); });
  queue(LightSource::Sky).visit([&](LaneMask lanes, const Ask& ask) { askSky(lanes, ask); });
  looks_.visit([&](LaneMask lanes, const Ask& ask) { lookOut(lanes, ask); });
  out_.visit([&](LaneMask lanes, const Ask& ask) { addSky(lanes, ask); });
  doubled_.visit([&](LaneMask lanes, const Doubled& found) { addDoubled(lanes, found); });
  for (LaneQueue<Ask>& q : queues_) q.clear();
  looks_.clear();
  out_.clear();
  doubled_.clear();
}

template <class Asked>
void DirectLight::add(LightSource source, LaneMask lanes, const Asked& asked, const LaneVec& light,
                      const Ints& group) {
  forLanes(lanes && maxComponent(light) > 0.0f, [&](int k) {
    const int path = lane(asked.path, k);
    const Rgb own = lane(light, k);
    batch_.add(path, own, static_cast<std::size_t>(lane(group, k)));
    if ((lane(asked.flags, k) & kAskLearns) == 0) return;
    Lesson& lesson = batch_.lessons[static_cast<std::size_t>(path)].back();
    // The sun is too small and bright to be learned as a mean.
    if (source == LightSource::Sun) lesson.before += own;
    const float scale = luminance(lesson.scale);
    const float lux = scale > 0 ? luminance(own) / scale : 0.0f;
    lesson.squares[static_cast<std::size_t>(source)] += lux * lux * lane(asked.share, k);
  });
}

// Adds the light of the samples where nothing is in between.
void DirectLight::connect(LightSource source, LaneMask lanes, const Ask& ask, const Point& point,
                          const LightSampleT<Floats>& light) {
  const LanePoints& at = point.at;
  const BsdfValueT<Floats> f = point.bsdf.eval(light.wi);
  LaneVec value = ask.throughput * f.value * light.weight * at.terminatorFor(light.wi);
  if (options_.lightSampling == LightSampling::Both)
    value *= select(light.pdf > 0.0f, share(light.pdf, f.pdf), Floats(1.0f));
  lanes = lanes && maxComponent(value) > 0.0f;
  if (!any(lanes)) return;
  batch_.rays += static_cast<std::uint64_t>(std::popcount(bitsOf(lanes)));
  value *= scene_.transmittance(
      lanes, {at.originTowards(light.wi), light.wi, 0.0f, light.distance * (1 - 5e-5f) - at.offset});
  lanes = lanes && maxComponent(value) > 0.0f;
  // Few are doubled, and weighing them is much work: they wait until they are many.
  const LaneMask doubled = lanes && hasFlag(ask, kAskByLooks);
  if (any(doubled))
    doubled_.push(
        doubled, {value, ask.direction, ask.fromPosition, ask.fromNormal, ask.fromPdf, ask.fromSkyShare,
                  ask.share, ask.flags, ask.path, light.lightGroup, Ints(static_cast<std::int32_t>(source))});
  value *= clampScale(options_, value, hasFlag(ask, kAskIndirect));
  add(source, lanes && !doubled, ask, value, light.lightGroup);
}

void DirectLight::addDoubled(LaneMask lanes, const Doubled& found) {
  const LaneReceiver from{found.fromPosition, found.fromNormal, hasFlag(found, kAskFromBothSides)};
  const Floats looks = found.fromSkyShare * OutlookT<Floats>(scene_, from).pdf(found.direction);
  LaneVec light = found.light * share(found.fromPdf, looks);
  light *= clampScale(options_, light, hasFlag(found, kAskIndirect));
  for (const LightSource source : {LightSource::Sun, LightSource::Lamps})
    add(source, lanes && toMask(found.source == static_cast<std::int32_t>(source)), found, light,
        found.group);
}

void DirectLight::addSky(LaneMask lanes, const Ask& ask) {
  const Daylight& daylight = scene_.lights().daylight();
  const LaneMask sharp = hasFlag(ask, kAskSharp);
  const LaneReceiver from{ask.fromPosition, ask.fromNormal, hasFlag(ask, kAskFromBothSides)};
  // lightPdf: of finding the same by light sampling; asked only where it could.
  const auto weigh = [&](LaneMask seen, const auto& lightPdf) {
    const LaneMask asked = seen && !sharp;
    if (options_.lightSampling == LightSampling::SurfacesOnly || !any(asked)) return Floats(1.0f);
    const Floats pdf = lightPdf(asked);
    const Floats weight = options_.lightSampling == LightSampling::LightsOnly
                              ? only(!(pdf > 0.0f), Floats(1.0f))
                              : share(ask.fromPdf, pdf);
    return select(sharp, Floats(1.0f), weight);
  };
  LaneVec fromSky = spread<Floats>({}), fromSun = fromSky;
  if (daylight.hasSky()) {
    const LaneVec sky = daylight.skyRadiance(ask.direction);
    const LaneMask seen = lanes && maxComponent(sky) > 0.0f;
    const Floats weight = weigh(seen, [&](LaneMask asked) {
      const LaneMask looked = hasFlag(ask, kAskByLooks);
      Floats pdf = 0.0f;
      if (any(asked && looked)) pdf = OutlookT<Floats>(scene_, from).pdf(ask.direction);
      if (any(asked && !looked)) pdf = select(looked, pdf, daylight.pdfSky(from, ask.direction));
      return Floats(pdf * ask.fromSkyShare);
    });
    fromSky = only(seen, sky * weight);
  }
  if (daylight.hasSun()) {
    const LaneVec sun = daylight.sunRadiance(ask.direction);
    const LaneMask seen = lanes && maxComponent(sun) > 0.0f;
    if (any(seen)) {
      const Floats weight = weigh(seen, [&](LaneMask) { return daylight.pdfSun(from); });
      fromSun = only(seen, sun * weight);
    }
  }
  LaneVec throughput = ask.throughput;
  throughput *= clampScale(options_, (fromSky + fromSun) * throughput, hasFlag(ask, kAskFarther));
  add(LightSource::Sky, lanes, ask, fromSky * throughput, 0);
  add(LightSource::Sun, lanes, ask, fromSun * throughput, Ints(std::int32_t{daylight.sunGroup()}));
}

void DirectLight::askSun(LaneMask lanes, const Ask& ask) {
  Point point(ask, LightSource::Sun);
  LightSampleT<Floats> light;
  lanes = lanes && scene_.lights().daylight().sampleSun(point.receiver, point.sampler.get2D(), light);
  if (!any(lanes)) return;
  light.weight *= 1.0f / ask.share;
  connect(LightSource::Sun, lanes, ask, point, light);
}

void DirectLight::askLamps(LaneMask lanes, const Ask& ask) {
  Point point(ask, LightSource::Lamps);
  const Floats choice = point.sampler.get1D();
  LightSampleT<Floats> light;
  lanes = scene_.lights().local().sample(lanes, point.receiver, choice, point.sampler.get2D(), light);
  if (!any(lanes)) return;
  light.pdf *= ask.share;
  light.weight *= 1.0f / ask.share;
  connect(LightSource::Lamps, lanes, ask, point, light);
}

void DirectLight::askSky(LaneMask lanes, const Ask& ask) {
  Point point(ask, LightSource::Sky);
  const Floats choice = point.sampler.get1D();
  LightSampleT<Floats> light;
  lanes = lanes && scene_.lights().daylight().sampleSky(point.receiver, choice, point.sampler.get2D(), light);
  light.pdf *= ask.share;
  light.weight *= 1.0f / ask.share;
  connect(LightSource::Sky, lanes, ask, point, light);
}

// Adds what one look from each point finds of sky and sunlit surfaces.
void DirectLight::lookOut(LaneMask lanes, const Ask& ask) {
  Point point(ask, LightSource::Sky);
  const LanePoints& at = point.at;
  const Floats choice = point.sampler.get1D();
  const LaneVec2 u = point.sampler.get2D();
  LookDraws draws{point.sampler.get2D(), {}, 0.0f};
  if (scene_.lights().sunPatches().hasLamps())
    draws.lamp = point.sampler.get2D(), draws.lampChoice = point.sampler.get1D();
  LaneVec wi;
  Floats pdf;
  lanes = lanes && OutlookT<Floats>(scene_, point.receiver).sample(choice, u, wi, pdf);
  pdf *= ask.share;
  const BsdfValueT<Floats> f = point.bsdf.eval(wi);
  LaneVec value = ask.throughput * f.value * Floats(at.terminatorFor(wi) / pdf);
  const bool both = options_.lightSampling == LightSampling::Both;
  if (both) value *= share(pdf, f.pdf);
  lanes = lanes && maxComponent(value) > 0.0f;
  if (!any(lanes)) return;
  const Seen seen = look(scene_, lanes, at.originTowards(wi), wi, draws, batch_.rays);
  const LaneVec sky = seen.sky * value;
  add(LightSource::Sky, lanes, ask, sky * clampScale(options_, sky, hasFlag(ask, kAskIndirect)), 0);
  if (!both) return;
  const LaneVec sun = seen.sun * value;
  add(LightSource::Sky, lanes, ask, sun * clampScale(options_, sun, LaneMask(true)),
      Ints(std::int32_t{scene_.lights().daylight().sunGroup()}));
  if (!scene_.lights().sunPatches().hasLamps()) return;
  const LaneVec lamp = seen.lamp * value;
  add(LightSource::Sky, lanes, ask, lamp * clampScale(options_, lamp, LaneMask(true)), seen.lampGroup);
}

}  // namespace idap::render
