#include "render/emitter/local_lights.h"

#include <algorithm>
#include <array>
#include <bit>

#include "render/accel/compiled_scene.h"
#include "render/emitter/lamp.h"
#include "render/lanes/lane_rows.h"
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
    rows_.push_back({{.position = lamp.position,
                      .radiance = lamp.intensity,
                      .radius = std::max(lamp.radius, 0.0f),
                      .group = static_cast<float>(lamp.lightGroup)}});
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
    rows_.push_back({{light.corner, light.edge1, light.edge2, light.radiance, light.inverseArea, 0.0f,
                      light.frontOnly ? mirrored : 0.0f, static_cast<float>(light.lightGroup)}});
  }
}

bool LocalLights::sample(const Receiver& at, float choice, Vec2f u, LightSample& s) const {
  LaneMask one(false);
  one[0] = true;
  const LaneReceiver there{toLanes(at.position), toLanes(at.normal), LaneMask(at.bothSides)};
  LightSampleT<Floats> lanes;
  if (!lane(sample(one, there, choice, {u.x, u.y}, lanes), 0)) return false;
  s = {lane(lanes.wi, 0), lane(lanes.distance, 0), lane(lanes.weight, 0), lane(lanes.pdf, 0),
       lane(lanes.lightGroup, 0)};
  return true;
}

LaneMask LocalLights::sample(LaneMask active, const LaneReceiver& at, Floats choice, const LaneVec2& u,
                             LightSampleT<Floats>& s) const {
  using namespace lane_math;
  LightTree::Choice choices[kLanes];
  tree_.choose(active, at, choice, choices);
  static constexpr Row kNoLight{};
  std::array<const Row*, kLanes> rows;
  rows.fill(&kNoLight);
  LaneArray chance(0.0f);
  forLanes(active, [&](int k) {
    if (!(choices[k].probability > 0)) return;
    rows[static_cast<std::size_t>(k)] = &rows_[choices[k].light];
    chance[k] = choices[k].probability;
  });
  const auto c = std::bit_cast<RowT<Floats>>(fetchWords(rows));
  const Floats probability = chance, radius = c.radius;
  const LaneMask isTriangle = c.inverseArea > 0.0f, isSphere = radius > 0.0f;
  LaneMask found = active && probability > 0.0f;
  const LaneVec2 b = uniformTriangle(u);
  const LaneVec to = c.position + c.edge1 * b.x + c.edge2 * b.y - at.position;
  const Floats d2 = dot(to, to), inverse = inverseSqrt(max(d2, 1e-20f));
  found = found && d2 > max(radius * radius, 1e-10f);
  s.distance = d2 * inverse;
  s.wi = to * inverse;
  s.pdf = 0.0f;
  s.weight = c.radiance;
  s.lightGroup = toInt(c.group);
  const LaneMask triangles = found && isTriangle, spheres = found && isSphere;
  if (any(triangles)) {
    Floats cosine = -0.5f * c.inverseArea * dot(cross(c.edge1, c.edge2), s.wi);
    cosine = select(c.front == 0.0f, abs(cosine), c.front * cosine);
    found = found && !(isTriangle && cosine <= 1e-6f);
    s.pdf = select(isTriangle, probability * c.inverseArea * d2 / cosine, s.pdf);
    s.weight = select(isTriangle, s.weight * Floats(1.0f / s.pdf), s.weight);
  }
  if (any(spheres)) {
    const Floats sin2 = min(radius * radius * inverse * inverse, 1.0f);
    const Floats cone = sin2 / (1.0f + sqrt(1.0f - sin2));
    const LaneVec wi = FrameT<Floats>(s.wi).toWorld(uniformCone(u, cone));
    s.wi = select(isSphere, wi, s.wi);
    const Floats along = dot(wi, to);
    const Floats inside = max(radius * radius - max(d2 - along * along, 0.0f), 0.0f);
    s.distance = select(isSphere, max(along - sqrt(inside), 0.0f), s.distance);
    const Floats solidAngle = coneSolidAngle(cone);
    s.pdf = select(isSphere, probability / solidAngle, s.pdf);
    s.weight =
        select(isSphere, s.weight * Floats(solidAngle / (kPiF * radius * radius * probability)), s.weight);
  }
  const LaneMask points = !isTriangle && !isSphere;
  if (any(points)) s.weight = select(points, s.weight * Floats(inverse * inverse / probability), s.weight);
  // Few shine differently to different sides, or have gaps.
  LaneArray factor(1.0f);
  forLanes(found, [&](int k) {
    const std::uint32_t light = choices[k].light;
    if (light >= lampCount_) {
      const Triangle& t = triangles_[light - lampCount_];
      if (t.mayPass) factor[k] = opacityAt(t, {lane(b.x, k), lane(b.y, k)});
    } else {
      factor[k] = lampFallOff(scene_.scene().lamps[light], -lane(s.wi, k));
    }
  });
  s.weight *= Floats(factor);
  return found && maxComponent(s.weight) > 0.0f;
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

Rgb LocalLights::lampRadiance(std::uint32_t index, Vec3f rayDirection) const {
  const Lamp& lamp = scene_.scene().lamps[index];
  return lampIntensity(lamp, -rayDirection) * (1 / (kPiF * lamp.radius * lamp.radius));
}

float LocalLights::pdfTriangle(const Receiver& at, const Ray& ray, const Hit& hit, bool frontFace) const {
  const auto& table = lightOfTriangle_[hit.instance];
  if (table.empty() || table[hit.triangle] == kNone) return 0;
  const std::uint32_t index = table[hit.triangle];
  const Triangle& light = triangles_[index - lampCount_];
  if (light.frontOnly && !frontFace) return 0;
  const float cosine = std::fabs(dot(light.normal, ray.direction));
  if (cosine <= 1e-6f) return 0;
  const Vec3f to = ray.origin + ray.direction * hit.t - at.position;
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
