// Rules between elements: ids that are one of a kind, groups that end, walls that do not lie on each other,
// and the files that came with the home. Each mends the home and reports it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "model/home.h"

namespace idap {

// Ids are counted in JSON numbers and shown to people: they stay exact in a double.
inline constexpr std::uint64_t kMaxId = std::uint64_t{1} << 53;
inline constexpr std::size_t kMaxGroupDepth = 100;

// Called with the kind of element ("wall"), its id, and what was done about what.
using Complaint =
    std::function<void(const char* kind, std::uint64_t id, const std::string& name, const char* what)>;

void mendCounts(Home& home, const Complaint& complain);
void mendIds(Home& home, const Complaint& complain);
void mendGroupCircles(Home& home, const Complaint& complain);
void mendDoubleWalls(Home& home, const Complaint& complain);
void mendSelfNeighbours(Home& home, const Complaint& complain);
void mendAssets(Home& home, const Complaint& complain);

std::uint64_t lastId(const Home& home);  // the highest id in use
// False for a group that holds itself, or is nested deeper than any person would.
bool endsSomewhere(const Home& home, GroupId group);
// The first wall that lies exactly on an earlier one, or none.
WallId doubleWall(const Home& home);
bool usableAssetName(const std::string& name);

}  // namespace idap
