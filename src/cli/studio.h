// `idap` and `idap FILE`: the studio, a program of its own beside this one, so that a render node needs no
// desktop libraries.
#pragma once

#include <string>
#include <vector>

namespace idap::cli {

// No arguments, or first one that is no command and no option: a file that is there, or would be a home by
// its extension.
bool meansStudio(int argc, char** argv);

// Becomes the studio. Comes back only where that cannot be, with the reason in one line.
std::string startStudio(const std::vector<std::string>& arguments);

}  // namespace idap::cli
