// Doors and windows jump into walls.
#include <algorithm>
#include <limits>

#include "editor/snap.h"
#include "model/wall_outline.h"
#include "model/wall_path.h"

namespace idap {

namespace {

struct Span {
  double from, to;
};

// Where along the wall the middle of something half wide may be: within its length, clear of what else stands
// in it, as near to the wanted place as can be.
double freePlace(double wanted, double half, double low, double high, std::vector<Span> taken) {
  if (high - low < 2 * half) return (low + high) / 2;
  low += half;
  high -= half;
  const double clamped = std::clamp(wanted, low, high);
  double best = clamped, bestOff = std::numeric_limits<double>::infinity();
  const auto blocked = [&](double s) {
    return std::any_of(taken.begin(), taken.end(), [s, half](const Span& span) {
      return s + half > span.from + 1e-6 && s - half < span.to - 1e-6;
    });
  };
  if (!blocked(clamped)) return clamped;
  for (const Span& span : taken)
    for (const double s : {span.from - half, span.to + half})
      if (s >= low - 1e-9 && s <= high + 1e-9 && !blocked(s) && std::abs(s - wanted) < bestOff) {
        best = s;
        bestOff = std::abs(s - wanted);
      }
  return best;
}

}  // namespace

std::optional<Opening> snapOpening(const Editor& editor, Opening opening, Vec2 at, double reach,
                                   const Elements& ignored) {
  const Home& home = editor.home();
  const Wall* host = nullptr;
  double nearest = std::numeric_limits<double>::infinity();
  WallId hostId;
  for (const auto& [id, wall] : home.walls) {
    if (wall->level != opening.level || contains(ignored, id)) continue;
    const WallPath path(*wall);
    // From the wall's body: of two walls the one that the pointer is in counts, thick or thin.
    const double off = length(path.point(path.nearest(at)) - at) - wall->thickness / 2;
    if (off > reach) continue;
    const double score = std::max(off, 0.0) + (id == opening.wall ? -1e-6 : 0);
    if (score < nearest) nearest = score, host = wall.get(), hostId = id;
  }
  if (!host) return {};

  const WallPath path(*host);
  const double wanted = path.nearest(at);
  const bool toLeft = dot(at - path.point(wanted), perpendicular(path.direction(wanted))) > 0;

  // At a corner the neighbour's body takes half its thickness of the room side.
  double low = 0, high = path.length();
  if (const Wall* other = home.walls.find(host->neighbourAtStart)) low += other->thickness / 2;
  if (const Wall* other = home.walls.find(host->neighbourAtEnd)) high -= other->thickness / 2;
  if (high - low < opening.size.x) low = 0, high = path.length();

  std::vector<Span> taken;
  for (const auto& [id, other] : home.openings) {
    if (other->wall != hostId || contains(ignored, id)) continue;
    const bool above = other->position.z >= opening.position.z + opening.size.z - 1e-6 ||
                       opening.position.z >= other->position.z + other->size.z - 1e-6;
    if (above) continue;
    const double s = path.nearest({other->position.x, other->position.y});
    taken.push_back({s - other->size.x / 2, s + other->size.x / 2});
  }
  const double along = freePlace(wanted, opening.size.x / 2, low, high, taken);

  const Vec2 direction = path.direction(along);
  opening.wall = hostId;
  // Its front faces -y of its own; the side of the pointer is where a door opens to.
  opening.angle = std::remainder(std::atan2(direction.y, direction.x) + (toLeft ? kPi : 0), 2 * kPi);
  const double part = std::clamp(opening.wallThickness, 0.0, 1.0);
  if (part > 0.05) {
    double depth = host->thickness / part;
    if (!opening.model.catalogId.empty())
      if (const CatalogPiecePtr piece = editor.catalog().find(opening.model.catalogId)) {
        if (piece->minSize.y > 0) depth = std::max(depth, piece->minSize.y);
        if (piece->maxSize.y > 0) depth = std::min(depth, piece->maxSize.y);
      }
    opening.size.y = depth;
  }
  // The middle of the part that sits in the wall lies on its centre line.
  const double middle = opening.size.y * (0.5 - opening.wallDistance - part / 2);
  const Vec2 place = path.point(along) - rotated(Vec2{0, middle}, opening.angle);
  const double top = wallHeightAt(*host, path.point(along));
  double sill = opening.position.z;
  if (sill > 0 && sill + opening.size.z > top) sill = std::max(0.0, top - opening.size.z);
  opening.position = {place.x, place.y, sill};
  return opening;
}

}  // namespace idap
