// Small homes for the scene builder's tests, and a way to shoot rays through what it built.
#pragma once

#include <cmath>
#include <limits>

#include "catalog/catalog.h"
#include "scene/scene_builder.h"
#include "support/wall_chain.h"

namespace idap::test {

inline const Catalog& noLibraries() {
  static const Catalog catalog(std::vector<std::filesystem::path>{});
  return catalog;
}

inline RoomId addRoom(Home& home, Polygon points, LevelId level = {}) {
  Room room;
  room.points = std::move(points);
  room.level = level;
  const RoomId id = home.newId<RoomId>();
  home.rooms.set(id, room);
  return id;
}

// A room of 4 m x 3 m between walls 0.2 m thick; its inner faces lie at 0.1 m from the walls' lines.
inline Home closedRoom() {
  Home home;
  addWalls(home, {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  addRoom(home, {{0.1, 0.1}, {3.9, 0.1}, {3.9, 2.9}, {0.1, 2.9}});
  return home;
}

inline Opening bareOpening(Vec3 position, double width, double height, double angle = 0) {
  Opening o;
  o.kind = OpeningKind::Bare;
  o.position = position;
  o.size = {width, 0.3, height};
  o.angle = angle;
  return o;
}

struct RayHit {
  double distance = std::numeric_limits<double>::infinity();
  std::size_t instance = 0;
  std::uint32_t slot = 0;
  bool found() const { return std::isfinite(distance); }
};

// The nearest triangle along a ray given in world space; brute force. @cite moller1997
inline RayHit shoot(const BuiltScene& built, Vec3 origin, Vec3 direction) {
  RayHit nearest;
  const Vec3 o = origin - built.centre;
  for (std::size_t i = 0; i < built.scene->instances.size(); ++i) {
    const render::Instance& instance = built.scene->instances[i];
    const Mesh& mesh = *built.scene->meshes[instance.mesh];
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& v = mesh.triangles[t];
      const Vec3 a = toDouble(instance.transform.point(mesh.positions[v[0]]));
      const Vec3 e1 = toDouble(instance.transform.point(mesh.positions[v[1]])) - a;
      const Vec3 e2 = toDouble(instance.transform.point(mesh.positions[v[2]])) - a;
      const Vec3 p = cross(direction, e2);
      const double det = dot(e1, p);
      if (std::abs(det) < 1e-14) continue;
      const Vec3 s = o - a;
      const double u = dot(s, p) / det;
      const Vec3 q = cross(s, e1);
      const double w = dot(direction, q) / det;
      if (u < -1e-9 || w < -1e-9 || u + w > 1 + 1e-9) continue;
      const double distance = dot(e2, q) / det;
      if (distance > 1e-9 && distance < nearest.distance) nearest = {distance, i, mesh.slotOf(t)};
    }
  }
  return nearest;
}

inline Vec3 fibonacci(int i, int count) {
  const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(std::max(0.0, 1 - z * z));
  const double phi = i * kPi * (3 - std::sqrt(5.0));
  return {r * std::cos(phi), r * std::sin(phi), z};
}

// How many of the rays from a point get out to the sky or fall on the land (the only instance of no element).
inline int escaping(const BuiltScene& built, Vec3 from, int count) {
  int out = 0;
  for (int i = 0; i < count; ++i) {
    const RayHit hit = shoot(built, from, fibonacci(i, count));
    if (!hit.found() || std::holds_alternative<std::monostate>(
                            built.objects[built.scene->instances[hit.instance].objectId])) {
      ++out;
    }
  }
  return out;
}

// m3 inside a closed mesh.
inline double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    sum += dot(toDouble(mesh.positions[t[0]]),
               cross(toDouble(mesh.positions[t[1]]), toDouble(mesh.positions[t[2]]))) /
           6;
  }
  return sum;
}

}  // namespace idap::test
