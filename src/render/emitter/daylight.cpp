#include "render/emitter/daylight.h"

#include <algorithm>

#include "render/accel/compiled_scene.h"
#include "render/sampling/frame.h"
#include "render/sampling/spherical_rectangle.h"
#include "render/sampling/warp.h"

namespace idap::render {

namespace {

// Where portals are given, at least this share of sky samples still ignores them: gaps nobody marked let
// light in, too. The smaller they are seen, the likelier the point is out of doors, and the more samples
// ignore them.
constexpr float kLeastMapShare = 0.15f;
constexpr float kFarPortals = 0.02f;  // sr, where half of the others do
template <class F>
F mapShare(F importance) {
  return kLeastMapShare + (1 - kLeastMapShare) * kFarPortals / (kFarPortals + importance);
}
constexpr std::size_t kHeld = 16;  // openings
// A portal seen under less than this (sr) is left to the sky map.
constexpr float kLeastSolidAngle = 1e-5f;

template <class F>
Vec3T<F> directionOf(const Vec2T<F>& point) {
  F sinTheta, cosTheta, sinPhi, cosPhi;
  sinCos(kPiF * point.y, sinTheta, cosTheta);
  sinCos(2 * kPiF * point.x, sinPhi, cosPhi);
  return {sinTheta * cosPhi, sinTheta * sinPhi, cosTheta};
}

template <class F>
Vec2T<F> pointOf(const Vec3T<F>& d) {
  using namespace lane_math;
  const F turn = arcTangent2(d.y, d.x) * (0.5f / kPiF);
  return {clamp(select(turn < 0.0f, turn + 1.0f, turn), 0.0f, kOneMinusEpsilon),
          clamp(F(arcCosine(clamp(d.z, -1.0f, 1.0f)) * (1 / kPiF)), 0.0f, kOneMinusEpsilon)};
}

}  // namespace

Daylight::Daylight(const CompiledScene& scene)
    : sun_(scene.scene().sun), sunGroup_(scene.scene().sunGroup), sky_(scene.scene().sky) {
  if (maxComponent(sun_.illuminance) > 0 && std::isfinite(maxComponent(sun_.illuminance))) {
    hasSun_ = true;
    sun_.direction = normalized(sun_.direction);
    sun_.angularRadius = std::clamp(sun_.angularRadius, 1e-4f, 0.5f);
    const float s = std::sin(0.5f * sun_.angularRadius);
    sunCone_ = 2 * s * s;
    // Illuminance of a disc facing the receiver: pi L sin^2.
    const float sine = std::sin(sun_.angularRadius);
    sunRadiance_ = sun_.illuminance * (1 / (kPiF * sine * sine));
  }
  const int w = sky_.width, h = sky_.height;
  if (w > 0 && h > 0 && sky_.radiance.size() == static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {
    std::vector<float> weights(sky_.radiance.size());
    const auto at = [&](int x, int y) {
      const int column = (x + w) % w, row = std::clamp(y, 0, h - 1);
      return std::max(0.0f, luminance(sky_.radiance[static_cast<std::size_t>(row * w + column)]));
    };
    // The picture is read with interpolation, so a cell shines with its neighbours' light as well.
    for (int y = 0; y < h; ++y) {
      const float theta = (static_cast<float>(y) + 0.5f) / static_cast<float>(h) * kPiF;
      for (int x = 0; x < w; ++x) {
        float sum = 0;
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) sum += at(x + dx, y + dy) * (dx == 0 && dy == 0 ? 8.0f : 1.0f);
        weights[static_cast<std::size_t>(y * w + x)] = sum * std::sin(theta);
      }
    }
    map_ = Distribution2D(weights, w, h);
    hasSky_ = map_.mean() > 0 && std::isfinite(map_.mean());
  }
  for (const Portal& p : scene.scene().portals) {
    Opening o{p.corner, p.edgeU, p.edgeV, {}, cross(p.edgeU, p.edgeV)};
    o.area = length(o.normal);
    if (!(o.area > 1e-6f && std::isfinite(o.area))) continue;
    o.inverseArea = 1 / o.area;
    o.normal = o.normal * o.inverseArea;
    o.centre = p.corner + (p.edgeU + p.edgeV) * 0.5f;
    o.inverseU2 = 1 / dot(p.edgeU, p.edgeU);
    o.inverseV2 = 1 / dot(p.edgeV, p.edgeV);
    // Outdoors is the side from which more of the sky is seen.
    int free[2] = {};
    constexpr int kRays = 64;
    for (int side = 0; side < 2; ++side) {
      const Frame frame(side == 0 ? o.normal : -o.normal);
      for (int i = 0; i < kRays; ++i) {
        const Vec2f u = hammersley(i, kRays);
        const Vec2f where = hammersley((i * 37) % kRays, kRays);
        const Vec3f d = frame.toWorld(cosineHemisphere(u));
        Ray ray{p.corner + p.edgeU * where.x + p.edgeV * where.y, d, 1e-3f};
        if (!scene.occluded(ray)) ++free[side];
      }
    }
    if (free[1] > free[0]) o.normal = -o.normal;
    o.bothSides = std::abs(free[0] - free[1]) < kRays / 8;
    openings_.push_back(o);
  }
}

template <class F>
F Daylight::importance(const Opening& o, const ReceiverT<F>& at) {
  using namespace lane_math;
  const Vec3T<F> to = spread<F>(o.centre) - at.position;
  const F side = dot(to, spread<F>(o.normal));
  Mask<F> seen = side > 0.0f || Mask<F>(o.bothSides);
  const F towards = dot(at.normal, to);
  const F reach =
      towards + 0.5f * (abs(dot(at.normal, spread<F>(o.edgeU))) + abs(dot(at.normal, spread<F>(o.edgeV))));
  seen = seen && (at.bothSides || reach > 0.0f);
  // About the solid angle, and about the cosine at the receiver.
  const F inverse = inverseSqrt(max(dot(to, to), 1e-12f));
  const F solidAngle = o.area * abs(side) * inverse * min(inverse * inverse, 4 * o.inverseArea);
  seen = seen && solidAngle >= kLeastSolidAngle;
  const F cosine = select(at.bothSides, F(1.0f), max(towards * inverse, 0.1f));
  return only(seen, solidAngle * cosine);
}

template <class F>
Mask<F> Daylight::crosses(const Opening& o, const Vec3T<F>& from, const Vec3T<F>& direction) {
  using namespace lane_math;
  const Vec3T<F> normal = spread<F>(o.normal);
  // All times the cosine, for want of a division.
  const F facing = dot(direction, normal), cosine = abs(facing);
  const Vec3T<F> corner = spread<F>(o.corner) - from;
  const F t = copysign(F(1.0f), facing) * dot(corner, normal);
  const Vec3T<F> p = direction * t - corner * cosine;
  const F u = dot(p, spread<F>(o.edgeU)) * o.inverseU2, v = dot(p, spread<F>(o.edgeV)) * o.inverseV2;
  return cosine >= 1e-7f && t > 0.0f && u >= 0.0f && u <= cosine && v >= 0.0f && v <= cosine;
}

template <class F>
Mask<F> Daylight::seesSun(const ReceiverT<F>& at) const {
  return Mask<F>(hasSun_) &&
         (at.bothSides || dot(at.normal, spread<F>(sun_.direction)) > -sun_.angularRadius);
}

template <class F>
Mask<F> Daylight::sampleSun(const ReceiverT<F>& at, const Vec2T<F>& u, LightSampleT<F>& s) const {
  const Mask<F> seen = seesSun(at);
  if (!any(seen)) return seen;
  s.lightGroup = Int<F>(std::int32_t{sunGroup_});
  s.distance = std::numeric_limits<float>::infinity();
  const Frame frame(sun_.direction);
  const Vec3T<F> local = uniformCone(u, sunCone_);
  s.wi = spread<F>(frame.x) * local.x + spread<F>(frame.y) * local.y + spread<F>(frame.z) * local.z;
  s.pdf = 1 / coneSolidAngle(sunCone_);
  s.weight = spread<F>(sunRadiance_ * coneSolidAngle(sunCone_));
  return seen;
}

template <class F>
Mask<F> Daylight::sampleSky(const ReceiverT<F>& at, std::type_identity_t<F> choice, const Vec2T<F>& u,
                            LightSampleT<F>& s) const {
  if (!hasSky_) return Mask<F>(false);
  const SkyChoice<F> made = chooseSky<F>(at, choice, u);
  s.wi = made.wi;
  s.pdf = pdfSky<F>(at, s.wi, made, Mask<F>(true));
  const Mask<F> found = made.found && s.pdf > 0.0f;
  s.lightGroup = 0;
  s.distance = std::numeric_limits<float>::infinity();
  s.weight = only(found, skyRadiance(s.wi) * F(1.0f / s.pdf));
  return found;
}

template <class F>
auto Daylight::chooseSky(const ReceiverT<F>& at, std::type_identity_t<F> choice, const Vec2T<F>& u) const
    -> SkyChoice<F> {
  SkyChoice<F> made;
  F held[kHeld];  // importances, lest they be asked for twice
  F& sum = made.importance;
  for (std::size_t i = 0; i < openings_.size(); ++i) {
    const F w = importance(openings_[i], at);
    if (i < kHeld) held[i] = w;
    sum += w;
  }
  const F byMap = mapShare(sum);
  const Mask<F> throughOpening = sum > 0.0f && choice >= byMap;
  made.found = !throughOpening;
  made.wi = at.normal;
  if (any(throughOpening)) {
    F rest = (choice - byMap) / (1.0f - byMap) * sum;
    Mask<F> open = throughOpening;
    Vec3T<F> corner = at.position, edgeU = spread<F>({1, 0, 0}), edgeV = spread<F>({0, 1, 0});
    for (std::size_t i = 0; i < openings_.size(); ++i) {
      const Opening& o = openings_[i];
      const F w = i < kHeld ? held[i] : importance(o, at);
      const Mask<F> takes = open && w > 0.0f;
      if (!any(takes)) continue;
      made.opening = select(takes, Int<F>(static_cast<std::int32_t>(i)), made.opening);
      corner = select(takes, spread<F>(o.corner), corner);
      edgeU = select(takes, spread<F>(o.edgeU), edgeU);
      edgeV = select(takes, spread<F>(o.edgeV), edgeV);
      open = open && !(takes && rest < w);
      rest = select(takes && open, rest - w, rest);
    }
    const SphericalRectangleT<F> seen(corner, edgeU, edgeV, at.position);
    const Vec3T<F> d = seen.sample(u);
    const F l2 = dot(d, d);
    made.wi = d * inverseSqrt(lane_math::max(l2, 1e-30f));
    made.found = made.found || (seen.solidAngle() >= kLeastSolidAngle * 0.1f && l2 > 1e-30f && l2 < 1e30f);
  }
  if (!every(throughOpening)) {
    const Distribution2D::Sample<F> m = map_.sample(u);
    made.wi = select(throughOpening, made.wi, directionOf(m.point));
  }
  return made;
}

template <class F>
F Daylight::pdfMap(const Vec3T<F>& d) const {
  using namespace lane_math;
  const F sine = sqrt(max(d.x * d.x + d.y * d.y, 1e-12f));
  return map_.pdf(pointOf(d)) / (2 * kPiF * kPiF * sine);
}

template <class F>
F Daylight::mixturePdf(const ReceiverT<F>& at, const Vec3T<F>& d, F sum, Int<F> known) const {
  const F map = pdfMap(d);
  const Mask<F> mixed = sum > 0.0f;
  if (!any(mixed)) return map;
  // Most directions cross one opening, each lane's its own: those are judged together, further ones in turn.
  F through = 0.0f;
  Int<F> last = -1;
  for (Mask<F> more = mixed; any(more);) {
    Mask<F> crossing(false), another(false);
    Vec3T<F> corner = at.position, edgeU = spread<F>({1, 0, 0}), edgeV = spread<F>({0, 1, 0});
    F weight = 0.0f;
    std::int32_t index = -1;
    for (const Opening& o : openings_) {
      ++index;
      const Mask<F> here =
          more && toMask(last < index) && (crosses(o, at.position, d) || toMask(known == index));
      if (!any(here)) continue;
      const Mask<F> first = here && !crossing;
      another = another || (here && crossing);
      crossing = crossing || here;
      if (!any(first)) continue;
      last = select(first, Int<F>(index), last);
      corner = select(first, spread<F>(o.corner), corner);
      edgeU = select(first, spread<F>(o.edgeU), edgeU);
      edgeV = select(first, spread<F>(o.edgeV), edgeV);
      weight = select(first, importance(o, at), weight);
    }
    if (any(crossing)) {
      const F solidAngle = SphericalRectangleT<F>(corner, edgeU, edgeV, at.position).solidAngle();
      through += only(crossing && solidAngle >= kLeastSolidAngle * 0.1f, weight / solidAngle);
    }
    more = another;
  }
  const F byMap = mapShare(sum);
  return select(mixed, byMap * map + (1.0f - byMap) * through / sum, map);
}

template <class F>
F Daylight::pdfSky(const ReceiverT<F>& at, const Vec3T<F>& d) const {
  if (!hasSky_) return F(0.0f);
  F sum = 0.0f;
  for (const Opening& o : openings_) sum += importance(o, at);
  return mixturePdf<F>(at, d, sum, Int<F>(-1));
}

template <class F>
F Daylight::pdfSun(const ReceiverT<F>& at) const {
  return only(seesSun(at), F(1 / coneSolidAngle(sunCone_)));
}

template <class F>
Vec3T<F> Daylight::sunRadiance(const Vec3T<F>& d) const {
  const Vec3T<F> off = d - spread<F>(sun_.direction);
  return only(Mask<F>(hasSun_) && dot(off, off) <= 2 * sunCone_, spread<F>(sunRadiance_));
}

template <class F>
Vec3T<F> Daylight::skyRadiance(const Vec3T<F>& d) const {
  using namespace lane_math;
  if (!hasSky_) return spread<F>({});
  const Vec2T<F> p = pointOf(d);
  const int w = sky_.width, h = sky_.height;
  const F x = p.x * static_cast<float>(w) - 0.5f, y = p.y * static_cast<float>(h) - 0.5f;
  const F fx = floor(x), fy = floor(y);
  const F s = x - fx, t = y - fy;
  const Int<F> ix = toInt(fx), iy = toInt(fy);
  const Int<F> x0 = select(toMask(ix < 0), ix + w, ix), x1 = select(toMask(ix + 1 >= w), Int<F>(0), ix + 1);
  const Int<F> y0 = select(toMask(iy < 0), Int<F>(0), iy),
               y1 = select(toMask(iy + 1 >= h), Int<F>(h - 1), iy + 1);
  static_assert(sizeof(Rgb) == 3 * sizeof(float));
  const float* texels = &sky_.radiance[0].x;
  const auto at = [&](const Int<F>& column, const Int<F>& row) {
    const Int<F> i = (row * w + column) * 3;
    return Vec3T<F>{gather(texels, i), gather(texels, i + 1), gather(texels, i + 2)};
  };
  const F left = 1.0f - s, upper = 1.0f - t;
  return (at(x0, y0) * left + at(x1, y0) * s) * upper + (at(x0, y1) * left + at(x1, y1) * s) * t;
}

// For one receiver and for lanes of them.
#define IDAP_INSTANTIATE(F)                                                                              \
  template Mask<F> Daylight::sampleSun(const ReceiverT<F>&, const Vec2T<F>&, LightSampleT<F>&) const;    \
  template Mask<F> Daylight::sampleSky(const ReceiverT<F>&, F, const Vec2T<F>&, LightSampleT<F>&) const; \
  template Daylight::SkyChoice<F> Daylight::chooseSky(const ReceiverT<F>&, F, const Vec2T<F>&) const;    \
  template F Daylight::mixturePdf(const ReceiverT<F>&, const Vec3T<F>&, F, Int<F>) const;                \
  template Vec3T<F> Daylight::skyRadiance(const Vec3T<F>&) const;                                        \
  template Vec3T<F> Daylight::sunRadiance(const Vec3T<F>&) const;                                        \
  template F Daylight::pdfSky(const ReceiverT<F>&, const Vec3T<F>&) const;                               \
  template F Daylight::pdfSun(const ReceiverT<F>&) const;
IDAP_INSTANTIATE(float)
IDAP_INSTANTIATE(Floats)
#undef IDAP_INSTANTIATE

}  // namespace idap::render
