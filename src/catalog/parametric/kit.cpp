#include "catalog/parametric/kit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "catalog/parametric/kit_grid.h"

namespace idap::parametric {

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

Vec3 Builder::stretch(std::size_t firstVertex, std::size_t firstLight, Vec3 min, Vec3 max) {
  Box3f box;
  for (std::size_t i = firstVertex; i < mesh_.positions.size(); ++i) box.add(mesh_.positions[i]);
  if (box.empty()) return {1, 1, 1};
  const Vec3f lo = box.min, extent = box.size(), wanted = toFloat(max - min), to = toFloat(min);
  Vec3f scale{1, 1, 1}, shift{};
  for (int i = 0; i < 3; ++i) {
    if (extent[i] > 1e-6f && wanted[i] > 0) scale[i] = wanted[i] / extent[i];
    shift[i] = to[i] - lo[i] * scale[i];
  }
  const Vec3f inverse{1 / scale.x, 1 / scale.y, 1 / scale.z};
  for (std::size_t i = firstVertex; i < mesh_.positions.size(); ++i) {
    mesh_.positions[i] = mesh_.positions[i] * scale + shift;
    mesh_.normals[i] = normalized(mesh_.normals[i] * inverse);
  }
  for (std::size_t i = firstLight; i < lights_.size(); ++i)
    lights_[i] = lights_[i] * toDouble(scale) + toDouble(shift);
  return toDouble(scale);
}

Builder::Result Builder::finish() {
  Result result;
  result.fit = stretch(0, 0, {left(), front(), 0}, {right(), back(), height()});
  result.mesh = std::move(mesh_);
  result.slots = std::move(slots_);
  result.lights = std::move(lights_);
  return result;
}

}  // namespace idap::parametric
