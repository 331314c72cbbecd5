// Gathers faces given in world space (metres, double) into a float mesh relative to the scene's centre, with
// normals and texture coordinates in metres.
#pragma once

#include <memory>

#include "geometry/mesh.h"
#include "geometry/polygon.h"

namespace idap {

class MeshSink {
 public:
  struct Vertex {
    Vec3 position;
    Vec3 normal;
    Vec2 uv;
  };

  explicit MeshSink(Vec3 centre) : centre_(centre) {}

  std::uint32_t vertex(const Vertex& v);
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t slot);
  // A planar quad, its corners counter-clockwise seen from outside.
  void quad(const std::array<Vec3, 4>& corners, const std::array<Vec2, 4>& uvs, std::uint32_t slot);
  // A horizontal face at height z that looks up or down; uvs are plan coordinates.
  void horizontal(const Regions& regions, double z, bool up, std::uint32_t slot);
  // Vertical faces around the regions (outer side outwards) from z0 up to z1.
  void sides(const Regions& regions, double z0, double z1, std::uint32_t slot);
  // Triangulates regions of a face's own plane and maps their points into the world; counter-clockwise there
  // must be outside.
  template <class Map>
  void face(const Regions& regions, std::uint32_t slot, Map&& toVertex) {
    const Triangulation t = triangulate(regions);
    const auto base = static_cast<std::uint32_t>(mesh_.positions.size());
    for (const Vec2& p : t.points) vertex(toVertex(p));
    for (const auto& v : t.triangles) triangle(base + v[0], base + v[1], base + v[2], slot);
  }

  bool empty() const { return mesh_.empty(); }
  std::shared_ptr<const Mesh> take() { return std::make_shared<const Mesh>(std::move(mesh_)); }

 private:
  Vec3 centre_;
  Mesh mesh_;
};

}  // namespace idap
