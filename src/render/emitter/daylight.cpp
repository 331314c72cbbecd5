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
float mapShare(float importance) {
  return kLeastMapShare + (1 - kLeastMapShare) * kFarPortals / (kFarPortals + importance);
}
// A portal seen under less than this (sr) is left to the sky map.
constexpr float kLeastSolidAngle = 1e-5f;

Vec3f directionOf(Vec2f point) {
  const float theta = kPiF * point.y, phi = 2 * kPiF * point.x;
  const float s = std::sin(theta);
  return {s * std::cos(phi), s * std::sin(phi), std::cos(theta)};
}

Vec2f pointOf(Vec3f d) {
  const float phi = std::atan2(d.y, d.x) * (0.5f / kPiF);
  return {std::clamp(phi < 0 ? phi + 1 : phi, 0.0f, kOneMinusEpsilon),
          std::clamp(std::acos(std::clamp(d.z, -1.0f, 1.0f)) / kPiF, 0.0f, kOneMinusEpsilon)};
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
    o.normal = o.normal * (1 / o.area);
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

float Daylight::importance(const Opening& o, const Receiver& at) {
  const Vec3f to = o.centre - at.position;
  const float side = dot(to, o.normal);
  if (!o.bothSides && side <= 0) return 0;
  if (!at.bothSides) {
    const float reach =
        dot(at.normal, to) + 0.5f * (std::fabs(dot(at.normal, o.edgeU)) + std::fabs(dot(at.normal, o.edgeV)));
    if (reach <= 0) return 0;
  }
  // About the solid angle, and about the cosine at the receiver.
  const float d2 = dot(to, to);
  const float d = std::sqrt(d2);
  const float solidAngle = o.area * std::fabs(side) / (d * std::max(d2, 0.25f * o.area) + 1e-9f);
  if (solidAngle < kLeastSolidAngle) return 0;
  const float cosine = at.bothSides ? 1.0f : std::max(dot(at.normal, to) / d, 0.1f);
  return solidAngle * cosine;
}

bool Daylight::crosses(const Opening& o, Vec3f from, Vec3f direction) {
  const float facing = dot(direction, o.normal);
  if (std::fabs(facing) < 1e-7f) return false;
  const float t = dot(o.corner - from, o.normal) / facing;
  if (t <= 0) return false;
  const Vec3f p = from + direction * t - o.corner;
  const float u = dot(p, o.edgeU) * o.inverseU2, v = dot(p, o.edgeV) * o.inverseV2;
  return u >= 0 && u <= 1 && v >= 0 && v <= 1;
}

bool Daylight::seesSun(const Receiver& at) const {
  return hasSun_ && (at.bothSides || dot(at.normal, sun_.direction) > -sun_.angularRadius);
}

bool Daylight::sampleSun(const Receiver& at, Vec2f u, LightSample& s) const {
  if (!seesSun(at)) return false;
  s.lightGroup = sunGroup_;
  s.distance = std::numeric_limits<float>::infinity();
  s.wi = Frame(sun_.direction).toWorld(uniformCone(u, sunCone_));
  s.pdf = 1 / coneSolidAngle(sunCone_);
  s.weight = sunRadiance_ * coneSolidAngle(sunCone_);
  return true;
}

bool Daylight::sampleSky(const Receiver& at, float choice, Vec2f u, LightSample& s) const {
  if (!hasSky_ || !chooseSky(at, choice, u, s)) return false;
  s.lightGroup = 0;
  s.distance = std::numeric_limits<float>::infinity();
  s.weight = skyRadiance(s.wi) * (1 / s.pdf);
  return true;
}

bool Daylight::chooseSky(const Receiver& at, float choice, Vec2f u, LightSample& s) const {
  float sum = 0;
  for (const Opening& o : openings_) sum += importance(o, at);
  const float byMap = mapShare(sum);
  if (sum > 0 && choice >= byMap) {
    float rest = (choice - byMap) / (1 - byMap) * sum;
    const Opening* chosen = nullptr;
    for (const Opening& o : openings_) {
      const float w = importance(o, at);
      if (w <= 0) continue;
      chosen = &o;
      if (rest < w) break;
      rest -= w;
    }
    const SphericalRectangle seen(chosen->corner, chosen->edgeU, chosen->edgeV, at.position);
    if (seen.solidAngle() < kLeastSolidAngle * 0.1f) return false;
    const Vec3f d = seen.sample(u);
    s.wi = normalized(d);
    if (!std::isfinite(dot(s.wi, s.wi))) return false;
    s.pdf = mixturePdf(at, s.wi, sum, chosen, seen.solidAngle());
    return s.pdf > 0;
  }
  const Distribution2D::Sample m = map_.sample(u);
  s.wi = directionOf(m.point);
  if (openings_.empty() || sum <= 0) {
    const float sine = std::sin(kPiF * m.point.y);
    s.pdf = m.pdf / (2 * kPiF * kPiF * std::max(sine, 1e-6f));
  } else {
    s.pdf = mixturePdf(at, s.wi, sum, nullptr, 0);
  }
  return s.pdf > 0;
}

float Daylight::pdfMap(Vec3f d) const {
  const float sine = std::sqrt(std::max(d.x * d.x + d.y * d.y, 1e-12f));
  return map_.pdf(pointOf(d)) / (2 * kPiF * kPiF * sine);
}

float Daylight::mixturePdf(const Receiver& at, Vec3f d) const {
  float sum = 0;
  for (const Opening& o : openings_) sum += importance(o, at);
  return mixturePdf(at, d, sum, nullptr, 0);
}

float Daylight::mixturePdf(const Receiver& at, Vec3f d, float sum, const Opening* known,
                           float knownAngle) const {
  const float map = pdfMap(d);
  if (!(sum > 0)) return map;
  float through = 0;
  for (const Opening& o : openings_) {
    if (&o != known && !crosses(o, at.position, d)) continue;
    const float w = importance(o, at);
    if (w <= 0) continue;
    const float solidAngle =
        &o == known ? knownAngle : SphericalRectangle(o.corner, o.edgeU, o.edgeV, at.position).solidAngle();
    if (solidAngle >= kLeastSolidAngle * 0.1f) through += w / solidAngle;
  }
  const float byMap = mapShare(sum);
  return byMap * map + (1 - byMap) * through / sum;
}

float Daylight::pdfSky(const Receiver& at, Vec3f d) const { return hasSky_ ? mixturePdf(at, d) : 0.0f; }

float Daylight::pdfSun(const Receiver& at) const { return seesSun(at) ? 1 / coneSolidAngle(sunCone_) : 0.0f; }

Rgb Daylight::sunRadiance(Vec3f d) const {
  if (!hasSun_) return {};
  const Vec3f off = d - sun_.direction;
  return dot(off, off) <= 2 * sunCone_ ? sunRadiance_ : Rgb{};
}

Rgb Daylight::skyRadiance(Vec3f d) const {
  if (!hasSky_) return {};
  const Vec2f p = pointOf(d);
  const int w = sky_.width, h = sky_.height;
  const float x = p.x * static_cast<float>(w) - 0.5f, y = p.y * static_cast<float>(h) - 0.5f;
  const float fx = std::floor(x), fy = std::floor(y);
  const float s = x - fx, t = y - fy;
  const int x0 = (static_cast<int>(fx) + w) % w, x1 = (x0 + 1) % w;
  const int y0 = std::clamp(static_cast<int>(fy), 0, h - 1), y1 = std::min(static_cast<int>(fy) + 1, h - 1);
  const auto at = [&](int column, int row) {
    return sky_.radiance[static_cast<std::size_t>(row * w + column)];
  };
  return (at(x0, y0) * (1 - s) + at(x1, y0) * s) * (1 - t) + (at(x0, y1) * (1 - s) + at(x1, y1) * s) * t;
}

}  // namespace idap::render
