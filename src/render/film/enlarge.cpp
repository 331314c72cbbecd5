#include "render/film/enlarge.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

namespace idap::render {

namespace {

constexpr float kLeastAlbedo = 0.02f;  // darker than this, light is not told from reflectance

struct Lit {
  Rgb light;  // radiance over reflectance
  Rgb color;
  Vec3f normal;
  float depth = 0;
};

Rgb over(Rgb color, Rgb albedo) {
  return {color.x / std::max(albedo.x, kLeastAlbedo), color.y / std::max(albedo.y, kLeastAlbedo),
          color.z / std::max(albedo.z, kLeastAlbedo)};
}

}  // namespace

std::vector<Rgb> enlarged(const Film& film, const std::vector<Rgb>& color, const Features& f, int threads) {
  std::vector<Lit> lit(film.pixels());
  for (std::size_t i = 0; i < lit.size(); ++i)
    lit[i] = {over(color[i], film.meanAlbedo(i)), color[i], film.meanNormal(i), film.meanDepth(i)};
  std::vector<Rgb> out(f.depth.size());
  const float sx = static_cast<float>(film.width) / static_cast<float>(f.width);
  const float sy = static_cast<float>(film.height) / static_cast<float>(f.height);
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  const auto rowsOf = [&](const tbb::blocked_range<int>& rows) {
    for (int y = rows.begin(); y < rows.end(); ++y) {
      for (int x = 0; x < f.width; ++x) {
        const std::size_t i = f.index(x, y);
        const bool sky = f.depth[i] == 0;
        const float u = (static_cast<float>(x) + 0.5f) * sx - 0.5f,
                    v = (static_cast<float>(y) + 0.5f) * sy - 0.5f;
        const int x0 = static_cast<int>(std::floor(u)), y0 = static_cast<int>(std::floor(v));
        Rgb sum{};
        float weights = 0;
        for (int dy = -1; dy <= 2; ++dy) {
          for (int dx = -1; dx <= 2; ++dx) {
            const int px = std::clamp(x0 + dx, 0, film.width - 1),
                      py = std::clamp(y0 + dy, 0, film.height - 1);
            const Lit& near = lit[film.index(px, py)];
            const float ex = u - static_cast<float>(x0 + dx), ey = v - static_cast<float>(y0 + dy);
            float w = std::max(0.0f, 1.9f - std::fabs(ex)) * std::max(0.0f, 1.9f - std::fabs(ey)) + 1e-4f;
            if (sky) {
              w *= near.depth == 0 ? 1.0f : 1e-3f;
            } else {
              const float along = std::max(0.0f, std::fabs(dot(near.normal, f.normal[i])));
              const float a2 = along * along, a4 = a2 * a2;
              const float apart = (near.depth - f.distance[i]) / (0.08f * f.distance[i] + 0.05f);
              w *= (a4 * a4 + 1e-3f) / (1 + apart * apart);
            }
            sum += (sky ? near.color : near.light) * w;
            weights += w;
          }
        }
        const Rgb mean = sum / weights;
        const Rgb a = f.albedo[i];
        out[i] = sky ? mean
                     : Rgb{mean.x * std::max(a.x, kLeastAlbedo), mean.y * std::max(a.y, kLeastAlbedo),
                           mean.z * std::max(a.z, kLeastAlbedo)};
      }
    }
  };
  arena.execute([&] { tbb::parallel_for(tbb::blocked_range<int>(0, f.height, 8), rowsOf); });
  return out;
}

}  // namespace idap::render
