#include "render/integrator/classic.h"

#include <algorithm>
#include <cmath>

namespace idap::render {

namespace {

// A light's colour for the 0..1 world: its hue at full brightness, taken most of the way to white as the eye
// that has got used to it does.
Rgb hue(Rgb light) {
  constexpr float kHueShare = 0.35f;
  const float most = maxComponent(light);
  if (!(most > 0)) return {};
  return Rgb{1, 1, 1} * (1 - kHueShare) + light * (kHueShare / most);
}

}  // namespace

Ray classicRay(float px, float py, int width, int height, const ClassicCamera& camera) {
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  const float sx = (px - w / 2) / w;
  const float sy = ((h - 1) - py - h / 2) / h;
  return {camera.location, normalized(camera.direction + camera.right * sx + camera.up * sy)};
}

ClassicCamera classicCamera(const Camera& camera, float aspect) {
  const Vec3f right = normalized(cross(camera.forward, camera.up));
  const float width = 2 * std::tan(0.5f * std::clamp(camera.horizontalFov, 1e-3f, 3.1f));
  return {camera.eye, camera.forward, right * width, cross(right, camera.forward) * (width / aspect)};
}

std::vector<ClassicLight> classicLights(const Scene& scene) {
  std::vector<ClassicLight> lights;
  float strongest = 0;
  for (const Lamp& lamp : scene.lamps) strongest = std::max(strongest, luminance(lamp.intensity));
  if (strongest > 0) {
    // Twice as bright a lamp looks less than twice as bright: strengths follow the square root.
    const auto strength = [&](const Lamp& lamp) { return std::sqrt(luminance(lamp.intensity) / strongest); };
    // Lamps of one room add up, those of other rooms do not count: the most that meets at any lamp becomes
    // kTogether, of which shadows take their part; no lamp is brighter than white.
    constexpr float kRoom = 3.0f;  // m
    constexpr float kTogether = 1.8f;
    float most = 0;
    for (const Lamp& a : scene.lamps) {
      float sum = 0;
      for (const Lamp& b : scene.lamps) {
        if (!(luminance(b.intensity) > 0)) continue;
        const Vec3f d = (a.position - b.position) / kRoom;
        const float d2 = dot(d, d);
        sum += strength(b) / (1 + d2 * d2);
      }
      most = std::max(most, sum);
    }
    for (const Lamp& lamp : scene.lamps) {
      if (!(luminance(lamp.intensity) > 0)) continue;
      lights.push_back({lamp.position,
                        hue(lamp.intensity) * std::min(kTogether * strength(lamp) / most, 1.0f), lamp.radius,
                        false});
    }
  }
  const float sun = luminance(scene.sun.illuminance);
  if (sun > 0) {
    constexpr float kFullSun = 50'000;  // lux; more is no brighter
    const float share = std::sqrt(std::min(sun / kFullSun, 1.0f));
    lights.push_back({normalized(scene.sun.direction), hue(scene.sun.illuminance) * share, 0, true});
  }
  return lights;
}

Rgb classicShade(const ClassicSurface& s, Rgb own, Rgb light, Vec3f n, Vec3f toLight, Vec3f ray) {
  const float cosine = dot(n, toLight);
  if (cosine <= 0) return {};
  const float diffuse = s.diffuse * (s.brilliance == 1.0f ? cosine : std::pow(cosine, s.brilliance));
  Rgb sum = light * own * diffuse;
  if (s.specular > 0) {
    const Vec3f mirrored = ray - n * (2 * dot(n, ray));
    const float highlight = dot(mirrored, toLight);
    if (highlight > 0) sum += light * (s.specular * std::pow(highlight, s.roughness));
  }
  return sum;
}

bool classicRefract(Vec3f ray, Vec3f n, float n12, Vec3f& out) {
  const float c = -dot(ray, n);
  const float radicand = 1 + n12 * n12 * (c * c - 1);
  if (radicand < 0) return false;
  out = normalized(ray * n12 + n * (n12 * c - std::sqrt(radicand)));
  return true;
}

ClassicTracer::ClassicTracer(const CompiledScene& scene)
    : ClassicTracer(scene, classicLights(scene.scene())) {}

ClassicTracer::ClassicTracer(const CompiledScene& scene, std::vector<ClassicLight> lights)
    : scene_(scene), lights_(std::move(lights)) {}

bool ClassicTracer::lit(const ClassicLight& light, Vec3f point, Vec3f normal, Vec3f& toLight) const {
  Ray shadow{point, light.position, kClassicEpsilon, std::numeric_limits<float>::infinity()};
  if (!light.far) {
    const Vec3f way = light.position - point;
    const float distance = length(way);
    if (!(distance > 2 * kClassicEpsilon)) return false;
    shadow.direction = way / distance;
    shadow.tMax = distance - std::max(light.radius, kClassicEpsilon);
  }
  toLight = shadow.direction;
  if (!(dot(normal, toLight) > 0)) return false;
  return !(shadow.tMax > shadow.tMin && scene_.occluded(shadow));
}

Rgb ClassicTracer::follow(Ray ray, int depth, Vec3f eye) const {
  constexpr int kMostGaps = 64;  // leaves and lace that a ray may pass through
  const Scene& scene = scene_.scene();
  const std::uint32_t seen = depth == 0 ? kSeenByCamera : kSeenByLight;
  Interaction at;
  SurfaceValues values;
  for (int gaps = 0;; ++gaps) {
    Hit hit;
    if (!scene_.intersect(ray, hit, seen, depth == 0)) return scene.classicBackground;
    at = scene_.interaction(ray, hit);
    values = valuesAt(*at.surface, at.uv);
    if (values.opacity >= 0.5f || gaps == kMostGaps) break;
    ray.tMin = hit.t + kClassicEpsilon;
  }
  const Surface& surface = scene.surfaces[at.surfaceIndex];
  // What shines is not shaded: it shows the colour of its light.
  if (maxComponent(surface.emission) > 0) return hue(surface.emission);

  const ClassicSurface& s = surface.classic;
  const Rgb own = values.baseColor;
  const Vec3f n = at.ns, d = ray.direction;
  Rgb sum = own * s.ambient;
  const auto add = [&](const ClassicLight& light) {
    Vec3f toLight;
    if (!lit(light, at.position, n, toLight)) return;
    sum += classicShade(s, own, light.color, n, toLight, d);
  };
  for (const ClassicLight& light : lights_) add(light);
  if (lights_.empty()) add({eye, {1, 1, 1}, 0, false});
  if (depth >= kClassicDepth) return sum;

  const auto further = [&](Vec3f direction) {
    return follow({at.position, direction, kClassicEpsilon, std::numeric_limits<float>::infinity()},
                  depth + 1, eye);
  };
  const Vec3f mirrored = d - n * (2 * dot(n, d));
  if (s.reflection > 0) sum += further(mirrored) * s.reflection;
  if (s.transmission > 0) {
    const float ior = std::max(s.ior, 0.1f);
    Vec3f through;
    const bool passes = classicRefract(d, n, at.frontFace ? 1 / ior : ior, through);
    sum += further(passes ? through : mirrored) * s.transmission;
  }
  return sum;
}

Rgb ClassicTracer::trace(const Ray& ray) const { return follow(ray, 0, ray.origin); }

Rgb classicRadiance(const CompiledScene& scene, const Ray& ray) { return ClassicTracer(scene).trace(ray); }

}  // namespace idap::render
