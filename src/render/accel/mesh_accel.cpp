#include "render/accel/mesh_accel.h"

#include <algorithm>

namespace idap::render {

namespace {

bool finite(Vec3f p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

}  // namespace

MeshAccel::MeshAccel(std::shared_ptr<const Mesh> mesh, std::vector<bool> sieve)
    : mesh_(std::move(mesh)), sieve_(std::move(sieve)) {
  for (const Vec3f& p : mesh_->positions)
    if (finite(p)) bounds_.add(p);
}

void MeshAccel::attach(RTCDevice device, unsigned id, const Corners* triangles, std::size_t count,
                       RTCFilterFunctionN filter) {
  if (count == 0) return;
  const Vec3f* positions = paddedPositions_.empty() ? mesh_->positions.data() : paddedPositions_.data();
  GeometryHandle geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
  rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions, 0,
                             sizeof(Vec3f), mesh_->positions.size());
  rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, triangles, 0,
                             sizeof(Corners), count);
  rtcSetGeometryMask(geometry.get(), ~0u);
  if (filter != nullptr) rtcSetGeometryOccludedFilterFunction(geometry.get(), filter);
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometryByID(scene_.get(), geometry.get(), id);
}

void MeshAccel::build(RTCDevice device, RTCFilterFunctionN shadowFilter) {
  scene_.reset(rtcNewScene(device));
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  // Not the spatial splits of RTC_BUILD_QUALITY_HIGH: they would call the filter twice for one triangle.
  rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_MEDIUM);

  // Embree reads 16 bytes at every vertex, so four bytes past the last one must be ours.
  if (mesh_->positions.capacity() == mesh_->positions.size()) {
    paddedPositions_.reserve(mesh_->positions.size() + 1);
    paddedPositions_ = mesh_->positions;
  }

  const auto& triangles = mesh_->triangles;
  if (std::ranges::find(sieve_, true) == sieve_.end()) {
    attach(device, kOpaqueGeometry, triangles.data(), triangles.size(), nullptr);
  } else if (std::ranges::find(sieve_, false) == sieve_.end()) {
    attach(device, kSieveGeometry, triangles.data(), triangles.size(), shadowFilter);
  } else {
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      const unsigned part = sieve_[mesh_->slotOf(i)] ? kSieveGeometry : kOpaqueGeometry;
      parts_[part].push_back(triangles[i]);
      maps_[part].push_back(i);
    }
    attach(device, kOpaqueGeometry, parts_[0].data(), parts_[0].size(), nullptr);
    attach(device, kSieveGeometry, parts_[1].data(), parts_[1].size(), shadowFilter);
  }
  rtcJoinCommitScene(scene_.get());
}

}  // namespace idap::render
