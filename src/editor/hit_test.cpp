#include "editor/hit_test.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "editor/hit_test_shapes.h"

namespace idap {

namespace {

// What a click means first: thin things, which are hard to hit, before bodies before areas.
enum class Rank { Thin, Body, Wall, Cone, Room };

struct Hit {
  AnyId id;
  Rank rank;
  double order;  // ascending within a rank
};

bool covers(const Polygon& polygon, Vec2 at, double tolerance) {
  return contains(polygon, at) || (tolerance > 0 && distanceToPath(polygon, true, at) <= tolerance);
}

// No point of the piece's box is further from its middle.
double reach(const Piece& piece) { return length(piece.size) / 2; }

Vec3 middle(const Piece& piece, double elevation) {
  return piece.position + Vec3{0, 0, elevation + piece.size.z / 2};
}

class HitTest {
 public:
  HitTest(const Editor& editor, Plane plane)
      : editor_(editor), home_(editor.home()), plane_(plane), floor_(editor.elevation()) {
    if (plane != Plane::XY) section_ = sectionNearness(home_, editor.level(), plane);
  }

  std::vector<Hit> at(Vec2 p, double tolerance) const {
    std::vector<Hit> hits;
    const bool base = !editor_.settings().baseLocked;
    if (base) {
      openingsAt(p, tolerance, hits);
      wallsAt(p, tolerance, hits);
      dimensionsAt(p, tolerance, hits);
      if (plane_ == Plane::XY) {
        labelsAt(p, tolerance, hits);
        roomsAt(p, tolerance, hits);
      }
    }
    piecesAt(home_.furniture, p, tolerance, hits);
    camerasAt(p, tolerance, hits);
    if (plane_ == Plane::XY)
      for (const auto& [id, line] : home_.polylines)
        if (here(*line) && distanceToPath(line->points, line->closed, p) <= tolerance + line->thickness / 2)
          hits.push_back({id, Rank::Thin, 3});
    std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
      return a.rank < b.rank || (a.rank == b.rank && a.order < b.order);
    });
    return hits;
  }

 private:
  template <class T>
  bool here(const T& element) const {
    return element.level == editor_.level();
  }

  template <class Pieces>
  void piecesAt(const Pieces& pieces, Vec2 p, double tolerance, std::vector<Hit>& hits) const {
    for (const auto& [id, piece] : pieces) {
      if (!here(*piece)) continue;
      const double near = reach(*piece) + tolerance;
      const Vec2 to = project(plane_, middle(*piece, floor_)) - p;
      if (dot(to, to) > near * near || !isShown(home_, *piece)) continue;
      const Polygon shape = outline(plane_, *piece, floor_);
      if (!covers(shape, p, tolerance)) continue;
      // From above: a cushion before the bed it lies on, the sofa before the rug under it, and what stands
      // under a lamp only after the lamp. From the side: the nearest.
      const double order = plane_ == Plane::XY ? std::log2(std::max(signedArea(shape), 1e-6)) -
                                                     1.5 * (piece->position.z + piece->size.z)
                                               : -nearness(plane_, piece->position) - depth(*piece) / 2;
      // From the side, what is in the walls before the section is only outlined: others show through.
      const bool open = std::is_same_v<Pieces, Table<OpeningId, Opening>> && plane_ != Plane::XY &&
                        nearness(plane_, piece->position) > section_;
      hits.push_back({id, open ? Rank::Wall : Rank::Body, order});
    }
  }
  void openingsAt(Vec2 p, double tolerance, std::vector<Hit>& hits) const {
    piecesAt(home_.openings, p, tolerance, hits);
  }

  // Along the line of sight.
  double depth(const Piece& piece) const {
    const Vec2 right = rotated(Vec2{piece.size.x, 0}, piece.angle);
    const Vec2 back = rotated(Vec2{0, piece.size.y}, piece.angle);
    return plane_ == Plane::XZ ? std::abs(right.y) + std::abs(back.y) : std::abs(right.x) + std::abs(back.x);
  }

  void wallsAt(Vec2 p, double tolerance, std::vector<Hit>& hits) const {
    for (const auto& [id, wall] : home_.walls) {
      if (!here(*wall)) continue;
      // A sharp corner reaches out four thicknesses at most; an arc as far as its chord and sweep let it.
      const Vec2 chord = wall->end - wall->start;
      const double near = length(chord) * (wall->arcExtent == 0 ? 0.5 : 0.5 + std::abs(wall->arcExtent)) +
                          4 * wall->thickness + tolerance;
      const Vec2 centre = (wall->start + wall->end) / 2;
      const double off = plane_ == Plane::XY ? length(centre - p)
                                             : std::abs((plane_ == Plane::XZ ? centre.x : centre.y) - p.x);
      if (off > near) continue;
      const Polygon shape = outline(plane_, home_, id, *wall);
      if (plane_ == Plane::XY) {
        if (covers(shape, p, tolerance)) hits.push_back({id, Rank::Wall, 0});
        continue;
      }
      const double far = std::min(nearness(plane_, Vec3{wall->start.x, wall->start.y, 0}),
                                  nearness(plane_, Vec3{wall->end.x, wall->end.y, 0}));
      const bool hit =
          far > section_ ? distanceToPath(shape, true, p) <= tolerance : covers(shape, p, tolerance);
      if (hit) hits.push_back({id, Rank::Wall, -nearness(plane_, Vec3{centre.x, centre.y, 0})});
    }
  }

  void roomsAt(Vec2 p, double tolerance, std::vector<Hit>& hits) const {
    for (const auto& [id, room] : home_.rooms)
      if (here(*room) && covers(room->points, p, tolerance))
        hits.push_back({id, Rank::Room, std::abs(signedArea(room->points))});
  }

  void dimensionsAt(Vec2 p, double tolerance, std::vector<Hit>& hits) const {
    for (const auto& [id, dimension] : home_.dimensions) {
      if (!here(*dimension)) continue;
      const std::optional<DimensionLine> line = dimensionLine(plane_, *dimension, floor_);
      if (!line) continue;
      const Vec2 along = line->to - line->from;
      const double span = length(along);
      const Vec2 local{dot(p - line->from, along) / span, cross(along, p - line->from) / span};
      const double half = 1.5 * dimension->textSize;  // of a text such as "3.25 m"
      const bool onText = std::abs(local.x - span / 2) <= half && std::abs(local.y) <= dimension->textSize;
      if (onText || distanceToSegment(p, line->from, line->to) <= tolerance)
        hits.push_back({id, Rank::Thin, 2});
    }
  }

  void labelsAt(Vec2 p, double tolerance, std::vector<Hit>& hits) const {
    for (const auto& [id, label] : home_.labels)
      if (here(*label) && covers(labelBox(*label), p, tolerance / 2)) hits.push_back({id, Rank::Thin, 1});
  }

  void camerasAt(Vec2 p, double tolerance, std::vector<Hit>& hits) const {
    for (const auto& [id, camera] : home_.cameras) {
      // The body is drawn as large at any scale.
      const double away = length(project(plane_, camera->eye) - p);
      if (away <= std::max(2.4 * tolerance, 0.1))
        hits.push_back({id, Rank::Thin, 0});
      else if (away <= 2 * kCameraCone && contains(cameraCone(plane_, *camera), p))
        hits.push_back({id, Rank::Cone, away});
    }
  }

  const Editor& editor_;
  const Home& home_;
  Plane plane_;
  double floor_;
  double section_ = 0;
};

bool inside(const Box2& box, Vec2 p) {
  return p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y;
}

// Liang and Barsky's clipping, asking only whether something is left.
bool crosses(const Box2& box, Vec2 a, Vec2 b) {
  double from = 0, to = 1;
  const Vec2 d = b - a;
  const double step[4]{-d.x, d.x, -d.y, d.y};
  const double room[4]{a.x - box.min.x, box.max.x - a.x, a.y - box.min.y, box.max.y - a.y};
  for (int i = 0; i < 4; ++i) {
    if (step[i] == 0) {
      if (room[i] < 0) return false;
    } else if (step[i] < 0) {
      from = std::max(from, room[i] / step[i]);
    } else {
      to = std::min(to, room[i] / step[i]);
    }
  }
  return from <= to;
}

bool lies(const Box2& box, const std::vector<Vec2>& shape, bool closed, bool touching) {
  if (shape.empty()) return false;
  if (!touching) return std::all_of(shape.begin(), shape.end(), [&box](Vec2 p) { return inside(box, p); });
  for (std::size_t i = 0; i + 1 < shape.size(); ++i)
    if (crosses(box, shape[i], shape[i + 1])) return true;
  if (closed && crosses(box, shape.back(), shape.front())) return true;
  return closed && contains(shape, box.min);
}

}  // namespace

std::vector<AnyId> membersAt(const Editor& editor, Plane plane, Vec2 at, double tolerance) {
  std::vector<AnyId> ids;
  for (const Hit& hit : HitTest(editor, plane).at(at, tolerance)) ids.push_back(hit.id);
  return ids;
}

std::vector<AnyId> hitsAt(const Editor& editor, Plane plane, Vec2 at, double tolerance) {
  std::vector<AnyId> ids;
  for (const AnyId id : membersAt(editor, plane, at, tolerance)) {
    const AnyId whole = byGroup(editor.home(), id);
    if (std::find(ids.begin(), ids.end(), whole) == ids.end()) ids.push_back(whole);
  }
  return ids;
}

Elements hitsIn(const Editor& editor, Plane plane, Vec2 from, Vec2 to) {
  const Home& home = editor.home();
  const bool touching = to.x < from.x;
  const double floor = editor.elevation();
  Box2 box;
  box.add(from);
  box.add(to);
  Elements found;
  const auto here = [&editor](const auto& element) { return element.level == editor.level(); };
  const auto takePieces = [&](const auto& pieces, auto& ids) {
    for (const auto& [id, piece] : pieces) {
      if (!here(*piece)) continue;
      const Vec2 centre = project(plane, middle(*piece, floor));
      const double r = reach(*piece);
      if (centre.x < box.min.x - r || centre.x > box.max.x + r || centre.y < box.min.y - r ||
          centre.y > box.max.y + r)
        continue;
      if (!isShown(home, *piece) || !lies(box, outline(plane, *piece, floor), true, touching)) continue;
      if (piece->group)
        found.groups.push_back(outermost(home, piece->group));
      else
        ids.push_back(id);
    }
  };
  takePieces(home.furniture, found.furniture);
  if (!editor.settings().baseLocked) {
    takePieces(home.openings, found.openings);
    for (const auto& [id, wall] : home.walls)
      if (here(*wall) && lies(box, outline(plane, home, id, *wall), true, touching))
        found.walls.push_back(id);
    for (const auto& [id, dimension] : home.dimensions)
      if (here(*dimension))
        if (const auto line = dimensionLine(plane, *dimension, floor);
            line && lies(box, {line->from, line->to}, false, touching))
          found.dimensions.push_back(id);
    if (plane == Plane::XY) {
      for (const auto& [id, room] : home.rooms)
        if (here(*room) && lies(box, room->points, true, touching && !contains(room->points, box.min)))
          found.rooms.push_back(id);
      for (const auto& [id, label] : home.labels)
        if (here(*label) && lies(box, labelBox(*label), true, touching)) found.labels.push_back(id);
    }
  }
  if (plane == Plane::XY)
    for (const auto& [id, line] : home.polylines)
      if (here(*line) && lies(box, line->points, line->closed, touching)) found.polylines.push_back(id);
  for (const auto& [id, camera] : home.cameras)
    if (inside(box, project(plane, camera->eye))) found.cameras.push_back(id);
  return pruned(home, std::move(found));
}

}  // namespace idap
