// Ends of walls that move together: corners shared by several walls follow as one, and ends that lie on
// another wall slide along it.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "model/edits/motion.h"
#include "model/edits/wall_edits.h"

namespace idap {

class WallMove {
 public:
  explicit WallMove(const Home& home) : home_(home) {}

  // An end of an existing wall goes to a place of its own.
  void set(WallId id, WallEnd end, Vec2 to);
  // Whole walls move; their ends on walls that do not move slide along these.
  void move(const std::vector<WallId>& ids, const Motion& motion);

  // The home with these walls, all that is joined to them, and the doors and windows in them.
  Home applied();

 private:
  struct Moved {
    Wall wall;
    std::array<bool, 2> set{};  // by WallEnd
    bool rigid = false;         // its openings take part in the motion as they are
  };

  Moved& entry(WallId id);
  void place(WallId id, WallEnd end, Vec2 to);
  void followCorner(WallId id, WallEnd end);
  void followStems(WallId id);

  const Home& home_;
  Motion motion_;
  std::map<WallId, Moved> moved_;
  std::vector<WallId> waiting_;  // walls whose new shape others have to follow
};

}  // namespace idap
