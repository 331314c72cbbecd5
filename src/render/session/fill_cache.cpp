#include "render/session/fill_cache.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "base/error.h"
#include "render/integrator/camera_ray.h"
#include "render/integrator/path.h"

namespace idap::render {

namespace {

constexpr int kChunk = 512;  // paths
constexpr int kFewestForGuide = 16384, kMostForGuide = 65536;
constexpr int kEighths[] = {1, 1, 2, 4};  // of the paths, pass by pass
constexpr int kAllAtOnce[] = {8};

// Each pass uses what those before have found.
std::shared_ptr<const LightCache> learn(const CompiledScene& scene, std::span<const Camera> cameras,
                                        const RenderSettings& settings, int paths,
                                        std::span<const int> eighths, const Progress& progress) {
  if (settings.integrator != IntegratorKind::Path || paths < 8 || cameras.empty()) return nullptr;
  std::vector<CameraRays> rays;
  for (const Camera& camera : cameras) rays.emplace_back(camera, settings.width, settings.height);
  std::shared_ptr<const LightCache> cache;
  std::vector<CacheRecord> records;
  tbb::task_arena arena(settings.threads > 0 ? settings.threads : tbb::task_arena::automatic);
  std::uint64_t pass = 0;
  for (const int part : eighths) {
    const int count = paths / 8 * part;
    const int chunks = (count + kChunk - 1) / kChunk;
    std::vector<std::vector<CacheRecord>> parts(static_cast<std::size_t>(chunks));
    const PathTracer tracer(scene, {.clampIndirect = settings.clampIndirect, .cache = cache.get()});
    const std::uint64_t seed = settings.seed * 4 + pass++ + 0x63616368u;
    arena.execute([&] {
      tbb::parallel_for(0, chunks, [&](int chunk) {
        if (progress.cancelled()) return;
        PathStarts starts;
        for (int i = chunk * kChunk; i < std::min(count, (chunk + 1) * kChunk); ++i) {
          Sampler sampler(i & 0xffff, i >> 16, 0, 0, seed);
          const Vec2f u = sampler.get2D();
          const auto ray = rays[static_cast<std::size_t>(i) % rays.size()].at(
              {u.x * static_cast<float>(settings.width), u.y * static_cast<float>(settings.height)});
          if (ray) add(starts, *ray, sampler);
        }
        tracer.learn(starts, parts[static_cast<std::size_t>(chunk)]);
      });
    });
    if (progress.cancelled()) throw Cancelled();
    for (const auto& found : parts) records.insert(records.end(), found.begin(), found.end());
    cache = std::make_shared<const LightCache>(records);
  }
  return cache->empty() ? nullptr : cache;
}

}  // namespace

std::shared_ptr<const LightCache> fillCache(const CompiledScene& scene, const Camera& camera,
                                            const RenderSettings& settings, int paths,
                                            const Progress& progress) {
  return fillCache(scene, std::span(&camera, 1), settings, paths, progress);
}

std::shared_ptr<const LightCache> fillCache(const CompiledScene& scene, std::span<const Camera> cameras,
                                            const RenderSettings& settings, int paths,
                                            const Progress& progress) {
  return learn(scene, cameras, settings, paths, kEighths, progress);
}

std::shared_ptr<const LightCache> fillGuide(const CompiledScene& scene, const Camera& camera,
                                            const RenderSettings& settings, const Progress& progress) {
  const std::int64_t pixels = std::int64_t{settings.width} * settings.height;
  const auto paths = std::clamp<std::int64_t>(pixels / 4, kFewestForGuide, kMostForGuide);
  return learn(scene, std::span(&camera, 1), settings, static_cast<int>(paths), kAllAtOnce, progress);
}

}  // namespace idap::render
