// The border control of the model: nothing that breaks these rules gets into a Document.
#pragma once

#include "model/home.h"
#include "model/import_report.h"

namespace idap {

// Mends what can be mended and drops the rest, and says so in the report: non-finite numbers; walls of zero
// length, thickness or height; sizes that are not positive or absurd (over 10 km); rooms under three points
// or without area; ids that point nowhere or in circles; walls that lie on each other exactly.
Home validated(Home home, ImportReport& report);

// Throws InvalidHome with the first broken rule. What validated() returns always passes.
void requireValid(const Home& home);

// The same for a home made from a valid one, in time that grows with what changed.
void requireValid(const Home& home, const Home& validBefore);

}  // namespace idap
