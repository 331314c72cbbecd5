// Wrong usage found after the options were read, by what they say together: exit status 2.
#pragma once

#include "base/error.h"

namespace idap::cli {

class UsageError : public Error {
 public:
  using Error::Error;
};

}  // namespace idap::cli
