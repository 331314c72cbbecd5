// OBJ material libraries (MTL) and the way from their Phong shading to a physically based Material.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/material.h"
#include "catalog/model_file.h"

namespace idap {

// A material as MTL and its relatives (3DS, DAE) describe it.
struct PhongMaterial {
  std::string name;
  Color diffuse{0.8f, 0.8f, 0.8f};
  Color specular{0, 0, 0};
  Vec3 emission{};                                // Ke, linear
  double exponent = 0;                            // Ns
  double opacity = 1;                             // d, or 1 - Tr
  double ior = 0;                                 // Ni; 0: not given
  int illumination = 2;                           // illum
  std::string diffuseMap, opacityMap, normalMap;  // file names as written
};

std::vector<PhongMaterial> parseMtl(std::string_view text);

// What the part of a model it lies on is for: models for Sweet Home 3D mark panes and mirrors by their
// group's name.
enum class SlotRole { Plain, Pane, Mirror };

// Loads the texture through siblings, trying the bare file name where the path leads nowhere.
Material materialOf(const PhongMaterial& phong, SlotRole role, const SiblingFiles& siblings);

// The default material of that name, or the one called "default".
PhongMaterial defaultPhongMaterial(std::string_view name);

// Perceptual roughness of a Phong highlight: alpha^2 = 2 / (exponent + 2) [Walter et al. 2007, eq. 37], and
// towards matt where the highlight is weak.
double roughnessOfPhong(double specular, double exponent);

}  // namespace idap
