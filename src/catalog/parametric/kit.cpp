#include "catalog/parametric/kit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace idap::parametric {
namespace {

// Triangles without area have no normal and light nothing.
void dropEmptyTriangles(Mesh& part) {
  std::erase_if(part.triangles, [&](const std::array<std::uint32_t, 3>& t) {
    const Vec3f a = part.positions[t[0]], b = part.positions[t[1]], c = part.positions[t[2]];
    return length(cross(b - a, c - a)) < 1e-10f;
  });
}

}  // namespace

double Builder::random(int key) {
  std::uint32_t h = static_cast<std::uint32_t>(key) * 0x9E3779B9u + 0x7F4A7C15u;
  h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
  h = (h ^ (h >> 13)) * 0xC2B2AE35u;
  return (h ^ (h >> 16)) * (1.0 / 4294967296.0);
}

void Builder::slot(const std::string& name) {
  const auto it = std::find(slots_.begin(), slots_.end(), name);
  slot_ = static_cast<std::uint32_t>(it - slots_.begin());
  if (it == slots_.end()) slots_.push_back(name);
}

void Builder::light(Vec3 position) { lights_.push_back(transform_.point(position)); }

void Builder::add(Mesh part, double crease, bool fixedUvs) {
  if (slots_.empty()) slot("body");
  dropEmptyTriangles(part);
  if (part.triangles.empty()) return;
  if (part.normals.empty()) computeSmoothNormals(part, static_cast<float>(crease));
  const int key = parts_++;
  const Vec2f shift{static_cast<float>(3 * random(2 * key)), static_cast<float>(3 * random(2 * key + 1))};
  part.uvs.resize(part.positions.size());
  if (!fixedUvs)
    for (Vec2f& uv : part.uvs) uv += shift;
  part.slots.clear();
  append(mesh_, part, toFloat(transform_), slot_);
  mesh_.slots.resize(mesh_.triangles.size(), slot_);
}

Builder::Result Builder::finish() {
  const Box3f box = mesh_.bounds();
  Result result;
  if (!box.empty()) {
    const Vec3f lo = box.min, extent = box.size();
    const Vec3f wanted = toFloat(size_);
    Vec3f scale{1, 1, 1}, shift{};
    for (int i = 0; i < 3; ++i) {
      const float target = i == 2 ? 0.0f : -wanted[i] / 2;
      if (extent[i] > 1e-6f && wanted[i] > 0) scale[i] = wanted[i] / extent[i];
      shift[i] = target - lo[i] * scale[i];
    }
    const Vec3f inverse{1 / scale.x, 1 / scale.y, 1 / scale.z};
    for (Vec3f& p : mesh_.positions) p = p * scale + shift;
    for (Vec3f& n : mesh_.normals) n = normalized(n * inverse);
    for (Vec3& light : lights_) light = light * toDouble(scale) + toDouble(shift);
    result.fit = toDouble(scale);
  }
  result.mesh = std::move(mesh_);
  result.slots = std::move(slots_);
  result.lights = std::move(lights_);
  return result;
}

}  // namespace idap::parametric
