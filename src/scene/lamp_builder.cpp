#include "scene/lamp_builder.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <string>

#include "light/color_temperature.h"
#include "light/photometry.h"
#include "scene/fixture_light.h"

namespace idap {

namespace {

constexpr float kBulbRadius = 0.03f;    // m, of an ordinary bulb
constexpr float kLeastRadius = 0.004f;  // m
constexpr double kEscapes = 0.25;       // this share of free directions lets a bulb be seen
constexpr double kOpening = 0.02;       // below this share a shade counts as closed
// Of the light that a shade gives off this share shows where the bulb is near; the rest has been scattered
// about inside and is even.
constexpr double kDirect = 0.6;
constexpr double kGlowStep = 1.05;  // triangles whose luminances differ by less share a surface

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

// Light that comes through a shade takes on half of its tint; its luminance stays.
Rgb tinted(Rgb light, Rgb shade) {
  const Rgb through{light.x * std::sqrt(std::max(shade.x, 0.0f)),
                    light.y * std::sqrt(std::max(shade.y, 0.0f)),
                    light.z * std::sqrt(std::max(shade.z, 0.0f))};
  const float l = luminance(through);
  return l > 1e-3f ? through * (luminance(light) / l) : light;
}

struct Source {
  Vec3 position;  // object space, metres
  double diameter = 0, share = 1;
  std::optional<Color> color;
};

std::vector<Source> sourcesOf(const Lamp& lamp, const Fixture& fixture) {
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
  for (Source& s : sources) s.share = shares > 0 ? s.share / shares : 1 / double(sources.size());
  return sources;
}

// Adds the light of one hidden bulb to what the triangles of its shade give off, lm/m2.
bool shine(const FixtureRays& rays, const FixtureRays::Escape& escape, Vec3f bulb, double lumens,
           const std::function<Rgb(std::size_t)>& colorOf, std::vector<Rgb>& exitance) {
  const std::vector<bool> shade = rays.shadeParts(escape);
  const std::vector<double>& areas = rays.shiningAreas();
  std::vector<std::size_t> shining;
  double area = 0, received = 0;
  for (std::size_t t = 0; t < areas.size(); ++t) {
    if (!shade[rays.parts().partOf[t]]) continue;
    shining.push_back(t);
    area += areas[t];
    received += areas[t] * rays.illuminance(t, bulb);
  }
  if (!(area > 1e-6)) return false;
  exitance.resize(areas.size());
  for (const std::size_t t : shining) {
    const double even = 1 / area;
    const double direct = received > 0 ? rays.illuminance(t, bulb) / received : even;
    exitance[t] += colorOf(t) * static_cast<float>(lumens * (even + kDirect * (direct - even)));
  }
  return true;
}

// Triangles that look the same share a glow, which has their mean luminance: the flux stays what it is.
std::vector<LampLight::Glow> glowsOf(const Mesh& mesh, const std::vector<double>& areas,
                                     const std::vector<Rgb>& exitance) {
  using Key = std::array<int, 4>;  // slot, level, hue
  std::map<Key, std::size_t> known;
  std::vector<LampLight::Glow> glows;
  std::vector<Vec3> flux;
  for (std::size_t t = 0; t < exitance.size(); ++t) {
    const float l = luminance(exitance[t]);
    if (!(l > 0) || !(areas[t] > 0)) continue;
    const auto step = [](float v) {
      return static_cast<int>(std::lround(std::log(std::max(double(v), 1e-6)) / std::log(kGlowStep)));
    };
    const Key key{static_cast<int>(mesh.slotOf(t)), step(l), step(exitance[t].x / l),
                  step(exitance[t].z / l)};
    const auto [at, added] = known.try_emplace(key, glows.size());
    if (added) {
      glows.emplace_back().slot = mesh.slotOf(t);
      flux.emplace_back();
    }
    LampLight::Glow& glow = glows[at->second];
    glow.triangles.push_back(static_cast<std::uint32_t>(t));
    glow.area += areas[t];
    flux[at->second] += toDouble(exitance[t]) * areas[t];
  }
  for (std::size_t i = 0; i < glows.size(); ++i) {
    glows[i].emission = toFloat(flux[i] / (kPi * glows[i].area));
  }
  return glows;
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

  std::optional<FixtureRays> rays;
  if (fixture.mesh && !fixture.mesh->empty()) rays.emplace(*fixture.mesh, fixture.meshToScene);
  std::vector<bool> clear;
  for (const render::Surface* s : slots) clear.push_back(letsLightThrough(*s));

  std::vector<Rgb> exitance;  // lm/m2 by triangle
  for (const Source& source : sourcesOf(lamp, fixture)) {
    double lumens = options.lumens * source.share;
    if (!(lumens > 0)) continue;
    const Rgb color = lampColor(lamp, source.color);
    Vec3 position = fixture.pieceToScene.point(source.position);
    const Vec3f bulbAt = toFloat(position);
    FixtureRays::Escape escape;
    if (rays) escape = rays->escapeFrom(bulbAt, clear);

    if (rays && escape.free < kEscapes) {
      // What is hidden shines through the shade, what is not through its opening.
      const double seen = escape.free < kOpening ? 0 : escape.free / kEscapes;
      const auto colorOf = [&](std::size_t t) {
        return tinted(color, slots[fixture.mesh->slotOf(t)]->baseColor);
      };
      if (shine(*rays, escape, bulbAt, lumens * (1 - seen), colorOf, exitance)) lumens *= seen;
      if (!(lumens > 0)) continue;
    }

    render::Lamp bulb;
    float radius = source.diameter > 0 ? static_cast<float>(source.diameter / 2) : kBulbRadius;
    if (rays) radius = std::min(radius, 0.9f * rays->distanceTo(bulbAt));
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
    for (std::size_t slot = 0; slot < escape.firstSlot.size(); ++slot) {
      if (escape.firstSlot[slot] > 0 && namedLikeAShade(slots[slot]->name))
        light.slotTranslucent[slot] = true;
    }
  }
  if (!exitance.empty()) light.glows = glowsOf(*fixture.mesh, rays->shiningAreas(), exitance);
  return light;
}

}  // namespace idap
