// Where the program's own data lies: the built-in catalog, translations, denoiser weights.
#pragma once

#include <filesystem>

namespace idap {

// The first that is a folder of: the environment variable IDAP_DATA, <folder of the program>/../share/idap,
// and the share/ of the source tree the program was built from. Where none is, the last one, so that a
// message about a missing file names a real place.
std::filesystem::path dataFolder();

}  // namespace idap
