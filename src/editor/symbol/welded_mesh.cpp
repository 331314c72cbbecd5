#include "editor/symbol/welded_mesh.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace idap {

namespace {

constexpr std::size_t kMany = 40'000;  // triangles
constexpr float kFine = 2e-5f;         // of the longest side: corners nearer to each other are one
constexpr float kCoarse = 1.0f / 350;  // for meshes of many triangles

}  // namespace

Box3f WeldedMesh::bounds() const {
  Box3f box;
  for (const Vec3f& p : positions) box.add(p);
  return box;
}

WeldedMesh weld(const Mesh& mesh, const Transformf& toEye) {
  WeldedMesh welded;
  std::vector<Vec3f> turned;
  turned.reserve(mesh.positions.size());
  Box3f box;
  for (const Vec3f& p : mesh.positions) {
    turned.push_back(toEye.point(p));
    if (!isFinite(toDouble(turned.back()))) return welded;
    box.add(turned.back());
  }
  if (box.empty()) return welded;
  const Vec3f size = box.size();
  const float longest = std::max({size.x, size.y, size.z, 1e-6f});
  const float cell = longest * (mesh.triangles.size() > kMany ? kCoarse : kFine);

  std::unordered_map<std::uint64_t, std::uint32_t> places;
  places.reserve(turned.size());
  std::vector<std::uint32_t> index(turned.size());
  for (std::size_t i = 0; i < turned.size(); ++i) {
    const Vec3f q = (turned[i] - box.min) / cell;
    const auto part = [](float v) { return std::uint64_t(std::llround(v)) & 0x1fffff; };
    const std::uint64_t key = part(q.x) << 42 | part(q.y) << 21 | part(q.z);
    const auto [at, added] = places.try_emplace(key, std::uint32_t(welded.positions.size()));
    if (added) welded.positions.push_back(turned[i]);
    index[i] = at->second;
  }
  const bool flip = toEye.determinant() < 0;
  welded.triangles.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> corners{index[mesh.triangles[t][0]], index[mesh.triangles[t][1]],
                                         index[mesh.triangles[t][2]]};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    if (flip) std::swap(corners[1], corners[2]);
    const Vec3f a = welded.positions[corners[0]];
    const Vec3f n = cross(welded.positions[corners[1]] - a, welded.positions[corners[2]] - a);
    const float area = length(n);
    if (!(area > 0)) continue;
    welded.triangles.push_back(corners);
    welded.slots.push_back(mesh.slotOf(t));
    welded.normals.push_back(n / area);
  }
  return welded;
}

}  // namespace idap
