#include "geometry/mesh.h"

#include <bit>
#include <cmath>
#include <unordered_map>

namespace idap {

namespace {

Vec3f unitOr(Vec3f v, Vec3f otherwise) {
  const float l = length(v);
  return l > 0 && std::isfinite(l) ? v / l : otherwise;
}

Vec3f doubledAreaNormal(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const Vec3f a = mesh.positions[t[0]];
  return cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
}

// Gives each triangle its own three vertices with the face's normal.
void splitFlat(Mesh& mesh) {
  Mesh flat;
  const std::size_t corners = mesh.triangles.size() * 3;
  flat.positions.reserve(corners);
  flat.normals.reserve(corners);
  if (!mesh.uvs.empty()) flat.uvs.reserve(corners);
  flat.triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    const Vec3f n = unitOr(doubledAreaNormal(mesh, t), {0, 0, 1});
    const auto first = static_cast<std::uint32_t>(flat.positions.size());
    for (const std::uint32_t v : t) {
      flat.positions.push_back(mesh.positions[v]);
      flat.normals.push_back(n);
      if (!mesh.uvs.empty()) flat.uvs.push_back(mesh.uvs[v]);
    }
    flat.triangles.push_back({first, first + 1, first + 2});
  }
  flat.slots = std::move(mesh.slots);
  mesh = std::move(flat);
}

struct PositionHash {
  std::size_t operator()(const Vec3f& p) const noexcept {
    // + 0 turns -0 into 0, which compares equal to it.
    const std::uint64_t x = std::bit_cast<std::uint32_t>(p.x + 0.0f);
    const std::uint64_t y = std::bit_cast<std::uint32_t>(p.y + 0.0f);
    const std::uint64_t z = std::bit_cast<std::uint32_t>(p.z + 0.0f);
    std::uint64_t h = x * 0x9E3779B97F4A7C15u ^ y * 0xC2B2AE3D27D4EB4Fu ^ z * 0x165667B19E3779F9u;
    h ^= h >> 29;
    h *= 0xBF58476D1CE4E5B9u;
    return static_cast<std::size_t>(h ^ (h >> 32));
  }
};

// Where a vertex is shared by more triangles than this, their normals are first put together in bins, so that
// the cost stays linear.
constexpr std::size_t kManyCorners = 256;
constexpr int kBins = 16;  // a side of the octahedral map

std::size_t binOf(Vec3f n) {
  const float sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
  float u = n.x / sum, v = n.y / sum;
  if (n.z < 0) {
    const float folded = (1 - std::abs(v)) * (u < 0 ? -1.0f : 1.0f);
    v = (1 - std::abs(u)) * (v < 0 ? -1.0f : 1.0f);
    u = folded;
  }
  const auto cell = [](float x) {
    return std::min(kBins - 1, std::max(0, static_cast<int>((x * 0.5f + 0.5f) * kBins)));
  };
  return static_cast<std::size_t>(cell(u) * kBins + cell(v));
}

}  // namespace

void append(Mesh& a, const Mesh& b, const Transformf& t, std::uint32_t slotOffset) {
  if (b.empty()) return;
  const bool wantNormals = !b.normals.empty() || (!a.empty() && !a.normals.empty());
  if (wantNormals && !a.empty() && a.normals.empty()) splitFlat(a);
  if (wantNormals && b.normals.empty()) {
    Mesh flat = b;
    splitFlat(flat);
    append(a, flat, t, slotOffset);
    return;
  }
  const auto base = static_cast<std::uint32_t>(a.positions.size());
  const std::size_t triangleBase = a.triangles.size();
  const bool mirrors = t.determinant() < 0;
  const Transformf cofactor = t.cofactor();
  const float sign = mirrors ? -1.0f : 1.0f;

  for (const Vec3f& p : b.positions) a.positions.push_back(t.point(p));
  if (wantNormals) {
    for (const Vec3f& n : b.normals) a.normals.push_back(unitOr(cofactor.vector(n) * sign, n));
  }
  if (!b.uvs.empty()) {
    a.uvs.resize(base);
    a.uvs.insert(a.uvs.end(), b.uvs.begin(), b.uvs.end());
  } else if (!a.uvs.empty()) {
    a.uvs.resize(a.positions.size());
  }
  for (const auto& v : b.triangles) {
    if (mirrors) {
      a.triangles.push_back({base + v[0], base + v[2], base + v[1]});
    } else {
      a.triangles.push_back({base + v[0], base + v[1], base + v[2]});
    }
  }
  if (slotOffset != 0 || !b.slots.empty() || !a.slots.empty()) {
    a.slots.resize(triangleBase);
    for (std::size_t i = 0; i < b.triangles.size(); ++i) a.slots.push_back(slotOffset + b.slotOf(i));
  }
}

void computeSmoothNormals(Mesh& mesh, float creaseAngle) {
  const std::size_t triangleCount = mesh.triangles.size(), cornerCount = triangleCount * 3;
  if (triangleCount == 0) return;

  // Places: vertices with equal positions.
  std::vector<std::uint32_t> place(mesh.positions.size());
  std::size_t placeCount = 0;
  {
    std::unordered_map<Vec3f, std::uint32_t, PositionHash> places;
    places.reserve(mesh.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      place[v] =
          places.try_emplace(mesh.positions[v], static_cast<std::uint32_t>(places.size())).first->second;
    }
    placeCount = places.size();
  }
  // Corners by place.
  std::vector<std::uint32_t> begin(placeCount + 1, 0), cornersAt(cornerCount);
  const auto vertexOf = [&](std::size_t corner) { return mesh.triangles[corner / 3][corner % 3]; };
  for (std::size_t c = 0; c < cornerCount; ++c) ++begin[place[vertexOf(c)] + 1];
  for (std::size_t p = 0; p < placeCount; ++p) begin[p + 1] += begin[p];
  {
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t c = 0; c < cornerCount; ++c) {
      cornersAt[next[place[vertexOf(c)]]++] = static_cast<std::uint32_t>(c);
    }
  }

  std::vector<Vec3f> faceArea(triangleCount), faceNormal(triangleCount);
  for (std::size_t t = 0; t < triangleCount; ++t) {
    faceArea[t] = doubledAreaNormal(mesh, mesh.triangles[t]);
    faceNormal[t] = unitOr(faceArea[t], {});
  }

  const float cosine = std::cos(creaseAngle) - 1e-5f;
  std::vector<Vec3f> cornerNormal(cornerCount);
  std::vector<Vec3f> bins;
  for (std::size_t p = 0; p < placeCount; ++p) {
    const std::size_t count = begin[p + 1] - begin[p];
    const bool many = count > kManyCorners;
    if (many) {
      bins.assign(kBins * kBins, Vec3f{});
      for (std::size_t i = begin[p]; i < begin[p + 1]; ++i) {
        const Vec3f n = faceNormal[cornersAt[i] / 3];
        if (dot(n, n) > 0) bins[binOf(n)] += faceArea[cornersAt[i] / 3];
      }
    }
    for (std::size_t i = begin[p]; i < begin[p + 1]; ++i) {
      const Vec3f own = faceNormal[cornersAt[i] / 3];
      Vec3f sum{};
      if (many) {
        for (const Vec3f& bin : bins) {
          const float l = length(bin);
          if (l > 0 && dot(own, bin) >= cosine * l) sum += bin;
        }
      } else {
        for (std::size_t j = begin[p]; j < begin[p + 1]; ++j) {
          if (dot(own, faceNormal[cornersAt[j] / 3]) >= cosine) sum += faceArea[cornersAt[j] / 3];
        }
      }
      cornerNormal[cornersAt[i]] = unitOr(sum, dot(own, own) > 0 ? own : Vec3f{0, 0, 1});
    }
  }

  // A vertex gets one copy for each different normal of its corners: its first keeps the index, more are put
  // at the end, chained by next.
  constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  std::vector<std::uint32_t> next(mesh.positions.size(), kNone);
  std::vector<char> used(mesh.positions.size(), 0);
  mesh.normals.assign(mesh.positions.size(), Vec3f{0, 0, 1});
  for (std::size_t c = 0; c < cornerCount; ++c) {
    std::uint32_t& vertex = mesh.triangles[c / 3][c % 3];
    const Vec3f n = cornerNormal[c];
    std::uint32_t v = vertex;
    if (!used[v]) {
      used[v] = 1;
      mesh.normals[v] = n;
      continue;
    }
    while (dot(mesh.normals[v], n) < 0.99999f && next[v] != kNone) v = next[v];
    if (dot(mesh.normals[v], n) < 0.99999f) {
      const auto copy = static_cast<std::uint32_t>(mesh.positions.size());
      next[v] = copy;
      next.push_back(kNone);
      used.push_back(1);
      mesh.positions.push_back(Vec3f(mesh.positions[v]));
      mesh.normals.push_back(n);
      if (!mesh.uvs.empty()) mesh.uvs.push_back(Vec2f(mesh.uvs[v]));
      v = copy;
    }
    vertex = v;
  }
}

}  // namespace idap
