#include "editor/selection.h"

#include <algorithm>
#include <type_traits>

#include "model/wall_outline.h"

namespace idap {

namespace {

template <class IdType, class E>
auto& listOf(E& elements) {
  if constexpr (std::is_same_v<IdType, WallId>)
    return elements.walls;
  else if constexpr (std::is_same_v<IdType, RoomId>)
    return elements.rooms;
  else if constexpr (std::is_same_v<IdType, OpeningId>)
    return elements.openings;
  else if constexpr (std::is_same_v<IdType, FurnitureId>)
    return elements.furniture;
  else if constexpr (std::is_same_v<IdType, GroupId>)
    return elements.groups;
  else if constexpr (std::is_same_v<IdType, CameraId>)
    return elements.cameras;
  else if constexpr (std::is_same_v<IdType, DimensionId>)
    return elements.dimensions;
  else if constexpr (std::is_same_v<IdType, LabelId>)
    return elements.labels;
  else
    return elements.polylines;
}

const auto& tableOf(const Home& home, WallId) { return home.walls; }
const auto& tableOf(const Home& home, RoomId) { return home.rooms; }
const auto& tableOf(const Home& home, OpeningId) { return home.openings; }
const auto& tableOf(const Home& home, FurnitureId) { return home.furniture; }
const auto& tableOf(const Home& home, GroupId) { return home.groups; }
const auto& tableOf(const Home& home, CameraId) { return home.cameras; }
const auto& tableOf(const Home& home, DimensionId) { return home.dimensions; }
const auto& tableOf(const Home& home, LabelId) { return home.labels; }
const auto& tableOf(const Home& home, PolylineId) { return home.polylines; }

bool within(const Home& home, GroupId group, const std::vector<GroupId>& selected) {
  for (std::size_t steps = 0; group && steps <= home.groups.size(); ++steps) {
    if (std::binary_search(selected.begin(), selected.end(), group)) return true;
    const Group* found = home.groups.find(group);
    if (!found) return false;
    group = found->parent;
  }
  return false;
}

void addBox(Box3& box, const Piece& piece, double elevation) {
  const Transform place = placement(piece);
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      for (const double z : {0.0, 1.0})
        box.add(place.point({x * piece.size.x, y * piece.size.y, z * piece.size.z}) + Vec3{0, 0, elevation});
}

void addFlat(Box3& box, Vec2 p, double z) { box.add(Vec3{p.x, p.y, z}); }

}  // namespace

bool empty(const Elements& elements) { return count(elements) == 0; }

std::size_t count(const Elements& elements) {
  std::size_t total = 0;
  forEachList(elements, [&total](const auto& ids) { total += ids.size(); });
  return total;
}

bool contains(const Elements& elements, AnyId id) {
  return std::visit(
      [&elements](auto each) {
        const auto& ids = listOf<decltype(each)>(elements);
        return std::binary_search(ids.begin(), ids.end(), each);
      },
      id);
}

void add(Elements& elements, AnyId id) {
  std::visit(
      [&elements](auto each) {
        auto& ids = listOf<decltype(each)>(elements);
        const auto at = std::lower_bound(ids.begin(), ids.end(), each);
        if (at == ids.end() || *at != each) ids.insert(at, each);
      },
      id);
}

void add(Elements& elements, const Elements& others) {
  for (const AnyId id : list(others)) add(elements, id);
}

void remove(Elements& elements, AnyId id) {
  std::visit([&elements](auto each) { std::erase(listOf<decltype(each)>(elements), each); }, id);
}

Elements only(AnyId id) {
  Elements elements;
  add(elements, id);
  return elements;
}

std::vector<AnyId> list(const Elements& elements) {
  std::vector<AnyId> all;
  all.reserve(count(elements));
  forEachList(elements, [&all](const auto& ids) { all.insert(all.end(), ids.begin(), ids.end()); });
  return all;
}

bool same(const Elements& a, const Elements& b) {
  return a.walls == b.walls && a.rooms == b.rooms && a.openings == b.openings && a.furniture == b.furniture &&
         a.groups == b.groups && a.cameras == b.cameras && a.dimensions == b.dimensions &&
         a.labels == b.labels && a.polylines == b.polylines;
}

std::optional<AnyId> single(const Elements& elements) {
  if (count(elements) != 1) return {};
  return list(elements).front();
}

Elements pruned(const Home& home, Elements elements) {
  forEachList(elements, [&home](auto& ids) {
    using IdType = typename std::remove_cvref_t<decltype(ids)>::value_type;
    if (!std::is_sorted(ids.begin(), ids.end())) std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    std::erase_if(ids, [&home](IdType id) { return !tableOf(home, id).contains(id); });
  });
  if (elements.groups.empty()) return elements;
  const std::vector<GroupId> groups = elements.groups;
  std::erase_if(elements.groups,
                [&](GroupId id) { return within(home, home.groups.find(id)->parent, groups); });
  std::erase_if(elements.furniture,
                [&](FurnitureId id) { return within(home, home.furniture.find(id)->group, groups); });
  std::erase_if(elements.openings,
                [&](OpeningId id) { return within(home, home.openings.find(id)->group, groups); });
  return elements;
}

Elements followed(const Home& before, const Home& after, Elements elements) {
  elements = pruned(after, std::move(elements));
  Elements came;
  const auto follow = [&](const auto& ids, const auto& was, const auto& now, auto member) {
    for (const auto id : ids) {
      const auto* old = was.find(id);
      if (old && !(old->*member) && (now.find(id)->*member))
        came.groups.push_back(outermost(after, now.find(id)->*member));
    }
  };
  follow(elements.furniture, before.furniture, after.furniture, &Furniture::group);
  follow(elements.openings, before.openings, after.openings, &Opening::group);
  follow(elements.groups, before.groups, after.groups, &Group::parent);
  if (came.groups.empty()) return elements;
  elements.groups.insert(elements.groups.end(), came.groups.begin(), came.groups.end());
  return pruned(after, std::move(elements));
}

Elements everything(const Home& home, std::optional<LevelId> level) {
  Elements all;
  const auto take = [&level](const auto& table, auto& ids) {
    for (const auto& [id, element] : table)
      if (!level || element->level == *level) ids.push_back(id);
  };
  const auto takePieces = [&](const auto& table, auto& ids) {
    for (const auto& [id, piece] : table) {
      if (level && piece->level != *level) continue;
      if (piece->group)
        all.groups.push_back(outermost(home, piece->group));
      else
        ids.push_back(id);
    }
  };
  take(home.walls, all.walls);
  take(home.rooms, all.rooms);
  takePieces(home.openings, all.openings);
  takePieces(home.furniture, all.furniture);
  for (const auto& [id, camera] : home.cameras) all.cameras.push_back(id);
  take(home.dimensions, all.dimensions);
  take(home.labels, all.labels);
  take(home.polylines, all.polylines);
  return pruned(home, std::move(all));
}

GroupId outermost(const Home& home, GroupId group) {
  for (std::size_t steps = 0; steps <= home.groups.size(); ++steps) {
    const Group* found = home.groups.find(group);
    if (!found || !found->parent) break;
    group = found->parent;
  }
  return group;
}

const Piece* pieceOf(const Home& home, AnyId id) {
  if (const auto* furniture = std::get_if<FurnitureId>(&id)) return home.furniture.find(*furniture);
  if (const auto* opening = std::get_if<OpeningId>(&id)) return home.openings.find(*opening);
  return nullptr;
}

AnyId byGroup(const Home& home, AnyId id) {
  if (const auto* group = std::get_if<GroupId>(&id)) return outermost(home, *group);
  const Piece* piece = pieceOf(home, id);
  return piece && piece->group ? AnyId(outermost(home, piece->group)) : id;
}

Box3 bounds(const Home& home, const Elements& elements) {
  const Elements all = elements.groups.empty() ? elements : withGroups(home, elements);
  Box3 box;
  for (const WallId id : all.walls)
    if (const Wall* wall = home.walls.find(id)) {
      const double floor = elevationOf(home, wall->level);
      for (const Vec2 p : wallOutline(home, id, *wall).polygon()) {
        addFlat(box, p, floor);
        addFlat(box, p, floor + std::max(wall->heightAtStart, wall->heightAtEnd));
      }
    }
  for (const RoomId id : all.rooms)
    if (const Room* room = home.rooms.find(id))
      for (const Vec2 p : room->points) addFlat(box, p, elevationOf(home, room->level));
  for (const OpeningId id : all.openings)
    if (const Opening* opening = home.openings.find(id))
      addBox(box, *opening, elevationOf(home, opening->level));
  for (const FurnitureId id : all.furniture)
    if (const Furniture* piece = home.furniture.find(id))
      addBox(box, *piece, elevationOf(home, piece->level));
  for (const CameraId id : all.cameras)
    if (const Camera* camera = home.cameras.find(id)) box.add(camera->eye);
  for (const DimensionId id : all.dimensions)
    if (const Dimension* dimension = home.dimensions.find(id)) {
      const double floor = elevationOf(home, dimension->level);
      addFlat(box, dimension->start, floor + dimension->startElevation);
      addFlat(box, dimension->end, floor + dimension->endElevation);
    }
  for (const LabelId id : all.labels)
    if (const Label* label = home.labels.find(id))
      addFlat(box, label->position, elevationOf(home, label->level) + label->elevation);
  for (const PolylineId id : all.polylines)
    if (const Polyline* line = home.polylines.find(id))
      for (const Vec2 p : line->points)
        addFlat(box, p, elevationOf(home, line->level) + line->elevation.value_or(0));
  return box;
}

}  // namespace idap
