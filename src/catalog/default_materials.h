// The materials that an OBJ file may use by name without bringing a material library. The names and values
// are those of Java 3D's OBJ loader (published with java3d-utils); models made for it, Sweet Home 3D's among
// them, rely on them.
#pragma once

#include <string_view>

#include "model/finish.h"

namespace idap {

struct DefaultMaterial {
  std::string_view name;
  Color color;
  double specular = 0;      // 0..1, strongest channel
  double exponent = 0;      // of Phong's highlight
  double transparency = 0;  // 0 opaque .. 1 clear
};

// Null when there is none of that name.
const DefaultMaterial* findDefaultMaterial(std::string_view name);

}  // namespace idap
