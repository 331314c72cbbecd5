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

// Idle lanes work on zeroes, in a medium that is one.
constexpr SurfaceRow kIdle = [] {
  SurfaceRow row{};
  row.ior = 1;
  return row;
}();

}  // namespace

void fetchPoints(const CompiledScene::Accel& accel, LaneMask active, const LaneRays& rays,
                 const LaneHits& hits, LanePoints& points) {
  using namespace lane_math;
  // What is fetched lane by lane, to be worked on side by side.
  std::array<const SurfaceRow*, kLanes> rows;
  rows.fill(&kIdle);
  Corners normals;
  LaneTransform normalToWorld;
  LaneArray translation(0.0f), mirrored(1.0f), bent(0.0f);
  forLanes(active, [&](int k) {
    const HitInstance& data = accel.instances[hits.instance[k]];
    const HitTriangle& triangle = data.triangles[hits.index[k]];
    const std::uint32_t surface = data.surfaces[triangle.slot()];
    points.surface[k] = &accel.surfaces[surface];
    points.objectId[k] = data.objectId;
    points.lightGroup[k] = data.lightGroup;
    rows[static_cast<std::size_t>(k)] = &accel.surfaceRows[surface];
    translation[k] = data.translation;
    mirrored[k] = data.mirrored;
    if (triangle.bent()) {
      bent[k] = 1;
      normals.a.set(k, data.normals[triangle.corners[0]]);
      normals.b.set(k, data.normals[triangle.corners[1]]);
      normals.c.set(k, data.normals[triangle.corners[2]]);
    }
    if (triangle.bent() || !accel.flat) normalToWorld.set(k, data.normalToWorld);
  });
  SurfaceRowT<Floats> surface = fetchRows(rows);
  const auto set = [](const Floats& flag) { return flag > 0.0f; };

  // Along the ray; off the triangle by no more than the offset allows for.
  points.position = rays.origin + rays.direction * hits.t;
  const LaneVec& p = points.position;
  const Floats size = max(max(abs(p.x), abs(p.y)), abs(p.z));
  points.offset = kOffsetUlps * max(max(size + Floats(translation), hits.t), 0.1f);

  LaneVec ng = accel.flat ? hits.ng * Floats(mirrored) : normalToWorld.vector(hits.ng);
  const Floats l2 = dot(ng, ng);
  const LaneMask sound = active && l2 > 1e-36f && l2 < 1e36f;
  ng = select(sound, ng * inverseSqrt(max(l2, 1e-36f)), -rays.direction);
  const LaneMask front = dot(ng, rays.direction) <= 0.0f;
  ng = select(front, ng, -ng);
  LaneVec ns = ng;
  points.smooth = active && set(bent);
  if (any(points.smooth)) {
    const LaneVec n = normalToWorld.vector(normals.interpolated(hits.u, hits.v));
    const Floats n2 = dot(n, n);
    points.smooth = points.smooth && n2 > 1e-36f && n2 < 1e36f;
    const Floats scale = inverseSqrt(max(n2, 1e-36f));
    ns = select(points.smooth, n * select(front, scale, -scale), ng);
  }
  const LaneMask textured = active && set(surface.hasMaps);
  LaneMask tilted(false);
  if (any(textured)) {
    LaneArray3 baseColor(surface.baseColor), normal(ns);
    LaneArray roughness(surface.roughness), opacity(surface.opacity), tilts(0.0f);
    forLanes(textured, [&](int k) {
      const HitInstance& data = accel.instances[hits.instance[k]];
      const auto& c = data.triangles[hits.index[k]].corners;
      const Vec2f uv = data.uvs ? interpolate(data.uvs[c[0]], data.uvs[c[1]], data.uvs[c[2]], lane(hits.u, k),
                                              lane(hits.v, k))
                                : Vec2f{};
      const SurfaceValues values = valuesAt(*points.surface[k], uv);
      baseColor.set(k, values.baseColor);
      roughness[k] = values.roughness, opacity[k] = values.opacity;
      if (!points.surface[k]->normalMap || !data.uvs) return;
      const Ray ray{lane(rays.origin, k), lane(rays.direction, k)};
      const Interaction at = interactionOn(data, accel.surfaces.data(), ray, hits.hit(k));
      normal.set(k, at.ns);
      tilts[k] = at.smooth;
    });
    surface.baseColor = baseColor;
    surface.roughness = roughness, surface.opacity = opacity;
    ns = normal;
    tilted = set(tilts);
  }
  if (any(points.smooth)) ns = select(points.smooth && !tilted, bend(ns, ng, -rays.direction), ns);
  points.smooth = points.smooth || tilted;

  points.shading = {
      ng,         ns,          surface.baseColor,    surface.roughness,    surface.metalness, surface.ior,
      surface.f0, surface.f90, surface.transmission, surface.translucency, set(surface.thin), front};
  points.opacity = surface.opacity;
  points.emits = active && set(surface.emits);
  points.mayPass = active && set(surface.mayPass);
}

}  // namespace idap::render
