#include "render/emitter/local_lights.h"

#include <algorithm>

#include "render/accel/compiled_scene.h"
#include "render/emitter/lamp.h"
#include "render/sampling/frame.h"
#include "render/sampling/warp.h"

namespace idap::render {

namespace {

// 1 - cos of the half angle under which a sphere is seen from a distance (squared) outside it.
float sphereCone(float radius, float distance2) {
  const float sin2 = radius * radius / distance2;
  return sin2 / (1 + std::sqrt(std::max(0.0f, 1 - sin2)));
}

}  // namespace

LocalLights::LocalLights(const CompiledScene& scene)
    : scene_(scene),
      lampCount_(scene.scene().lamps.size()),
      lightOfTriangle_(scene.scene().instances.size()) {
  std::vector<LightBounds> bounds;
  bool any = false;
  for (const Lamp& lamp : scene.scene().lamps) {
    LightBounds b;
    const Vec3f r{lamp.radius, lamp.radius, lamp.radius};
    b.box.add(lamp.position - r);
    b.box.add(lamp.position + r);
    b.intensity = std::max(luminance(lamp.intensity), 0.0f);
    if (!std::isfinite(b.intensity)) b.intensity = 0;
    if (lamp.lambertian || lamp.beamAngle > 0)
      b.axis = lamp.axis;
    else
      b.cosSpread = -1;
    any = any || b.intensity > 0;
    bounds.push_back(b);
  }
  for (std::uint32_t i = 0; i < scene.scene().instances.size(); ++i) addTriangles(scene, i, bounds);
  if (any || !triangles_.empty()) tree_ = LightTree(bounds);
}

void LocalLights::addTriangles(const CompiledScene& scene, std::uint32_t i,
                               std::vector<LightBounds>& bounds) {
  const Instance& instance = scene.scene().instances[i];
  if (std::ranges::none_of(instance.surfaces, [&](std::uint32_t s) { return scene.surface(s).emits; }))
    return;
  const Mesh& mesh = *scene.scene().meshes[instance.mesh];
  const Transformf t = scene.transform(i);
  const float mirrored = t.determinant() < 0 ? -1.0f : 1.0f;
  const std::vector<bool> closed = outsideOfClosedShells(mesh);
  auto& table = lightOfTriangle_[i];
  table.assign(mesh.triangles.size(), kNone);
  for (std::uint32_t k = 0; k < mesh.triangles.size(); ++k) {
    const std::uint32_t surfaceIndex = instance.surfaces[mesh.slotOf(k)];
    const SurfaceData& surface = scene.surface(surfaceIndex);
    if (!surface.emits) continue;
    const auto& c = mesh.triangles[k];
    Triangle light;
    light.corner = t.point(mesh.positions[c[0]]);
    light.edge1 = t.point(mesh.positions[c[1]]) - light.corner;
    light.edge2 = t.point(mesh.positions[c[2]]) - light.corner;
    const Vec3f n = cross(light.edge1, light.edge2);
    const float twiceArea = length(n);
    if (!(twiceArea > 1e-12f && std::isfinite(twiceArea))) continue;
    light.normal = n * (mirrored / twiceArea);
    light.inverseArea = 2 / twiceArea;
    light.radiance = surface.emission;
    light.instance = i;
    light.triangle = k;
    light.surface = surfaceIndex;
    light.mayPass = surface.mayPass;
    light.lightGroup = instance.lightGroup;
    light.frontOnly = closed[k];
    LightBounds b;
    b.box.add(light.corner);
    b.box.add(light.corner + light.edge1);
    b.box.add(light.corner + light.edge2);
    b.axis = light.normal;
    b.intensity = luminance(light.radiance) * 0.5f * twiceArea;
    b.bothSides = !light.frontOnly;
    if (!(b.intensity > 0)) continue;
    table[k] = static_cast<std::uint32_t>(bounds.size());
    bounds.push_back(b);
    triangles_.push_back(light);
  }
}

bool LocalLights::sample(const Receiver& at, float choice, Vec2f u, LightSample& s) const {
  const LightTree::Choice chosen = tree_.choose(at, choice);
  if (!(chosen.probability > 0)) return false;
  if (chosen.light < lampCount_) {
    if (!sampleLamp(at, chosen.light, u, s)) return false;
    s.weight *= 1 / chosen.probability;
    s.pdf *= chosen.probability;
    return true;
  }
  const Triangle& light = triangles_[chosen.light - lampCount_];
  const Vec2f b = uniformTriangle(u);
  const Vec3f to = light.corner + light.edge1 * b.x + light.edge2 * b.y - at.position;
  const float d2 = dot(to, to);
  if (!(d2 > 1e-10f)) return false;
  s.distance = std::sqrt(d2);
  s.wi = to * (1 / s.distance);
  float cosine = -dot(light.normal, s.wi);
  if (!light.frontOnly) cosine = std::fabs(cosine);
  if (cosine <= 1e-6f) return false;
  s.pdf = chosen.probability * light.inverseArea * d2 / cosine;
  s.weight = light.radiance * (1 / s.pdf);
  s.lightGroup = light.lightGroup;
  if (light.mayPass) s.weight *= opacityAt(light, b);
  return true;
}

float LocalLights::opacityAt(const Triangle& light, Vec2f b) const {
  const Mesh& mesh = *scene_.scene().meshes[scene_.scene().instances[light.instance].mesh];
  Vec2f uv{};
  if (!mesh.uvs.empty()) {
    const auto& c = mesh.triangles[light.triangle];
    uv = mesh.uvs[c[0]] * (1 - b.x - b.y) + mesh.uvs[c[1]] * b.x + mesh.uvs[c[2]] * b.y;
  }
  return valuesAt(scene_.surface(light.surface), uv).opacity;
}

bool LocalLights::sampleLamp(const Receiver& at, std::uint32_t index, Vec2f u, LightSample& s) const {
  const Lamp& lamp = scene_.scene().lamps[index];
  const Vec3f to = lamp.position - at.position;
  const float d2 = dot(to, to);
  s.lightGroup = lamp.lightGroup;
  if (lamp.radius > 0) {
    if (d2 <= lamp.radius * lamp.radius) return false;
    const float cone = sphereCone(lamp.radius, d2);
    const Frame frame(to * (1 / std::sqrt(d2)));
    s.wi = frame.toWorld(uniformCone(u, cone));
    const float along = dot(s.wi, to);
    const float inside = std::max(0.0f, lamp.radius * lamp.radius - std::max(0.0f, d2 - along * along));
    s.distance = std::max(along - std::sqrt(inside), 0.0f);
    s.pdf = 1 / coneSolidAngle(cone);
    s.weight = lampRadiance(index, s.wi) * coneSolidAngle(cone);
  } else {
    if (!(d2 > 1e-10f)) return false;
    s.distance = std::sqrt(d2);
    s.wi = to * (1 / s.distance);
    s.pdf = 0;
    s.weight = lampIntensity(lamp, -s.wi) * (1 / d2);
  }
  return maxComponent(s.weight) > 0;
}

Rgb LocalLights::lampRadiance(std::uint32_t index, Vec3f rayDirection) const {
  const Lamp& lamp = scene_.scene().lamps[index];
  return lampIntensity(lamp, -rayDirection) * (1 / (kPiF * lamp.radius * lamp.radius));
}

float LocalLights::pdfTriangle(const Receiver& at, const Ray& ray, const Hit& hit,
                               const Interaction& on) const {
  const auto& table = lightOfTriangle_[hit.instance];
  if (table.empty() || table[hit.triangle] == kNone) return 0;
  const std::uint32_t index = table[hit.triangle];
  const Triangle& light = triangles_[index - lampCount_];
  if (light.frontOnly && !on.frontFace) return 0;
  const float cosine = std::fabs(dot(light.normal, ray.direction));
  if (cosine <= 1e-6f) return 0;
  const Vec3f to = on.position - at.position;
  return tree_.probability(at, index) * light.inverseArea * dot(to, to) / cosine;
}

float LocalLights::pdfLamp(const Receiver& at, std::uint32_t index) const {
  const Lamp& lamp = scene_.scene().lamps[index];
  const Vec3f to = lamp.position - at.position;
  const float d2 = dot(to, to);
  if (d2 <= lamp.radius * lamp.radius) return 0;
  return tree_.probability(at, index) / coneSolidAngle(sphereCone(lamp.radius, d2));
}

}  // namespace idap::render
