// Questions about what is selected. The selection itself is model/edits/element_edits.h's Elements, ids in
// ascending order; members of a group are selected by their group, unless the user went into it.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "geometry/box.h"
#include "model/edits/element_edits.h"
#include "model/home.h"

namespace idap {

using AnyId =
    std::variant<WallId, RoomId, OpeningId, FurnitureId, GroupId, CameraId, DimensionId, LabelId, PolylineId>;

// Calls f with each list of ids.
template <class E, class F>
void forEachList(E& elements, F&& f) {
  f(elements.walls);
  f(elements.rooms);
  f(elements.openings);
  f(elements.furniture);
  f(elements.groups);
  f(elements.cameras);
  f(elements.dimensions);
  f(elements.labels);
  f(elements.polylines);
}

bool empty(const Elements& elements);
std::size_t count(const Elements& elements);
bool contains(const Elements& elements, AnyId id);
void add(Elements& elements, AnyId id);
void add(Elements& elements, const Elements& others);
void remove(Elements& elements, AnyId id);
Elements only(AnyId id);
std::vector<AnyId> list(const Elements& elements);
bool same(const Elements& a, const Elements& b);
// The one element, when exactly one is selected.
std::optional<AnyId> single(const Elements& elements);

// In order and without duplicates, without what the home no longer has, and without pieces and groups inside
// a group that is selected too.
Elements pruned(const Home& home, Elements elements);
// The selection after the home changed: pieces that came into a group since are selected by it.
Elements followed(const Home& before, const Home& after, Elements elements);
// All that can be selected on a level; every level for none given. Pieces in groups by their groups.
Elements everything(const Home& home, std::optional<LevelId> level);

// The group around this one that is in no other; the group itself when it is in none.
GroupId outermost(const Home& home, GroupId group);
// The piece of furniture or opening; null for other kinds of elements.
const Piece* pieceOf(const Home& home, AnyId id);
// A member of a group by its outermost group; all else as it is.
AnyId byGroup(const Home& home, AnyId id);

// The box around elements, world, metres; empty for none. Groups count with all that is in them.
Box3 bounds(const Home& home, const Elements& elements);

}  // namespace idap
