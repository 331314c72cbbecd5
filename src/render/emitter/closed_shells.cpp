#include <algorithm>
#include <numeric>
#include <tuple>

#include "render/emitter/local_lights.h"

namespace idap::render {

std::vector<bool> outsideOfClosedShells(const Mesh& mesh) {
  // Number the places, joining corners that coincide.
  std::vector<std::uint32_t> order(mesh.positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    const Vec3f p = mesh.positions[i];
    return std::tuple(p.x, p.y, p.z);
  };
  const bool numbers = std::ranges::all_of(mesh.positions, [](Vec3f p) { return std::isfinite(dot(p, p)); });
  if (!numbers) return std::vector<bool>(mesh.triangles.size(), false);
  std::ranges::sort(order, {}, key);
  std::vector<std::uint32_t> place(mesh.positions.size());
  std::uint32_t places = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k > 0 && key(order[k]) != key(order[k - 1])) ++places;
    place[order[k]] = places;
  }

  // Every edge of a closed shell is walked once each way.
  struct Edge {
    std::uint32_t low, high, triangle;
    bool forward;
  };
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& c = mesh.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = place[c[k]], b = place[c[(k + 1) % 3]];
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b), t, a < b});
    }
  }
  std::ranges::sort(edges, {},
                    [](const Edge& e) { return std::tuple(e.low, e.high, e.triangle, e.forward); });

  std::vector<std::uint32_t> parent(mesh.triangles.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t t) {
    while (parent[t] != t) t = parent[t] = parent[parent[t]];
    return t;
  };
  std::vector<bool> open(mesh.triangles.size(), false);
  for (std::size_t from = 0; from < edges.size();) {
    std::size_t to = from;
    int balance = 0;
    while (to < edges.size() && edges[to].low == edges[from].low && edges[to].high == edges[from].high)
      balance += edges[to++].forward ? 1 : -1;
    for (std::size_t k = from; k < to; ++k) {
      if (balance != 0) open[edges[k].triangle] = true;
      parent[root(edges[k].triangle)] = root(edges[from].triangle);
    }
    from = to;
  }

  std::vector<double> volume(mesh.triangles.size(), 0.0);
  std::vector<bool> leaky(mesh.triangles.size(), false);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& c = mesh.triangles[t];
    // Measured from the first corner, so that a shell far from the origin loses no digits.
    const Vec3 o = toDouble(mesh.positions[mesh.triangles[root(t)][0]]);
    const Vec3 p = toDouble(mesh.positions[c[0]]) - o, q = toDouble(mesh.positions[c[1]]) - o,
               r = toDouble(mesh.positions[c[2]]) - o;
    volume[root(t)] += dot(p, cross(q, r));
    if (open[t]) leaky[root(t)] = true;
  }
  std::vector<bool> closed(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    closed[t] = !leaky[root(t)] && volume[root(t)] > 1e-15;
  return closed;
}

}  // namespace idap::render
