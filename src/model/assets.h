// Which of the files that came with a home it still uses.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "model/home.h"

namespace idap {

// Of the available names: those that the home refers to, and the files beside a model in its folder (material
// libraries, textures).
std::set<std::string> assetsInUse(const Home& home, const std::vector<std::string>& available);

}  // namespace idap
