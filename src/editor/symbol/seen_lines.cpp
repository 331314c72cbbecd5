#include "editor/symbol/seen_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "editor/symbol/area_tracing.h"

namespace idap {

namespace {

constexpr float kCrease = 0.82f;     // cosine of the fold from which an edge shows: 35 degrees
constexpr float kTolerance = 0.45f;  // cells that a drawn line may stray
constexpr float kShortest = 3;       // cells: shorter lines are dust
constexpr float kHidden = 2.5f;      // cells of depth that something must be in front to hide a line

struct Edge {
  std::uint64_t key;  // of its two corners
  std::uint32_t triangle;
  bool backwards;
};

struct Run {  // a part of an edge that is seen; cells
  Vec2f from, to;
  bool outline;
};

// Which edges are worth a line.
std::vector<std::pair<std::uint32_t, std::uint32_t>> drawnEdges(const WeldedMesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(mesh.triangles.size() * 3);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
      edges.push_back({std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), t, a > b});
    }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.key < b.key; });
  std::vector<std::pair<std::uint32_t, std::uint32_t>> drawn;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].key == edges[i].key) ++end;
    bool shows = end - i != 2;  // the end of a sheet, or several that meet
    if (!shows) {
      const Edge &e = edges[i], &f = edges[i + 1];
      const Vec3f n = mesh.normals[e.triangle];
      // Wound the other way round: its normal looks the other way too.
      const Vec3f m = e.backwards == f.backwards ? -mesh.normals[f.triangle] : mesh.normals[f.triangle];
      constexpr float kEdgeOn = 1e-3f;
      const bool silhouette = (n.z > kEdgeOn && m.z < kEdgeOn) || (n.z < kEdgeOn && m.z > kEdgeOn);
      shows = silhouette || dot(n, m) < kCrease || mesh.slots[e.triangle] != mesh.slots[f.triangle];
    }
    if (shows) drawn.emplace_back(std::uint32_t(edges[i].key >> 32), std::uint32_t(edges[i].key));
    i = end;
  }
  return drawn;
}

// Which cells have a line already, by its direction: what lies on a line that is drawn is not drawn again.
class Drawn {
 public:
  explicit Drawn(const DepthRaster& raster)
      : width_(raster.width()), cells_(std::size_t(raster.width()) * std::size_t(raster.height()), 0) {}
  static int directionOf(Vec2f way) {
    const float turn = std::atan2(way.y, way.x) / float(kPi);  // a line has no sense: half a turn is all
    return int(std::lround((turn + 2) * 8)) % 8;
  }
  bool has(int x, int y, int direction) const {
    const std::uint8_t near =
        std::uint8_t(1 << direction | 1 << ((direction + 1) % 8) | 1 << ((direction + 7) % 8));
    return (cells_[at(x, y)] & near) != 0;
  }
  void add(int x, int y, int direction) { cells_[at(x, y)] |= std::uint8_t(1 << direction); }

 private:
  std::size_t at(int x, int y) const { return std::size_t(y) * std::size_t(width_) + std::size_t(x); }
  int width_;
  std::vector<std::uint8_t> cells_;
};

struct Sample {
  int x, y;
  bool seen, outline, fresh;
};

// The parts of an edge that are seen and not drawn yet.
void addRuns(const WeldedMesh& mesh, const DepthRaster& raster, std::uint32_t from, std::uint32_t to,
             Drawn& drawn, std::vector<Run>& runs, std::vector<Sample>& samples) {
  const Vec3f a = mesh.positions[from], b = mesh.positions[to];
  const Vec2f pa = raster.toCells(a), pb = raster.toCells(b);
  const float cells = length(pb - pa);
  if (cells < 0.3f) return;
  const int steps = std::max(1, int(std::ceil(cells)));
  const int direction = Drawn::directionOf(pb - pa);
  samples.clear();
  const float slack = kHidden * raster.cell();
  for (int i = 0; i <= steps; ++i) {
    // The ends lie on corners, where other faces meet: look a little inside.
    const float t = std::clamp(float(i) / float(steps), 0.25f / float(steps), 1 - 0.25f / float(steps));
    const Vec2f p = pa + (pb - pa) * t;
    const float z = a.z + (b.z - a.z) * t;
    Sample s{std::clamp(int(std::floor(p.x)), 1, raster.width() - 2),
             std::clamp(int(std::floor(p.y)), 1, raster.height() - 2), false, false, false};
    int behind = 0, empty = 0;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const float there = raster.depth(s.x + dx, s.y + dy);
        if (there == DepthRaster::kNothing) ++empty;
        if (there <= z + slack) ++behind;
      }
    s.seen = behind >= 2;
    s.outline = empty >= 1;
    s.fresh = !drawn.has(s.x, s.y, direction);
    samples.push_back(s);
  }
  const auto fresh =
      std::count_if(samples.begin(), samples.end(), [](const Sample& s) { return s.seen && s.fresh; });
  const auto seen = std::count_if(samples.begin(), samples.end(), [](const Sample& s) { return s.seen; });
  // Short edges of a curve share cells with their neighbours: only what is wholly drawn is left out.
  if (seen == 0 || 3 * fresh < seen) return;
  for (std::size_t i = 0; i < samples.size();) {
    if (!samples[i].seen) {
      ++i;
      continue;
    }
    std::size_t end = i;
    std::size_t outlines = 0;
    while (end < samples.size() && samples[end].seen) outlines += samples[end++].outline ? 1 : 0;
    const bool whole = i == 0 && end == samples.size();
    if (whole || end - i > 2) {
      const auto at = [&](std::size_t k) { return pa + (pb - pa) * (float(k) / float(steps)); };
      runs.push_back({at(i), at(end - 1), 2 * outlines > end - i});
      for (std::size_t k = i; k < end; ++k) drawn.add(samples[k].x, samples[k].y, direction);
    }
    i = end;
  }
}

// Runs that meet end to end as one line.
std::vector<SymbolLine> chained(const std::vector<Run>& runs, const DepthRaster& raster) {
  const auto key = [](Vec2f p) {
    return std::uint64_t(std::uint32_t(std::lround(p.x * 2))) << 32 | std::uint32_t(std::lround(p.y * 2));
  };
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> ends;
  for (std::uint32_t i = 0; i < runs.size(); ++i) {
    ends[key(runs[i].from)].push_back(i);
    ends[key(runs[i].to)].push_back(i);
  }
  std::vector<bool> used(runs.size(), false);
  std::vector<SymbolLine> lines;
  const auto follow = [&](std::vector<Vec2f>& points, bool outline) {
    for (;;) {
      const auto& here = ends[key(points.back())];
      std::uint32_t best = ~0u;
      float straightest = -0.2f;  // sharper corners begin a new line, but a rectangle's go on
      const Vec2f way = points.back() - points[points.size() - 2];
      for (const std::uint32_t i : here) {
        if (used[i] || runs[i].outline != outline) continue;
        const Vec2f on =
            key(runs[i].from) == key(points.back()) ? runs[i].to - runs[i].from : runs[i].from - runs[i].to;
        const float along = dot(way, on) / std::max(length(way) * length(on), 1e-9f);
        if (along > straightest) straightest = along, best = i;
      }
      if (best == ~0u) return;
      used[best] = true;
      points.push_back(key(runs[best].from) == key(points.back()) ? runs[best].to : runs[best].from);
    }
  };
  for (std::uint32_t i = 0; i < runs.size(); ++i) {
    if (used[i]) continue;
    used[i] = true;
    std::vector<Vec2f> points{runs[i].from, runs[i].to};
    follow(points, runs[i].outline);
    std::reverse(points.begin(), points.end());
    follow(points, runs[i].outline);
    float cells = 0;
    for (std::size_t k = 1; k < points.size(); ++k) cells += length(points[k] - points[k - 1]);
    if (cells < kShortest) continue;
    SymbolLine line;
    line.length = cells * raster.cell();
    line.outline = runs[i].outline;
    for (const Vec2f p : simplified(points, kTolerance)) line.points.push_back(raster.toMetres(p));
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

std::vector<SymbolLine> seenLines(const WeldedMesh& mesh, const DepthRaster& raster) {
  auto edges = drawnEdges(mesh);
  // The nearest first: what lies exactly under them, as the foot of a wall, is not drawn again.
  const auto nearness = [&](const auto& e) { return mesh.positions[e.first].z + mesh.positions[e.second].z; };
  std::stable_sort(edges.begin(), edges.end(),
                   [&](const auto& a, const auto& b) { return nearness(a) > nearness(b); });
  Drawn drawn(raster);
  std::vector<Run> runs;
  std::vector<Sample> samples;
  for (const auto& [a, b] : edges) addRuns(mesh, raster, a, b, drawn, runs, samples);
  std::vector<SymbolLine> lines = chained(runs, raster);
  std::stable_sort(lines.begin(), lines.end(),
                   [](const SymbolLine& a, const SymbolLine& b) { return a.length > b.length; });
  return lines;
}

}  // namespace idap
