// Whether the groups around a piece let it be seen.
#pragma once

#include "model/home.h"

namespace idap {

// False when this group, or one that it is in, is hidden; true for no group and for unknown ones.
bool groupsShown(const Home& home, GroupId group);

}  // namespace idap
