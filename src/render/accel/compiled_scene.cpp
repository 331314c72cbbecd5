#include "render/accel/compiled_scene.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>

#include "base/error.h"
#include "render/accel/scene_accel.h"
#include "render/emitter/lights.h"
#include "render/material/albedo_table.h"

namespace idap::render {

namespace {

// With their vertices and BVH about 0.2 GB.
constexpr std::uint64_t kMostInOneLevel = 1'500'000;

bool usable(const Transformf& t) {
  const float d = t.determinant();
  return std::isfinite(d) && d != 0.0f && std::isfinite(dot(t.origin, t.origin));
}

bool keepTrackOfMemory(void* counter, ssize_t bytes, bool) {
  static_cast<std::atomic<std::int64_t>*>(counter)->fetch_add(bytes, std::memory_order_relaxed);
  return true;
}

}  // namespace

void CompiledScene::Accel::place(std::uint32_t i, const Transformf& t) {
  HitInstance& data = instances[i];
  data.toWorld = t;
  data.normalToWorld = t.cofactor();
  data.mirrored = t.determinant() < 0 ? -1.0f : 1.0f;
  auto& n = data.normalToWorld;
  n.x = n.x * data.mirrored, n.y = n.y * data.mirrored, n.z = n.z * data.mirrored;
  data.translation = std::max({std::fabs(t.origin.x), std::fabs(t.origin.y), std::fabs(t.origin.z)});
  if (!geometries[i]) return;
  RTCGeometry geometry = geometries[i].get();
  if (usable(t)) {
    const float columns[12] = {t.x.x, t.x.y, t.x.z, t.y.x,      t.y.y,      t.y.z,
                               t.z.x, t.z.y, t.z.z, t.origin.x, t.origin.y, t.origin.z};
    rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
    rtcEnableGeometry(geometry);
  } else {
    rtcDisableGeometry(geometry);
  }
  rtcCommitGeometry(geometry);
}

CompiledScene::CompiledScene(std::shared_ptr<const Scene> scene, int threads, const CompiledScene* previous,
                             BvhLevels levels)
    : scene_(std::move(scene)), accel_(std::make_unique<Accel>()) {
  const auto start = std::chrono::steady_clock::now();
  Accel& a = *accel_;
  AlbedoTable::get();
  if (previous) {
    a.device = previous->accel_->device;
  } else {
    a.device = std::make_shared<Accel::Device>();
    a.device->handle.reset(rtcNewDevice("start_threads=0,set_affinity=0"));
    if (!a.device->handle) throw RenderError("the ray tracing library Embree could not be started");
    rtcSetDeviceMemoryMonitorFunction(a.device->handle.get(), keepTrackOfMemory, &a.device->bytes);
  }

  a.surfaces.reserve(scene_->surfaces.size());
  for (const Surface& s : scene_->surfaces) a.surfaces.push_back(compileSurface(s));
  for (const SurfaceData& s : a.surfaces) a.surfaceRows.push_back(surfaceRow(s));

  // One BVH for every mesh and every pattern of slots that light can get through.
  std::vector<std::uint32_t> slotCount(scene_->meshes.size(), 0);
  for (std::size_t m = 0; m < scene_->meshes.size(); ++m) {
    const Mesh& mesh = *scene_->meshes[m];
    if (previous) {
      const auto known = previous->accel_->slotCounts.find(&mesh);
      if (known != previous->accel_->slotCounts.end()) {
        slotCount[m] = a.slotCounts[&mesh] = known->second;
        continue;
      }
    }
    for (const auto& t : mesh.triangles)
      for (const std::uint32_t c : t)
        if (c >= mesh.positions.size()) throw RenderError(fmt::format("mesh {}: no vertex {}", m, c));
    if ((!mesh.slots.empty() && mesh.slots.size() != mesh.triangles.size()) ||
        (!mesh.normals.empty() && mesh.normals.size() != mesh.positions.size()) ||
        (!mesh.uvs.empty() && mesh.uvs.size() != mesh.positions.size()))
      throw RenderError(fmt::format("mesh {}: slots, normals or uvs of the wrong number", m));
    slotCount[m] = mesh.slots.empty() ? 1 : *std::ranges::max_element(mesh.slots) + 1;
    if (!mesh.empty()) a.slotCounts[&mesh] = slotCount[m];
  }
  std::map<Accel::MeshKey, std::uint32_t> known;
  std::vector<bool> meshUsed(scene_->meshes.size(), false);
  for (std::size_t i = 0; i < scene_->instances.size(); ++i) {
    const Instance& instance = scene_->instances[i];
    if (instance.mesh >= scene_->meshes.size())
      throw RenderError(fmt::format("instance {}: no mesh {}", i, instance.mesh));
    const auto& mesh = scene_->meshes[instance.mesh];
    if (mesh->empty()) {
      a.meshOfInstance.push_back(kNone);
      continue;
    }
    if (instance.surfaces.size() < slotCount[instance.mesh])
      throw RenderError(fmt::format("instance {}: {} surfaces for {} material slots", i,
                                    instance.surfaces.size(), slotCount[instance.mesh]));
    std::vector<bool> sieve(slotCount[instance.mesh]);
    for (std::size_t s = 0; s < instance.surfaces.size(); ++s) {
      if (instance.surfaces[s] >= a.surfaces.size())
        throw RenderError(fmt::format("instance {}: no surface {}", i, instance.surfaces[s]));
      if (s < sieve.size()) sieve[s] = !a.surfaces[instance.surfaces[s]].opaqueToShadows;
    }
    const Accel::MeshKey key{mesh.get(), sieve};
    const auto [it, isNew] = known.try_emplace(key, static_cast<std::uint32_t>(a.meshes.size()));
    if (isNew) {
      std::shared_ptr<MeshAccel> accel;
      if (previous) {
        const auto old = previous->accel_->meshByKey.find(key);
        if (old != previous->accel_->meshByKey.end()) accel = old->second;
      }
      if (!accel) accel = std::make_shared<MeshAccel>(mesh, sieve);
      a.meshByKey[key] = accel;
      a.meshes.push_back(std::move(accel));
    }
    a.meshOfInstance.push_back(it->second);
    stats_.instancedTriangles += mesh->triangles.size();
    if (!meshUsed[instance.mesh]) stats_.uniqueTriangles += mesh->triangles.size();
    meshUsed[instance.mesh] = true;
  }

  a.flat = levels == BvhLevels::One && stats_.instancedTriangles <= kMostInOneLevel;
  const auto buildAll = [&] {
    const RTCDevice device = a.device->handle.get();
    if (!a.flat)
      tbb::parallel_for(std::size_t{0}, a.meshes.size(), [&](std::size_t m) {
        if (a.meshes[m]->scene()) return;
        tbb::this_task_arena::isolate([&] { a.meshes[m]->build(device, kSieveFilters); });
      });

    a.top.reset(rtcNewScene(device));
    // Not RTC_SCENE_FLAG_ROBUST: a tenth slower, for one ray in a million that slips between two triangles.
    if (!a.flat) rtcSetSceneFlags(a.top.get(), RTC_SCENE_FLAG_DYNAMIC);
    Box3f world;
    for (std::uint32_t i = 0; i < scene_->instances.size(); ++i) {
      const Instance& instance = scene_->instances[i];
      HitInstance& data = a.instances.emplace_back();
      GeometryHandle& geometry = a.geometries.emplace_back();
      const std::uint32_t m = a.meshOfInstance[i];
      if (m != kNone) {
        const MeshAccel& accel = *a.meshes[m];
        const Mesh& mesh = accel.mesh();
        data.positions = mesh.positions.data();
        data.normals = mesh.normals.empty() ? nullptr : mesh.normals.data();
        data.uvs = mesh.uvs.empty() ? nullptr : mesh.uvs.data();
        data.triangles = accel.hitTriangles();
        data.surfaces = instance.surfaces.data();
        data.triangleMap[0] = accel.triangleMap(0);
        data.triangleMap[1] = accel.triangleMap(1);
        data.objectId = instance.objectId;
        data.lightGroup = instance.lightGroup;
        const unsigned mask = kSeenByLight | (instance.visibleToCamera ? kSeenByCamera : 0u);
        if (a.flat) {
          a.inOneLevel[i] = usable(instance.transform);
          if (a.inOneLevel[i])
            data.worldPositions =
                accel.attachTo(device, a.top.get(), instance.transform, 2 * i, mask, kSieveFilters);
        } else {
          geometry.reset(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE));
          rtcSetGeometryInstancedScene(geometry.get(), accel.scene());
          rtcSetGeometryTimeStepCount(geometry.get(), 1);
          rtcSetGeometryMask(geometry.get(), mask);
        }
        if (usable(instance.transform)) {
          const Box3f& b = accel.bounds();
          for (int corner = 0; corner < 8 && !b.empty(); ++corner)
            world.add(
                instance.transform.point({corner & 1 ? b.max.x : b.min.x, corner & 2 ? b.max.y : b.min.y,
                                          corner & 4 ? b.max.z : b.min.z}));
        }
      }
      a.place(i, instance.transform);
      if (geometry) rtcAttachGeometryByID(a.top.get(), geometry.get(), i);
    }

    for (std::uint32_t l = 0; l < scene_->lamps.size(); ++l)
      if (scene_->lamps[l].radius > 0) a.sphereLamps.push_back(l);
    if (!a.sphereLamps.empty()) {
      GeometryHandle spheres(rtcNewGeometry(a.device->handle.get(), RTC_GEOMETRY_TYPE_SPHERE_POINT));
      auto* buffer = static_cast<float*>(rtcSetNewGeometryBuffer(
          spheres.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 16, a.sphereLamps.size()));
      for (const std::uint32_t l : a.sphereLamps) {
        const Lamp& lamp = scene_->lamps[l];
        *buffer++ = lamp.position.x, *buffer++ = lamp.position.y, *buffer++ = lamp.position.z;
        *buffer++ = lamp.radius;
      }
      rtcSetGeometryMask(spheres.get(), kLampSpheres);
      rtcCommitGeometry(spheres.get());
      a.lampGeometry = static_cast<unsigned>(2 * scene_->instances.size());
      rtcAttachGeometryByID(a.top.get(), spheres.get(), a.lampGeometry);
    }
    rtcJoinCommitScene(a.top.get());

    for (const Lamp& lamp : scene_->lamps)
      if (std::isfinite(dot(lamp.position, lamp.position))) world.add(lamp.position);
    if (!world.empty()) {
      centre_ = world.centre();
      radius_ = std::max(0.5f * length(world.size()), 1e-3f);
    }
  };
  a.instances.reserve(scene_->instances.size());
  a.inOneLevel.resize(scene_->instances.size());
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute(buildAll);

  lights_ = std::make_unique<Lights>(*this);
  stats_.embreeBytes = static_cast<std::uint64_t>(std::max<std::int64_t>(0, a.device->bytes.load()));
  stats_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

CompiledScene::~CompiledScene() = default;

const SurfaceData& CompiledScene::surface(std::uint32_t index) const { return accel_->surfaces[index]; }
std::size_t CompiledScene::surfaceCount() const { return accel_->surfaces.size(); }
Transformf CompiledScene::transform(std::uint32_t i) const { return accel_->instances[i].toWorld; }
std::uint32_t CompiledScene::surfaceOfSlot(std::uint32_t i, std::uint32_t slot) const {
  return accel_->instances[i].surfaces[slot];
}

RTCSceneTy* CompiledScene::embreeScene() const { return accel_->top.get(); }

void CompiledScene::setVisibleToCamera(std::uint32_t instance, bool visible) {
  if (instance >= accel_->instances.size()) throw RenderError(fmt::format("no instance {}", instance));
  const unsigned mask = kSeenByLight | (visible ? kSeenByCamera : 0u);
  const auto set = [&](RTCGeometry geometry) {
    if (!geometry) return;
    rtcSetGeometryMask(geometry, mask);
    rtcCommitGeometry(geometry);
  };
  if (!accel_->flat) return set(accel_->geometries[instance].get());
  for (const unsigned part : {kOpaqueGeometry, kSieveGeometry})
    if (accel_->hasPart(instance, part)) set(rtcGetGeometry(accel_->top.get(), 2 * instance + part));
}

void CompiledScene::setFilters(bool on) {
  for (std::uint32_t i = 0; i < accel_->instances.size(); ++i) {
    if (!accel_->flat || !accel_->hasPart(i, kSieveGeometry)) continue;
    RTCGeometry geometry = rtcGetGeometry(accel_->top.get(), 2 * i + kSieveGeometry);
    rtcSetGeometryOccludedFilterFunction(geometry, on ? kSieveFilters.shadow : nullptr);
    rtcSetGeometryIntersectFilterFunction(geometry, on ? kSieveFilters.nearest : nullptr);
    rtcCommitGeometry(geometry);
  }
  rtcJoinCommitScene(accel_->top.get());
}

void CompiledScene::commit() { rtcJoinCommitScene(accel_->top.get()); }

}  // namespace idap::render
