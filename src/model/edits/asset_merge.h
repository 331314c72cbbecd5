// Files of one home taken over into another.
#pragma once

#include "model/home.h"

namespace idap {

// Adds the files that the fragment uses to the home, and gives the fragment as it refers to them there: where
// another file has the name already, the new one gets a name of its own.
Home withAssetsOf(Home& home, const Home& fragment);

// Without files that the home before did not have and that nothing uses now.
Home withoutNewUnusedAssets(const Home& before, Home home);

}  // namespace idap
