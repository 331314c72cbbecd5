#include "scene/lamp_builder.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "light/color_temperature.h"
#include "light/photometry.h"
#include "render/emitter/local_lights.h"

namespace idap {

namespace {

constexpr float kBulbRadius = 0.03f;    // m, of an ordinary bulb
constexpr float kLeastRadius = 0.004f;  // m
constexpr double kEscapes = 0.25;       // this share of free directions lets a bulb be seen

using Triangle = std::array<Vec3f, 3>;

std::vector<Triangle> trianglesOf(const Fixture& fixture) {
  std::vector<Triangle> triangles;
  if (!fixture.mesh) return triangles;
  const Mesh& mesh = *fixture.mesh;
  std::vector<Vec3f> points;
  points.reserve(mesh.positions.size());
  const Transformf t = toFloat(fixture.meshToScene);
  for (const Vec3f& p : mesh.positions) points.push_back(t.point(p));
  triangles.reserve(mesh.triangles.size());
  for (const auto& v : mesh.triangles) triangles.push_back({points[v[0]], points[v[1]], points[v[2]]});
  return triangles;
}

// Distance along the ray; 0 for a miss. @cite moller1997
float hit(const Triangle& t, Vec3f origin, Vec3f d) {
  const Vec3f e1 = t[1] - t[0], e2 = t[2] - t[0], p = cross(d, e2);
  const float det = dot(e1, p);
  if (std::fabs(det) < 1e-14f) return 0;
  const float inverse = 1 / det;
  const Vec3f s = origin - t[0];
  const float u = dot(s, p) * inverse;
  if (u < -1e-5f || u > 1.00001f) return 0;
  const Vec3f q = cross(s, e1);
  const float v = dot(d, q) * inverse;
  if (v < -1e-5f || u + v > 1.00001f) return 0;
  const float distance = dot(e2, q) * inverse;
  return distance > 1e-5f ? distance : 0;
}

float distanceTo(const Triangle& t, Vec3f p) {
  const Vec3f ab = t[1] - t[0], ac = t[2] - t[0], n = cross(ab, ac);
  const float nn = dot(n, n);
  if (nn > 0) {
    const Vec3f ap = p - t[0];
    const float v = dot(cross(ap, ac), n) / nn, w = dot(cross(ab, ap), n) / nn;
    if (v >= 0 && w >= 0 && v + w <= 1) return std::fabs(dot(ap, n)) / std::sqrt(nn);
  }
  float nearest = 1e30f;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3f a = t[i], d = t[(i + 1) % 3] - a;
    const float dd = dot(d, d);
    const float s = dd > 0 ? std::clamp(dot(p - a, d) / dd, 0.0f, 1.0f) : 0.0f;
    nearest = std::min(nearest, length(p - a - d * s));
  }
  return nearest;
}

// Evenly spread directions: a Fibonacci spiral on the sphere.
Vec3f direction(int i, int count) {
  const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(std::max(0.0, 1 - z * z));
  const double phi = i * kPi * (3 - std::sqrt(5.0));
  return {float(r * std::cos(phi)), float(r * std::sin(phi)), float(z)};
}

bool letsLightThrough(const render::Surface& s) {
  return s.transmission * (1 - s.metalness) > 0.3f || s.opacity < 0.7f;
}

bool namedLikeAShade(const std::string& name) {
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const char* word :
       {"shade", "cloth", "fabric", "textile", "paper", "linen", "glass", "opal", "diffus"}) {
    if (lower.find(word) != std::string::npos) return true;
  }
  return false;
}

struct Escape {
  double free = 1;             // share of directions that leave the fixture
  std::vector<int> outermost;  // by slot: rays whose last obstacle it is
  std::vector<int> first;      // by slot: rays whose first obstacle it is
};

Escape escapeFrom(Vec3f point, const Fixture& fixture, const std::vector<Triangle>& triangles,
                  const std::vector<const render::Surface*>& slots) {
  Escape escape;
  escape.outermost.assign(slots.size(), 0);
  escape.first.assign(slots.size(), 0);
  if (triangles.empty()) return escape;
  const int rays = triangles.size() > 100'000 ? 32 : triangles.size() > 10'000 ? 64 : 256;
  int free = 0;
  for (int i = 0; i < rays; ++i) {
    const Vec3f d = direction(i, rays);
    float nearest = 1e30f, farthest = 0;
    std::uint32_t firstSlot = 0, lastSlot = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const float at = hit(triangles[t], point, d);
      if (at <= 0) continue;
      const std::uint32_t slot = fixture.mesh->slotOf(t);
      if (slot >= slots.size() || letsLightThrough(*slots[slot])) continue;
      if (at < nearest) nearest = at, firstSlot = slot;
      if (at > farthest) farthest = at, lastSlot = slot;
    }
    if (farthest == 0) {
      ++free;
    } else {
      ++escape.first[firstSlot];
      ++escape.outermost[lastSlot];
    }
  }
  escape.free = double(free) / rays;
  return escape;
}

// Light that comes through a shade takes on half of its tint; its luminance stays.
Rgb tinted(Rgb light, Rgb shade) {
  const Rgb through{light.x * std::sqrt(std::max(shade.x, 0.0f)),
                    light.y * std::sqrt(std::max(shade.y, 0.0f)),
                    light.z * std::sqrt(std::max(shade.z, 0.0f))};
  const float l = luminance(through);
  return l > 1e-3f ? through * (luminance(light) / l) : light;
}

// m2 of each slot that give light off, both sides of open sheets counted.
std::vector<double> shiningAreas(const Fixture& fixture, const std::vector<Triangle>& triangles,
                                 std::size_t slots) {
  std::vector<double> areas(slots, 0.0);
  const std::vector<bool> closed = render::outsideOfClosedShells(*fixture.mesh);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& c = triangles[t];
    const std::uint32_t slot = fixture.mesh->slotOf(t);
    if (slot < slots)
      areas[slot] += double(length(cross(c[1] - c[0], c[2] - c[0]))) / 2 * (closed[t] ? 1 : 2);
  }
  return areas;
}

}  // namespace

Rgb lampColor(const Lamp& lamp, const std::optional<Color>& own) {
  const std::optional<Color>& color = own ? own : lamp.color;
  if (color) {
    const Rgb rgb{srgbToLinear(color->r), srgbToLinear(color->g), srgbToLinear(color->b)};
    const float l = luminance(rgb);
    if (l > 1e-4f) return rgb / l;
  }
  return rgbFromTemperature(lamp.colorTemperature);
}

LampLight lampLight(const Lamp& lamp, const Fixture& fixture,
                    const std::vector<const render::Surface*>& slots, const LampOptions& options) {
  LampLight light;
  if (!(options.lumens > 0)) return light;

  struct Source {
    Vec3 position;  // object space, metres
    double diameter = 0, share = 1;
    std::optional<Color> color;
  };
  std::vector<Source> sources;
  for (const LightSource& s : lamp.sources) {
    sources.push_back({{(s.position.x - 0.5) * fixture.size.x, (s.position.y - 0.5) * fixture.size.y,
                        s.position.z * fixture.size.z},
                       s.diameter,
                       std::max(s.share, 0.0),
                       s.color});
  }
  if (sources.empty()) {
    for (const Vec3& p : fixture.bulbs) sources.push_back({p, 0, 1, {}});
  }
  if (sources.empty()) sources.push_back({{0, 0, fixture.size.z / 2}, 0, 1, {}});
  double shares = 0;
  for (const Source& s : sources) shares += s.share;
  if (!(shares > 0)) {
    for (Source& s : sources) s.share = 1;
    shares = double(sources.size());
  }

  const std::vector<Triangle> triangles = trianglesOf(fixture);
  std::vector<double> areas;
  for (const Source& source : sources) {
    const double lumens = options.lumens * source.share / shares;
    if (!(lumens > 0)) continue;
    const Rgb color = lampColor(lamp, source.color);
    Vec3 position = fixture.pieceToScene.point(source.position);
    const Escape escape = escapeFrom(toFloat(position), fixture, triangles, slots);

    if (escape.free < kEscapes && !triangles.empty()) {
      // The shade shines instead: what is outermost on most ways out.
      int blocked = 0;
      for (const int n : escape.outermost) blocked += n;
      if (areas.empty()) areas = shiningAreas(fixture, triangles, slots.size());
      double area = 0;
      std::vector<std::size_t> shining;
      for (std::size_t slot = 0; slot < slots.size(); ++slot) {
        if (escape.outermost[slot] * 5 >= blocked && areas[slot] > 1e-6) {
          shining.push_back(slot);
          area += areas[slot];
        }
      }
      if (area > 0) {
        light.slotEmission.resize(slots.size());
        const auto brightness = static_cast<float>(surfaceLuminance(lumens, area));
        for (const std::size_t slot : shining) {
          light.slotEmission[slot] += tinted(color, slots[slot]->baseColor) * brightness;
        }
        continue;
      }
    }

    render::Lamp bulb;
    float radius = source.diameter > 0 ? static_cast<float>(source.diameter / 2) : kBulbRadius;
    for (const Triangle& t : triangles) radius = std::min(radius, 0.9f * distanceTo(t, toFloat(position)));
    bulb.radius = std::clamp(radius, kLeastRadius, 0.5f);
    if (options.intoRoom) position = options.intoRoom(position, double(bulb.radius));
    bulb.position = toFloat(position);
    bulb.lightGroup = options.lightGroup;
    if (lamp.beamAngle > 0 && lamp.beamAngle < kPi) {
      bulb.beamAngle = static_cast<float>(lamp.beamAngle);
      bulb.axis = toFloat(normalized(fixture.pieceToScene.vector({0, 0, -1})));
      bulb.intensity = color * static_cast<float>(spotIntensity(lumens, lamp.beamAngle));
    } else {
      bulb.intensity = color * static_cast<float>(isotropicIntensity(lumens));
    }
    light.bulbs.push_back(bulb);
    light.slotTranslucent.resize(slots.size());
    for (std::size_t slot = 0; slot < slots.size(); ++slot) {
      if (escape.first[slot] > 0 && namedLikeAShade(slots[slot]->name)) light.slotTranslucent[slot] = true;
    }
  }
  return light;
}

}  // namespace idap
