#include "render/accel/mesh_accel.h"

#include <algorithm>

namespace idap::render {

namespace {

bool finite(Vec3f p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

// Most triangles of a home are flat however they were modelled; those need no normals of their corners.
bool bent(const Mesh& mesh, const std::array<std::uint32_t, 3>& c) {
  constexpr float kLeast = 2e-4f;  // radians; more than files with few digits are off by
  if (mesh.normals.empty()) return false;
  const Vec3f a = mesh.positions[c[0]];
  const Vec3f own = cross(mesh.positions[c[1]] - a, mesh.positions[c[2]] - a);
  const float l2 = dot(own, own);
  if (!(l2 > 0 && std::isfinite(l2))) return true;
  for (const std::uint32_t corner : c) {
    const Vec3f n = mesh.normals[corner];
    const Vec3f off = n * (1 / length(n)) - own * (1 / std::sqrt(l2));
    if (!(dot(off, off) < kLeast * kLeast)) return true;
  }
  return false;
}

}  // namespace

MeshAccel::MeshAccel(std::shared_ptr<const Mesh> mesh, std::vector<bool> sieve) : mesh_(std::move(mesh)) {
  for (const Vec3f& p : mesh_->positions)
    if (finite(p)) bounds_.add(p);
  const auto& triangles = mesh_->triangles;
  hitTriangles_.reserve(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    hitTriangles_.push_back({triangles[i], (mesh_->slotOf(i) << 1) | (bent(*mesh_, triangles[i]) ? 1u : 0u)});
  const bool anyOpaque = std::ranges::find(sieve, false) != sieve.end(),
             anySieve = std::ranges::find(sieve, true) != sieve.end();
  if (!anySieve) {
    parts_[kOpaqueGeometry] = triangles;
  } else if (!anyOpaque) {
    parts_[kSieveGeometry] = triangles;
  } else {
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      const unsigned part = sieve[mesh_->slotOf(i)] ? kSieveGeometry : kOpaqueGeometry;
      sorted_[part].push_back(triangles[i]);
      maps_[part].push_back(i);
    }
    parts_[0] = sorted_[0];
    parts_[1] = sorted_[1];
  }
}

const Vec3f* MeshAccel::attach(RTCDevice device, RTCScene scene, unsigned part, unsigned id, unsigned mask,
                               const Transformf* transform, const SieveFilters& filters) const {
  if (parts_[part].empty()) return nullptr;
  const Vec3f* world = nullptr;
  const GeometryHandle geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
  const std::size_t count = mesh_->positions.size();
  if (transform) {
    auto* vertices = static_cast<Vec3f*>(rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0,
                                                                 RTC_FORMAT_FLOAT3, sizeof(Vec3f), count));
    world = vertices;
    for (const Vec3f& p : mesh_->positions) *vertices++ = transform->point(p);
  } else {
    const Vec3f* positions = paddedPositions_.empty() ? mesh_->positions.data() : paddedPositions_.data();
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions, 0,
                               sizeof(Vec3f), count);
  }
  rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, parts_[part].data(),
                             0, sizeof(Corners), parts_[part].size());
  rtcSetGeometryMask(geometry.get(), mask);
  if (part == kSieveGeometry) {
    rtcSetGeometryOccludedFilterFunction(geometry.get(), filters.shadow);
    rtcSetGeometryIntersectFilterFunction(geometry.get(), filters.nearest);
  }
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometryByID(scene, geometry.get(), id);
  return world;
}

void MeshAccel::build(RTCDevice device, const SieveFilters& filters) {
  scene_.reset(rtcNewScene(device));
  // Not the spatial splits of RTC_BUILD_QUALITY_HIGH: they would call the filter twice for one triangle.
  rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_MEDIUM);

  // Embree reads 16 bytes at every vertex, so four bytes past the last one must be ours.
  if (mesh_->positions.capacity() == mesh_->positions.size()) {
    paddedPositions_.reserve(mesh_->positions.size() + 1);
    paddedPositions_ = mesh_->positions;
  }
  for (unsigned part = 0; part < 2; ++part) attach(device, scene_.get(), part, part, ~0u, nullptr, filters);
  rtcJoinCommitScene(scene_.get());
}

const Vec3f* MeshAccel::attachTo(RTCDevice device, RTCScene scene, const Transformf& transform,
                                 unsigned firstId, unsigned mask, const SieveFilters& filters) const {
  const Vec3f* world = nullptr;  // either part's, as both are the same
  for (unsigned part = 0; part < 2; ++part)
    if (const Vec3f* vertices = attach(device, scene, part, firstId + part, mask, &transform, filters))
      world = vertices;
  return world;
}

}  // namespace idap::render
