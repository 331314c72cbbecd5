#include "catalog/parametric/registry.h"
namespace idap::parametric {
void addChairs(Generators&) {}
}  // namespace idap::parametric
