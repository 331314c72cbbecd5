#include "render/accel/interaction.h"

#include <algorithm>
#include <cmath>

#include "render/accel/hit_instance.h"

namespace idap::render {

Interaction interactionOn(const HitInstance& data, const SurfaceData* surfaces, const Ray& ray,
                          const Hit& hit) {
  const auto& c = data.triangles[hit.triangle].corners;
  const Vec3f* positions = data.worldPositions ? data.worldPositions : data.positions;
  const Vec3f a = positions[c[0]], b = positions[c[1]], d = positions[c[2]];
  const auto toWorld = [&](Vec3f v) { return data.worldPositions ? v : data.toWorld.vector(v); };

  Interaction s;
  s.surfaceIndex = data.surfaceOf(hit.triangle);
  s.surface = &surfaces[s.surfaceIndex];
  s.objectId = data.objectId;
  s.lightGroup = data.lightGroup;
  s.position = interpolate(a, b, d, hit.u, hit.v);
  if (!data.worldPositions) s.position = data.toWorld.point(s.position);
  const float size = std::max({std::fabs(s.position.x), std::fabs(s.position.y), std::fabs(s.position.z)});
  s.offset = kOffsetUlps * std::max(size + data.translation, 0.1f);

  Vec3f ng = cross(b - a, d - a);
  ng = data.worldPositions ? ng * data.mirrored : data.normalToWorld.vector(ng);
  const float l2 = dot(ng, ng);
  ng = l2 > 0 && std::isfinite(l2) ? ng * (1 / std::sqrt(l2)) : -ray.direction;
  s.frontFace = dot(ng, ray.direction) <= 0;
  s.ng = s.frontFace ? ng : -ng;
  s.ns = s.ng;

  if (s.surface->hasMaps && data.uvs)
    s.uv = interpolate(data.uvs[c[0]], data.uvs[c[1]], data.uvs[c[2]], hit.u, hit.v);
  if (data.normals && data.triangles[hit.triangle].bent()) {
    const Vec3f n = data.normalToWorld.vector(
        interpolate(data.normals[c[0]], data.normals[c[1]], data.normals[c[2]], hit.u, hit.v));
    const float n2 = dot(n, n);
    if (n2 > 0 && std::isfinite(n2)) {
      s.ns = n * ((s.frontFace ? 1.0f : -1.0f) / std::sqrt(n2));
      s.smooth = true;
    }
  }
  if (s.surface->normalMap && data.uvs) {
    const Vec2f u1 = s.surface->mapUv(data.uvs[c[1]]) - s.surface->mapUv(data.uvs[c[0]]);
    const Vec2f u2 = s.surface->mapUv(data.uvs[c[2]]) - s.surface->mapUv(data.uvs[c[0]]);
    const float det = cross(u1, u2);
    const Vec3f e1 = toWorld(b - a), e2 = toWorld(d - a);
    Vec3f tangent = (e1 * u2.y - e2 * u1.y) * (det < 0 ? -1.0f : 1.0f);
    tangent = tangent - s.ns * dot(s.ns, tangent);
    const float t2 = dot(tangent, tangent);
    if (std::fabs(det) > 1e-20f && t2 > 0 && std::isfinite(t2)) {
      tangent = tangent * (1 / std::sqrt(t2));
      Vec3f bitangent = cross(s.ns, tangent);
      const Vec3f up = (e2 * u1.x - e1 * u2.x) * (det < 0 ? -1.0f : 1.0f);
      if (dot(bitangent, up) < 0) bitangent = -bitangent;
      const Rgb m = lookUp(*s.surface->normalMap, s.surface->mapUv(s.uv)).color;
      const Vec3f n =
          tangent * (2 * m.x - 1) + bitangent * (2 * m.y - 1) + s.ns * std::max(2 * m.z - 1, 0.05f);
      s.ns = normalized(n);
      s.smooth = true;
    }
  }
  if (s.smooth) s.ns = bend(s.ns, s.ng, Vec3f(-ray.direction));
  return s;
}

}  // namespace idap::render
