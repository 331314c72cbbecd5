// Small scenes for the physics tests. Metres.
#pragma once

#include <memory>

#include "render/accel/compiled_scene.h"
#include "render/scene.h"

namespace idap::render::test {

inline Surface lambert(Rgb reflectance, Rgb emission = {}) {
  Surface s;
  s.baseColor = reflectance;
  s.emission = emission;
  s.ior = 1.0f;
  s.roughness = 1.0f;
  return s;
}
inline Rgb grey(float v) { return {v, v, v}; }

// The parallelogram corner + s*u + t*v, its front along u x v.
inline Mesh parallelogram(Vec3f corner, Vec3f u, Vec3f v) {
  Mesh m;
  m.positions = {corner, corner + u, corner + u + v, corner + v};
  m.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  m.triangles = {{0, 1, 2}, {0, 2, 3}};
  return m;
}

// The box between two corners; slots 0..5 are -x +x -y +y -z +z. Fronts outside, or inside if inward.
inline Mesh boxMesh(Vec3f a, Vec3f b, bool inward = false) {
  Mesh m;
  const Vec3f d = b - a;
  const auto face = [&](Vec3f corner, Vec3f u, Vec3f v) {
    const auto base = static_cast<std::uint32_t>(m.positions.size());
    for (const Vec3f p : {corner, corner + u, corner + u + v, corner + v}) m.positions.push_back(p);
    for (const Vec2f uv : {Vec2f{0, 0}, Vec2f{1, 0}, Vec2f{1, 1}, Vec2f{0, 1}}) m.uvs.push_back(uv);
    const auto slot = static_cast<std::uint32_t>(m.slots.size() / 2);
    for (std::array<std::uint32_t, 3> t :
         {std::array<std::uint32_t, 3>{0, 1, 2}, std::array<std::uint32_t, 3>{0, 2, 3}}) {
      if (inward) std::swap(t[1], t[2]);
      m.triangles.push_back({base + t[0], base + t[1], base + t[2]});
      m.slots.push_back(slot);
    }
  };
  const Vec3f x{d.x, 0, 0}, y{0, d.y, 0}, z{0, 0, d.z};
  face(a, z, y);
  face(a + x, y, z);
  face(a, x, z);
  face(a + y, z, x);
  face(a, y, x);
  face(a + z, x, y);
  return m;
}

// A sphere of triangles with smooth normals, fronts outside.
inline Mesh sphereMesh(Vec3f centre, float radius, int rings = 32) {
  Mesh m;
  const int sectors = 2 * rings;
  const auto pi = static_cast<float>(kPi);
  for (int i = 0; i <= rings; ++i)
    for (int k = 0; k <= sectors; ++k) {
      const float theta = pi * static_cast<float>(i) / static_cast<float>(rings);
      const float phi = 2 * pi * static_cast<float>(k % sectors) / static_cast<float>(sectors);
      const float s = i == 0 || i == rings ? 0.0f : std::sin(theta);
      const Vec3f n{s * std::cos(phi), s * std::sin(phi), std::cos(theta)};
      m.positions.push_back(centre + n * radius);
      m.normals.push_back(n);
    }
  for (int i = 0; i < rings; ++i)
    for (int k = 0; k < sectors; ++k) {
      const auto a = static_cast<std::uint32_t>(i * (sectors + 1) + k);
      const auto b = a + static_cast<std::uint32_t>(sectors) + 1;
      if (i > 0) m.triangles.push_back({a, b, a + 1});
      if (i < rings - 1) m.triangles.push_back({a + 1, b, b + 1});
    }
  return m;
}

class SceneMaker {
 public:
  std::uint32_t surface(const Surface& s) {
    scene_->surfaces.push_back(s);
    return static_cast<std::uint32_t>(scene_->surfaces.size() - 1);
  }
  // One surface for all slots.
  Instance& add(Mesh mesh, const Surface& s, const Transformf& t = {}) {
    return add(std::move(mesh), surface(s), t);
  }
  Instance& add(Mesh mesh, std::uint32_t surfaceIndex, const Transformf& t = {}) {
    std::uint32_t slots = 1;
    for (const std::uint32_t k : mesh.slots) slots = std::max(slots, k + 1);
    return add(std::move(mesh), std::vector<std::uint32_t>(slots, surfaceIndex), t);
  }
  Instance& add(Mesh mesh, std::vector<std::uint32_t> surfaces, const Transformf& t = {}) {
    scene_->meshes.push_back(std::make_shared<Mesh>(std::move(mesh)));
    Instance instance;
    instance.mesh = static_cast<std::uint32_t>(scene_->meshes.size() - 1);
    instance.surfaces = std::move(surfaces);
    instance.transform = t;
    instance.objectId = static_cast<std::uint32_t>(scene_->instances.size() + 1);
    scene_->instances.push_back(std::move(instance));
    return scene_->instances.back();
  }
  Scene& scene() { return *scene_; }
  std::shared_ptr<const Scene> shared() const { return scene_; }
  std::unique_ptr<CompiledScene> compile() const { return std::make_unique<CompiledScene>(scene_); }

 private:
  std::shared_ptr<Scene> scene_ = std::make_shared<Scene>();
};

}  // namespace idap::render::test
