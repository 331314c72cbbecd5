// Where a person can stand and walk on one storey, as a grid of small squares, and the way between two
// points: by A*
// @cite hart1968astar, through doors, round furniture, keeping to the middle of passages. Plan space, metres.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "geometry/box.h"
#include "model/home.h"

namespace idap {

class WalkMap {
 public:
  static constexpr double kCell = 0.05;
  static constexpr double kBodyRadius = 0.2;  // m that a person needs on each side
  static constexpr double kStep = 0.22;       // m; lower things are walked over
  static constexpr double kHead = 1.85;       // m; what hangs higher is walked under

  // floor: of the storey to walk on, world height.
  WalkMap(const Home& home, double floor);

  struct Way {
    std::vector<Vec2> points;    // from the first to the last, few, with free sight between neighbours
    bool overFurniture = false;  // no free way round: it leads over something low
  };
  // None where nothing leads there. The ends may be in corners that are too tight to walk into.
  std::optional<Way> way(Vec2 from, Vec2 to) const;

  bool indoors(Vec2 p) const;
  // A person fits there.
  bool free(Vec2 p) const;
  // The same for the straight line.
  bool freeLine(Vec2 a, Vec2 b) const;
  // m to the nearest thing that a person at p would touch; 0 inside one.
  double clearance(Vec2 p) const;
  // No wall and nothing as high as the eye is within a hand's breadth: a camera fits there.
  bool seeable(Vec2 p) const;

  // Doors that the line goes through.
  std::set<OpeningId> doorsOn(const std::vector<Vec2>& line) const;

 private:
  enum Kind : std::uint8_t { Open, Outdoors, Low, Solid };
  struct Door {
    OpeningId id;
    std::vector<Vec2> passage;
  };

  void paint(const std::vector<Vec2>& polygon, Kind kind);
  void markIndoors(const std::vector<Vec2>& polygon);
  void measureClearance();
  bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  int column(double x) const;
  int row(double y) const;
  Vec2 centre(int x, int y) const;
  bool lineHolds(Vec2 a, Vec2 b, double least) const;
  std::vector<Vec2> simplified(const std::vector<Vec2>& cells) const;

  Vec2 origin_;
  int width_ = 0, height_ = 0;
  std::vector<Kind> kind_;
  std::vector<std::uint8_t> indoors_;
  std::vector<float> clearance_;  // m to anything but the open floor
  std::vector<float> solid_;      // m to walls and high things
  std::vector<Door> doors_;
};

// The storey a point of view is on: the highest whose floor is at least 0.4 m below the eye; world height of
// it.
double floorBelow(const Home& home, double eyeHeight);

}  // namespace idap
