#include "scene/box_mapping.h"

#include <cmath>
#include <map>

namespace idap {

Mesh boxMapped(const Mesh& mesh, const std::vector<bool>& slots, Vec3 scale) {
  Mesh result = mesh;
  result.uvs.resize(mesh.positions.size());
  const Vec3f s = toFloat(scale);
  // A vertex is used once for each axis it is projected along.
  std::map<std::pair<std::uint32_t, int>, std::uint32_t> copies;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t slot = mesh.slotOf(t);
    if (slot >= slots.size() || !slots[slot]) continue;
    auto& corners = result.triangles[t];
    const Vec3f a = mesh.positions[corners[0]] * s, b = mesh.positions[corners[1]] * s,
                c = mesh.positions[corners[2]] * s;
    const Vec3f n = cross(b - a, c - a);
    const int axis = std::fabs(n.z) >= std::fabs(n.x) && std::fabs(n.z) >= std::fabs(n.y) ? 2
                     : std::fabs(n.x) > std::fabs(n.y)                                    ? 0
                                                                                          : 1;
    const int key = axis * 2 + (n[axis] < 0 ? 1 : 0);
    for (std::uint32_t& v : corners) {
      const auto [at, added] =
          copies.try_emplace({v, key}, static_cast<std::uint32_t>(result.positions.size()));
      if (added) {
        const Vec3f p = mesh.positions[v] * s;
        const float sign = n[axis] < 0 ? -1.0f : 1.0f;
        // Seen from outside the picture stands upright and is not mirrored.
        const Vec2f uv = axis == 0   ? Vec2f{p.y * sign, p.z}
                         : axis == 1 ? Vec2f{-p.x * sign, p.z}
                                     : Vec2f{p.x, p.y};
        result.positions.push_back(mesh.positions[v]);
        if (!mesh.normals.empty()) result.normals.push_back(mesh.normals[v]);
        result.uvs.push_back(uv);
      }
      v = at->second;
    }
  }
  return result;
}

}  // namespace idap
