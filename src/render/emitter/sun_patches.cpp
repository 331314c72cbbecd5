#include "render/emitter/sun_patches.h"

#include <algorithm>
#include <cmath>

#include "geometry/box.h"
#include "render/accel/compiled_scene.h"
#include "render/emitter/lamp.h"
#include "render/sampling/frame.h"
#include "render/sampling/warp.h"

namespace idap::render {

namespace {

constexpr int kRays = 4096;
constexpr int kMostSheets = 8;      // panes a sunbeam is followed through
constexpr float kMargin = 0.04f;    // m, around spots, for what lies between them
constexpr float kSmallest = 0.12f;  // m, radius of groups that are not divided further
// The same for the insides of lamps, which are those nearer to a bulb than kInside.
constexpr float kLampMargin = 0.01f, kSmallestOfLamps = 0.03f, kInside = 0.25f;
constexpr int kLampRays = 256;
constexpr std::size_t kMostLamps = 32;  // are looked at; where there are more, light sampling has to do
constexpr float kLeastInside = 0.12f;   // of a bulb's light, for its lamp to be worth looking at
constexpr float kLeastOfAll = 0.05f;    // of all bulbs' light, for looks to be worth their rays
constexpr float kDaylight = 0.5f;  // times what the lamps' insides give off: where it is more, none matters

}  // namespace

SunPatches::SunPatches(const CompiledScene& scene) {
  addSun(scene);
  firstLamp_ = patches_.size();
  addLamps(scene);
}

void SunPatches::addSun(const CompiledScene& scene) {
  const Sun& sun = scene.scene().sun;
  if (!(luminance(sun.illuminance) > 0)) return;
  const Vec3f towards = normalized(sun.direction);
  const auto beamArea = [&](const Portal& p) { return std::fabs(dot(cross(p.edgeU, p.edgeV), towards)); };
  float area = 0;
  for (const Portal& p : scene.scene().portals)
    if (std::isfinite(beamArea(p))) area += beamArea(p);
  if (!(area > 0)) return;

  std::vector<Spot> spots;
  for (const Portal& p : scene.scene().portals) {
    const float beam = beamArea(p);
    if (!(beam > 1e-6f && std::isfinite(beam))) continue;
    const int rays = std::max(16, static_cast<int>(kRays * beam / area));
    for (int i = 0; i < rays; ++i) {
      const Vec2f u = hammersley(i, rays);
      Ray ray{p.corner + p.edgeU * u.x + p.edgeV * u.y, towards, 1e-3f};
      float flux = luminance(scene.transmittance(ray)) * beam / static_cast<float>(rays);
      ray.direction = -towards;
      for (int sheet = 0; flux > 0 && sheet < kMostSheets; ++sheet) {
        Hit hit;
        if (!scene.intersect(ray, hit, kSeenByLight)) break;
        const Interaction at = scene.interaction(ray, hit);
        const SurfaceValues values = valuesAt(*at.surface, at.uv);
        const float cosine = std::min(std::fabs(dot(at.ng, towards)), 1.0f);
        const float through = luminance(straightTransmittance(*at.surface, values, cosine));
        if (through < 0.5f) {
          const bool bothSides = at.surface->translucency > 0;
          spots.push_back({at.position, bothSides ? Vec3f{} : at.ng,
                           flux * (1 - through) * std::max(luminance(values.baseColor), 0.02f)});
          break;
        }
        flux *= through;
        ray.tMin = hit.t * 1.000002f + 1e-6f;
      }
    }
  }
  if (!spots.empty()) cluster(spots, kMost / 2, kSmallest, kMargin);
}

void SunPatches::addLamps(const CompiledScene& scene) {
  const std::vector<Lamp>& lamps = scene.scene().lamps;
  if (lamps.empty() || lamps.size() > kMostLamps) return;
  float daylight = total_;
  const Sky& sky = scene.scene().sky;
  double radiance = 0;
  for (const Rgb c : sky.radiance) radiance += static_cast<double>(luminance(c));
  if (!sky.radiance.empty()) radiance /= static_cast<double>(sky.radiance.size());
  for (const Portal& p : scene.scene().portals)
    daylight += length(cross(p.edgeU, p.edgeV)) * kPiF * static_cast<float>(radiance);
  float most = 0;
  for (const Lamp& lamp : lamps) most += luminance(lampFlux(lamp));
  if (!(daylight < kDaylight * most)) return;

  std::vector<Spot> spots;
  float inside = 0, total = 0;
  for (const Lamp& lamp : lamps) {
    if (!std::isfinite(dot(lamp.position, lamp.position))) continue;
    std::vector<Spot> own;
    float flux = 0, all = 0;
    for (int i = 0; i < kLampRays; ++i) {
      const Vec3f d = uniformCone(hammersley(i, kLampRays), 2.0f);
      const float beam = luminance(lampIntensity(lamp, d)) * (4 * kPiF / kLampRays);
      if (!(beam > 0 && std::isfinite(beam))) continue;
      all += beam;
      Hit hit;
      const Ray ray{lamp.position, d, lamp.radius * 1.01f, kInside};
      if (!scene.intersect(ray, hit, kSeenByLight)) continue;
      const Interaction at = scene.interaction(ray, hit);
      const SurfaceValues values = valuesAt(*at.surface, at.uv);
      const float cosine = std::min(std::fabs(dot(at.ng, d)), 1.0f);
      const float through = luminance(straightTransmittance(*at.surface, values, cosine));
      const float off = beam * (1 - through) * luminance(values.baseColor);
      if (!(off > 0)) continue;
      own.push_back({at.position, at.surface->translucency > 0 ? Vec3f{} : at.ng, off});
      flux += off;
    }
    total += all;
    if (!(flux > kLeastInside * all)) continue;
    spots.insert(spots.end(), own.begin(), own.end());
    inside += flux;
  }
  if (!(inside > kLeastOfAll * total)) return;
  if (!(daylight < kDaylight * inside)) return;
  cluster(spots, kMost / 2, kSmallestOfLamps, kLampMargin);
}

LaneMask SunPatches::nearLamps(const LaneVec& points) const {
  LaneMask near(false);
  for (std::size_t i = firstLamp_; i < patches_.size(); ++i) {
    const LaneVec to = points - spread<Floats>(patches_[i].centre);
    near = near || dot(to, to) <= patches_[i].radius * patches_[i].radius;
  }
  return near;
}

// Divides the group in which most light is spread widest until there are enough.
void SunPatches::cluster(std::vector<Spot>& spots, std::size_t most, float smallest, float margin) {
  struct Group {
    std::size_t from, to;
    Box3f box;
    float flux = 0.0f, radius = 0.0f;
  };
  const auto group = [&](std::size_t from, std::size_t to) {
    Group g{from, to, {}};
    for (std::size_t i = from; i < to; ++i) {
      g.box.add(spots[i].position);
      g.flux += spots[i].flux;
    }
    for (std::size_t i = from; i < to; ++i)
      g.radius = std::max(g.radius, length(spots[i].position - g.box.centre()));
    return g;
  };
  std::vector<Group> groups{group(0, spots.size())};
  while (groups.size() < most) {
    const auto widest = std::ranges::max_element(groups, {}, [&](const Group& g) {
      return g.radius > smallest ? g.flux * g.radius * g.radius : 0.0f;
    });
    if (!(widest->radius > smallest)) break;
    const Group whole = *widest;
    const Vec3f size = whole.box.size(), centre = whole.box.centre();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto begin = spots.begin() + static_cast<std::ptrdiff_t>(whole.from);
    const auto middle = std::partition(begin, spots.begin() + static_cast<std::ptrdiff_t>(whole.to),
                                       [&](const Spot& s) { return s.position[axis] < centre[axis]; });
    const std::size_t cut = whole.from + static_cast<std::size_t>(middle - begin);
    *widest = group(whole.from, cut);
    groups.push_back(group(cut, whole.to));
  }
  for (const Group& g : groups) {
    Vec3f normal{};
    for (std::size_t i = g.from; i < g.to; ++i) normal = normal + spots[i].normal * (spots[i].flux / g.flux);
    patches_.push_back(
        {g.box.centre(), g.radius + margin, g.flux, normal, std::max(0.0f, 1 - length(normal))});
    total_ += g.flux;
  }
}

template <class F>
SunPatchViewT<F>::SunPatchViewT(const SunPatches& p, const ReceiverT<F>& at) {
  using namespace lane_math;
  for (const SunPatches::Patch& patch : p.patches_) {
    const Vec3T<F> to = spread<F>(patch.centre) - at.position;
    const F inverse = inverseSqrt(max(dot(to, to), 1e-12f));
    const F sine = patch.radius * inverse;
    const Vec3T<F> d = to * inverse;
    const F sin2 = sine * sine;
    const F cosLight = patch.slack + sine - dot(spread<F>(patch.normal), d);
    const F r = dot(at.normal, d);
    const F cosHere = select(at.bothSides, abs(r), r) + sine;
    // From within, a patch cannot be aimed at; ordinary bounces find it.
    const F weight = only(sine < 0.95f, patch.flux * inverse * inverse * clamp(cosLight, 0.0f, 1.0f) *
                                            clamp(cosHere, 0.0f, 1.0f));
    if (!any(weight > 0.0f)) continue;
    const int k = count_++;
    weight_[k] = weight;
    direction_[k] = d;
    // About 1 - sqrt(1 - sin2); any cone will do, as long as samples and densities agree on it.
    oneMinusCos_[k] = max(0.5f * sin2 * (1.0f + 0.25f * sin2 * (1.0f + sin2)), 1e-7f);
    sum_ += weight;
  }
}

template <class F>
F SunPatchViewT<F>::pdf(const Vec3T<F>& d) const {
  F sum = 0.0f;
  for (int k = 0; k < count_; ++k) {
    const Mask<F> inside = 1.0f - dot(direction_[k], d) <= oneMinusCos_[k];
    if (any(inside)) sum += only(inside, weight_[k] / oneMinusCos_[k]);
  }
  return select(sum_ > 0.0f, sum / (2 * kPiF * sum_), F(0.0f));
}

template <class F>
Vec3T<F> SunPatchViewT<F>::sample(F choice, const Vec2T<F>& u) const {
  F rest = choice * sum_;
  Mask<F> open(true);
  Vec3T<F> direction = spread<F>({0, 0, 1});
  F oneMinusCos = 1e-7f;
  for (int k = 0; k < count_; ++k) {
    const Mask<F> takes = open && weight_[k] > 0.0f;
    direction = select(takes, direction_[k], direction);
    oneMinusCos = select(takes, oneMinusCos_[k], oneMinusCos);
    open = open && !(takes && rest < weight_[k]);
    rest = select(takes && open, rest - weight_[k], rest);
  }
  // A hair inside the cone, so that pdf() agrees.
  return FrameT<F>(direction).toWorld(uniformCone(u, F(oneMinusCos * 0.9999f)));
}

template class SunPatchViewT<float>;
template class SunPatchViewT<Floats>;

}  // namespace idap::render
