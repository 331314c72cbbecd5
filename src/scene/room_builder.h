// Floors, slabs, doorsteps and ceilings of the rooms. World space, metres.
#pragma once

#include <map>
#include <optional>

#include "scene/mesh_sink.h"
#include "scene/opening_cut.h"
#include "scene/structure_memo.h"

namespace idap {

enum RoomSlot : std::uint32_t { kRoomFloor, kRoomCeiling, kRoomUnderside, kRoomSlots };

// A hole that a staircase needs in the floors and ceilings it passes.
struct StairHole {
  Regions region;
  double bottom = 0, top = 0;  // world heights of the staircase
};
std::vector<StairHole> stairHoles(const Home& home, const std::vector<Storey>& storeys);

class RoomBuilder {
 public:
  // cuts: of each wall.
  RoomBuilder(const Home& home, const std::vector<Storey>& storeys, const std::vector<WallSolid>& walls,
              const std::vector<std::vector<WallCut>>& cuts, bool ceilings,
              StructureMemo* memo = nullptr);  // used by the constructor only

  struct Room {
    RoomId id;
    std::shared_ptr<const idap::Room> room;
    std::size_t storey = 0;
    Regions plan;        // as drawn, repaired, without the walls
    Box2 box;            // of the plan
    Regions floor;       // what its floor covers: also a little under the walls; empty: no floor
    Regions doorsteps;   // floor in the openings beside it
    double ceiling = 0;  // world height of a flat ceiling
    bool sloped = false;
  };
  const std::vector<Room>& rooms() const { return rooms_; }

  // The floor of rooms()[index] with its slab, and its ceiling, relative to centre; null where there is none.
  std::shared_ptr<const Mesh> buildFloor(std::size_t index, Vec3 centre, StructureMemo* memo = nullptr) const;
  std::shared_ptr<const Mesh> buildCeiling(std::size_t index, Vec3 centre,
                                           StructureMemo* memo = nullptr) const;

  // True where the point of the plan lies in a room of the storey that has something over it.
  bool isIndoors(std::size_t storey, Vec2 point) const;
  // World height of the flat ceiling over a point of the storey, if there is one.
  std::optional<double> ceilingOver(std::size_t storey, Vec2 point) const;
  // The floor plan of a storey together with its walls; for what must not be covered by the ground.
  Regions footprint(std::size_t storey) const;

 private:
  std::optional<Room> planOf(RoomId id, const std::shared_ptr<const idap::Room>& room,
                             StructureMemo& memo) const;
  void layFloors(StructureMemo& memo);
  double reachUnderWalls(std::size_t storey) const;
  void layDoorsteps(StructureMemo& memo);
  void findCeilings();
  double flatCeiling(const Room& room) const;
  bool touchesSlope(const Room& room) const;
  bool goesOn(const StairHole& hole, std::size_t storey, double ceiling) const;
  Regions ceilingRegion(std::size_t index, StructureMemo& memo) const;
  void addSlopedCeiling(const Room& room, MeshSink& sink) const;

  const std::vector<Storey>& storeys_;
  const std::vector<WallSolid>& walls_;
  const std::vector<std::vector<WallCut>>& cuts_;
  std::vector<StairHole> holes_;
  std::vector<Room> rooms_;
  bool ceilings_;
};

}  // namespace idap
