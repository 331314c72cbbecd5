#include "light/atmosphere.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "light/spectrum.h"

namespace idap {

namespace {

constexpr float kGround = 6360, kTop = 6460;  // radii, km
constexpr float kObserver = 0.01f;            // km above the ground
constexpr float kMoleculeScale = 8.0f, kAerosolScale = 1.2f;
constexpr float kOzoneMiddle = 25, kOzoneHalfWidth = 15;
constexpr float kSunRadius = 0.00465f;  // radians
constexpr float kAsymmetry = 0.8f;      // of the aerosol's phase function
constexpr float kAerosolAlbedo = 0.92f;
constexpr float kPiF = static_cast<float>(kPi);

// Spectra every 10 nm from 390 nm, four values a band.
constexpr int kFirstWavelength = 390, kStep = 10, kPerBand = 4;
// Sunlight outside the air, W/(m2 nm). @cite astmg173
constexpr std::array<double, 32> kSun{1.147, 1.728, 1.731, 1.689, 1.613, 1.912, 2.035, 2.020,
                                      2.022, 1.934, 1.958, 1.917, 1.830, 1.869, 1.893, 1.851,
                                      1.850, 1.834, 1.835, 1.815, 1.782, 1.753, 1.697, 1.682,
                                      1.647, 1.605, 1.521, 1.556, 1.511, 1.474, 1.448, 1.410};
// Ozone's absorption cross section, 1e-25 m2. @cite gorshelev2014ozone
constexpr std::array<double, 32> kOzone{0.0066, 0.0153, 0.0276, 0.0552, 0.0845, 0.158, 0.232, 0.367,
                                        0.492,  0.775,  0.902,  1.48,   1.60,   2.14,  2.76,  3.09,
                                        3.50,   4.27,   4.67,   4.40,   4.70,   5.02,  4.31,  3.74,
                                        3.22,   2.66,   2.24,   1.85,   1.47,   1.21,  0.942, 0.746};
constexpr double kOzoneColumn = 300 * 2.687e20;  // 300 Dobson units, molecules / m2

template <class F>
Bands bandMeans(const F& f) {
  Bands bands;
  for (int b = 0; b < Bands::kCount; ++b) {
    double sum = 0;
    for (int k = 0; k < kPerBand; ++k) {
      const int i = b * kPerBand + k;
      sum += f(i, static_cast<double>(kFirstWavelength + kStep * i));
    }
    bands[b] = static_cast<float>(sum / kPerBand);
  }
  return bands;
}

// e^x for x <= 0 to 3e-6, without a branch so that the compiler makes vectors of it.
inline float fastExp(float x) {
  const float t = std::max(x * 1.44269504f, -120.0f);
  const float whole = std::floor(t);
  const float f = t - whole;
  const float p =
      1 + f * (0.69314718f + f * (0.24022651f + f * (0.05550411f + f * (0.00961813f + f * 0.00133336f))));
  return p * std::bit_cast<float>((static_cast<std::int32_t>(whole) + 127) << 23);
}

float distanceToSphere(float radius, float cosine, float sphere) {
  const float inside = radius * radius * (cosine * cosine - 1) + sphere * sphere;
  return inside < 0 ? -1 : -radius * cosine + std::sqrt(inside);
}

bool hitsGround(float radius, float cosine) {
  return cosine < 0 && radius * radius * (cosine * cosine - 1) + kGround * kGround >= 0;
}

float moleculePhase(float c) { return 3 / (16 * kPiF) * (1 + c * c); }

// Column table: distance along the ray to the top against height, both through square roots that give the
// horizon its share. @cite bruneton2008sky
constexpr int kColumnHeights = 32, kColumnAngles = 128;
const float kHorizonDistance = std::sqrt(kTop * kTop - kGround * kGround);

// Multiple scattering: heights up to 60 km, suns around the one there is (the earth bends under long rays).
constexpr int kHeights = 10, kSuns = 9;
constexpr float kMultipleTop = 60, kSunSpread = 0.2f;

}  // namespace

Vec3 sunlight(const Bands& share) {
  static const std::array<Vec3, Bands::kCount> perBand = [] {
    std::array<Vec3, Bands::kCount> xyz;
    for (int i = 0; i < Bands::kCount * kPerBand; ++i) {
      const double power = kMaxEfficacy * kStep * kSun[static_cast<std::size_t>(i)];
      xyz[static_cast<std::size_t>(i / kPerBand)] += colorMatching(kFirstWavelength + kStep * i) * power;
    }
    return xyz;
  }();
  Vec3 sum;
  for (int b = 0; b < Bands::kCount; ++b)
    sum += perBand[static_cast<std::size_t>(b)] * static_cast<double>(share[b]);
  return sum;
}

Atmosphere::Atmosphere(float turbidity, float groundAlbedo, float sinSun) : sinSun_(sinSun) {
  constexpr double kAngstrom = 1.3;  // the aerosol's fall with the wavelength
  // Vertical optical depth of the molecules at sea level. @cite bodhaine1999rayleigh
  const auto moleculeDepth = [](double nm) {
    const double um = nm / 1000;
    return 0.00864 * std::pow(um, -(3.916 + 0.074 * um + 0.05 / um));
  };
  molecules_ =
      bandMeans([&](int, double nm) { return moleculeDepth(nm) / static_cast<double>(kMoleculeScale); });
  const double aerosolDepth = std::clamp(static_cast<double>(turbidity) - 1, 0.0, 30.0) * moleculeDepth(550);
  aerosolExtinction_ = bandMeans([&](int, double nm) {
    return aerosolDepth / static_cast<double>(kAerosolScale) * std::pow(nm / 550, -kAngstrom);
  });
  for (int b = 0; b < Bands::kCount; ++b) aerosolScattering_[b] = kAerosolAlbedo * aerosolExtinction_[b];
  // The layer is a tent; its area is its half width times its peak.
  ozone_ = bandMeans([](int i, double) {
    return kOzone[static_cast<std::size_t>(i)] * 1e-25 * kOzoneColumn / static_cast<double>(kOzoneHalfWidth);
  });
  tabulateColumns();
  tabulateMultiple(std::clamp(groundAlbedo, 0.0f, 1.0f));
}

Atmosphere::Columns Atmosphere::densities(float height) const {
  return {fastExp(-std::max(height, 0.0f) / kMoleculeScale), fastExp(-std::max(height, 0.0f) / kAerosolScale),
          std::max(1 - std::fabs(height - kOzoneMiddle) / kOzoneHalfWidth, 0.0f)};
}

void Atmosphere::tabulateColumns() {
  columns_.resize(kColumnHeights * kColumnAngles);
  constexpr int kSteps = 40;
  for (int i = 0; i < kColumnHeights; ++i) {
    const float rho = kHorizonDistance * static_cast<float>(i) / (kColumnHeights - 1);
    const float radius = std::max(std::sqrt(rho * rho + kGround * kGround), kGround + kObserver);
    for (int j = 0; j < kColumnAngles; ++j) {
      const float shortest = kTop - radius, longest = rho + kHorizonDistance;
      const float length = shortest + (longest - shortest) * static_cast<float>(j) / (kColumnAngles - 1);
      const float cosine = length > 0 ? (kHorizonDistance * kHorizonDistance - rho * rho - length * length) /
                                            (2 * radius * length)
                                      : 1.0f;
      Columns sum;
      float before = 0;
      for (int k = 0; k < kSteps; ++k) {
        // Steps grow with the square: the air is thick below.
        const float s = static_cast<float>(k + 1) / kSteps;
        const float end = length * s * s;
        const float t = 0.5f * (before + end), dt = end - before;
        before = end;
        const float height = std::sqrt(radius * radius + t * t + 2 * radius * t * cosine) - kGround;
        const Columns d = densities(height);
        sum.molecules += d.molecules * dt;
        sum.aerosol += d.aerosol * dt;
        sum.ozone += d.ozone * dt;
      }
      columns_[static_cast<std::size_t>(i * kColumnAngles + j)] = sum;
    }
  }
}

Atmosphere::Columns Atmosphere::columnsToTop(float radius, float cosine) const {
  const float rho = std::sqrt(std::max(radius * radius - kGround * kGround, 0.0f));
  const float shortest = kTop - radius, longest = rho + kHorizonDistance;
  const float length = std::max(distanceToSphere(radius, cosine, kTop), 0.0f);
  const float x = std::clamp((length - shortest) / (longest - shortest), 0.0f, 1.0f) * (kColumnAngles - 1);
  const float y = std::clamp(rho / kHorizonDistance, 0.0f, 1.0f) * (kColumnHeights - 1);
  const int j = std::min(static_cast<int>(x), kColumnAngles - 2),
            i = std::min(static_cast<int>(y), kColumnHeights - 2);
  const float fx = x - static_cast<float>(j), fy = y - static_cast<float>(i);
  const Columns* row = &columns_[static_cast<std::size_t>(i * kColumnAngles + j)];
  const auto mixed = [&](float Columns::*m) {
    const float low = row[0].*m + fx * (row[1].*m - row[0].*m);
    const float high = row[kColumnAngles].*m + fx * (row[kColumnAngles + 1].*m - row[kColumnAngles].*m);
    return low + fy * (high - low);
  };
  return {mixed(&Columns::molecules), mixed(&Columns::aerosol), mixed(&Columns::ozone)};
}

Atmosphere::Medium Atmosphere::medium(const Columns& d) const {
  Medium m;
  for (int b = 0; b < Bands::kCount; ++b) {
    m.molecules[b] = molecules_[b] * d.molecules;
    m.aerosol[b] = aerosolScattering_[b] * d.aerosol;
    m.extinction[b] = m.molecules[b] + aerosolExtinction_[b] * d.aerosol + ozone_[b] * d.ozone;
  }
  return m;
}

Bands Atmosphere::transmittance(const Columns& c) const {
  Bands t;
  for (int b = 0; b < Bands::kCount; ++b) {
    t[b] = fastExp(-(molecules_[b] * c.molecules + aerosolExtinction_[b] * c.aerosol + ozone_[b] * c.ozone));
  }
  return t;
}

Bands Atmosphere::sunReaching(float radius, float cosSun) const {
  // The disc sinks behind the horizon little by little.
  const float sinHorizon = std::min(kGround / radius, 1.0f);
  const float horizon = -std::sqrt(1 - sinHorizon * sinHorizon);
  const float edge = std::clamp((cosSun - horizon) / (sinHorizon * kSunRadius) * 0.5f + 0.5f, 0.0f, 1.0f);
  const float visible = edge * edge * (3 - 2 * edge);
  if (visible <= 0) return {};
  Bands t = transmittance(columnsToTop(radius, std::max(cosSun, horizon)));
  for (int b = 0; b < Bands::kCount; ++b) t[b] *= visible;
  return t;
}

Bands Atmosphere::transmittanceToSun(float sinSun) const { return sunReaching(kGround + kObserver, sinSun); }

// What isotropic light of all orders beyond the first adds at a point: the second order, gathered over the
// sphere, times the sum of a geometric series of the share that is scattered again.
void Atmosphere::tabulateMultiple(float groundAlbedo) {
  multiple_.resize(kHeights * kSuns);
  constexpr int kZeniths = 8, kAzimuths = 4, kSteps = 16;
  for (int i = 0; i < kHeights; ++i) {
    const float u = static_cast<float>(i) / (kHeights - 1);
    const float radius = kGround + std::max(kMultipleTop * u * u, kObserver);
    for (int j = 0; j < kSuns; ++j) {
      const float cosSun =
          std::clamp(sinSun_ + kSunSpread * (2.0f * static_cast<float>(j) / (kSuns - 1) - 1), -1.0f, 1.0f);
      const float sinSun = std::sqrt(1 - cosSun * cosSun);
      Bands second, again;
      for (int a = 0; a < kZeniths * kAzimuths; ++a) {
        const float cosine = (static_cast<float>(a / kAzimuths) + 0.5f) / kZeniths * 2 - 1;
        const float azimuth = kPiF * (static_cast<float>(a % kAzimuths) + 0.5f) / kAzimuths;
        const float sine = std::sqrt(1 - cosine * cosine);
        const float cosToSun = cosine * cosSun + sine * sinSun * std::cos(azimuth);
        const bool ground = hitsGround(radius, cosine);
        const float length =
            ground
                ? -radius * cosine -
                      std::sqrt(std::max(radius * radius * (cosine * cosine - 1) + kGround * kGround, 0.0f))
                : distanceToSphere(radius, cosine, kTop);
        Bands through;
        through.v.fill(1);
        float before = 0;
        for (int k = 0; k < kSteps; ++k) {
          const float s = static_cast<float>(k + 1) / kSteps;
          const float end = length * s * s, t = 0.5f * (before + end), dt = end - before;
          before = end;
          const float r = std::sqrt(radius * radius + t * t + 2 * radius * t * cosine);
          const Medium m = medium(densities(r - kGround));
          const Bands sun = sunReaching(r, (radius * cosSun + t * cosToSun) / r);
          for (int b = 0; b < Bands::kCount; ++b) {
            const float scattering = m.molecules[b] + m.aerosol[b];
            const float step = fastExp(-m.extinction[b] * dt);
            const float integral = through[b] * (1 - step) / std::max(m.extinction[b], 1e-12f);
            second[b] += integral * scattering * sun[b] / (4 * kPiF);
            again[b] += integral * scattering;
            through[b] *= step;
          }
        }
        if (ground) {
          const float cosAtGround = (radius * cosSun + length * cosToSun) / kGround;
          const Bands sun = sunReaching(kGround + kObserver, cosAtGround);
          for (int b = 0; b < Bands::kCount; ++b) {
            second[b] += through[b] * groundAlbedo / kPiF * sun[b] * std::max(cosAtGround, 0.0f);
          }
        }
      }
      Bands& psi = multiple_[static_cast<std::size_t>(i * kSuns + j)];
      constexpr float kShare = 1.0f / (kZeniths * kAzimuths);
      for (int b = 0; b < Bands::kCount; ++b)
        psi[b] = second[b] * kShare / (1 - std::min(again[b] * kShare, 0.95f));
    }
  }
}

Bands Atmosphere::multiple(float height, float cosSun) const {
  const float y = std::sqrt(std::clamp(height / kMultipleTop, 0.0f, 1.0f)) * (kHeights - 1);
  const float x = std::clamp((cosSun - sinSun_) / kSunSpread * 0.5f + 0.5f, 0.0f, 1.0f) * (kSuns - 1);
  const int i = std::min(static_cast<int>(y), kHeights - 2), j = std::min(static_cast<int>(x), kSuns - 2);
  const float fy = y - static_cast<float>(i), fx = x - static_cast<float>(j);
  const Bands* row = &multiple_[static_cast<std::size_t>(i * kSuns + j)];
  Bands mixed;
  for (int b = 0; b < Bands::kCount; ++b) {
    const float low = row[0][b] + fx * (row[1][b] - row[0][b]);
    const float high = row[kSuns][b] + fx * (row[kSuns + 1][b] - row[kSuns][b]);
    mixed[b] = low + fy * (high - low);
  }
  return mixed;
}

float Atmosphere::aerosolPhase(float c) {
  // Cornette and Shanks. @cite cornette1992phase
  constexpr float g = kAsymmetry, g2 = g * g;
  return 3 / (8 * kPiF) * (1 - g2) * (1 + c * c) / ((2 + g2) * std::pow(1 + g2 - 2 * g * c, 1.5f));
}

Atmosphere::Scattered Atmosphere::scattered(Vec3f direction, Vec3f sun) const {
  constexpr int kSteps = 32;
  const float radius = kGround + kObserver;
  const float cosine = std::max(direction.z, 0.0f);
  const float cosToSun = dot(direction, sun);
  const float length = distanceToSphere(radius, cosine, kTop);
  const float phase = moleculePhase(cosToSun);
  Scattered sum;
  Bands through;
  through.v.fill(1);
  float before = 0;
  for (int k = 0; k < kSteps; ++k) {
    const float s = static_cast<float>(k + 1) / kSteps;
    const float end = length * s * s, t = 0.5f * (before + end), dt = end - before;
    before = end;
    const float r = std::sqrt(radius * radius + t * t + 2 * radius * t * cosine);
    const float cosSun = (radius * sun.z + t * cosToSun) / r;
    const Medium m = medium(densities(r - kGround));
    const Bands reaching = sunReaching(r, cosSun);
    const Bands further = multiple(r - kGround, cosSun);
    for (int b = 0; b < Bands::kCount; ++b) {
      const float step = fastExp(-m.extinction[b] * dt);
      const float integral = through[b] * (1 - step) / std::max(m.extinction[b], 1e-12f);
      sum.even[b] +=
          integral * (m.molecules[b] * phase * reaching[b] + (m.molecules[b] + m.aerosol[b]) * further[b]);
      sum.aerosol[b] += integral * m.aerosol[b] * reaching[b];
      through[b] *= step;
    }
  }
  return sum;
}

}  // namespace idap
