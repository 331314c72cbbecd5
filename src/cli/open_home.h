// What every command that takes a home does first: read it, and tell what had to be mended.
#pragma once

#include <string>

#include "base/progress.h"
#include "cli/message.h"
#include "formats/registry.h"

namespace idap::cli {

ReadResult openHome(const std::string& file, Warnings& warnings, const Progress& progress);

}  // namespace idap::cli
