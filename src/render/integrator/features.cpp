#include "render/integrator/features.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "render/integrator/camera_ray.h"

namespace idap::render {

namespace {

constexpr int kMostSheets = 6;  // panes and mirrors that a look is followed through

std::uint32_t slotOf(const CompiledScene& scene, const Hit& hit) {
  const Scene& s = scene.scene();
  return s.meshes[s.instances[hit.instance].mesh]->slotOf(hit.triangle);
}

void look(const CompiledScene& scene, Ray ray, Features& out, std::size_t i) {
  float travelled = 0;
  for (int sheet = 0; sheet < kMostSheets; ++sheet) {
    Hit hit;
    if (!scene.intersect(ray, hit, sheet == 0 ? kSeenByCamera : kSeenByLight, sheet == 0)) return;
    const Interaction at = scene.interaction(ray, hit);
    const SurfaceValues values = valuesAt(*at.surface, at.uv);
    if (out.distance[i] == 0 && values.opacity > 0.5f) {
      out.distance[i] = travelled + hit.t;
      out.objectId[i] = at.objectId;
      out.slot[i] = static_cast<std::uint8_t>(std::min(slotOf(scene, hit), 255u));
    }
    const bool last = sheet + 1 == kMostSheets;
    const bool pane = at.surface->thin && at.surface->transmission > 0.5f && values.roughness < 0.1f;
    if (!last && (pane || values.opacity < 0.5f)) {
      ray.tMin = hit.t * 1.000002f + 1e-5f;
      continue;
    }
    if (!last && at.surface->metalness > 0.5f && values.roughness < 0.08f) {
      travelled += hit.t;
      const Vec3f d = ray.direction - at.ns * (2 * dot(ray.direction, at.ns));
      ray = {at.originTowards(d), normalized(d)};
      continue;
    }
    out.albedo[i] = at.surface->emits ? Rgb{1, 1, 1} : values.baseColor;
    out.normal[i] = dot(at.ns, ray.direction) > 0 ? -at.ns : at.ns;
    out.depth[i] = travelled + hit.t;
    return;
  }
}

}  // namespace

Features features(const CompiledScene& scene, const Camera& camera, int width, int height, int threads) {
  Features out;
  out.width = width;
  out.height = height;
  const std::size_t n = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  out.albedo.resize(n);
  out.normal.resize(n);
  out.depth.resize(n);
  out.distance.resize(n);
  out.objectId.resize(n);
  out.slot.resize(n);
  const CameraRays rays(camera, width, height);
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<int>(0, height, 4), [&](const tbb::blocked_range<int>& rows) {
      for (int y = rows.begin(); y < rows.end(); ++y)
        for (int x = 0; x < width; ++x)
          if (const auto ray = rays.at({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}))
            look(scene, *ray, out, out.index(x, y));
    });
  });
  return out;
}

}  // namespace idap::render
