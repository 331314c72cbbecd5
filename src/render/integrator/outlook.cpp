#include "render/integrator/outlook.h"

#include "render/material/bsdf.h"

namespace idap::render {

namespace {

constexpr float kPatchShare = 0.5f;  // of looks, where patches of sun are in view
constexpr int kMostPanes = 8;        // of glass that a look goes through

}  // namespace

Outlook::Outlook(const CompiledScene& scene, const Receiver& at)
    : daylight_(scene.lights().daylight()), at_(at), patches_(scene.lights().sunPatches(), at) {
  patchShare_ = patches_.empty() ? 0.0f : daylight_.hasSky() ? kPatchShare : 1.0f;
}

bool Outlook::sample(float choice, Vec2f u, Vec3f& direction, float& pdf) const {
  if (choice < patchShare_) {
    direction = patches_.sample(choice / patchShare_, u);
    pdf = this->pdf(direction);
  } else {
    if (patchShare_ >= 1) return false;
    LightSample light;
    if (!daylight_.chooseSky(at_, std::min((choice - patchShare_) / (1 - patchShare_), 0.99999994f), u,
                             light))
      return false;
    direction = light.wi;
    pdf = (1 - patchShare_) * light.pdf;
    if (patchShare_ > 0) pdf += patchShare_ * patches_.pdf(direction);
  }
  return pdf > 0;
}

float Outlook::pdf(Vec3f direction) const {
  float pdf = (1 - patchShare_) * daylight_.pdfSky(at_, direction);
  if (patchShare_ > 0) pdf += patchShare_ * patches_.pdf(direction);
  return pdf;
}

Outlook::Seen Outlook::look(const CompiledScene& scene, Vec3f origin, Vec3f direction, Vec2f u,
                            std::uint32_t& rays) {
  const Daylight& daylight = scene.lights().daylight();
  Seen seen;
  Rgb through{1, 1, 1};
  Ray ray{origin, direction};
  for (int sheet = 0; sheet <= kMostPanes; ++sheet) {
    Hit hit;
    ++rays;
    if (!scene.intersect(ray, hit, kSeenByLight)) {
      seen.sky = daylight.skyRadiance(direction) * through;
      return seen;
    }
    const Interaction at = scene.interaction(ray, hit);
    const SurfaceValues values = valuesAt(*at.surface, at.uv);
    const Vec3f wo = -direction;
    const float cosine = std::min(std::fabs(dot(at.ng, wo)), 1.0f);
    const Rgb straight =
        at.surface->opaqueToShadows ? Rgb{} : straightTransmittance(*at.surface, values, cosine);
    const Bsdf bsdf(at, values, wo);
    LightSample sun;
    if (bsdf.scatters() && daylight.sampleSun({at.position, at.ng, bsdf.seesBehind()}, u, sun)) {
      Rgb value = bsdf.eval(sun.wi).value * sun.weight * through * values.opacity;
      if (at.smooth) value *= terminator(at, sun.wi);
      if (maxComponent(value) > 0) {
        ++rays;
        seen.sun += value * scene.transmittance({at.originTowards(sun.wi), sun.wi});
      }
    }
    through *= straight;
    if (!(maxComponent(through) > 1e-4f)) return seen;
    ray.tMin = hit.t * 1.000002f + 1e-7f;
  }
  return seen;
}

}  // namespace idap::render
