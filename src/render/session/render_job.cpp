#include "render/session/render_job.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <chrono>
#include <mutex>
#include <numeric>
#include <optional>
#include <span>

#include "render/film/noise_estimate.h"
#include "render/integrator/camera_ray.h"
#include "render/integrator/classic.h"
#include "render/integrator/path.h"

namespace idap::render {

namespace {

using Clock = std::chrono::steady_clock;
constexpr int kLargeTile = 32, kSmallTile = 16;  // pixels a side; large ones fill the lanes better
constexpr int kFewestTiles = 8;                  // a thread, lest some have nothing to do
constexpr int kUnlimitedLog2Samples = 10;
constexpr int kFirstEstimate = 16;    // samples a pixel; fewer say nothing of the noise
constexpr double kDoneShare = 0.999;  // of the pixels; the last few would take as long as all the others

class Job {
 public:
  Job(const CompiledScene& scene, const Camera& camera, const RenderSettings& settings, Film& film,
      const Progress& progress)
      : scene_(scene),
        settings_(settings),
        film_(film),
        progress_(progress),
        rays_(camera, film.width, film.height),
        tracer_(scene, {.clampIndirect = settings.clampIndirect,
                        .looks = settings.looks,
                        .hideSky = settings.transparentBackground,
                        .cache = settings.perLightGroupLayers ? nullptr : settings.cache.get(),
                        .guide = settings.guide.get()}),
        tile_(tileFor(film)),
        tilesX_((film.width + tile_ - 1) / tile_),
        tilesY_((film.height + tile_ - 1) / tile_),
        log2Samples_(
            settings.spp > 0
                ? std::min(16, static_cast<int>(std::bit_width(static_cast<unsigned>(settings.spp - 1))))
                : kUnlimitedLog2Samples),
        order_(static_cast<std::size_t>(tilesX_ * tilesY_)) {
    // Tiles in an order that leaps across the picture, so that a wave cut short is thin everywhere.
    std::iota(order_.begin(), order_.end(), 0);
    const auto key = [](int tile) { return static_cast<std::uint32_t>(tile) * 0x9e3779b9u; };
    std::ranges::sort(order_, {}, key);
  }

  RenderStats run() {
    if (settings_.integrator == IntegratorKind::Classic) classic_.emplace(scene_);
    start_ = Clock::now();
    // Pixels that are quiet enough stay behind the others.
    const auto began = static_cast<int>(settings_.noise > 0 ? *std::ranges::max_element(film_.weight)
                                                            : *std::ranges::min_element(film_.weight));
    int done = began;
    for (int wave = std::max(began, 1); !stopped() && (settings_.spp == 0 || done < settings_.spp);) {
      if (settings_.noise > 0 && done >= kFirstEstimate && quietEnough()) break;
      int next = done + std::min(wave, kLongestWave);
      if (settings_.spp > 0) next = std::min(next, settings_.spp);
      if (settings_.timeLimitSeconds > 0 && done > began) {
        // Not more than the time left should allow, so that the last wave ends on time.
        const double each = seconds() / (done - began);
        const int possible = static_cast<int>((settings_.timeLimitSeconds - seconds()) / each);
        next = std::min(next, done + std::max(possible, 1));
      }
      runWave(done, next);
      if (!stopped()) wave = next;
      done = next;
    }
    film_.samples = static_cast<int>(*std::ranges::min_element(film_.weight));
    return {seconds(), paths_.load(), traced_.load(), film_.samples};
  }

 private:
  static constexpr int kLongestWave = 64;

  static int tileFor(const Film& film) {
    const std::size_t large = film.pixels() / (kLargeTile * kLargeTile);
    const auto wanted = static_cast<std::size_t>(kFewestTiles * tbb::this_task_arena::max_concurrency());
    return large >= wanted ? kLargeTile : kSmallTile;
  }

  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  bool stopped() const {
    return progress_.cancelled() ||
           (settings_.timeLimitSeconds > 0 && seconds() >= settings_.timeLimitSeconds);
  }

  // Finds the pixels that need more samples. True when hardly any does.
  bool quietEnough() {
    const std::vector<float> noise = noiseEstimate(film_);
    resting_.assign(noise.size(), 0);
    std::size_t loud = 0;
    double wanted = 0, had = 0;
    for (std::size_t i = 0; i < noise.size(); ++i) {
      const float ratio = noise[i] / settings_.noise;
      resting_[i] = ratio <= 1;
      if (ratio > 1) ++loud;
      had += static_cast<double>(film_.weight[i]);
      wanted += static_cast<double>(film_.weight[i] * std::max(1.0f, ratio * ratio));
    }
    expected_ = had / wanted;
    return static_cast<double>(loud) <= (1 - kDoneShare) * static_cast<double>(noise.size());
  }

  void runWave(int from, int to) {
    std::atomic<std::size_t> finished{0};
    tbb::parallel_for(
        std::size_t{0}, order_.size(),
        [&](std::size_t i) {
          if (stopped()) return;
          renderTile(order_[i], to);
          const std::size_t count = ++finished;
          report(from + (to - from) * static_cast<double>(count) / static_cast<double>(order_.size()));
        },
        tbb::simple_partitioner());
  }

  void report(double samples) {
    const double now = seconds();
    const std::unique_lock lock(reportMutex_, std::try_to_lock);
    if (!lock || now - lastReport_ < 0.05) return;
    lastReport_ = now;
    double fraction = settings_.spp > 0 ? samples / settings_.spp : 0.0;
    if (settings_.noise > 0) fraction = std::max(fraction, expected_);
    if (settings_.timeLimitSeconds > 0) fraction = std::max(fraction, now / settings_.timeLimitSeconds);
    progress_.report(std::min(fraction, 1.0), "rendering");
  }

  // One sample to be taken.
  struct Pending {
    std::size_t pixel;
    bool first;   // of its pixel
    bool hasRay;  // some lenses leave pixels out
  };
  struct Batch {
    std::vector<Pending> pending;
    PathStarts starts;  // of those that have rays
    std::vector<PathSample> samples;
    std::vector<Rgb> groups;
  };

  void renderTile(int tile, int to) {
    const int x0 = tile % tilesX_ * tile_, y0 = tile / tilesX_ * tile_;
    // What every pixel had; of those that rest and those beyond the edge, more than it will get.
    std::array<int, kLargeTile * kLargeTile> had;
    int least = to;
    for (int i = 0; i < tile_ * tile_; ++i) {
      const auto [dx, dy] = placeInTile(i);
      const int x = x0 + dx, y = y0 + dy;
      const bool inside = x < film_.width && y < film_.height;
      const std::size_t pixel = inside ? film_.index(x, y) : 0;
      const bool rests = !inside || (!resting_.empty() && resting_[pixel]) ||
                         (!settings_.region.empty() && !settings_.region.has(x, y));
      had[static_cast<std::size_t>(i)] = rests ? to : static_cast<int>(film_.weight[pixel]);
      least = std::min(least, had[static_cast<std::size_t>(i)]);
    }
    Batch batch;
    for (int s = least; s < to; ++s)
      for (int i = 0; i < tile_ * tile_; i += kLanes) {
        const Ints before(&had[static_cast<std::size_t>(i)], simd::element_aligned);
        const LaneMask wanted = toMask(before <= s);
        if (!any(wanted)) continue;
        const auto [dx, dy] = placeInTile(i + laneNumbers());
        begin(batch, wanted, x0 + dx, y0 + dy, s);
        if (batch.pending.size() < PathTracer::kBatch) continue;
        if (stopped()) return;
        take(batch);
      }
    if (!stopped()) take(batch);
  }

  // The tile's pixels by squares of four by four, so that the rays of neighbours are traced together.
  template <class I>
  std::pair<I, I> placeInTile(I i) const {
    const int squaresALine = tile_ / 4, shift = std::countr_zero(static_cast<unsigned>(squaresALine));
    const I square = i >> 4, within = i & 15;
    return {(square & (squaresALine - 1)) * 4 + (within & 3), (square >> shift) * 4 + (within >> 2)};
  }

  // Adds the lanes' pixels' samples of that number to the batch.
  void begin(Batch& batch, LaneMask lanes, const Ints& x, const Ints& y, int sample) {
    PathStart start;
    start.sampler = samplersOf(x, y, static_cast<std::uint32_t>(sample), log2Samples_, settings_.seed);
    const LaneVec2 offset = filterOffset(start.sampler.get2D(), settings_.filter);
    const LaneVec2 point{toFloats(x) + 0.5f + offset.x, toFloats(y) + 0.5f + offset.y};
    LaneVec2 lens{0.5f, 0.5f};
    if (rays_.hasLens()) lens = start.sampler.get2D();
    const LaneMask found = lanes && rays_.at(point, lens, start.origin, start.direction);
    batch.starts.push(found, start);
    forLanes(lanes, [&](int k) {
      batch.pending.push_back({film_.index(lane(x, k), lane(y, k)), sample == 0, lane(found, k)});
    });
  }

  // Follows the batch's paths and adds them to the film.
  void take(Batch& batch) {
    const std::size_t groups = settings_.perLightGroupLayers ? film_.groups.size() : 0;
    batch.samples.resize(batch.starts.size());
    batch.groups.assign(batch.starts.size() * groups, Rgb{});
    if (classic_)
      traceClassic(batch);
    else
      traced_ += tracer_.trace(batch.starts, batch.samples, batch.groups);
    std::size_t i = 0;
    for (const Pending& p : batch.pending) {
      film_.weight[p.pixel] += 1;
      if (!p.hasRay) continue;
      add(batch.samples[i], p, std::span(batch.groups).subspan(i * groups, groups));
      ++i;
    }
    paths_ += batch.starts.size();
    batch.pending.clear();
    batch.starts.clear();
  }

  void add(const PathSample& path, const Pending& p, std::span<const Rgb> groups) {
    // Something not finite would blot out the pixel for ever.
    if (std::isfinite(path.radiance.x + path.radiance.y + path.radiance.z)) {
      film_.color[p.pixel] += path.radiance;
      const float l = luminance(path.radiance);
      film_.square[p.pixel] += l * l;
      for (std::size_t g = 0; g < groups.size(); ++g) film_.groups[g][p.pixel] += groups[g];
    }
    film_.albedo[p.pixel] += path.albedo;
    film_.normal[p.pixel] += path.normal;
    film_.depth[p.pixel] += path.depth;
    if (path.depth > 0) film_.coverage[p.pixel] += 1;
    if (p.first) film_.objectId[p.pixel] = path.objectId;
  }

  void traceClassic(Batch& batch) const {
    auto pending = batch.pending.begin();
    auto sample = batch.samples.begin();
    batch.starts.visit([&](LaneMask lanes, const PathStart& start) {
      forLanes(lanes, [&](int k) {
        while (!pending->hasRay) ++pending;
        *sample++ = classic({lane(start.origin, k), lane(start.direction, k)}, (pending++)->pixel);
      });
    });
  }

  // The surface of 1993, with this integrator's features beside it: looked up once a pixel, since each costs
  // as much as the picture's own first ray.
  PathSample classic(const Ray& ray, std::size_t pixel) const {
    PathSample out;
    out.radiance = classic_->trace(ray);
    Hit hit;
    const float had = film_.weight[pixel];
    if (had > 0) {
      out.albedo = film_.albedo[pixel] * (1 / had);
      out.normal = film_.normal[pixel] * (1 / had);
      out.depth = film_.depth[pixel] / had;
    } else if (scene_.intersect(ray, hit, kSeenByCamera, true)) {
      const Interaction at = scene_.interaction(ray, hit);
      out.albedo = valuesAt(*at.surface, at.uv).baseColor;
      out.normal = at.ns;
      out.depth = hit.t;
      out.objectId = at.objectId;
    }
    return out;
  }

  const CompiledScene& scene_;
  const RenderSettings& settings_;
  Film& film_;
  const Progress& progress_;
  CameraRays rays_;
  PathTracer tracer_;
  std::optional<ClassicTracer> classic_;
  int tile_;
  int tilesX_, tilesY_;
  int log2Samples_;
  std::vector<int> order_;
  std::vector<std::uint8_t> resting_;  // pixels that are done; empty: none
  double expected_ = 0.0;              // the share of the samples that this picture will take
  Clock::time_point start_;
  std::mutex reportMutex_;
  double lastReport_ = 0.0;
  std::atomic<std::uint64_t> paths_{0}, traced_{0};
};

}  // namespace

RenderStats render(const CompiledScene& scene, const Camera& camera, const RenderSettings& settings,
                   Film& film, const Progress& progress) {
  if (film.width != settings.width || film.height != settings.height || film.empty())
    throw RenderError(fmt::format("a film of {} x {} pixels for a picture of {} x {}", film.width,
                                  film.height, settings.width, settings.height));
  tbb::task_arena arena(settings.threads > 0 ? settings.threads : tbb::task_arena::automatic);
  RenderStats stats;
  arena.execute([&] { stats = Job(scene, camera, settings, film, progress).run(); });
  progress.report(1.0, "rendering");
  return stats;
}

}  // namespace idap::render
