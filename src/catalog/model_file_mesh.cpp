#include "catalog/model_file_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "catalog/polygon_triangles.h"

namespace idap {

namespace {

// Neighbouring faces of a smoothing group share normals unless they meet more sharply than this. Sweet Home
// 3D's own limit is a right angle; a little less keeps the edges of boxes sharp whatever their rounding.
constexpr float kCreaseCosine = 0.17f;  // 80 degrees
// Vertices with more faces than this stay flat: nobody models such, and the work grows with the square.
constexpr std::size_t kMaxSharedFaces = 512;

using Corner = PolygonModel::Corner;
using Face = PolygonModel::Face;

bool isFinite(Vec3f v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// Twice the polygon's area along its normal (Newell), relative to its first corner for precision.
Vec3f areaVector(const PolygonModel& model, std::span<const Corner> corners) {
  const auto at = [&](std::size_t i) { return model.positions[std::size_t(corners[i].position)]; };
  const Vec3f origin = at(0);
  Vec3f sum;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) sum += cross(at(i) - origin, at(i + 1) - origin);
  return sum;
}

class Builder {
 public:
  Builder(PolygonModel& model, bool smoothed) : model_(model), smoothed_(smoothed) {}

  Mesh build() {
    keepGoodFaces();
    if (faces_.empty()) return {};
    sharePlaces();
    mesh_.positions.reserve(model_.positions.size() * 2);
    mesh_.triangles.reserve(model_.corners.size());
    mesh_.slots.reserve(model_.corners.size());
    firstVertex_.assign(model_.positions.size(), kNoVertex);
    flat_ = !std::any_of(faces_.begin(), faces_.end(),
                         [&](const Face& f) { return isSmooth(f) || hasNormals(cornersOf(f)); });
    for (std::size_t f = 0; f < faces_.size(); ++f) addFace(f);
    if (model_.uvs.empty()) mesh_.uvs.clear();
    return std::move(mesh_);
  }

 private:
  static constexpr std::uint32_t kNoVertex = ~0u;
  struct Link {  // the vertices made of one position
    std::uint32_t next = kNoVertex;
    std::int32_t uv = PolygonModel::kNone;
  };

  std::span<const Corner> cornersOf(const Face& face) const {
    return std::span(model_.corners).subspan(face.first, face.count);
  }
  bool isSmooth(const Face& face) const { return smoothed_ && face.smoothing != 0; }
  static bool hasNormals(std::span<const Corner> corners) {
    return std::all_of(corners.begin(), corners.end(), [](const Corner& c) { return c.normal >= 0; });
  }

  void keepGoodFaces() {
    const auto positions = std::int32_t(model_.positions.size());
    const auto normals = std::int32_t(model_.normals.size());
    const auto uvs = std::int32_t(model_.uvs.size());
    std::vector<bool> finite(model_.positions.size());
    for (std::size_t i = 0; i < finite.size(); ++i) finite[i] = isFinite(model_.positions[i]);
    for (Vec2f& uv : model_.uvs)
      if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) uv = {};
    faces_.reserve(model_.faces.size());
    areas_.reserve(model_.faces.size());
    for (const Face& face : model_.faces) {
      if (face.count < 3) continue;
      bool good = true;
      for (std::uint32_t i = 0; i < face.count; ++i) {
        Corner& c = model_.corners[face.first + i];
        good = good && c.position >= 0 && c.position < positions && finite[std::size_t(c.position)];
        if (c.normal < 0 || c.normal >= normals) c.normal = PolygonModel::kNone;
        if (c.uv < 0 || c.uv >= uvs) c.uv = PolygonModel::kNone;
      }
      if (!good) continue;
      const Vec3f area = areaVector(model_, cornersOf(face));
      if (!(dot(area, area) > 0) || !isFinite(area)) continue;
      faces_.push_back(face);
      areas_.push_back(area);
    }
  }

  // Gives equal positions one number, and lists the faces at each, so that files that repeat their vertices
  // are smooth too.
  void sharePlaces() {
    if (!smoothed_) return;
    const std::size_t count = model_.positions.size();
    place_.assign(count, 0);
    const std::size_t buckets = std::bit_ceil(count * 2 + 1);
    std::vector<std::uint32_t> table(buckets, kNoVertex);
    for (std::uint32_t i = 0; i < count; ++i) {
      const Vec3f p = model_.positions[i] + Vec3f{0, 0, 0};  // makes -0 equal to 0
      std::uint64_t hash = std::bit_cast<std::uint32_t>(p.x);
      hash = hash * 0x9E3779B97F4A7C15u + std::bit_cast<std::uint32_t>(p.y);
      hash = hash * 0x9E3779B97F4A7C15u + std::bit_cast<std::uint32_t>(p.z);
      hash *= 0x9E3779B97F4A7C15u;
      std::size_t slot = (hash >> 20) & (buckets - 1);
      while (table[slot] != kNoVertex && !(model_.positions[table[slot]] == p))
        slot = (slot + 1) & (buckets - 1);
      if (table[slot] == kNoVertex) table[slot] = i;
      place_[i] = table[slot];
    }
    placeFaces_.assign(count + 1, 0);
    for (const Face& face : faces_)
      if (isSmooth(face))
        for (const Corner& c : cornersOf(face)) ++placeFaces_[place_[std::size_t(c.position)] + 1];
    for (std::size_t i = 1; i < placeFaces_.size(); ++i) placeFaces_[i] += placeFaces_[i - 1];
    facesAtPlace_.resize(placeFaces_.back());
    std::vector<std::uint32_t> fill(placeFaces_.begin(), placeFaces_.end() - 1);
    for (std::uint32_t f = 0; f < faces_.size(); ++f)
      if (isSmooth(faces_[f]))
        for (const Corner& c : cornersOf(faces_[f]))
          facesAtPlace_[fill[place_[std::size_t(c.position)]]++] = f;
  }

  Vec3f normalOf(std::size_t f, const Corner& corner, bool fromFile) const {
    if (fromFile) {
      const Vec3f n = model_.normals[std::size_t(corner.normal)];
      const float squared = dot(n, n);
      if (squared > 1e-12f && std::isfinite(squared)) return n / std::sqrt(squared);
    } else if (isSmooth(faces_[f])) {
      const std::uint32_t place = place_[std::size_t(corner.position)];
      const std::size_t begin = placeFaces_[place], end = placeFaces_[place + 1];
      if (end - begin <= kMaxSharedFaces) {
        const Vec3f own = areas_[f];
        const float ownSquared = dot(own, own);
        Vec3f sum;
        for (std::size_t i = begin; i < end; ++i) {
          const std::uint32_t other = facesAtPlace_[i];
          if (faces_[other].smoothing != faces_[f].smoothing) continue;
          const float cosine = dot(own, areas_[other]);
          if (other == f || (cosine > 0 && cosine * cosine > kCreaseCosine * kCreaseCosine * ownSquared *
                                                                 dot(areas_[other], areas_[other])))
            sum += areas_[other];
        }
        const float squared = dot(sum, sum);
        if (squared > 0) return sum / std::sqrt(squared);
      }
    }
    return normalized(areas_[f]);
  }

  std::uint32_t vertex(const Corner& corner, Vec3f normal) {
    std::uint32_t& head = firstVertex_[std::size_t(corner.position)];
    for (std::uint32_t v = head; v != kNoVertex; v = links_[v].next)
      if (links_[v].uv == corner.uv && (flat_ || mesh_.normals[v] == normal)) return v;
    const auto v = std::uint32_t(mesh_.positions.size());
    mesh_.positions.push_back(model_.positions[std::size_t(corner.position)]);
    if (!flat_) mesh_.normals.push_back(normal);
    mesh_.uvs.push_back(corner.uv >= 0 ? model_.uvs[std::size_t(corner.uv)] : Vec2f{});
    links_.push_back({head, corner.uv});
    head = v;
    return v;
  }

  void addFace(std::size_t f) {
    const std::span<const Corner> corners = cornersOf(faces_[f]);
    const bool fromFile = !flat_ && hasNormals(corners);
    indices_.clear();
    for (const Corner& corner : corners)
      indices_.push_back(vertex(corner, flat_ ? Vec3f{} : normalOf(f, corner, fromFile)));
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      if (a == b || b == c || c == a) return;
      mesh_.triangles.push_back({a, b, c});
      mesh_.slots.push_back(faces_[f].slot);
    };
    if (corners.size() == 3) return add(indices_[0], indices_[1], indices_[2]);
    outline_.clear();
    for (const std::uint32_t i : indices_) outline_.push_back(mesh_.positions[i]);
    triangles_.clear();
    triangulatePolygon(outline_, areas_[f], triangles_);
    for (const auto& t : triangles_) add(indices_[t[0]], indices_[t[1]], indices_[t[2]]);
  }

  PolygonModel& model_;
  bool smoothed_;
  bool flat_ = false;
  Mesh mesh_;
  std::vector<Face> faces_;
  std::vector<Vec3f> areas_;
  std::vector<std::uint32_t> place_, placeFaces_, facesAtPlace_;
  std::vector<std::uint32_t> firstVertex_;
  std::vector<Link> links_;
  std::vector<std::uint32_t> indices_;
  std::vector<Vec3f> outline_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

Vec3f fitToUnitBox(Mesh& mesh, const std::array<Vec3, 3>& rotation) {
  if (mesh.positions.empty()) return {};
  const Transform given{rotation[0], rotation[1], rotation[2], {}};
  const double determinant = given.determinant();
  const bool usable = std::isfinite(determinant) && std::abs(determinant) > 1e-6;
  const Transformf turn =
      toFloat((usable ? given : Transform{}) * Transform{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {}});
  for (Vec3f& p : mesh.positions) p = turn.vector(p);
  if (usable && determinant < 0)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  const Box3f box = mesh.bounds();
  const Vec3f extent = box.size();
  const float longest = std::max({extent.x, extent.y, extent.z});
  Vec3f size{1, 1, 1};
  for (int axis = 0; axis < 3; ++axis)
    if (extent[axis] > longest * 1e-7f) size[axis] = extent[axis];
  const Vec3f middle = box.centre();
  for (Vec3f& p : mesh.positions) {
    p = (p - middle) / size;
    p.z += 0.5f;
  }
  const Transformf cofactor = turn.cofactor();
  for (Vec3f& n : mesh.normals) {
    n = cofactor.vector(n) * size;
    const float squared = dot(n, n);
    n = squared > 0 ? n / std::sqrt(squared) : Vec3f{0, 0, 1};
  }
  return extent;
}

SurfaceModel surfaceModelOf(PolygonModel model, const std::array<Vec3, 3>& rotation, bool smoothed) {
  SurfaceModel result;
  result.slots = std::move(model.slots);
  result.mesh = Builder(model, smoothed).build();
  result.unitBox = true;
  const Vec3f size = fitToUnitBox(result.mesh, rotation);
  result.fileSize = {size.x, size.y, size.z};
  return result;
}

}  // namespace idap
