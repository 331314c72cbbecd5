// Surface points side by side: what interactionOn() does for one.
#include "render/accel/scene_accel.h"
#include "render/lanes/lane_math.h"

namespace idap::render {

namespace {

struct Corners {
  LaneArray3 a, b, c;
  LaneVec interpolated(const Floats& u, const Floats& v) const {
    return LaneVec(a) * (1.0f - u - v) + LaneVec(b) * u + LaneVec(c) * v;
  }
};

struct LaneTransform {
  LaneArray3 x, y, z;
  void set(int k, const Transformf& t) { x.set(k, t.x), y.set(k, t.y), z.set(k, t.z); }
  LaneVec vector(const LaneVec& v) const { return LaneVec(x) * v.x + LaneVec(y) * v.y + LaneVec(z) * v.z; }
};

// What is fetched lane by lane, to be worked on side by side.
struct Fetched {
  Corners positions, normals;
  LaneTransform toWorld, normalToWorld;
  LaneArray3 origin, baseColor;
  LaneArray u, v, translation, smooth, mirrored;
  LaneArray roughness, opacity, metalness, ior, f0, f90, transmission, translucency;
  LaneArray thin, emits, mayPass, mapped;
};

void fetch(Fetched& f, int k, const HitInstance& data, const SurfaceData& surface, const Hit& hit) {
  const auto& c = data.triangles[hit.triangle];
  const Vec3f* positions = data.worldPositions ? data.worldPositions : data.positions;
  f.positions.a.set(k, positions[c[0]]);
  f.positions.b.set(k, positions[c[1]]);
  f.positions.c.set(k, positions[c[2]]);
  f.smooth[k] = data.normals != nullptr;
  if (data.normals) {
    f.normals.a.set(k, data.normals[c[0]]);
    f.normals.b.set(k, data.normals[c[1]]);
    f.normals.c.set(k, data.normals[c[2]]);
  }
  if (!data.worldPositions) {
    f.toWorld.set(k, data.toWorld);
    f.origin.set(k, data.toWorld.origin);
  }
  if (!data.worldPositions || data.normals) f.normalToWorld.set(k, data.normalToWorld);
  f.mirrored[k] = data.mirrored;
  f.translation[k] = data.translation;
  f.u[k] = hit.u, f.v[k] = hit.v;

  SurfaceValues values{surface.baseColor, surface.roughness, surface.opacity};
  if (surface.hasMaps)
    values =
        valuesAt(surface, data.uvs ? interpolate(data.uvs[c[0]], data.uvs[c[1]], data.uvs[c[2]], hit.u, hit.v)
                                   : Vec2f{});
  f.baseColor.set(k, values.baseColor);
  f.roughness[k] = values.roughness, f.opacity[k] = values.opacity;
  f.metalness[k] = surface.metalness, f.ior[k] = surface.ior, f.f0[k] = surface.f0, f.f90[k] = surface.f90;
  f.transmission[k] = surface.transmission, f.translucency[k] = surface.translucency;
  f.thin[k] = surface.thin, f.emits[k] = surface.emits, f.mayPass[k] = surface.mayPass;
  f.mapped[k] = surface.normalMap && data.uvs;
}

}  // namespace

void fetchPoints(const std::vector<HitInstance>& instances, const std::vector<SurfaceData>& surfaces,
                 bool inWorld, LaneMask active, const LaneRays& rays, const LaneHits& hits,
                 LanePoints& points) {
  using namespace lane_math;
  Fetched f;
  if (!every(active)) {
    f = {};  // idle lanes work on zeroes, in a medium that is one
    f.ior = Floats(1.0f);
  }
  forLanes(active, [&](int k) {
    const Hit& hit = hits.hit[k];
    const HitInstance& data = instances[hit.instance];
    points.surface[k] = &surfaces[data.surfaceOf(hit.triangle)];
    points.objectId[k] = data.objectId;
    points.lightGroup[k] = data.lightGroup;
    fetch(f, k, data, *points.surface[k], hit);
  });
  const Floats u = f.u, v = f.v;
  const auto set = [](const LaneArray& a) { return Floats(a) > 0.0f; };

  points.position = f.positions.interpolated(u, v);
  if (!inWorld) points.position = f.toWorld.vector(points.position) + LaneVec(f.origin);
  const LaneVec& p = points.position;
  const Floats size = max(max(abs(p.x), abs(p.y)), abs(p.z));
  points.offset = kOffsetUlps * max(size + Floats(f.translation), 0.1f);

  const LaneVec corner = f.positions.a;
  LaneVec ng = cross(LaneVec(f.positions.b) - corner, LaneVec(f.positions.c) - corner);
  ng = inWorld ? ng * Floats(f.mirrored) : f.normalToWorld.vector(ng);
  const Floats l2 = dot(ng, ng);
  const LaneMask sound = l2 > 1e-36f && l2 < 1e36f;
  ng = select(sound, ng * inverseSqrt(max(l2, 1e-36f)), -rays.direction);
  const LaneMask front = dot(ng, rays.direction) <= 0.0f;
  ng = select(front, ng, -ng);
  LaneVec ns = ng;
  points.smooth = active && set(f.smooth);
  if (any(points.smooth)) {
    const LaneVec n = f.normalToWorld.vector(f.normals.interpolated(u, v));
    const Floats n2 = dot(n, n);
    points.smooth = points.smooth && n2 > 1e-36f && n2 < 1e36f;
    const Floats scale = inverseSqrt(max(n2, 1e-36f));
    ns = select(points.smooth, n * select(front, scale, -scale), ng);
  }
  const LaneMask mapped = active && set(f.mapped);
  if (any(mapped)) {
    LaneArray3 tilted(ns);
    LaneArray tilts(0.0f);
    forLanes(mapped, [&](int k) {
      const Ray ray{lane(rays.origin, k), lane(rays.direction, k)};
      const Interaction at =
          interactionOn(instances[hits.hit[k].instance], surfaces.data(), ray, hits.hit[k]);
      tilted.set(k, at.ns);
      tilts[k] = at.smooth;
    });
    ns = tilted;
    points.smooth = points.smooth || Floats(tilts) > 0.0f;
  }
  if (any(points.smooth)) ns = select(points.smooth && !mapped, bend(ns, ng, -rays.direction), ns);

  points.shading = {ng,   ns,    f.baseColor,    f.roughness,    f.metalness, f.ior,
                    f.f0, f.f90, f.transmission, f.translucency, set(f.thin), front};
  points.opacity = f.opacity;
  points.emits = set(f.emits);
  points.mayPass = set(f.mayPass);
}

}  // namespace idap::render
