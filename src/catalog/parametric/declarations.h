// What a user may choose of each generator's pieces, beyond what a piece's JSON gives: kinds, ranges,
// options, and the names of all parameters. The generators keep to these ranges themselves.
#pragma once

#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "catalog/parametric/registry.h"

namespace idap::parametric {

// Kind and label of a parameter by its name; a length of its own name where nothing is known of it.
PieceParameter describedParameter(const std::string& name);

// Appends the generator's own parameters that are not in the list already. They start where `given` says,
// else where the generator starts. Throws std::invalid_argument where `given` has an option that is not
// declared.
void addDeclared(const std::string& generator, const Parameters& given, std::vector<PieceParameter>& to);

}  // namespace idap::parametric
