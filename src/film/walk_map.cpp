#include "film/walk_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "model/room_geometry.h"
#include "scene/opening_cut.h"
#include "scene/wall_solid.h"

namespace idap {

namespace {

constexpr double kMargin = 3.0;       // m around the home that can be walked on, too
constexpr double kComfort = 0.5;      // m to both sides; nearer to things it is walked less gladly
constexpr double kDoorHeight = 1.6;   // m; lower openings are windows or hatches
constexpr double kNearestEnd = 2.5;   // m from a point of view to where a person can stand
constexpr float kOutdoorCost = 6;     // a way through the garden is taken where there is no other
constexpr float kFurnitureCost = 40;  // over a bed, where nothing leads round it
constexpr double kEyeRoom = 0.12;     // m around a camera

// Rows of cells whose centres are in the polygon.
template <class Visit>
void scan(const std::vector<Vec2>& polygon, Vec2 origin, int width, int height, Visit&& visit) {
  std::vector<double> crossings;
  const Box2 box = bounds(polygon);
  const int first = std::max(0, static_cast<int>(std::floor((box.min.y - origin.y) / WalkMap::kCell)));
  const int last =
      std::min(height - 1, static_cast<int>(std::floor((box.max.y - origin.y) / WalkMap::kCell)));
  for (int y = first; y <= last; ++y) {
    const double line = origin.y + (y + 0.5) * WalkMap::kCell;
    crossings.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if ((a.y > line) == (b.y > line)) continue;
      crossings.push_back(a.x + (b.x - a.x) * (line - a.y) / (b.y - a.y));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const int from =
          std::max(0, static_cast<int>(std::ceil((crossings[i] - origin.x) / WalkMap::kCell - 0.5)));
      const int to = std::min(
          width - 1, static_cast<int>(std::floor((crossings[i + 1] - origin.x) / WalkMap::kCell - 0.5)));
      for (int x = from; x <= to; ++x) visit(x, y);
    }
  }
}

// Distance from every cell to the nearest marked one, in metres, by sweeping steps to eight neighbours.
std::vector<float> distances(const std::vector<std::uint8_t>& marked, int width, int height) {
  const auto at = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  };
  constexpr float kStraight = static_cast<float>(WalkMap::kCell), kDiagonal = kStraight * 1.41421356f;
  std::vector<float> d(marked.size());
  for (std::size_t i = 0; i < marked.size(); ++i) d[i] = marked[i] ? 0.0f : 1e6f;
  const auto relax = [&](int x, int y, int dx, int dy, float step) {
    const int nx = x + dx, ny = y + dy;
    if (nx >= 0 && ny >= 0 && nx < width && ny < height)
      d[at(x, y)] = std::min(d[at(x, y)], d[at(nx, ny)] + step);
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      relax(x, y, -1, 0, kStraight), relax(x, y, 0, -1, kStraight);
      relax(x, y, -1, -1, kDiagonal), relax(x, y, 1, -1, kDiagonal);
    }
  for (int y = height - 1; y >= 0; --y)
    for (int x = width - 1; x >= 0; --x) {
      relax(x, y, 1, 0, kStraight), relax(x, y, 0, 1, kStraight);
      relax(x, y, 1, 1, kDiagonal), relax(x, y, -1, 1, kDiagonal);
    }
  return d;
}

}  // namespace

double floorBelow(const Home& home, double eyeHeight) {
  double floor = -std::numeric_limits<double>::infinity(), lowest = std::numeric_limits<double>::infinity();
  for (const Storey& storey : shownStoreys(home, true)) {
    lowest = std::min(lowest, storey.elevation);
    if (storey.elevation <= eyeHeight - 0.4) floor = std::max(floor, storey.elevation);
  }
  return std::isfinite(floor) ? floor : std::isfinite(lowest) ? lowest : 0;
}

int WalkMap::column(double x) const { return static_cast<int>(std::floor((x - origin_.x) / kCell)); }
int WalkMap::row(double y) const { return static_cast<int>(std::floor((y - origin_.y) / kCell)); }
Vec2 WalkMap::centre(int x, int y) const { return origin_ + Vec2{(x + 0.5) * kCell, (y + 0.5) * kCell}; }

WalkMap::WalkMap(const Home& home, double floor) {
  const std::vector<Storey> storeys = shownStoreys(home, true);
  const std::vector<WallSolid> walls = wallSolids(home, storeys);
  const auto onFloor = [&](LevelId level) { return std::abs(elevationOf(home, level) - floor) < 0.05; };

  Box2 box;
  for (const WallSolid& wall : walls) box.add(wall.box.min), box.add(wall.box.max);
  for (const auto& [id, room] : home.rooms)
    for (const Vec2& p : room->points) box.add(p);
  for (const auto& [id, camera] : home.cameras) box.add({camera->eye.x, camera->eye.y});
  if (home.observer) box.add({home.observer->eye.x, home.observer->eye.y});
  if (box.empty()) {
    for (const auto& [id, piece] : home.furniture) box.add({piece->position.x, piece->position.y});
    box.add({-3, -3}), box.add({3, 3});
  }
  // A mistyped kilometre must not become a grid of as many cells.
  const Vec2 middle = (box.min + box.max) * 0.5;
  constexpr double kLargest = 60;
  box.min = {std::max(box.min.x, middle.x - kLargest), std::max(box.min.y, middle.y - kLargest)};
  box.max = {std::min(box.max.x, middle.x + kLargest), std::min(box.max.y, middle.y + kLargest)};
  origin_ = box.min - Vec2{kMargin, kMargin};
  width_ = static_cast<int>(std::ceil((box.max.x - box.min.x + 2 * kMargin) / kCell));
  height_ = static_cast<int>(std::ceil((box.max.y - box.min.y + 2 * kMargin) / kCell));
  const std::size_t cells = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  double ground = storeys.empty() ? 0 : storeys.front().elevation;
  for (const Storey& storey : storeys)
    if (std::abs(storey.elevation) < std::abs(ground)) ground = storey.elevation;
  // Beside an upper floor there is air.
  kind_.assign(cells, std::abs(floor - ground) < 0.6 ? Outdoors : Solid);
  indoors_.assign(cells, 0);

  bool anyRoom = false;
  for (const auto& [id, room] : home.rooms) {
    if (!onFloor(room->level) || !room->floorVisible) continue;
    anyRoom = true;
    markIndoors(room->points);
  }
  std::set<LevelId> levels;
  for (const Storey& storey : storeys)
    if (std::abs(storey.elevation - floor) < 0.05) levels.insert(storey.id);
  for (const LevelId level : levels)
    if (!anyRoom || std::abs(floor - ground) < 0.6)
      for (const Polygon& area : closedAreas(home, level)) markIndoors(area);

  // What stands on the floor or hangs in the way; the piece's box, as the plan shows it.
  for (const auto& [id, piece] : home.furniture) {
    if (!isShownOn(home, storeys, *piece) || !isFinite(piece->position) || !isFinite(piece->size)) continue;
    const double base = elevationOf(home, piece->level) + piece->position.z - floor;
    const double top = base + piece->size.z;
    if (top < kStep || base > kHead) continue;
    const auto corners = footprint(*piece);
    paint({corners.begin(), corners.end()}, top < 1.2 ? Low : Solid);
  }
  for (const auto& [id, piece] : home.furniture) {
    // The hole of stairs that come up from below.
    if (piece->staircaseCutOut.empty() || !isShownOn(home, storeys, *piece)) continue;
    const double base = elevationOf(home, piece->level) + piece->position.z;
    if (base > floor - 1 || base + piece->size.z < floor - 0.5 || base + piece->size.z > floor + 1.5)
      continue;
    const auto corners = footprint(*piece);
    paint({corners.begin(), corners.end()}, Solid);
  }
  for (const WallSolid& wall : walls) {
    const double top = std::max(wall.wall->heightAtStart, wall.wall->heightAtEnd) + wall.floor + wall.raised;
    if (wall.floor > floor + kHead || top < floor + kStep) continue;
    paint(wall.polygon, Solid);
  }
  for (const OpeningCut& cut : openingCuts(home, storeys)) {
    const auto& opening = *home.openings.find(cut.id);
    const bool door = opening.kind != OpeningKind::Window;
    if (!door || std::abs(cut.sill - floor) > 0.3 || cut.box.max.y - cut.sill < kDoorHeight) continue;
    double low = cut.v0, high = cut.v1;
    for (const WallSolid& wall : walls) {
      // The hole is as deep as the wall.
      const auto cuts = cutsOf(wall, {cut});
      if (cuts.empty()) continue;
      double from = 0, to = 0;
      if (wallSpanAt(wall, cut, (cut.box.min.x + cut.box.max.x) / 2, from, to))
        low = std::min(low, from), high = std::max(high, to);
    }
    const double u0 = cut.box.min.x + 0.03, u1 = cut.box.max.x - 0.03;
    const double v0 = low - kCell, v1 = high + kCell;
    const std::vector<Vec2> passage{cut.plan(u0, v0), cut.plan(u1, v0), cut.plan(u1, v1), cut.plan(u0, v1)};
    scan(passage, origin_, width_, height_, [&](int x, int y) {
      if (kind_[at(x, y)] == Solid) kind_[at(x, y)] = Open;
    });
    markIndoors(passage);
    doors_.push_back({cut.id, passage});
  }
  for (std::size_t i = 0; i < cells; ++i)
    if (kind_[i] == Open && !indoors_[i]) kind_[i] = Outdoors;
  measureClearance();
}

void WalkMap::paint(const std::vector<Vec2>& polygon, Kind kind) {
  scan(polygon, origin_, width_, height_,
       [&](int x, int y) { kind_[at(x, y)] = std::max(kind_[at(x, y)], kind); });
}

void WalkMap::markIndoors(const std::vector<Vec2>& polygon) {
  scan(polygon, origin_, width_, height_, [&](int x, int y) {
    Kind& kind = kind_[at(x, y)];
    // Before furniture and walls are painted, everything else is outdoors or air.
    if (!indoors_[at(x, y)] && kind != Low) kind = Open;
    indoors_[at(x, y)] = 1;
  });
}

void WalkMap::measureClearance() {
  std::vector<std::uint8_t> any(kind_.size()), solid(kind_.size());
  for (std::size_t i = 0; i < kind_.size(); ++i) {
    any[i] = kind_[i] >= Low;
    solid[i] = kind_[i] == Solid;
  }
  clearance_ = distances(any, width_, height_);
  solid_ = distances(solid, width_, height_);
}

bool WalkMap::indoors(Vec2 p) const {
  const int x = column(p.x), y = row(p.y);
  return inside(x, y) && indoors_[at(x, y)];
}

double WalkMap::clearance(Vec2 p) const {
  const int x = column(p.x), y = row(p.y);
  return inside(x, y) ? static_cast<double>(clearance_[at(x, y)]) : 0;
}

bool WalkMap::free(Vec2 p) const { return clearance(p) >= kBodyRadius - 1e-6; }

bool WalkMap::seeable(Vec2 p) const {
  const int x = column(p.x), y = row(p.y);
  return inside(x, y) && static_cast<double>(solid_[at(x, y)]) >= kEyeRoom;
}

bool WalkMap::lineHolds(Vec2 a, Vec2 b, double least) const {
  const double far = length(b - a);
  const int steps = std::max(1, static_cast<int>(std::ceil(far / (kCell / 2))));
  for (int i = 0; i <= steps; ++i)
    if (clearance(a + (b - a) * (double(i) / steps)) < least - 1e-6) return false;
  return true;
}

bool WalkMap::freeLine(Vec2 a, Vec2 b) const { return lineHolds(a, b, kBodyRadius); }

std::optional<WalkMap::Way> WalkMap::way(Vec2 from, Vec2 to) const {
  const bool garden = !indoors(from) || !indoors(to);
  // What a step onto a cell costs, as a multiple of its length; 0: not at all.
  const auto cost = [&](std::size_t i) -> float {
    if (double(solid_[i]) < kBodyRadius) return 0;
    float c = 1;
    if (kind_[i] == Outdoors && !indoors_[i]) {
      if (!garden) return 0;
      c = kOutdoorCost;
    }
    if (double(clearance_[i]) < kBodyRadius) c *= kFurnitureCost;
    const float tight = static_cast<float>(std::max(0.0, 1 - double(clearance_[i]) / kComfort));
    return c * (1 + 3 * tight * tight);
  };
  // Where to stand nearest to a point of view.
  const auto nearest = [&](Vec2 p) -> std::optional<std::pair<int, int>> {
    std::optional<std::pair<int, int>> best;
    double least = kNearestEnd;
    const int reach = static_cast<int>(kNearestEnd / kCell), cx = column(p.x), cy = row(p.y);
    for (int y = cy - reach; y <= cy + reach; ++y)
      for (int x = cx - reach; x <= cx + reach; ++x) {
        if (!inside(x, y) || cost(at(x, y)) == 0) continue;
        double far = length(centre(x, y) - p);
        if (double(clearance_[at(x, y)]) < kBodyRadius) far += 0.3;  // rather beside a bed than on it
        if (indoors_[at(x, y)] != indoors(p)) far += 1;
        if (far >= least) continue;
        // Not through a wall.
        bool clear = true;
        const int steps = std::max(1, static_cast<int>(far / kCell));
        for (int i = 1; i < steps && clear; ++i) {
          const Vec2 q = p + (centre(x, y) - p) * (double(i) / steps);
          const int qx = column(q.x), qy = row(q.y);
          clear = !inside(qx, qy) || kind_[at(qx, qy)] != Solid;
        }
        if (clear) least = far, best = {x, y};
      }
    return best;
  };
  const auto start = nearest(from), goal = nearest(to);
  if (!start || !goal) return std::nullopt;

  std::vector<float> spent(kind_.size(), std::numeric_limits<float>::infinity());
  std::vector<std::uint32_t> before(kind_.size(), 0);
  using Entry = std::pair<float, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto ahead = [&](int x, int y) {
    const float dx = static_cast<float>(std::abs(x - goal->first)),
                dy = static_cast<float>(std::abs(y - goal->second));
    return static_cast<float>(kCell) * (std::max(dx, dy) + 0.41421356f * std::min(dx, dy));
  };
  const auto first = static_cast<std::uint32_t>(at(start->first, start->second));
  const auto last = static_cast<std::uint32_t>(at(goal->first, goal->second));
  spent[first] = 0;
  open.push({ahead(start->first, start->second), first});
  std::vector<std::uint8_t> closed(kind_.size(), 0);
  while (!open.empty()) {
    const std::uint32_t here = open.top().second;
    open.pop();
    if (here == last) break;
    if (std::exchange(closed[here], std::uint8_t{1})) continue;
    const int x = static_cast<int>(here) % width_, y = static_cast<int>(here) / width_;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        if ((!dx && !dy) || !inside(x + dx, y + dy)) continue;
        const std::size_t next = at(x + dx, y + dy);
        const float c = cost(next);
        if (c == 0 || closed[next]) continue;
        const float g = spent[here] + c * static_cast<float>(kCell) * (dx && dy ? 1.41421356f : 1.0f);
        if (g >= spent[next]) continue;
        spent[next] = g;
        before[next] = here;
        open.push({g + ahead(x + dx, y + dy), static_cast<std::uint32_t>(next)});
      }
  }
  if (!std::isfinite(spent[last])) return std::nullopt;

  Way found;
  std::vector<Vec2> cells;
  for (std::uint32_t here = last;; here = before[here]) {
    cells.push_back(centre(static_cast<int>(here) % width_, static_cast<int>(here) / width_));
    found.overFurniture |= double(clearance_[here]) < kBodyRadius;
    if (here == first) break;
  }
  std::reverse(cells.begin(), cells.end());
  found.points.push_back(from);
  for (const Vec2& p : simplified(cells))
    if (length(p - found.points.back()) > 2 * kCell) found.points.push_back(p);
  if (length(to - found.points.back()) < 2 * kCell && found.points.size() > 1) found.points.pop_back();
  found.points.push_back(to);
  return found;
}

// Leaves out what lies on a straight line, as long as the line keeps nearly as far from things as the way
// does.
std::vector<Vec2> WalkMap::simplified(const std::vector<Vec2>& cells) const {
  std::vector<Vec2> few{cells.front()};
  constexpr std::size_t kLongest = 80;  // cells
  for (std::size_t i = 0; i + 1 < cells.size();) {
    std::size_t best = i + 1;
    double least = clearance(cells[i]);
    for (std::size_t j = i + 1; j < cells.size() && j <= i + kLongest; ++j) {
      least = std::min(least, clearance(cells[j]));
      if (lineHolds(cells[i], cells[j], std::min(least, kComfort) - kCell)) best = j;
    }
    few.push_back(cells[best]);
    i = best;
  }
  return few;
}

std::set<OpeningId> WalkMap::doorsOn(const std::vector<Vec2>& line) const {
  std::set<OpeningId> passed;
  for (const Door& door : doors_)
    for (std::size_t i = 0; i + 1 < line.size() && !passed.contains(door.id); ++i) {
      const double far = length(line[i + 1] - line[i]);
      const int steps = std::max(1, static_cast<int>(far / 0.02));
      for (int k = 0; k <= steps; ++k)
        if (contains(door.passage, line[i] + (line[i + 1] - line[i]) * (double(k) / steps))) {
          passed.insert(door.id);
          break;
        }
    }
  return passed;
}

}  // namespace idap
