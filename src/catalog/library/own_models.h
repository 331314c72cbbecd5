// Own furniture inside the home that it stands in, so that the home is whole without the library it came
// from.
#pragma once

#include "model/home.h"

namespace idap {

class OwnLibrary;

// Pieces of the user's own library bring their model's files with them.
bool usesOwnFurniture(const Home& home);
Home withOwnModels(const Home& home, const OwnLibrary& library);

}  // namespace idap
