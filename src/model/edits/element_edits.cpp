#include "model/edits/element_edits.h"

#include <algorithm>
#include <functional>
#include <set>

#include "base/error.h"
#include "model/edits/table_edits.h"
#include "model/edits/wall_move.h"
#include "model/room_geometry.h"

namespace idap {

Elements withGroups(const Home& home, const Elements& elements) {
  std::set<GroupId> groups = setOf(elements.groups);
  for (std::size_t before = 0; before != groups.size();) {
    before = groups.size();
    for (const auto& [id, group] : home.groups)
      if (group->parent && groups.contains(group->parent)) groups.insert(id);
  }
  std::set<OpeningId> openings = setOf(elements.openings);
  std::set<FurnitureId> furniture = setOf(elements.furniture);
  if (!groups.empty()) {
    for (const auto& [id, opening] : home.openings)
      if (groups.contains(opening->group)) openings.insert(id);
    for (const auto& [id, piece] : home.furniture)
      if (groups.contains(piece->group)) furniture.insert(id);
  }
  Elements all;
  all.walls = listOf(setOf(elements.walls));
  all.rooms = listOf(setOf(elements.rooms));
  all.openings = listOf(openings);
  all.furniture = listOf(furniture);
  all.groups = listOf(groups);
  all.cameras = listOf(setOf(elements.cameras));
  all.dimensions = listOf(setOf(elements.dimensions));
  all.labels = listOf(setOf(elements.labels));
  all.polylines = listOf(setOf(elements.polylines));
  return all;
}

Elements unlocked(const Home& home, const Elements& elements) {
  Elements free = elements;
  const auto locked = [](const auto& table, auto id) {
    const auto* piece = table.find(id);
    return piece && piece->locked;
  };
  std::erase_if(free.openings, [&](OpeningId id) { return locked(home.openings, id); });
  std::erase_if(free.furniture, [&](FurnitureId id) { return locked(home.furniture, id); });
  std::erase_if(free.groups, [&](GroupId id) {
    Elements group;
    group.groups = {id};
    const Elements members = withGroups(home, group);
    return std::any_of(members.openings.begin(), members.openings.end(),
                       [&](OpeningId member) { return locked(home.openings, member); }) ||
           std::any_of(members.furniture.begin(), members.furniture.end(),
                       [&](FurnitureId member) { return locked(home.furniture, member); });
  });
  return free;
}

Elements allElements(const Home& home) {
  Elements all;
  const auto gather = [](const auto& table, auto& ids) {
    ids.reserve(table.size());
    for (const auto& [id, element] : table) ids.push_back(id);
  };
  gather(home.walls, all.walls);
  gather(home.rooms, all.rooms);
  gather(home.openings, all.openings);
  gather(home.furniture, all.furniture);
  gather(home.groups, all.groups);
  gather(home.cameras, all.cameras);
  gather(home.dimensions, all.dimensions);
  gather(home.labels, all.labels);
  gather(home.polylines, all.polylines);
  return all;
}

Home deleteElements(const Home& home, const Elements& elements) {
  Elements all = withGroups(home, elements);
  const std::set<WallId> walls = setOf(all.walls);
  for (const auto& [id, opening] : home.openings)
    if (opening->wall && walls.contains(opening->wall)) all.openings.push_back(id);
  Home next = home;
  eraseEach(next.walls, all.walls);
  eraseEach(next.rooms, all.rooms);
  eraseEach(next.openings, all.openings);
  eraseEach(next.furniture, all.furniture);
  eraseEach(next.groups, all.groups);
  eraseEach(next.cameras, all.cameras);
  eraseEach(next.dimensions, all.dimensions);
  eraseEach(next.labels, all.labels);
  eraseEach(next.polylines, all.polylines);
  for (const auto& [id, wall] : next.walls) {
    if (!walls.contains(wall->neighbourAtStart) && !walls.contains(wall->neighbourAtEnd)) continue;
    Wall freed = *wall;
    if (walls.contains(freed.neighbourAtStart)) freed.neighbourAtStart = {};
    if (walls.contains(freed.neighbourAtEnd)) freed.neighbourAtEnd = {};
    next.walls.set(id, std::move(freed));
  }
  // Groups that this emptied, from the inside outwards; groups that were empty before stay.
  const auto inhabited = [](const Home& h) {
    std::set<GroupId> groups;
    for (const auto& [id, opening] : h.openings) groups.insert(opening->group);
    for (const auto& [id, piece] : h.furniture) groups.insert(piece->group);
    for (const auto& [id, group] : h.groups) groups.insert(group->parent);
    return groups;
  };
  const std::set<GroupId> before = inhabited(home);
  for (bool again = !home.groups.empty(); again;) {
    again = false;
    const std::set<GroupId> now = inhabited(next);
    for (const auto& [id, group] : next.groups)
      if (before.contains(id) && !now.contains(id)) again = next.groups.erase(id);
  }
  return next;
}

Home moveElements(const Home& home, const Elements& elements, Vec3 by) {
  return moved(home, withGroups(home, elements), Motion{.by = {by.x, by.y}, .rise = by.z});
}

Home turnElements(const Home& home, const Elements& elements, Vec2 about, double angle) {
  return moved(home, withGroups(home, elements), Motion{.angle = angle, .about = about});
}

GroupEdit groupElements(const Home& home, const Elements& elements, std::string name) {
  std::set<GroupId> parents;
  const auto gather = [&](const auto& table, const auto& ids, auto member) {
    for (const auto id : ids)
      if (const auto* found = table.find(id)) parents.insert(found->*member);
  };
  gather(home.openings, elements.openings, &Opening::group);
  gather(home.furniture, elements.furniture, &Furniture::group);
  gather(home.groups, elements.groups, &Group::parent);
  if (parents.empty()) throw InvalidHome("there is nothing to group");
  // A group that is itself selected cannot hold the new one.
  GroupId parent = parents.size() == 1 ? *parents.begin() : GroupId{};
  if (std::find(elements.groups.begin(), elements.groups.end(), parent) != elements.groups.end()) parent = {};
  Home next = home;
  const auto id = next.newId<GroupId>();
  next.groups.set(id, Group{parent, std::move(name), true});
  changeEach(next.openings, elements.openings, [id](Opening& opening) { opening.group = id; });
  changeEach(next.furniture, elements.furniture, [id](Furniture& piece) { piece.group = id; });
  changeEach(next.groups, elements.groups, [id](Group& group) { group.parent = id; });
  return {std::move(next), id};
}

Home ungroup(const Home& home, GroupId id) {
  const Group* group = home.groups.find(id);
  if (!group) throw InvalidHome("group " + std::to_string(id.value) + " does not exist");
  Home next = home;
  const auto lift = [&](auto& table, auto member) {
    for (const auto& [elementId, element] : table) {
      if (!((*element).*member == id)) continue;
      auto copy = *element;
      copy.*member = group->parent;
      table.set(elementId, std::move(copy));
    }
  };
  lift(next.openings, &Opening::group);
  lift(next.furniture, &Furniture::group);
  lift(next.groups, &Group::parent);
  next.groups.erase(id);
  return next;
}

RoomEdit addRoom(const Home& home, Room room) {
  Home next = home;
  const auto id = next.newId<RoomId>();
  next.rooms.set(id, std::move(room));
  return {std::move(next), id};
}

RoomEdit addRoomAt(const Home& home, LevelId level, Vec2 point, std::string name) {
  std::optional<Polygon> outline = closedAreaAt(home, level, point);
  if (!outline) throw InvalidHome("no walls close around this point");
  Room room;
  room.level = level;
  room.name = std::move(name);
  room.points = std::move(*outline);
  return addRoom(home, std::move(room));
}

}  // namespace idap
