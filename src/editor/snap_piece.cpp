// Where a piece comes to lie. Everything that could hold it is a line that its middle should be on: the best
// one first, then the best along that one.
#include <limits>

#include "editor/snap_support.h"
#include "model/edits/level_edits.h"
#include "model/wall_path.h"

namespace idap {

namespace {

constexpr double kAlongside = 1.0;  // m between pieces that still line up with each other
constexpr double kOverhang = 0.1;   // m that what stands on a table may reach beyond it
constexpr double kReachable = 1.7;  // m: on what is higher nobody puts things from above
constexpr double kTall = 0.8;       // m: what is taller stands on the floor, or on something low
constexpr double kLow = 0.3;        // m
constexpr double kThin = 0.03;      // m: a rug

enum Rank { AgainstWall, Touch, Edge, Centre, RoomCentre };

// normal . middle == target
struct Hold {
  Vec2 normal;
  double target;
  Rank rank;
  double edge;    // normal . x of the guide line
  double lo, hi;  // how far that goes beside the piece, along perpendicular(normal)
};

class PieceSnap {
 public:
  PieceSnap(const Editor& editor, const PieceSnapRequest& request)
      : home_(editor.home()), request_(request), piece_(request.piece) {}

  SnappedPiece onPlan() {
    if (request_.mayTurn && piece_.size.z > kThin) turnToWall();
    gatherWalls();
    gatherPieces();
    gatherRooms();
    settle();
    if (request_.mayStack && !request_.hangs) stack();
    return result();
  }

 private:
  // The wall face that the piece is near: a point of it and the direction into the room.
  struct Face {
    Vec2 point, normal, along;
    double from, to;  // of the wall, along `along` counted from point
    double away;      // of the piece's middle
  };
  std::vector<Face> facesAround(double reach) const {
    std::vector<Face> faces;
    const Vec2 at = planOf(piece_);
    for (const auto& [id, wall] : home_.walls) {
      if (wall->level != piece_.level || contains(request_.ignored, id)) continue;
      if (std::max(wall->heightAtStart, wall->heightAtEnd) <= piece_.position.z) continue;
      const WallPath path(*wall);
      const double s = path.nearest(at);
      const Vec2 line = path.point(s);
      if (length(line - at) > reach + wall->thickness / 2) continue;
      const Vec2 along = path.direction(s);
      const double side = dot(at - line, perpendicular(along)) >= 0 ? 1 : -1;
      const Vec2 normal = perpendicular(along) * side;
      const Vec2 face = line + normal * (wall->thickness / 2);
      faces.push_back({face, normal, along, -s, path.length() - s, dot(at - face, normal)});
    }
    return faces;
  }

  void turnToWall() {
    const double half = piece_.size.y / 2;
    const Face* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    const std::vector<Face> faces = facesAround(half + request_.tolerance);
    for (const Face& face : faces) {
      if (face.away > half + request_.tolerance) continue;
      // The wall that it has its back to already goes before another one, so that it does not flutter in a
      // corner.
      const Vec2 back = rotated(Vec2{0, 1}, request_.piece.angle);
      const double score =
          std::max(face.away, 0.0) - (dot(back, face.normal) < -0.99 ? request_.tolerance : 0);
      if (score < least) least = score, best = &face;
    }
    if (!best) return;
    const Vec2 back = -best->normal;
    piece_.angle = std::remainder(std::atan2(back.y, back.x) - kPi / 2, 2 * kPi);
    const Vec2 at = planOf(piece_) + best->normal * (half - best->away);
    piece_.position = {at.x, at.y, piece_.position.z};
    turned_ = true;
  }

  void gatherWalls() {
    const double reach = std::hypot(piece_.size.x, piece_.size.y) / 2 + request_.tolerance;
    for (const Face& face : facesAround(reach)) {
      const double half = halfExtent(piece_, face.normal), aside = halfExtent(piece_, face.along);
      if (aside < face.from || -aside > face.to) continue;
      const double edge = dot(face.normal, face.point);
      holds_.push_back({face.normal, edge + half, AgainstWall, edge, 1, -1});
    }
  }

  void gatherPieces() {
    const double reach = std::hypot(piece_.size.x, piece_.size.y) / 2 + kAlongside;
    forPiecesAround(home_, piece_.level, planOf(piece_), reach, request_.ignored, [this](const Piece& other) {
      if (!squareTo(piece_, other)) return;
      const bool meets = heightsMeet(piece_, other);
      const Vec2 between = planOf(piece_) - planOf(other);
      const Vec2 right = rotated(Vec2{1, 0}, other.angle);
      for (const Vec2 normal : {right, perpendicular(right)}) {
        const Vec2 side = perpendicular(normal);
        const double its = halfExtent(other, normal), mine = halfExtent(piece_, normal);
        const double gap = std::abs(dot(between, side)) - halfExtent(other, side) - halfExtent(piece_, side);
        const double away = std::abs(dot(between, normal)) - its - mine;
        const double middle = dot(normal, planOf(other));
        const double lo = dot(side, planOf(other)) - halfExtent(other, side);
        const double hi = dot(side, planOf(other)) + halfExtent(other, side);
        const double sign = dot(between, normal) >= 0 ? 1 : -1;
        if (meets && gap < request_.tolerance && away > -std::min(its, mine))
          holds_.push_back({normal, middle + sign * (its + mine), Touch, middle + sign * its, lo, hi});
        if (gap > kAlongside) continue;
        if (std::abs(its - mine) > 1e-6)
          for (const double edge : {-1.0, 1.0})
            holds_.push_back({normal, middle + edge * (its - mine), Edge, middle + edge * its, lo, hi});
        holds_.push_back({normal, middle, Centre, middle, lo, hi});
      }
    });
  }

  void gatherRooms() {
    const Vec2 at = planOf(piece_);
    for (const auto& [id, room] : home_.rooms) {
      if (room->level != piece_.level || !contains(room->points, at)) continue;
      const Box2 box = idap::bounds(room->points);
      // Without walls the edges of the room hold it as walls would.
      for (std::size_t i = 0; i < room->points.size(); ++i) {
        const Vec2 a = room->points[i], b = room->points[(i + 1) % room->points.size()];
        const double span = length(b - a);
        if (span < 1e-3) continue;
        const Vec2 along = (b - a) / span;
        Vec2 normal = perpendicular(along);
        if (signedArea(room->points) < 0) normal = -normal;
        const double s = dot(at - a, along), aside = halfExtent(piece_, along);
        if (s + aside < 0 || s - aside > span) continue;
        const double edge = dot(normal, a);
        holds_.push_back({normal, edge + halfExtent(piece_, normal), Touch, edge, 1, -1});
      }
      holds_.push_back({{1, 0},
                        (box.min.x + box.max.x) / 2,
                        RoomCentre,
                        (box.min.x + box.max.x) / 2,
                        box.min.y,
                        box.max.y});
      holds_.push_back({{0, 1},
                        (box.min.y + box.max.y) / 2,
                        RoomCentre,
                        (box.min.y + box.max.y) / 2,
                        -box.max.x,
                        -box.min.x});
    }
  }

  double reachOf(Rank rank) const {
    return rank == Centre       ? request_.tolerance * 0.6
           : rank == RoomCentre ? request_.tolerance * 0.5
                                : request_.tolerance;
  }

  void settle() {
    Vec2 at = planOf(piece_);
    const Hold* first = nullptr;
    double least = std::numeric_limits<double>::infinity();
    const auto score = [this](const Hold& hold, double move) {
      // A rank goes before another unless that one is much nearer.
      return std::abs(move) / request_.tolerance + 0.5 * static_cast<int>(hold.rank);
    };
    for (const Hold& hold : holds_) {
      const double move = hold.target - dot(hold.normal, at);
      if (std::abs(move) > reachOf(hold.rank) || score(hold, move) >= least) continue;
      least = score(hold, move);
      first = &hold;
    }
    if (!first) return;
    at += first->normal * (first->target - dot(first->normal, at));
    chosen_.push_back(*first);
    const Vec2 along = perpendicular(first->normal);
    const Hold* second = nullptr;
    double slide = 0;
    least = std::numeric_limits<double>::infinity();
    for (const Hold& hold : holds_) {
      const double slope = dot(along, hold.normal);
      if (std::abs(slope) < 0.3) continue;
      const double move = (hold.target - dot(hold.normal, at)) / slope;
      if (std::abs(move) > reachOf(hold.rank) || score(hold, move) >= least) continue;
      least = score(hold, move);
      second = &hold;
      slide = move;
    }
    if (second) {
      at += along * slide;
      chosen_.push_back(*second);
    }
    piece_.position = {at.x, at.y, piece_.position.z};
  }

  // On the highest thing under it that is large enough and not out of reach; else on the floor.
  void stack() {
    const Vec2 at = planOf(piece_);
    double height = 0;
    forPiecesAround(home_, piece_.level, at, 0, request_.ignored, [&](const Furniture& other) {
      const double top = other.position.z + other.dropOnTopHeight.value_or(other.size.z);
      if (top > kReachable || top <= height || other.dropOnTopHeight.value_or(0) < 0) return;
      if (piece_.size.z > kTall && top > kLow) return;
      const Vec2 off = rotated(at - planOf(other), -other.angle);
      Piece turned = piece_;
      turned.angle -= other.angle;
      const double beyondX = std::abs(off.x) + halfExtent(turned, {1, 0}) - other.size.x / 2;
      const double beyondY = std::abs(off.y) + halfExtent(turned, {0, 1}) - other.size.y / 2;
      const bool over = std::abs(off.x) <= other.size.x / 2 && std::abs(off.y) <= other.size.y / 2;
      if (!over || (top - other.position.z > kThin && std::max(beyondX, beyondY) > kOverhang)) return;
      height = top;
    });
    piece_.position.z = height;
    stacked_ = height > 0;
  }

  SnappedPiece result() const {
    SnappedPiece snapped{piece_.position, piece_.angle, turned_, stacked_, {}};
    const Vec2 at = planOf(piece_);
    for (const Hold& hold : chosen_) {
      const Vec2 along = perpendicular(hold.normal);
      const double middle = dot(along, at), aside = halfExtent(piece_, along);
      const double lo = std::min(middle - aside, hold.lo <= hold.hi ? hold.lo : middle);
      const double hi = std::max(middle + aside, hold.lo <= hold.hi ? hold.hi : middle);
      snapped.guides.push_back({hold.normal * hold.edge + along * lo, hold.normal * hold.edge + along * hi});
      snapped.onWall |=
          hold.rank == AgainstWall && dot(rotated(Vec2{0, 1}, piece_.angle), hold.normal) < -0.999;
    }
    return snapped;
  }

  const Home& home_;
  const PieceSnapRequest& request_;
  Piece piece_;
  std::vector<Hold> holds_, chosen_;
  bool turned_ = false, stacked_ = false;
};

Box2 boxOn(Plane plane, const Piece& piece, double elevation) {
  return bounds(outline(plane, piece, elevation));
}

// From the side: its left and right, its bottom and top, each by itself.
SnappedPiece fromTheSide(const Editor& editor, const PieceSnapRequest& request) {
  const Home& home = editor.home();
  const double floor = elevationOf(home, request.piece.level);
  const Box2 mine = boxOn(request.plane, request.piece, floor);
  const bool front = request.plane == Plane::XZ;
  const auto across = [front](const Piece& piece) { return front ? piece.position.y : piece.position.x; };
  const Vec2 sight = front ? Vec2{0, 1} : Vec2{1, 0};
  const double depth = halfExtent(request.piece, sight);

  struct Best {
    double move = 0, score = std::numeric_limits<double>::infinity();
    GuideLine guide;
  } best[2];
  const auto offer = [&](int axis, double from, double to, int rank, double lo, double hi) {
    const double move = to - from;
    if (std::abs(move) > request.tolerance) return;
    const double score = std::abs(move) / request.tolerance + 0.5 * rank;
    if (score >= best[axis].score) return;
    best[axis] = {move, score, axis == 0 ? GuideLine{{to, lo}, {to, hi}} : GuideLine{{lo, to}, {hi, to}}};
  };
  const auto around = [](double a, double b, double c, double d) {
    return std::pair{std::min(a, c), std::max(b, d)};
  };

  for (const double z : {floor, floor + ceilingHeight(home, request.piece.level)})
    offer(1, z == floor ? mine.min.y : mine.max.y, z, 0, mine.min.x, mine.max.x);
  for (const auto& [id, wall] : home.walls) {
    if (wall->level != request.piece.level || wall->arcExtent != 0 || contains(request.ignored, id)) continue;
    const Vec2 along = normalized(wall->end - wall->start);
    if (std::abs(dot(along, sight)) < 0.999) continue;
    const double from = dot(wall->start, sight), to = dot(wall->end, sight);
    if (across(request.piece) + depth < std::min(from, to) ||
        across(request.piece) - depth > std::max(from, to))
      continue;
    const double centre = front ? wall->start.x : wall->start.y;
    offer(0, mine.min.x, centre + wall->thickness / 2, 0, mine.min.y, mine.max.y);
    offer(0, mine.max.x, centre - wall->thickness / 2, 0, mine.min.y, mine.max.y);
  }
  const Vec2 at = planOf(request.piece);
  const double reach = std::hypot(request.piece.size.x, request.piece.size.y) / 2 + kAlongside;
  forPiecesAround(home, request.piece.level, at, reach, request.ignored, [&](const Furniture& other) {
    const Box2 its = boxOn(request.plane, other, floor);
    const bool sameDepth = std::abs(across(other) - across(request.piece)) < depth + halfExtent(other, sight);
    const auto [left, right] = around(mine.min.x, mine.max.x, its.min.x, its.max.x);
    const auto [low, high] = around(mine.min.y, mine.max.y, its.min.y, its.max.y);
    const bool overlapU = mine.min.x < its.max.x && its.min.x < mine.max.x;
    const bool overlapV = mine.min.y < its.max.y && its.min.y < mine.max.y;
    const int touch = sameDepth ? 0 : 2;
    if (overlapU) {
      const double top =
          other.dropOnTopHeight && *other.dropOnTopHeight > 0 && other.pitch == 0 && other.roll == 0
              ? floor + other.position.z + *other.dropOnTopHeight
              : its.max.y;
      offer(1, mine.min.y, top, touch, left, right);
      offer(1, mine.max.y, its.min.y, touch, left, right);
    }
    if (overlapV) {
      offer(0, mine.min.x, its.max.x, touch + (sameDepth ? 1 : 0), low, high);
      offer(0, mine.max.x, its.min.x, touch + (sameDepth ? 1 : 0), low, high);
    }
    offer(0, mine.min.x, its.min.x, 2, low, high);
    offer(0, mine.max.x, its.max.x, 2, low, high);
    offer(0, (mine.min.x + mine.max.x) / 2, (its.min.x + its.max.x) / 2, 3, low, high);
    offer(1, mine.max.y, its.max.y, 2, left, right);
    offer(1, mine.min.y, its.min.y, 2, left, right);
  });

  const Vec3 move = inWorld(request.plane, {best[0].move, best[1].move});
  SnappedPiece snapped{request.piece.position + move, request.piece.angle, false, false, {}};
  for (const Best& each : best)
    if (!std::isinf(each.score)) snapped.guides.push_back(each.guide);
  return snapped;
}

}  // namespace

SnappedPiece snapPiece(const Editor& editor, const PieceSnapRequest& request, bool off) {
  SnappedPiece snapped{request.piece.position, request.piece.angle, false, false, {}};
  if (off) return snapped;
  if (editor.settings().snapping) {
    snapped = request.plane == Plane::XY ? PieceSnap(editor, request).onPlan() : fromTheSide(editor, request);
    if (!snapped.guides.empty() || snapped.stacked) return snapped;
  }
  if (editor.settings().gridSnapping) {
    const double step = gridStep(request.tolerance / 2, editor.settings().unit);
    const Vec2 at = project(request.plane, snapped.position);
    const Vec2 on{std::round(at.x / step) * step, std::round(at.y / step) * step};
    snapped.position += inWorld(request.plane, on - at);
  }
  return snapped;
}

}  // namespace idap
