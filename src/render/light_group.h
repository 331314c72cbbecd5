// Lights whose share of a picture is kept by itself: each lamp of the home, the sun, the sky.
#pragma once

#include <string>

#include "light/rgb.h"

namespace idap::render {

struct LightGroup {
  std::string name;
  Rgb color{};  // of its light, linear, luminance 1; black: not known
  friend bool operator==(const LightGroup&, const LightGroup&) = default;
};

}  // namespace idap::render
