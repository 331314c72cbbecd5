// Places by the room alone: its walls, its corners, its middle.
#include <algorithm>
#include <cmath>

#include "editor/tools/arrange/spots.h"
#include "model/room_geometry.h"

namespace idap {

namespace {

constexpr double kStep = 0.1;  // m between places that are tried along a wall

struct Edge {
  Vec2 from, along;  // unit; the room is to the left
  double length;
};

std::vector<Edge> edgesOf(const Polygon& area) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < area.size(); ++i) {
    const Vec2 by = area[(i + 1) % area.size()] - area[i];
    if (const double size = length(by); size > 0.05) edges.push_back({area[i], by / size, size});
  }
  return edges;
}

// The stretch of an edge that a rectangle near it takes, where it stands within reach of the edge.
bool standsAt(const Edge& edge, const Corners& corners, double reach, double& from, double& to) {
  double nearest = std::numeric_limits<double>::infinity();
  from = nearest;
  to = -nearest;
  for (const Vec2 p : corners) {
    const double s = dot(p - edge.from, edge.along);
    nearest = std::min(nearest, cross(edge.along, p - edge.from));
    from = std::min(from, s);
    to = std::max(to, s);
  }
  return nearest < reach && nearest > -0.5 && to > 0 && from < edge.length;
}

}  // namespace

std::vector<Spot> spotsAlongWalls(const RoomSpace& room, const Furniture& piece, Manner manner) {
  std::vector<Spot> spots;
  if (!room.closed) return spots;
  const double width = piece.size.x, depth = piece.size.y, half = width / 2;
  const std::vector<Edge> edges = edgesOf(room.area);
  double longest = 0;
  for (const Edge& edge : edges) longest = std::max(longest, edge.length);
  for (const Edge& edge : edges) {
    if (edge.length < width - 0.005) continue;
    // What stands along this wall already, and the doors and windows in it.
    std::vector<std::pair<double, double>> stands, ways, windows;
    double from = 0, to = 0;
    for (const RoomSpace::Standing& other : room.furniture)
      if (standsAt(edge, other.corners, depth, from, to)) stands.emplace_back(from, to);
    for (const RoomSpace::Hole& hole : room.openings) {
      const Opening& opening = *hole.opening;
      if (standsAt(edge, footprint(opening), 0.05, from, to))
        (hole.way ? ways : windows).emplace_back(from, to);
    }
    std::vector<double> places{half, edge.length / 2, edge.length - half};
    for (double s = half + kStep; s < edge.length - half; s += kStep) places.push_back(s);
    for (const auto* taken : {&stands, &ways, &windows})
      for (const auto& [low, high] : *taken) {
        places.push_back(low - half);
        places.push_back(high + half);
        places.push_back((low + high) / 2);
      }
    const double angle = std::atan2(edge.along.y, edge.along.x) + kPi;
    for (const double s : places) {
      if (s < half - 0.003 || s > edge.length - half + 0.003) continue;
      Spot spot;
      spot.middle = edge.from + edge.along * s + perpendicular(edge.along) * (depth / 2);
      spot.angle = std::remainder(angle, 2 * kPi);
      spot.z = piece.position.z;
      // Room to the left and right of it: to the corners, and to what stands there.
      double left = s - half, right = edge.length - s - half;
      for (const auto& [low, high] : stands) {
        if (high <= s) left = std::min(left, s - half - high);
        if (low >= s) right = std::min(right, low - s - half);
      }
      left = std::max(left, 0.0);
      right = std::max(right, 0.0);
      const double off = std::abs(s - edge.length / 2);
      const auto away = [&](const std::vector<std::pair<double, double>>& holes) {
        double nearest = 10;
        for (const auto& [low, high] : holes)
          nearest = std::min(nearest, std::max({low - s - half, s - half - high, 0.0}));
        return nearest;
      };
      switch (manner) {
        case Manner::Bed:
          if (width > 1.25) {
            // One gets in from both sides, and there is a place for night tables.
            spot.merit -= 2 * (std::max(0.0, 0.6 - left) + std::max(0.0, 0.6 - right)) + 0.4 * off;
          } else {
            spot.merit -= 0.5 * std::min(left, right);
          }
          if (!ways.empty()) spot.merit -= 0.8;
          if (!windows.empty()) spot.merit -= 0.4;
          break;
        case Manner::Sofa:
        case Manner::OnWall:
          spot.merit -= 0.4 * std::abs(left - right) / 2;
          if (manner == Manner::OnWall) spot.merit -= 0.3 * std::max(0.0, 0.3 - std::min(left, right));
          if (!ways.empty() && manner == Manner::Sofa) spot.merit -= 0.4;
          spot.merit += 0.1 * edge.length / longest;
          break;
        case Manner::Screen:
          spot.merit -= 0.3 * off;
          break;
        case Manner::Desk:
          spot.merit -= 0.15 * std::min(away(windows), 3.0) + 0.2 * std::min(left, right);
          break;
        default: {
          // Into a corner or up to its neighbour, and no gap that nobody can dust.
          const double gap = std::min(left, right), other = std::max(left, right);
          spot.merit -= 0.5 * std::min(gap, 2.0);
          for (const double g : {gap, other})
            if (g > 0.02 && g < 0.35) spot.merit -= 0.4;
          // Not the wall that something wider would want.
          spot.merit -= 0.25 * (edge.length - width) / longest;
          if (piece.size.z > 1.2) spot.merit -= 0.3 * std::max(0.0, 0.4 - away(ways));
        }
      }
      spots.push_back(spot);
    }
  }
  return spots;
}

std::vector<Spot> spotsInCorners(const RoomSpace& room, const Furniture& piece) {
  constexpr double kOff = 0.05;  // m: leaves and shades do not touch the walls
  std::vector<Spot> spots;
  if (!room.closed) return spots;
  const std::size_t n = room.area.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 corner = room.area[i], in = corner - room.area[(i + n - 1) % n],
               out = room.area[(i + 1) % n] - corner;
    if (length(in) < 0.3 || length(out) < 0.3 || cross(in, out) <= 0.2 * length(in) * length(out)) continue;
    const Vec2 along = normalized(out), back = normalized(in);
    Spot spot;
    // Its back to the wall that leaves the corner; in a right angle its side then touches the other.
    spot.middle = corner + along * (piece.size.x / 2 + kOff) - back * (piece.size.y / 2 + kOff);
    spot.angle = std::remainder(std::atan2(along.y, along.x) + kPi, 2 * kPi);
    spot.z = piece.position.z;
    spots.push_back(spot);
  }
  return spots;
}

std::vector<Spot> spotsAllOver(const RoomSpace& room, const Furniture& piece) {
  Room shape;
  shape.points = room.area;
  const Vec2 centre = roomCentre(shape);
  double longest = 0, angle = 0;
  for (const Edge& edge : edgesOf(room.area))
    if (edge.length > longest) {
      longest = edge.length;
      angle = std::atan2(edge.along.y, edge.along.x);
    }
  // Upright on the page rather than upside down.
  angle = std::remainder(angle, kPi);
  if (std::abs(std::abs(angle) - kPi / 2) < 1e-6) angle = kPi / 2;
  std::vector<Spot> spots;
  const Box2 box = bounds(room.area);
  const double step = std::max(0.1, std::max(box.max.x - box.min.x, box.max.y - box.min.y) / 40);
  const auto add = [&](Vec2 at) {
    for (const double turn : {0.0, kPi / 2}) {
      Spot spot;
      spot.middle = at;
      spot.angle = angle + turn;
      spot.z = piece.position.z;
      spot.merit = -length(at - centre) - (turn == 0 ? 0 : 0.2);
      spots.push_back(spot);
    }
  };
  add(centre);
  for (double x = box.min.x + step / 2; x < box.max.x; x += step)
    for (double y = box.min.y + step / 2; y < box.max.y; y += step) add({x, y});
  return spots;
}

}  // namespace idap
