#include "scene/mesh_sink.h"

namespace idap {

std::uint32_t MeshSink::vertex(const Vertex& v) {
  mesh_.positions.push_back(toFloat(v.position - centre_));
  mesh_.normals.push_back(toFloat(v.normal));
  mesh_.uvs.push_back(toFloat(v.uv));
  return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
}

void MeshSink::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t slot) {
  mesh_.triangles.push_back({a, b, c});
  mesh_.slots.push_back(slot);
}

void MeshSink::quad(const std::array<Vec3, 4>& corners, const std::array<Vec2, 4>& uvs, std::uint32_t slot) {
  Vec3 normal = cross(corners[2] - corners[0], corners[3] - corners[1]);
  const double l = length(normal);
  if (!(l > 1e-12)) return;
  normal = normal / l;
  std::array<std::uint32_t, 4> index{};
  for (std::size_t i = 0; i < 4; ++i) index[i] = vertex({corners[i], normal, uvs[i]});
  const auto area = [&](std::size_t i, std::size_t j, std::size_t k) {
    return length(cross(corners[j] - corners[i], corners[k] - corners[i]));
  };
  if (area(0, 1, 2) > 1e-12) triangle(index[0], index[1], index[2], slot);
  if (area(0, 2, 3) > 1e-12) triangle(index[0], index[2], index[3], slot);
}

void MeshSink::horizontal(const Regions& regions, double z, bool up, std::uint32_t slot) {
  const Triangulation t = triangulate(regions);
  const auto base = static_cast<std::uint32_t>(mesh_.positions.size());
  for (const Vec2& p : t.points) vertex({{p.x, p.y, z}, {0, 0, up ? 1.0 : -1.0}, p});
  for (const auto& v : t.triangles) {
    if (up) {
      triangle(base + v[0], base + v[1], base + v[2], slot);
    } else {
      triangle(base + v[0], base + v[2], base + v[1], slot);
    }
  }
}

void MeshSink::sides(const Regions& regions, double z0, double z1, std::uint32_t slot) {
  const auto ring = [&](const Polygon& points) {
    double s = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 a = points[i], b = points[(i + 1) % points.size()];
      const double next = s + length(b - a);
      quad({Vec3{a.x, a.y, z0}, Vec3{b.x, b.y, z0}, Vec3{b.x, b.y, z1}, Vec3{a.x, a.y, z1}},
           {Vec2{s, z0}, Vec2{next, z0}, Vec2{next, z1}, Vec2{s, z1}}, slot);
      s = next;
    }
  };
  for (const Region& r : regions) {
    ring(r.outer);
    for (const Polygon& hole : r.holes) ring(hole);
  }
}

}  // namespace idap
