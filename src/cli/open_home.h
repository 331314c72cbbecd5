// What every command that takes a home does first: read it, and tell what had to be mended.
#pragma once

#include <string>

#include "base/progress.h"
#include "formats/registry.h"

namespace idap::cli {

// Reads the home and prints the report's entries as warnings on standard error (at most ten, then how many more).
ReadResult openHome(const std::string& file, const Progress& progress = {});

}  // namespace idap::cli
