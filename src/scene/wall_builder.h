// Turns walls into meshes: sides with their openings and reveals, ends, tops, baseboards. World space,
// metres.
#pragma once

#include "scene/mesh_sink.h"
#include "scene/opening_cut.h"
#include "scene/structure_memo.h"

namespace idap {

// Material slots of a wall's mesh.
enum WallSlot : std::uint32_t {
  kWallLeft,
  kWallRight,
  kWallTop,
  kBaseboardLeft,
  kBaseboardRight,
  kWallSlots
};

class WallBuilder {
 public:
  // cuts: of each wall.
  WallBuilder(const Home& home, const std::vector<WallSolid>& walls,
              const std::vector<std::vector<WallCut>>& cuts);

  // The mesh of walls[index], relative to centre; null when nothing of it is left.
  std::shared_ptr<const Mesh> build(std::size_t index, Vec3 centre, StructureMemo* memo = nullptr) const;

 private:
  // One upright face: from p0 to p1 with the outside on the right hand.
  struct Face {
    Vec2 p0, p1;
    Vec2 n0, n1;   // normals at its ends: they differ on round walls
    double s = 0;  // texture coordinate at p0
    std::uint32_t slot = 0;
    bool cap = false;
  };

  std::shared_ptr<const Mesh> make(std::size_t index, Vec3 centre) const;
  std::string keyOf(std::size_t index, Vec3 centre) const;
  bool near(const WallSolid& wall, const WallSolid& other) const;
  std::vector<Face> facesOf(const WallSolid& wall) const;
  void addFace(std::size_t index, const Face& face, MeshSink& sink) const;
  Regions cutFace(const WallSolid& wall, const WallCut& cut, const Face& face) const;
  Regions coveredByOthers(std::size_t index, const Face& face) const;
  void addTop(std::size_t index, MeshSink& sink) const;
  void addReveals(std::size_t index, const WallCut& cut, MeshSink& sink) const;
  void addBackPlate(std::size_t index, const WallCut& cut, bool atLow, MeshSink& sink) const;
  void addBaseboard(std::size_t index, bool left, MeshSink& sink) const;

  const Home& home_;
  const std::vector<WallSolid>& walls_;
  const std::vector<std::vector<WallCut>>& cuts_;
  std::vector<std::vector<Face>> faces_;
};

}  // namespace idap
