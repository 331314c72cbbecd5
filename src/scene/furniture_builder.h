// Furniture, doors and windows as instances of shared meshes, with their finishes and their light.
#pragma once

#include "scene/scene_builder.h"
#include "scene/scene_memory.h"
#include "scene/surface_mapper.h"

namespace idap {

class FurnitureBuilder {
 public:
  FurnitureBuilder(const Home& home, const std::vector<Storey>& storeys, SurfaceMapper& surfaces,
                   BuiltScene& built, SceneMemory& memory)
      : home_(home),
        storeys_(storeys),
        models_(memory.models),
        surfaces_(surfaces),
        built_(built),
        memory_(memory) {}

  // What light must not be put into.
  void setStructure(std::shared_ptr<const Structure> structure) { structure_ = std::move(structure); }

  void add(FurnitureId id, const std::shared_ptr<const Furniture>& piece, LampPolicy lamps);
  // Returns true when light gets through the model: a pane, or no model at all.
  bool add(OpeningId id, const Opening& opening);
  // Adds to the warnings what could not be shown: a line for each reason, not for each piece.
  void tellProblems();

 private:
  struct Problem {
    std::vector<std::string> names;  // of the first pieces
    std::size_t count = 0;
  };
  struct Placed {
    std::uint32_t instance = 0;
    const SurfaceModel* model = nullptr;  // null: a box in its stead
    std::shared_ptr<const Mesh> mesh;
    Transform meshToScene, pieceToScene;
    Vec3 size;
  };
  std::optional<Placed> place(ElementId id, const Piece& piece, bool boxIfMissing);
  std::vector<std::uint32_t> surfacesOf(const SurfaceModel& model, const Piece& piece, bool& needsMapping,
                                        std::vector<bool>& mappedSlots);
  std::uint32_t addSurface(render::Surface surface);
  std::uint32_t meshIndex(const std::shared_ptr<const Mesh>& mesh);
  Vec3 intoRoom(std::size_t storey, Vec3 point, double radius) const;
  void addLight(FurnitureId id, const std::shared_ptr<const Furniture>& piece, const Placed& placed,
                double lumens);
  LampLight lightOf(const Furniture& piece, const Placed& placed, const LampOptions& options) const;
  std::shared_ptr<const Mesh> glowingMesh(const Placed& placed, const LampLight& light,
                                          std::uint32_t firstSlot);

  const Home& home_;
  const std::vector<Storey>& storeys_;
  const ModelCache& models_;
  SurfaceMapper& surfaces_;
  BuiltScene& built_;
  SceneMemory& memory_;
  std::shared_ptr<const Structure> structure_;
  std::map<const Mesh*, std::uint32_t> meshes_;
  std::map<std::pair<const SurfaceModel*, std::size_t>, std::uint32_t> plain_;  // surfaces without a finish
  std::map<std::string, Problem> problems_;
};

}  // namespace idap
