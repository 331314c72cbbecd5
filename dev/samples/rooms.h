// The homes of the templates, each designed to be lived in.
#pragma once

#include "model/home.h"

namespace idap::samples {

Home bedroom();
Home livingRoom();
Home kitchen();
Home bathroom();
Home office();
Home studioApartment();
Home twoBedroomApartment();

}  // namespace idap::samples
