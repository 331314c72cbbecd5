// The clear atmosphere over a place on a round earth: how much of the sun's light comes through it and how
// much it scatters towards an observer on the ground. Rayleigh, aerosol and ozone in eight bands of the
// spectrum, single scattering integrated along each ray, the further orders by an isotropic approximation
// @cite hillaire2020sky.
#pragma once

#include <array>
#include <vector>

#include "geometry/vec.h"

namespace idap {

// Eight bands of 40 nm from 385 to 705 nm.
struct Bands {
  static constexpr int kCount = 8;
  std::array<float, kCount> v{};

  float& operator[](int i) { return v[static_cast<std::size_t>(i)]; }
  float operator[](int i) const { return v[static_cast<std::size_t>(i)]; }
};

// Light of the sun outside the air, weighted by `share` in each band, as CIE XYZ with Y in lux (or cd/m2
// where share is per steradian).
Vec3 sunlight(const Bands& share);

class Atmosphere {
 public:
  // turbidity: 1 pure air, 2 very clear, 3 usual, 6 hazy: the vertical optical depth at 550 nm, molecules and
  // aerosol together, over that of the molecules. groundAlbedo: 0..1. sinSun: sine of the sun's altitude.
  Atmosphere(float turbidity, float groundAlbedo, float sinSun);

  // Share of the sun's light that arrives straight, of a sun at this sine of altitude.
  Bands transmittanceToSun(float sinSun) const;

  // Light scattered towards the observer per unit of sunlight, 1/sr: total = even + phase * aerosol.
  struct Scattered {
    Bands even;     // molecules and multiple scattering
    Bands aerosol;  // to be multiplied by aerosolPhase
  };
  // Unit vectors, z up; a direction below the horizon counts as level.
  Scattered scattered(Vec3f direction, Vec3f sun) const;

  static float aerosolPhase(float cosToSun);

 private:
  // Amounts of the three substances along a way, km of air at the density of the ground (ozone: of its
  // layer).
  struct Columns {
    float molecules = 0, aerosol = 0, ozone = 0;
  };
  struct Medium {
    Bands molecules, aerosol;  // scattering, 1/km
    Bands extinction;          // 1/km
  };

  Columns densities(float height) const;
  Columns columnsToTop(float radius, float cosine) const;
  Medium medium(const Columns& density) const;
  Bands transmittance(const Columns& columns) const;
  Bands sunReaching(float radius, float cosSun) const;
  Bands multiple(float height, float cosSun) const;
  void tabulateColumns();
  void tabulateMultiple(float groundAlbedo);

  Bands molecules_, aerosolScattering_, aerosolExtinction_, ozone_;  // 1/km at full density
  float sinSun_;
  std::vector<Columns> columns_;
  std::vector<Bands> multiple_;
};

}  // namespace idap
