// Rays through the compiled scene, one by one and side by side.
#include <algorithm>
#include <new>
#include <tuple>

#include "render/accel/embree_ray.h"
#include "render/accel/scene_accel.h"

namespace idap::render {

namespace {

// What a shadow ray has met so far.
struct ShadowRay {
  Rgb transmittance{1, 1, 1};
  float lastT = -1.0f;  // the sheet counted last
  std::uint32_t lastInstance = kNone;
};

// The clear sheets that a look has met so far, in the order of traversal and not only those before its end.
struct SheetsMet {
  struct Sheet {  // not initialized where there is none
    float t;
    std::uint32_t instance;
    float transmittance[3];
  };
  static constexpr int kMost = 8;
  int count = 0;
  Sheet sheets[kMost];
};

// The directions of the rays under way, in world space; single ones or those of lanes.
struct Directions {
  const float *x, *y, *z;
  explicit Directions(const Vec3f& one) : x(&one.x), y(&one.y), z(&one.z) {}
  explicit Directions(const LaneVec& lanes)
      : x(reinterpret_cast<const float*>(&lanes.x)),
        y(reinterpret_cast<const float*>(&lanes.y)),
        z(reinterpret_cast<const float*>(&lanes.z)) {}
  Vec3f operator[](unsigned i) const { return {x[i], y[i], z[i]}; }
};

// What the rays of a kind meet on their way. Nothing is made of those that meet nothing, which most do.
template <class Ray>
struct Way {
  std::uint32_t met = 0;  // a bit a ray
  union {
    Ray rays[kLanes];  // of those that have met something
  };
  Way() {}  // NOLINT: nothing to initialize
  Ray& operator[](unsigned i) {
    if ((met >> i & 1u) == 0) {
      met |= 1u << i;
      new (&rays[i]) Ray;
    }
    return rays[i];
  }
};

// Travels through Embree to the filters; rays are found by their id.
struct TraceContext {
  RTCIntersectContext embree;
  const CompiledScene::Accel* accel;
  Directions directions;
  Way<ShadowRay>* shadows = nullptr;
  Way<SheetsMet>* looks = nullptr;  // null: nearest hits of any kind

  template <class Vec>
  TraceContext(const CompiledScene::Accel& a, const Vec& direction, bool coherent = false)
      : accel(&a), directions(direction) {
    rtcInitIntersectContext(&embree);
    embree.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  }
};

// A ray through the edge between two triangles, or through faces modelled twice, passes one sheet, not two.
bool sameSheet(float t, std::uint32_t instance, float lastT, std::uint32_t lastInstance) {
  return lastInstance == instance && std::fabs(t - lastT) <= 2e-6f * t;
}

Rgb transmittanceAt(const CompiledScene::Accel& accel, const HitInstance& instance,
                    const SurfaceData& surface, const RTCHit& hit, Vec3f direction) {
  Vec2f uv{};
  if (surface.hasMaps && instance.uvs) {
    const auto& c = instance.triangles[instance.triangleOf(hit.geomID, hit.primID)].corners;
    uv = interpolate(instance.uvs[c[0]], instance.uvs[c[1]], instance.uvs[c[2]], hit.u, hit.v);
  }
  Vec3f normal{hit.Ng_x, hit.Ng_y, hit.Ng_z};
  if (!accel.flat) normal = instance.normalToWorld.vector(normal);
  const float l2 = dot(normal, normal);
  const float cosine = l2 > 0 ? std::fabs(dot(normal, direction)) / std::sqrt(l2) : 1.0f;
  return straightTransmittance(surface, valuesAt(surface, uv), std::min(cosine, 1.0f));
}

// True when the hit ends the ray.
bool meets(const CompiledScene::Accel& accel, ShadowRay& ray, Vec3f direction, const RTCHit& hit, float t) {
  const std::uint32_t index = accel.instanceOf(hit.geomID, hit.instID[0]);
  if (sameSheet(t, index, ray.lastT, ray.lastInstance)) return false;
  ray.lastT = t;
  ray.lastInstance = index;
  const HitInstance& instance = accel.instances[index];
  const SurfaceData& surface =
      accel.surfaces[instance.surfaceOf(instance.triangleOf(hit.geomID, hit.primID))];
  ray.transmittance *= transmittanceAt(accel, instance, surface, hit, direction);
  return !(maxComponent(ray.transmittance) > 1e-5f);
}
bool meets(const CompiledScene::Accel& accel, SheetsMet& ray, Vec3f direction, const RTCHit& hit, float t) {
  const std::uint32_t index = accel.instanceOf(hit.geomID, hit.instID[0]);
  const HitInstance& instance = accel.instances[index];
  const SurfaceData& surface =
      accel.surfaces[instance.surfaceOf(instance.triangleOf(hit.geomID, hit.primID))];
  if (!surface.clearSheet || ray.count == SheetsMet::kMost) return true;
  const Rgb through = transmittanceAt(accel, instance, surface, hit, direction);
  ray.sheets[ray.count++] = {t, index, {through.x, through.y, through.z}};
  return false;
}

template <class Ray>
void filter(const RTCFilterFunctionNArguments* args, Way<Ray>& way) {
  const auto& context = *reinterpret_cast<TraceContext*>(args->context);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const RTCHit hit = rtcGetHitFromHitN(args->hit, args->N, i);
    const unsigned id = RTCRayN_id(args->ray, args->N, i);
    const float t = RTCRayN_tfar(args->ray, args->N, i);
    if (!meets(*context.accel, way[id], context.directions[id], hit, t)) args->valid[i] = 0;
  }
}
void shadowFilter(const RTCFilterFunctionNArguments* args) {
  filter(args, *reinterpret_cast<TraceContext*>(args->context)->shadows);
}
void nearestFilter(const RTCFilterFunctionNArguments* args) {
  Way<SheetsMet>* looks = reinterpret_cast<TraceContext*>(args->context)->looks;
  if (looks) filter(args, *looks);
}

// What the sheets before the look's end let by.
Rgb transmittanceOf(SheetsMet& ray, float end) {
  Rgb through{1, 1, 1};
  std::sort(ray.sheets, ray.sheets + ray.count, [](const auto& a, const auto& b) {
    return std::tie(a.t, a.instance) < std::tie(b.t, b.instance);
  });
  for (int i = 0; i < ray.count && ray.sheets[i].t < end; ++i) {
    const SheetsMet::Sheet& sheet = ray.sheets[i];
    if (i > 0 && sameSheet(sheet.t, sheet.instance, ray.sheets[i - 1].t, ray.sheets[i - 1].instance))
      continue;
    through *= Rgb{sheet.transmittance[0], sheet.transmittance[1], sheet.transmittance[2]};
  }
  return through;
}

// Embree's packets of as many rays as there are lanes.
template <int N>
struct Packet;
template <>
struct Packet<4> {
  using RayHit = RTCRayHit4;
  static constexpr auto intersect = rtcIntersect4;
  static constexpr auto occluded = rtcOccluded4;
};
template <>
struct Packet<8> {
  using RayHit = RTCRayHit8;
  static constexpr auto intersect = rtcIntersect8;
  static constexpr auto occluded = rtcOccluded8;
};
template <>
struct Packet<16> {
  using RayHit = RTCRayHit16;
  static constexpr auto intersect = rtcIntersect16;
  static constexpr auto occluded = rtcOccluded16;
};
using RayPacket = Packet<kLanes>;

template <class Rays>
void fill(Rays& r, LaneMask active, const LaneRays& rays, Words masks, int (&valid)[kLanes]) {
  rays.origin.x.copy_to(r.org_x, simd::element_aligned);
  rays.origin.y.copy_to(r.org_y, simd::element_aligned);
  rays.origin.z.copy_to(r.org_z, simd::element_aligned);
  rays.direction.x.copy_to(r.dir_x, simd::element_aligned);
  rays.direction.y.copy_to(r.dir_y, simd::element_aligned);
  rays.direction.z.copy_to(r.dir_z, simd::element_aligned);
  rays.tMin.copy_to(r.tnear, simd::element_aligned);
  rays.tMax.copy_to(r.tfar, simd::element_aligned);
  Floats(0.0f).copy_to(r.time, simd::element_aligned);
  masks.copy_to(r.mask, simd::element_aligned);
  Words(0u).copy_to(r.flags, simd::element_aligned);
  Words([](auto k) { return static_cast<std::uint32_t>(k); }).copy_to(r.id, simd::element_aligned);
  select(active, Ints(-1), Ints(0)).copy_to(valid, simd::element_aligned);
}

void nearest(const CompiledScene::Accel& accel, TraceContext& context, LaneMask active, const LaneRays& rays,
             LaneHits& hits, Words masks) {
  RayPacket::RayHit r;
  alignas(64) int valid[kLanes];
  fill(r.ray, active, rays, masks, valid);
  const Words none(RTC_INVALID_GEOMETRY_ID);
  none.copy_to(r.hit.geomID, simd::element_aligned);
  none.copy_to(r.hit.instID[0], simd::element_aligned);
  RayPacket::intersect(valid, accel.top.get(), &context.embree, &r);
  const Words geometry(r.hit.geomID, simd::element_aligned);
  hits.found = active && toMask(geometry != none);
  hits.lamp = hits.found && toMask(geometry == accel.lampGeometry);
  hits.t = Floats(r.ray.tfar, simd::element_aligned);
  hits.u = Floats(r.hit.u, simd::element_aligned);
  hits.v = Floats(r.hit.v, simd::element_aligned);
  hits.ng = {Floats(r.hit.Ng_x, simd::element_aligned), Floats(r.hit.Ng_y, simd::element_aligned),
             Floats(r.hit.Ng_z, simd::element_aligned)};
  forLanes(hits.found, [&](int k) {
    const std::uint32_t i = hits.instance[k] = accel.instanceOf(r.hit.geomID[k], r.hit.instID[0][k]);
    hits.index[k] = accel.indexOf(i, r.hit.geomID[k], r.hit.primID[k]);
  });
}

Ray rayOf(const LaneRays& rays, int k) {
  return {lane(rays.origin, k), lane(rays.direction, k), lane(rays.tMin, k), lane(rays.tMax, k)};
}

}  // namespace

const SieveFilters kSieveFilters{shadowFilter, nearestFilter};

bool CompiledScene::intersect(const Ray& ray, Hit& hit, std::uint32_t mask, bool coherent) const {
  if (log_) [[unlikely]]
    log_->push_back({ray, mask, false, coherent});
  TraceContext context(*accel_, ray.direction, coherent);
  RTCRayHit r;
  r.ray = embreeRay(ray, mask);
  r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(accel_->top.get(), &context.embree, &r);
  if (r.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
  hit = accel_->hitOf(r.ray.tfar, r.hit);
  return true;
}

Rgb CompiledScene::transmittance(const Ray& ray) const {
  if (log_) [[unlikely]]
    log_->push_back({ray, kSeenByLight, true, false});
  Way<ShadowRay> shadow;
  TraceContext context(*accel_, ray.direction);
  context.shadows = &shadow;
  RTCRay r = embreeRay(ray, kSeenByLight);
  rtcOccluded1(accel_->top.get(), &context.embree, &r);
  if (r.tfar < 0) return {};
  return shadow.met != 0 ? shadow[0].transmittance : Rgb{1, 1, 1};
}

bool CompiledScene::occluded(const Ray& ray) const { return maxComponent(transmittance(ray)) <= 0; }

Interaction CompiledScene::interaction(const Ray& ray, const Hit& hit) const {
  return interactionOn(accel_->instances[hit.instance], accel_->surfaces.data(), ray, hit);
}

void CompiledScene::intersect(LaneMask active, const LaneRays& rays, LaneHits& hits, Words masks) const {
  if (log_) [[unlikely]]
    forLanes(active, [&](int k) {
      log_->push_back({rayOf(rays, k), lane(masks, k), false, (lane(masks, k) & kSeenByCamera) != 0});
    });
  TraceContext context(*accel_, rays.direction);
  nearest(*accel_, context, active, rays, hits, masks);
}

void CompiledScene::look(LaneMask active, const LaneRays& rays, LaneHits& hits, LaneVec& through) const {
  if (log_) [[unlikely]]
    forLanes(active, [&](int k) { log_->push_back({rayOf(rays, k), kSeenByLight, false, false}); });
  Way<SheetsMet> sheets;
  TraceContext context(*accel_, rays.direction);
  context.looks = &sheets;
  nearest(*accel_, context, active, rays, hits, Words(kSeenByLight));
  through = spread<Floats>({1, 1, 1});
  if (sheets.met == 0) return;
  LaneArray3 passed(through);
  for (std::uint32_t bits = sheets.met; bits != 0; bits &= bits - 1) {
    const int k = std::countr_zero(bits);
    passed.set(k, transmittanceOf(sheets[static_cast<unsigned>(k)], lane(hits.t, k)));
  }
  through = passed;
}

LaneVec CompiledScene::transmittance(LaneMask active, const LaneRays& rays) const {
  if (log_) [[unlikely]]
    forLanes(active, [&](int k) { log_->push_back({rayOf(rays, k), kSeenByLight, true, false}); });
  Way<ShadowRay> shadows;
  TraceContext context(*accel_, rays.direction);
  context.shadows = &shadows;
  RayPacket::RayHit r;
  alignas(64) int valid[kLanes];
  fill(r.ray, active, rays, Words(kSeenByLight), valid);
  RayPacket::occluded(valid, accel_->top.get(), &context.embree, &r.ray);
  const LaneMask free = active && Floats(r.ray.tfar, simd::element_aligned) >= 0.0f;
  const LaneVec one = spread<Floats>({1, 1, 1});
  if (shadows.met == 0) return only(free, one);
  LaneArray3 through(one);
  for (std::uint32_t bits = shadows.met; bits != 0; bits &= bits - 1) {
    const int k = std::countr_zero(bits);
    through.set(k, shadows[static_cast<unsigned>(k)].transmittance);
  }
  return only(free, LaneVec(through));
}

void CompiledScene::points(LaneMask active, const LaneRays& rays, const LaneHits& hits,
                           LanePoints& points) const {
  fetchPoints(*accel_, active, rays, hits, points);
}

}  // namespace idap::render
