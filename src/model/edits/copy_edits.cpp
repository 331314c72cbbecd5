// Duplicating, and the clipboard: parts of a home taken out and put in again.
#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "model/assets.h"
#include "model/edits/arrange_edits.h"
#include "model/edits/asset_merge.h"
#include "model/edits/motion.h"
#include "model/edits/table_edits.h"
#include "model/structure_rules.h"
#include "model/wall_path.h"

namespace idap {

namespace {

// What is copied: groups with all in them, and walls with their doors and windows.
Elements wholly(const Home& home, const Elements& elements) {
  Elements all = elements;
  const std::set<WallId> walls = setOf(elements.walls);
  if (!walls.empty())
    for (const auto& [id, opening] : home.openings)
      if (opening->wall && walls.contains(opening->wall)) all.openings.push_back(id);
  return withGroups(home, all);
}

// Copies elements of one home into another under new ids.
class Copier {
 public:
  Copier(const Home& from, Home& to) : from_(from), to_(to) {}

  // level: where they go; none: each to its own.
  Elements copy(const Elements& all, std::optional<LevelId> level, Vec3 by, GroupId group) {
    const Motion motion{.by = {by.x, by.y}, .rise = by.z};
    const auto land = [&level](auto& element) {
      if (level) element.level = *level;
    };
    number(from_.groups, all.groups, groups_);
    number(from_.walls, all.walls, walls_);
    Elements made;
    each(from_.groups, all.groups, [&](GroupId id, Group copy) {
      copy.parent = renamed(groups_, copy.parent, group);
      if (copy.parent == group) made.groups.push_back(groups_.at(id));
      to_.groups.set(groups_.at(id), std::move(copy));
    });
    each(from_.walls, all.walls, [&](WallId id, Wall copy) {
      land(copy);
      motion(copy);
      copy.neighbourAtStart = renamed(walls_, copy.neighbourAtStart, {});
      copy.neighbourAtEnd = renamed(walls_, copy.neighbourAtEnd, {});
      to_.walls.set(walls_.at(id), std::move(copy));
      made.walls.push_back(walls_.at(id));
    });
    each(from_.openings, all.openings, [&](OpeningId, Opening copy) {
      const GroupId within = renamed(groups_, copy.group, group);
      copy.group = within;
      land(copy);
      motion(copy);
      const WallId wall = renamed(walls_, copy.wall, {});
      copy.wall = wall ? wall : stillIn(copy);
      const auto id = to_.newId<OpeningId>();
      if (within == group) made.openings.push_back(id);
      to_.openings.set(id, std::move(copy));
    });
    each(from_.furniture, all.furniture, [&](FurnitureId, Furniture copy) {
      copy.group = renamed(groups_, copy.group, group);
      land(copy);
      motion(copy);
      const auto id = to_.newId<FurnitureId>();
      if (copy.group == group) made.furniture.push_back(id);
      to_.furniture.set(id, std::move(copy));
    });
    if (group) {  // what went into it is selected as it
      made.groups = {group};
      made.openings.clear();
      made.furniture.clear();
    }
    const auto plain = [&](const auto& from, auto& to, const auto& ids, auto& list) {
      each(from, ids, [&](auto id, auto copy) {
        if constexpr (requires { copy.level; }) land(copy);
        motion(copy);
        id = to_.template newId<decltype(id)>();
        to.set(id, std::move(copy));
        list.push_back(id);
      });
    };
    plain(from_.rooms, to_.rooms, all.rooms, made.rooms);
    plain(from_.cameras, to_.cameras, all.cameras, made.cameras);
    plain(from_.dimensions, to_.dimensions, all.dimensions, made.dimensions);
    plain(from_.labels, to_.labels, all.labels, made.labels);
    plain(from_.polylines, to_.polylines, all.polylines, made.polylines);
    return made;
  }

 private:
  template <class IdType, class T, class F>
  static void each(const Table<IdType, T>& table, const std::vector<IdType>& ids, F f) {
    for (const IdType id : ids)
      if (const T* found = table.find(id)) f(id, *found);
  }
  template <class IdType, class T>
  void number(const Table<IdType, T>& table, const std::vector<IdType>& ids,
              std::map<IdType, IdType>& names) {
    for (const IdType id : ids)
      if (table.contains(id)) names.emplace(id, to_.newId<IdType>());
  }
  template <class IdType>
  static IdType renamed(const std::map<IdType, IdType>& names, IdType id, IdType otherwise) {
    const auto found = names.find(id);
    return found == names.end() ? otherwise : found->second;
  }

  // A door copied without its wall belongs to the wall it has come to lie in, if there is one.
  WallId stillIn(const Opening& opening) const {
    const Vec2 at{opening.position.x, opening.position.y};
    for (const auto& [id, wall] : to_.walls) {
      if (wall->level != opening.level) continue;
      const WallPath path(*wall);
      const double distance = path.nearest(at);
      const double turn = cross(path.direction(distance), rotated(Vec2{1, 0}, opening.angle));
      if (length(path.point(distance) - at) <= wall->thickness / 2 + 0.01 && std::abs(turn) < 0.1) return id;
    }
    return {};
  }

  const Home& from_;
  Home& to_;
  std::map<GroupId, GroupId> groups_;
  std::map<WallId, WallId> walls_;
};

// Walls put exactly onto walls that are there already would stand in them: they are left out, and what was
// in them goes into those.
void mergeDoubleWalls(CopyEdit& edit) {
  for (WallId twice = doubleWall(edit.home); twice; twice = doubleWall(edit.home)) {
    const Wall& wall = *edit.home.walls.find(twice);
    WallId first;
    Home without = edit.home;
    for (const auto& [id, other] : edit.home.walls)
      if (id != twice && other->level == wall.level &&
          ((other->start == wall.start && other->end == wall.end) ||
           (other->start == wall.end && other->end == wall.start))) {
        first = id;
        break;
      }
    without.walls.erase(twice);
    changeWhere(
        without.openings, [twice](const Opening& o) { return o.wall == twice; },
        [first](Opening& o) { o.wall = first; });
    changeWhere(
        without.walls,
        [twice](const Wall& w) { return w.neighbourAtStart == twice || w.neighbourAtEnd == twice; },
        [twice](Wall& w) {
          if (w.neighbourAtStart == twice) w.neighbourAtStart = {};
          if (w.neighbourAtEnd == twice) w.neighbourAtEnd = {};
        });
    std::erase(edit.copies.walls, twice);
    edit.home = std::move(without);
  }
}

template <class IdType, class T>
void keepOnly(Table<IdType, T>& table, const std::vector<IdType>& ids) {
  typename Table<IdType, T>::Chunk kept;
  const std::set<IdType> wanted(ids.begin(), ids.end());
  for (const auto& entry : table)
    if (wanted.contains(entry.first)) kept.push_back(entry);
  table = Table<IdType, T>::of(std::move(kept));
}

}  // namespace

CopyEdit duplicateElements(const Home& home, const Elements& elements, Vec3 by) {
  CopyEdit edit{home, {}};
  edit.copies = Copier(home, edit.home).copy(wholly(home, elements), std::nullopt, by, {});
  mergeDoubleWalls(edit);
  return edit;
}

Home extractElements(const Home& home, const Elements& elements) {
  const Elements all = wholly(home, elements);
  Home part = home;
  part.title.clear();
  part.notes.clear();
  part.properties.clear();
  part.backgrounds.clear();
  part.environment = {};
  part.observer.reset();
  part.aerial.reset();
  keepOnly(part.groups, all.groups);
  keepOnly(part.walls, all.walls);
  keepOnly(part.rooms, all.rooms);
  keepOnly(part.openings, all.openings);
  keepOnly(part.furniture, all.furniture);
  keepOnly(part.cameras, all.cameras);
  keepOnly(part.dimensions, all.dimensions);
  keepOnly(part.labels, all.labels);
  keepOnly(part.polylines, all.polylines);
  changeWhere(
      part.groups, [&](const Group& g) { return g.parent && !part.groups.contains(g.parent); },
      [](Group& g) { g.parent = {}; });
  const auto loose = [&](const Piece& p) { return p.group && !part.groups.contains(p.group); };
  changeWhere(part.furniture, loose, [](Furniture& p) { p.group = {}; });
  changeWhere(part.openings, loose, [](Opening& p) { p.group = {}; });
  changeWhere(
      part.openings, [&](const Opening& o) { return o.wall && !part.walls.contains(o.wall); },
      [](Opening& o) { o.wall = {}; });
  const auto gone = [&](WallId id) { return id && !part.walls.contains(id); };
  changeWhere(
      part.walls, [&](const Wall& w) { return gone(w.neighbourAtStart) || gone(w.neighbourAtEnd); },
      [&](Wall& w) {
        if (gone(w.neighbourAtStart)) w.neighbourAtStart = {};
        if (gone(w.neighbourAtEnd)) w.neighbourAtEnd = {};
      });
  return withoutUnusedAssets(part);
}

CopyEdit pasteElements(const Home& home, const Home& fragment, LevelId level, Vec3 by, GroupId group) {
  CopyEdit edit{home, {}};
  const Home mended = withAssetsOf(edit.home, fragment);
  edit.copies = Copier(mended, edit.home)
                    .copy(allElements(mended), level, by, home.groups.contains(group) ? group : GroupId{});
  mergeDoubleWalls(edit);
  return edit;
}

Home pasteStyle(const Home& home, const Home& fragment, const Elements& elements) {
  Home next = home;
  const Home model = withAssetsOf(next, fragment);
  const Elements all = withGroups(home, elements);
  if (!model.walls.empty()) {
    const Wall& like = *model.walls.begin()->second;
    changeEach(next.walls, all.walls, [&](Wall& wall) {
      wall.left = like.left;
      wall.right = like.right;
      wall.top = like.top;
      wall.pattern = like.pattern;
    });
  }
  if (!model.rooms.empty()) {
    const Room& like = *model.rooms.begin()->second;
    changeEach(next.rooms, all.rooms, [&](Room& room) {
      room.floor = like.floor;
      room.ceiling = like.ceiling;
      room.floorVisible = like.floorVisible;
      room.ceilingVisible = like.ceilingVisible;
      room.nameStyle = like.nameStyle;
      room.areaStyle = like.areaStyle;
    });
  }
  const auto dress = [](Piece& piece, const Piece& like) {
    piece.finish = like.finish;
    piece.slotFinishes = like.slotFinishes;
  };
  if (!model.openings.empty())
    changeEach(next.openings, all.openings,
               [&](Opening& opening) { dress(opening, *model.openings.begin()->second); });
  if (!model.furniture.empty()) {
    const Furniture& like = *model.furniture.begin()->second;
    changeEach(next.furniture, all.furniture, [&](Furniture& piece) {
      dress(piece, like);
      if (!piece.lamp || !like.lamp) return;
      // Its light; where in the fixture that comes from is the model's.
      std::vector<LightSource> sources = std::move(piece.lamp->sources);
      piece.lamp = like.lamp;
      piece.lamp->sources = std::move(sources);
    });
  }
  if (!model.dimensions.empty()) {
    const Dimension& like = *model.dimensions.begin()->second;
    changeEach(next.dimensions, all.dimensions, [&](Dimension& dimension) {
      dimension.color = like.color;
      dimension.textSize = like.textSize;
    });
  }
  if (!model.labels.empty())
    changeEach(next.labels, all.labels,
               [&](Label& label) { label.style = model.labels.begin()->second->style; });
  if (!model.polylines.empty()) {
    const Polyline& like = *model.polylines.begin()->second;
    changeEach(next.polylines, all.polylines, [&](Polyline& line) {
      line.thickness = like.thickness;
      line.dash = like.dash;
      line.startArrow = like.startArrow;
      line.endArrow = like.endArrow;
      line.color = like.color;
    });
  }
  return withoutNewUnusedAssets(home, std::move(next));
}

}  // namespace idap
