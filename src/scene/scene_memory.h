// What a scene builder keeps from one build to the next: models, decoded pictures, walls and rooms, meshes
// made for one piece. With it an edit costs about what it touched, and all it did not touch stays the same
// mesh in memory, so that the renderer's acceleration structures stay, too. One thread at a time.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "light/daylight.h"
#include "model/home.h"
#include "scene/ground_builder.h"
#include "scene/lamp_builder.h"
#include "scene/model_cache.h"
#include "scene/room_builder.h"
#include "scene/texture_cache.h"

namespace idap {

// Walls, rooms and what cuts them, for one way of showing the storeys.
struct Structure {
  // What it was made from.
  Home home;
  bool ceilings = true, hiddenLevels = true;
  std::vector<std::shared_ptr<const Furniture>> stairs;

  std::vector<Storey> storeys;
  std::vector<WallSolid> walls;
  std::vector<OpeningCut> openings;
  std::vector<std::vector<WallCut>> cuts;  // of each wall
  std::optional<RoomBuilder> rooms;
  std::vector<std::shared_ptr<const Mesh>> wallMeshes, roomMeshes, ceilingMeshes;  // null: nothing to see
  Regions openGround;  // where rooms lie below the land
  Box2 extent;         // of the plan
  Vec3 centre;
  std::map<WallId, Vec2> outward;  // of outer walls: the side that is outdoors, unit
};

// Meshes made for one piece, kept for as long as somebody asks for them now and then.
class MeshStore {
 public:
  // The mesh made before for that key, or what make gives. source: a mesh whose address is in the key.
  template <class Make>
  std::shared_ptr<const Mesh> get(const std::string& key, const std::shared_ptr<const Mesh>& source,
                                  Make&& make) {
    Entry& entry = entries_[key];
    if (!entry.mesh) entry = {make(), source, 0};
    entry.usedAt = build_;
    return entry.mesh;
  }
  void nextBuild();

 private:
  struct Entry {
    std::shared_ptr<const Mesh> mesh, source;
    std::uint64_t usedAt = 0;
  };
  std::map<std::string, Entry> entries_;
  std::uint64_t build_ = 0;
};

struct SceneMemory {
  ModelCache models;
  TextureCache textures;
  std::shared_ptr<const Structure> structure[2];  // without and with ceilings
  // Not moved with the rest: threads hold its locks.
  std::unique_ptr<StructureMemo> structureParts = std::make_unique<StructureMemo>();
  MeshStore pieceMeshes;
  std::shared_ptr<const Mesh> missingModel;
  struct Light {
    DaylightConditions conditions;
    Daylight light;
  };
  std::optional<Light> daylight;
  struct Land {
    Regions open;
    Box2 extent;
    Vec3 centre;
    Rgb soil, horizon;
    render::TexturePtr soilMap;
    Ground ground;
  };
  std::optional<Land> land;
  struct LampEntry {  // the lamp, its fixture and its place, as they were when its light was worked out
    std::shared_ptr<const Furniture> piece;
    std::shared_ptr<const Mesh> mesh;
    Transform meshToScene;
    double lumens = 0;
    LampLight light;
  };
  std::map<FurnitureId, LampEntry> lamps;
};

}  // namespace idap
