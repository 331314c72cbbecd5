// How light leaves a fixture: which of its parts stand in the way of a bulb, and which of them shine when the
// bulb itself is not put into the scene. Scene space, metres.
#pragma once

#include <functional>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/transform.h"

namespace idap {

// By triangle: the number of the part that it belongs to. A part hangs together by shared corners (corners at
// one place count as one) and has one slot: a cord is not a part of the shade it carries.
struct MeshParts {
  std::vector<std::uint32_t> partOf;
  std::uint32_t count = 0;
};
MeshParts meshParts(const Mesh& mesh);

class FixtureRays {
 public:
  FixtureRays(const Mesh& mesh, const Transform& meshToScene);

  struct Escape {
    double free = 1;             // share of directions that leave the fixture
    std::vector<int> outermost;  // by part: rays whose last obstacle it is
    std::vector<int> firstSlot;  // by slot: rays whose first obstacle it is
  };
  // isClear: by slot, light passes.
  Escape escapeFrom(Vec3f point, const std::vector<bool>& isClear) const;

  // Parts that stand between the bulb and most of the world around it.
  std::vector<bool> shadeParts(const Escape& escape) const;

  float distanceTo(Vec3f point) const;
  // m2, counted twice where the triangle shines to both sides (an open sheet).
  const std::vector<double>& shiningAreas() const { return areas_; }
  // lm/m2 on the middle of a triangle for 4 pi lm of a bulb at the point, whichever side it is on.
  double illuminance(std::size_t triangle, Vec3f bulb) const;
  const MeshParts& parts() const { return parts_; }

 private:
  struct Triangle {
    Vec3f corner, edge1, edge2;
    Vec3f middle;
    float radius = 0;  // of a sphere around the middle
  };
  const Mesh& mesh_;
  MeshParts parts_;
  std::vector<Triangle> triangles_;
  std::vector<double> areas_;
};

}  // namespace idap
