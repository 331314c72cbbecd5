// Diagnostics for developers and bug reports, on standard error; silent below warnings unless IDAP_LOG says
// more.
#pragma once

#include <spdlog/spdlog.h>

namespace idap {

// Reads the level from the environment variable IDAP_LOG (trace, debug, info, warn, error, off).
void setUpLogging();

}  // namespace idap
