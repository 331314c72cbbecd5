// Questions about what is selected. The selection itself is model/edits/element_edits.h's Elements, ids in
// ascending order; members of a group are selected by their group.
#pragma once

#include <optional>
#include <variant>

#include "model/edits/element_edits.h"
#include "model/home.h"

namespace idap {

using AnyId =
    std::variant<WallId, RoomId, OpeningId, FurnitureId, GroupId, CameraId, DimensionId, LabelId, PolylineId>;

bool empty(const Elements& elements);
std::size_t count(const Elements& elements);
bool contains(const Elements& elements, AnyId id);
void add(Elements& elements, AnyId id);
void remove(Elements& elements, AnyId id);
Elements only(AnyId id);
std::vector<AnyId> list(const Elements& elements);
// The one element, when exactly one is selected.
std::optional<AnyId> single(const Elements& elements);

// Without what the home no longer has, and every piece inside a group by its outermost group.
Elements pruned(const Home& home, Elements elements);
// All that can be selected on a level; every level for none given.
Elements everything(const Home& home, std::optional<LevelId> level);

// The box around elements, world, metres; empty for none. Groups count with all that is in them.
Box3 bounds(const Home& home, const Elements& elements);

}  // namespace idap
