#include "model/structure_rules.h"

#include <map>
#include <set>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "base/utf8.h"
#include "model/judge.h"
#include "model/tables.h"

namespace idap {

namespace {

template <class IdType>
using Renamed = std::map<IdType, IdType>;  // from, to

// Gives every element of a table that holds a renamed id in one of the members the new one.
template <class IdType, class T, class... Members>
void redirect(Table<IdType, T>& table, const auto& renamed, Members... members) {
  for (const auto& [id, element] : table) {
    const T& current = *element;
    const auto affected = [&](auto member) { return renamed.contains(current.*member); };
    if (!(affected(members) || ...)) continue;
    T copy = current;
    const auto change = [&](auto member) {
      if (const auto found = renamed.find(copy.*member); found != renamed.end()) copy.*member = found->second;
    };
    (change(members), ...);
    table.set(id, std::move(copy));
  }
}

void redirectAll(Home& home, const Renamed<LevelId>& renamed) {
  redirect(home.walls, renamed, &Wall::level);
  redirect(home.rooms, renamed, &Room::level);
  redirect(home.openings, renamed, &Opening::level);
  redirect(home.furniture, renamed, &Furniture::level);
  redirect(home.dimensions, renamed, &Dimension::level);
  redirect(home.labels, renamed, &Label::level);
  redirect(home.polylines, renamed, &Polyline::level);
  for (const auto& [from, to] : renamed)
    if (auto entry = home.backgrounds.extract(from)) {
      entry.key() = to;
      home.backgrounds.insert(std::move(entry));
    }
}
void redirectAll(Home& home, const Renamed<GroupId>& renamed) {
  redirect(home.groups, renamed, &Group::parent);
  redirect(home.openings, renamed, &Opening::group);
  redirect(home.furniture, renamed, &Furniture::group);
}
void redirectAll(Home& home, const Renamed<WallId>& renamed) {
  redirect(home.walls, renamed, &Wall::neighbourAtStart, &Wall::neighbourAtEnd);
  redirect(home.openings, renamed, &Opening::wall);
}
template <class IdType>
void redirectAll(Home&, const Renamed<IdType>&) {}  // nothing refers to the other kinds

// Equal for walls that stand on the same line with the same body, in whichever direction they were drawn.
using WallKey = std::tuple<LevelId, double, double, double, double, double, double, double, double>;
WallKey keyOf(const Wall& w) {
  const bool forward = std::pair(w.start.x, w.start.y) <= std::pair(w.end.x, w.end.y);
  const Vec2 a = forward ? w.start : w.end, b = forward ? w.end : w.start;
  return {w.level,
          a.x,
          a.y,
          b.x,
          b.y,
          forward ? w.arcExtent : -w.arcExtent,
          w.thickness,
          forward ? w.heightAtStart : w.heightAtEnd,
          forward ? w.heightAtEnd : w.heightAtStart};
}

}  // namespace

void mendCounts(Home& home, const Complaint& complain) {
  forEachTable([&](auto table, auto, const char* kind) {
    auto& elements = home.*table;
    if (elements.size() <= kMaxElements) return;
    using TableType = std::remove_reference_t<decltype(elements)>;
    typename TableType::Chunk kept;
    for (const auto& entry : elements)
      if (kept.size() < kMaxElements) kept.push_back(entry);
    elements = TableType::of(std::move(kept));
    complain(kind, 0, "", "over a million of them: the rest dropped");
  });
}

void mendIds(Home& home, const Complaint& complain) {
  const auto keepable = [](std::uint64_t id) { return id != 0 && id < kMaxId / 2; };
  // Which numbers are in use is settled first, so that a new one meets none of them.
  std::uint64_t last = 0;
  forEachTable([&](auto table, auto, const char*) {
    for (const auto& entry : home.*table)
      if (keepable(entry.first.value)) last = std::max(last, entry.first.value);
  });
  std::unordered_set<std::uint64_t> used;
  forEachTable([&](auto table, auto, const char* kind) {
    auto& elements = home.*table;
    using TableType = std::remove_reference_t<decltype(elements)>;
    using IdType = std::remove_cvref_t<decltype(elements.begin()->first)>;
    typename TableType::Chunk entries;
    Renamed<IdType> renamed;
    bool changed = false;
    for (auto [id, element] : elements) {
      if (!keepable(id.value) || !used.insert(id.value).second) {
        complain(kind, id.value, "", "number used twice or not usable: given a new one");
        if (id) renamed.emplace(id, IdType{last + 1});
        id = IdType{++last};
        used.insert(last);
        changed = true;
      }
      entries.emplace_back(id, std::move(element));
    }
    if (!changed) return;
    elements = TableType::of(std::move(entries));
    redirectAll(home, renamed);
  });
  if (home.nextId <= last || home.nextId >= kMaxId / 2) home.nextId = last + 1;
}

std::uint64_t lastId(const Home& home) {
  std::uint64_t last = 0;
  forEachTable([&](auto table, auto, const char*) {
    if (const auto& chunks = (home.*table).chunks(); !chunks.empty())
      last = std::max(last, chunks.back()->back().first.value);
  });
  return last;
}

bool endsSomewhere(const Home& home, GroupId group) {
  GroupId above = group;
  for (std::size_t steps = 0; steps <= kMaxGroupDepth; ++steps) {
    const Group* found = home.groups.find(above);
    if (!found || !found->parent) return true;
    above = found->parent;
  }
  return false;
}

void mendGroupCircles(Home& home, const Complaint& complain) {
  const auto holdsItself = [&home](GroupId group) {
    GroupId above = group;
    for (std::size_t steps = 0; steps <= kMaxGroupDepth; ++steps) {
      const Group* found = home.groups.find(above);
      if (!found || !found->parent) return false;
      above = found->parent;
      if (above == group) return true;
    }
    return false;
  };
  const auto release = [&](GroupId id, const Group& group, const char* what) {
    Group freed = group;
    freed.parent = {};
    complain("group", id.value, freed.name, what);
    home.groups.set(id, std::move(freed));
  };
  for (const auto& [id, group] : home.groups)
    if (holdsItself(id)) release(id, *group, "in a group that is inside it: taken out");
  for (const auto& [id, group] : home.groups)
    if (!endsSomewhere(home, id)) release(id, *group, "in too many groups inside each other: taken out");
}

WallId doubleWall(const Home& home) {
  std::set<WallKey> seen;
  for (const auto& [id, wall] : home.walls)
    if (!seen.insert(keyOf(*wall)).second) return id;
  return {};
}

void mendSelfNeighbours(Home& home, const Complaint& complain) {
  for (const auto& [id, wall] : home.walls) {
    if (wall->neighbourAtStart != id && wall->neighbourAtEnd != id) continue;
    complain("wall", id.value, "", "joined to itself: left free");
    Wall freed = *wall;
    if (freed.neighbourAtStart == id) freed.neighbourAtStart = {};
    if (freed.neighbourAtEnd == id) freed.neighbourAtEnd = {};
    home.walls.set(id, std::move(freed));
  }
}

void mendDoubleWalls(Home& home, const Complaint& complain) {
  std::map<WallKey, WallId> seen;
  Renamed<WallId> renamed;
  Table<WallId, Wall>::Chunk kept;
  for (const auto& [id, wall] : home.walls) {
    const auto [first, isNew] = seen.emplace(keyOf(*wall), id);
    if (isNew) {
      kept.emplace_back(id, wall);
      continue;
    }
    complain("wall", id.value, "", "lies exactly on another: dropped");
    renamed.emplace(id, first->second);
  }
  if (renamed.empty()) return;
  home.walls = Table<WallId, Wall>::of(std::move(kept));
  redirectAll(home, renamed);
}

bool usableAssetName(const std::string& name) {
  if (name.empty() || name == "home.json" || name.size() > 4096 || name.back() == '/' || !isUtf8(name))
    return false;
  if (name.front() == '/' || name.find('\\') != std::string::npos || name.find('\0') != std::string::npos)
    return false;
  if (name.size() > 1 && name[1] == ':') return false;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    const std::string part = name.substr(begin, end - begin);
    if (part.empty() || part == "." || part == "..") return false;
    begin = end + 1;
  }
  return true;
}

void mendAssets(Home& home, const Complaint& complain) {
  if (!home.assets) home.assets = std::make_shared<const Assets>();
  const auto bad = [](const auto& entry) { return !entry.second || !usableAssetName(entry.first); };
  if (std::none_of(home.assets->begin(), home.assets->end(), bad)) return;
  Assets kept = *home.assets;
  for (auto entry = kept.begin(); entry != kept.end();) {
    if (bad(*entry)) {
      complain("file", 0, toValidUtf8(entry->first), "empty or of an unusable name: dropped");
      entry = kept.erase(entry);
    } else {
      ++entry;
    }
  }
  home.assets = std::make_shared<const Assets>(std::move(kept));
}

}  // namespace idap
