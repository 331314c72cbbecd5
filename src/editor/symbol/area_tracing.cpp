#include "editor/symbol/area_tracing.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace idap {

namespace {

constexpr float kTolerance = 0.8f;  // cells: just more than the steps of a slanting border
constexpr float kSpeck = 10;        // cells of area

struct Corner {
  int x, y;
};

// Follows the borders of one label. Each piece of border has the area on its left.
class Borders {
 public:
  explicit Borders(int width) : width_(width) {}

  void add(Corner from, Corner to) { next_[key(from)].push_back(to); }

  std::vector<std::vector<Vec2f>> rings() {
    std::vector<std::vector<Vec2f>> all;
    for (auto& [start, ways] : next_) {
      while (!ways.empty()) {
        std::vector<Vec2f> ring;
        std::uint64_t at = start;
        int dx = 0, dy = 0;
        for (;;) {
          auto& out = next_[at];
          if (out.empty()) break;
          const Corner here = cornerOf(at);
          // Where two areas touch at a corner, turn left: they stay apart.
          std::size_t chosen = 0;
          if (out.size() > 1 && (dx != 0 || dy != 0))
            for (std::size_t i = 0; i < out.size(); ++i)
              if (dx * (out[i].y - here.y) - dy * (out[i].x - here.x) > 0) chosen = i;
          const Corner to = out[chosen];
          out.erase(out.begin() + std::ptrdiff_t(chosen));
          if ((to.x - here.x) != dx || (to.y - here.y) != dy) ring.push_back({float(here.x), float(here.y)});
          dx = to.x - here.x, dy = to.y - here.y;
          at = key(to);
        }
        if (ring.size() > 3) all.push_back(std::move(ring));
      }
    }
    return all;
  }

 private:
  std::uint64_t key(Corner c) const {
    return std::uint64_t(c.y) * std::uint64_t(width_ + 1) + std::uint64_t(c.x);
  }
  Corner cornerOf(std::uint64_t key) const {
    return {int(key % std::uint64_t(width_ + 1)), int(key / std::uint64_t(width_ + 1))};
  }

  int width_;
  std::map<std::uint64_t, std::vector<Corner>> next_;
};

float areaOf(const std::vector<Vec2f>& ring) {
  float twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) twice += cross(ring[i], ring[(i + 1) % ring.size()]);
  return twice / 2;
}

std::vector<SymbolRing> ringsOf(const DepthRaster& raster, Borders& borders, float& area) {
  std::vector<SymbolRing> rings;
  for (const auto& ring : borders.rings()) {
    const float own = areaOf(ring);
    area += own;
    if (std::abs(own) < kSpeck) continue;
    SymbolRing mapped;
    for (const Vec2f p : simplifiedRing(ring, kTolerance)) mapped.push_back(raster.toMetres(p));
    if (mapped.size() > 2) rings.push_back(std::move(mapped));
  }
  return rings;
}

template <class LabelOf>
std::vector<TracedArea> trace(const DepthRaster& raster, const LabelOf& labelOf) {
  std::map<std::uint32_t, Borders> borders;
  for (int y = 0; y < raster.height(); ++y)
    for (int x = 0; x < raster.width(); ++x) {
      const std::uint32_t label = labelOf(x, y);
      if (label == 0) continue;
      Borders* own = nullptr;
      const auto side = [&](int nx, int ny, Corner from, Corner to) {
        if (labelOf(nx, ny) == label) return;
        if (!own) own = &borders.try_emplace(label, raster.width()).first->second;
        own->add(from, to);
      };
      side(x, y - 1, {x, y}, {x + 1, y});
      side(x + 1, y, {x + 1, y}, {x + 1, y + 1});
      side(x, y + 1, {x + 1, y + 1}, {x, y + 1});
      side(x - 1, y, {x, y + 1}, {x, y});
    }
  std::vector<std::pair<float, TracedArea>> found;
  for (auto& [label, border] : borders) {
    float area = 0;
    TracedArea traced;
    traced.label = label;
    traced.rings = ringsOf(raster, border, area);
    if (!traced.rings.empty()) found.emplace_back(area, std::move(traced));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<TracedArea> areas;
  for (auto& [area, traced] : found) areas.push_back(std::move(traced));
  return areas;
}

}  // namespace

std::vector<TracedArea> traceAreas(const DepthRaster& raster) {
  return trace(raster, [&](int x, int y) { return raster.label(x, y); });
}

std::vector<SymbolRing> traceOutline(const DepthRaster& raster) {
  auto areas = trace(raster, [&](int x, int y) { return raster.label(x, y) != 0 ? 1u : 0u; });
  return areas.empty() ? std::vector<SymbolRing>{} : std::move(areas.front().rings);
}

std::vector<Vec2f> simplified(const std::vector<Vec2f>& line, float tolerance) {
  if (line.size() < 3) return line;
  std::vector<bool> kept(line.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> spans{{0, line.size() - 1}};
  while (!spans.empty()) {
    const auto [from, to] = spans.back();
    spans.pop_back();
    const Vec2f a = line[from], way = line[to] - a;
    const float reach = length(way);
    float most = tolerance;
    std::size_t worst = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const Vec2f p = line[i] - a;
      const float t = reach > 0 ? std::clamp(dot(p, way) / (reach * reach), 0.0f, 1.0f) : 0.0f;
      if (const float off = length(p - way * t); off > most) most = off, worst = i;
    }
    if (worst == from) continue;
    kept[worst] = true;
    spans.emplace_back(from, worst);
    spans.emplace_back(worst, to);
  }
  std::vector<Vec2f> fewer;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (kept[i]) fewer.push_back(line[i]);
  return fewer;
}

// A ring is cut at its two points furthest from each other, and each half made simpler.
std::vector<Vec2f> simplifiedRing(const std::vector<Vec2f>& ring, float tolerance) {
  std::size_t far = 0;
  float most = -1;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (const float d = length(ring[i] - ring[0]); d > most) most = d, far = i;
  const auto half = std::ptrdiff_t(far);
  std::vector<Vec2f> first(ring.begin(), ring.begin() + half + 1), second(ring.begin() + half, ring.end());
  second.push_back(ring[0]);
  first = simplified(first, tolerance);
  second = simplified(second, tolerance);
  first.pop_back();
  second.pop_back();
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

}  // namespace idap
