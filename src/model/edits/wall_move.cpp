#include "model/edits/wall_move.h"

#include <algorithm>
#include <optional>
#include <set>

#include "base/error.h"
#include "model/edits/wall_ends.h"
#include "model/wall_path.h"

namespace idap {

namespace {

constexpr double kParallel = 0.05;  // sine of the angle under which lines do not meet usefully

Vec2 directionAt(const Wall& wall, WallEnd end) {
  const WallPath path(wall);
  return path.direction(end == WallEnd::Start ? 0 : path.length());
}

// Where on a wall an end of another wall lies, which it meets at an angle in its midst.
struct Foot {
  double along = 0;   // fraction of the wall's length
  double offset = 0;  // m to the left of its centre line
};
std::optional<Foot> footOn(const WallPath& path, const Wall& wall, const Wall& stem, WallEnd end) {
  const Vec2 p = endPoint(stem, end);
  if (samePlace(p, wall.start) || samePlace(p, wall.end)) return std::nullopt;
  const double distance = path.nearest(p);
  const Vec2 between = p - path.point(distance);
  if (length(between) > wall.thickness / 2 + kSamePlace) return std::nullopt;
  if (distance < kSamePlace || distance > path.length() - kSamePlace) return std::nullopt;
  const Vec2 direction = path.direction(distance);
  if (std::abs(cross(directionAt(stem, end), direction)) < kParallel) return std::nullopt;
  return Foot{distance / path.length(), dot(between, perpendicular(direction))};
}

// Where a line meets the line beside a straight wall, if it does so between the wall's ends.
std::optional<Vec2> meeting(Vec2 from, Vec2 direction, const Wall& wall, double offset) {
  if (wall.arcExtent != 0) return std::nullopt;
  const Vec2 along = wall.end - wall.start;
  const double whole = length(along);
  if (!(whole > 0)) return std::nullopt;
  const Vec2 unit = along / whole;
  const double turn = cross(direction, unit);
  if (std::abs(turn) < kParallel) return std::nullopt;
  const Vec2 start = wall.start + perpendicular(unit) * offset;
  const double s = cross(start - from, unit) / turn;
  const Vec2 p = from + direction * s;
  const double at = dot(p - start, unit);
  if (at < -kSamePlace || at > whole + kSamePlace) return std::nullopt;
  return p;
}

}  // namespace

WallMove::Moved& WallMove::entry(WallId id) {
  const auto found = moved_.find(id);
  if (found != moved_.end()) return found->second;
  const Wall* wall = home_.walls.find(id);
  if (!wall) throw InvalidHome("wall " + std::to_string(id.value) + " does not exist");
  return moved_.emplace(id, Moved{*wall, {}, false}).first->second;
}

void WallMove::place(WallId id, WallEnd end, Vec2 to) {
  Moved& moved = entry(id);
  endPoint(moved.wall, end) = to;
  moved.set[static_cast<std::size_t>(end)] = true;
  waiting_.push_back(id);
}

void WallMove::set(WallId id, WallEnd end, Vec2 to) { place(id, end, to); }

void WallMove::move(const std::vector<WallId>& ids, const Motion& motion) {
  motion_ = motion;
  const std::set<WallId> chosen(ids.begin(), ids.end());
  for (const WallId id : chosen) {
    const Wall* wall = home_.walls.find(id);
    if (!wall) continue;
    Moved& moved = entry(id);
    motion(moved.wall);
    moved.set = {true, true};
    moved.rigid = true;
    waiting_.push_back(id);
    if (wall->arcExtent != 0) continue;
    const Vec2 direction = normalized(moved.wall.end - moved.wall.start);
    for (const WallEnd end : {WallEnd::Start, WallEnd::End})
      for (const auto& [otherId, other] : home_.walls) {
        if (other->level != wall->level || chosen.contains(otherId)) continue;
        const auto foot = footOn(WallPath(*other), *other, *wall, end);
        if (!foot) continue;
        const auto slid = meeting(endPoint(moved.wall, end), direction, *other, foot->offset);
        if (!slid) continue;
        if (length(*slid - endPoint(moved.wall, end)) > 1e-9) {
          endPoint(moved.wall, end) = *slid;
          moved.rigid = false;
        }
        break;
      }
  }
}

void WallMove::followCorner(WallId id, WallEnd end) {
  const Wall& before = *home_.walls.find(id);
  const Vec2 from = endPoint(before, end), to = endPoint(moved_.at(id).wall, end);
  if (from == to) return;
  for (const auto& [otherId, other] : home_.walls) {
    if (otherId == id || other->level != before.level) continue;
    const bool joined = neighbour(before, end) == otherId;
    const WallEnd nearer =
        length(other->start - from) <= length(other->end - from) ? WallEnd::Start : WallEnd::End;
    // Joined walls of files may miss each other by a little.
    const double reach = joined ? std::max(before.thickness, other->thickness) : kSamePlace;
    if (length(endPoint(*other, nearer) - from) > reach) continue;
    const auto found = moved_.find(otherId);
    if (found != moved_.end() && found->second.set[static_cast<std::size_t>(nearer)]) continue;
    place(otherId, nearer, to);
  }
}

void WallMove::followStems(WallId id) {
  const Wall& before = *home_.walls.find(id);
  const Wall after = moved_.at(id).wall;
  const WallPath from(before), to(after);
  for (const auto& [stemId, stem] : home_.walls) {
    if (stemId == id || stem->level != before.level) continue;
    for (const WallEnd end : {WallEnd::Start, WallEnd::End}) {
      const auto found = moved_.find(stemId);
      if (found != moved_.end() && found->second.set[static_cast<std::size_t>(end)]) continue;
      const auto foot = footOn(from, before, *stem, end);
      if (!foot) continue;
      // It grows or shrinks along its own line, or else keeps its place in the wall.
      std::optional<Vec2> at;
      if (stem->arcExtent == 0)
        at = meeting(endPoint(*stem, end), directionAt(*stem, end), after, foot->offset);
      if (!at) {
        const double distance = foot->along * to.length();
        at = to.point(distance) + perpendicular(to.direction(distance)) * foot->offset;
      }
      if (length(*at - endPoint(*stem, end)) > 1e-9) place(stemId, end, *at);
    }
  }
}

Home WallMove::applied() {
  // A wall waits once for each of its ends at most, so this comes to an end.
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    const WallId id = waiting_[i];
    for (const WallEnd end : {WallEnd::Start, WallEnd::End})
      if (moved_.at(id).set[static_cast<std::size_t>(end)]) followCorner(id, end);
    followStems(id);
  }
  Home next = home_;
  std::set<WallId> rigid;
  for (const auto& [id, moved] : moved_) {
    if (moved.rigid) {
      rigid.insert(id);
      next.walls.set(id, moved.wall);
      continue;
    }
    const Wall& before = *home_.walls.find(id);
    const bool startStays = samePlace(before.start, moved.wall.start);
    next = replaceWall(next, id, moved.wall, startStays ? WallEnd::Start : WallEnd::End);
  }
  if (!rigid.empty())
    for (const auto& [id, opening] : home_.openings) {
      if (!rigid.contains(opening->wall)) continue;
      Opening moved = *opening;
      motion_(static_cast<Piece&>(moved));
      moved.position.z = opening->position.z;
      next.openings.set(id, std::move(moved));
    }
  return next;
}

}  // namespace idap
