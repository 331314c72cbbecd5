// What changed between two homes, in O(changed + containers). Scene, plans and panels all use it.
#pragma once

#include <vector>

#include "model/home.h"

namespace idap {

template <class IdType>
struct Changes {
  std::vector<IdType> added, removed, changed;
  bool empty() const { return added.empty() && removed.empty() && changed.empty(); }
};

struct HomeDiff {
  Changes<LevelId> levels;
  Changes<WallId> walls;
  Changes<RoomId> rooms;
  Changes<OpeningId> openings;
  Changes<FurnitureId> furniture;
  Changes<GroupId> groups;
  Changes<CameraId> cameras;
  Changes<DimensionId> dimensions;
  Changes<LabelId> labels;
  Changes<PolylineId> polylines;
  Changes<PictureId> pictures;
  bool site = false, environment = false;
  bool texts = false;   // name, title, notes, currency, height of new walls, properties
  bool assets = false;  // the set of files is another one, perhaps with equal files
  bool backgrounds = false;
  bool empty() const;
};

HomeDiff diff(const Home& before, const Home& after);

}  // namespace idap
