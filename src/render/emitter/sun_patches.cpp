#include "render/emitter/sun_patches.h"

#include <algorithm>
#include <cmath>

#include "geometry/box.h"
#include "render/accel/compiled_scene.h"
#include "render/sampling/frame.h"
#include "render/sampling/warp.h"

namespace idap::render {

namespace {

constexpr int kRays = 4096;
constexpr int kMostSheets = 8;      // panes a sunbeam is followed through
constexpr float kMargin = 0.04f;    // m, around spots, for what lies between them
constexpr float kSmallest = 0.12f;  // m, radius of groups that are not divided further

}  // namespace

SunPatches::SunPatches(const CompiledScene& scene) {
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
  if (!spots.empty()) cluster(spots);
}

// Divides the group in which most light is spread widest until there are enough.
void SunPatches::cluster(std::vector<Spot>& spots) {
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
  while (groups.size() < kMost) {
    const auto widest = std::ranges::max_element(groups, {}, [](const Group& g) {
      return g.radius > kSmallest ? g.flux * g.radius * g.radius : 0.0f;
    });
    if (!(widest->radius > kSmallest)) break;
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
  for (std::size_t k = 0; k < groups.size(); ++k) {
    const Group& g = groups[k];
    Vec3f normal{};
    for (std::size_t i = g.from; i < g.to; ++i) normal = normal + spots[i].normal * (spots[i].flux / g.flux);
    const Vec3f c = g.box.centre();
    x_[k] = c.x, y_[k] = c.y, z_[k] = c.z;
    radius_[k] = g.radius + kMargin;
    flux_[k] = g.flux;
    normalX_[k] = normal.x, normalY_[k] = normal.y, normalZ_[k] = normal.z;
    slack_[k] = std::max(0.0f, 1 - length(normal));
    total_ += g.flux;
  }
}

SunPatchView::SunPatchView(const SunPatches& p, const Receiver& at) {
  const float px = at.position.x, py = at.position.y, pz = at.position.z;
  const float nx = at.normal.x, ny = at.normal.y, nz = at.normal.z;
  const float behind = at.bothSides ? -1.0f : 1.0f;
  for (int k = 0; k < kMost; ++k) {
    const float x = p.x_[k] - px, y = p.y_[k] - py, z = p.z_[k] - pz;
    const float d2 = std::max(x * x + y * y + z * z, 1e-12f);
    const float inverse = 1 / std::sqrt(d2);
    const float sine = p.radius_[k] * inverse;
    x_[k] = x * inverse, y_[k] = y * inverse, z_[k] = z * inverse;
    const float sin2 = std::min(sine * sine, 1.0f);
    oneMinusCos_[k] = std::max(sin2 / (1 + std::sqrt(1 - sin2)), 1e-7f);
    const float cosLight =
        p.slack_[k] + sine - (p.normalX_[k] * x + p.normalY_[k] * y + p.normalZ_[k] * z) * inverse;
    const float r = (nx * x + ny * y + nz * z) * inverse;
    const float cosHere = std::max(r, behind * r) + sine;
    // From within, a patch cannot be aimed at; ordinary bounces find it.
    const float outside = sine < 0.95f ? 1.0f : 0.0f;
    weight_[k] = outside * p.flux_[k] * inverse * inverse * std::min(std::max(cosLight, 0.0f), 1.0f) *
                 std::min(std::max(cosHere, 0.0f), 1.0f);
    density_[k] = weight_[k] / (2 * kPiF * oneMinusCos_[k]);
  }
  for (const float w : weight_) sum_ += w;
}

float SunPatchView::pdf(Vec3f d) const {
  float inside[kMost];
  for (int k = 0; k < kMost; ++k) {
    const float off = 1 - (x_[k] * d.x + y_[k] * d.y + z_[k] * d.z);
    inside[k] = off <= oneMinusCos_[k] ? density_[k] : 0.0f;
  }
  float sum = 0;
  for (const float i : inside) sum += i;
  return sum / sum_;
}

Vec3f SunPatchView::sample(float choice, Vec2f u) const {
  float rest = choice * sum_;
  int chosen = 0;
  for (int k = 0; k < kMost; ++k) {
    if (weight_[k] <= 0) continue;
    chosen = k;
    if (rest < weight_[k]) break;
    rest -= weight_[k];
  }
  // A hair inside the cone, so that pdf() agrees.
  return Frame({x_[chosen], y_[chosen], z_[chosen]}).toWorld(uniformCone(u, oneMinusCos_[chosen] * 0.9999f));
}

}  // namespace idap::render
