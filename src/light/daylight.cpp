#include "light/daylight.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "light/atmosphere.h"
#include "light/spectrum.h"

namespace idap {

namespace {

// Share of what a clear day gives level ground (sun and sky) that comes through closed cloud, and through the
// scattered clouds of a partly cloudy sky besides the clear part: the former gives 300 + 21000 sin(altitude)
// lux within a third @cite krochmann1974daylight.
constexpr double kCloudShare = 0.2, kPartlyCloudShare = 0.15;
constexpr double kPartlySun = 0.8, kPartlyClear = 0.6;
constexpr double kDarkestSun = -0.31;  // sine of 18 degrees under the horizon: night

// The clear sky on a grid that is fine near the horizon, symmetric about the sun's azimuth.
class ClearSky {
 public:
  ClearSky(const Atmosphere& air, Vec3f sun) : sun_(sun) {
    even_.resize(kRows * kColumns);
    aerosol_.resize(kRows * kColumns);
    const float sinSun = sun.z, cosSun = std::sqrt(std::max(1 - sinSun * sinSun, 0.0f));
    const Vec3f turned{cosSun, 0, sinSun};
    for (int i = 0; i < kRows; ++i) {
      const double u = static_cast<double>(i) / (kRows - 1), elevation = u * u * kPi / 2;
      for (int j = 0; j < kColumns; ++j) {
        const double azimuth = kPi * j / (kColumns - 1);
        const Vec3f d = toFloat(Vec3{std::cos(elevation) * std::cos(azimuth),
                                     std::cos(elevation) * std::sin(azimuth), std::sin(elevation)});
        const Atmosphere::Scattered s = air.scattered(d, turned);
        even_[static_cast<std::size_t>(i * kColumns + j)] = sunlight(s.even);
        aerosol_[static_cast<std::size_t>(i * kColumns + j)] = sunlight(s.aerosol);
      }
    }
  }

  // CIE XYZ, Y in cd/m2.
  Vec3 operator()(Vec3f d) const {
    const double elevation = std::asin(std::clamp(static_cast<double>(d.z), 0.0, 1.0));
    const double azimuth =
        std::fabs(std::atan2(static_cast<double>(cross(Vec2f{sun_.x, sun_.y}, Vec2f{d.x, d.y})),
                             static_cast<double>(dot(Vec2f{sun_.x, sun_.y}, Vec2f{d.x, d.y}))));
    const double y = std::sqrt(elevation / (kPi / 2)) * (kRows - 1), x = azimuth / kPi * (kColumns - 1);
    const int i = std::min(static_cast<int>(y), kRows - 2), j = std::min(static_cast<int>(x), kColumns - 2);
    const auto mixed = [&](const std::vector<Vec3>& table) {
      const Vec3* row = &table[static_cast<std::size_t>(i * kColumns + j)];
      const Vec3 low = row[0] + (row[1] - row[0]) * (x - j);
      const Vec3 high = row[kColumns] + (row[kColumns + 1] - row[kColumns]) * (x - j);
      return low + (high - low) * (y - i);
    };
    return mixed(even_) + mixed(aerosol_) * static_cast<double>(Atmosphere::aerosolPhase(dot(d, sun_)));
  }

 private:
  static constexpr int kRows = 40, kColumns = 24;
  Vec3f sun_;
  std::vector<Vec3> even_, aerosol_;
};

// Stars and airglow, and the lamps of towns in the haze, brighter towards the horizon. XYZ.
Vec3 nightSky(Vec3f d, double cityGlow) {
  constexpr double kNatural = 2.0e-4;  // cd/m2, about 21.8 magnitudes a square second
  const double low = 1 - std::clamp(static_cast<double>(d.z), 0.0, 1.0);
  const Vec3 starlight{0.97, 1.0, 1.1}, lamps{1.0, 1.0, 0.7};
  return starlight * (kNatural * (1 + 0.6 * low)) + lamps * (cityGlow * (1 + 3 * low * low));
}

// Overcast after Moon and Spencer, for 1 lux on level ground.
double overcast(Vec3f d) { return (1 + 2 * static_cast<double>(d.z)) / 3 * 9 / (7 * kPi); }

struct Grid {
  int width, height;
  double elevation(int row) const { return kPi / 2 - kPi * (row + 0.5) / height; }
  Vec3f direction(int row, int column) const {
    const double e = elevation(row), a = 2 * kPi * (column + 0.5) / width;
    return toFloat(Vec3{std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)});
  }
  // Projected solid angle of one pixel on level ground.
  double weight(int row) const {
    const double top = std::sin(kPi / 2 - kPi * row / height),
                 bottom = std::sin(kPi / 2 - kPi * (row + 1) / height);
    return kPi / width * (top * top - bottom * bottom);
  }
};

}  // namespace

Daylight daylightFor(const DaylightConditions& c, int width, int height) {
  if (width < 4 || height < 4 || height % 2 != 0)
    throw Error("a sky must have at least 4 x 4 pixels, in even rows");
  const float norm = length(c.sunDirection);
  if (!(norm > 0) || !std::isfinite(norm)) throw Error("the direction of the sun is not a direction");
  const Vec3f sun = c.sunDirection / norm;
  const Grid grid{width, height};
  const int rows = height / 2;
  const double albedo = std::clamp(static_cast<double>(c.groundAlbedo), 0.0, 1.0);

  // The clear day first: every other weather is measured by it.
  std::vector<Vec3> sky(static_cast<std::size_t>(width) * static_cast<std::size_t>(rows));
  Vec3 direct;
  if (static_cast<double>(sun.z) > kDarkestSun) {
    const Atmosphere air(std::clamp(c.turbidity, 1.0f, 12.0f), c.groundAlbedo, sun.z);
    direct = sunlight(air.transmittanceToSun(sun.z));
    const ClearSky clear(air, sun);
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < width; ++x)
        sky[static_cast<std::size_t>(y * width + x)] = clear(grid.direction(y, x));
    }
  }
  const auto onGround = [&](const std::vector<Vec3>& radiance) {
    Vec3 sum;
    for (int y = 0; y < rows; ++y) {
      Vec3 row;
      for (int x = 0; x < width; ++x) row += radiance[static_cast<std::size_t>(y * width + x)];
      sum += row * grid.weight(y);
    }
    return sum;
  };
  const double sinSun = std::max(static_cast<double>(sun.z), 0.0);
  const Vec3 global = direct * sinSun + onGround(sky);
  // Clouds mix the warm sun and the blue sky and lose the more of the warm light's surplus in many
  // scatterings.
  const Vec3 white = Vec3{0.9505, 1, 1.089} * global.y;
  const Vec3 cloud = global * 0.4 + white * 0.6;
  const double clearShare = c.weather == Weather::Clear ? 1 : c.weather == Weather::Partly ? kPartlyClear : 0;
  const double cloudShare = c.weather == Weather::Clear    ? 0
                            : c.weather == Weather::Partly ? kPartlyCloudShare
                                                           : kCloudShare;
  const double sunShare = c.weather == Weather::Clear ? 1 : c.weather == Weather::Partly ? kPartlySun : 0;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < width; ++x) {
      const Vec3f d = grid.direction(y, x);
      Vec3& l = sky[static_cast<std::size_t>(y * width + x)];
      l = l * clearShare + cloud * (cloudShare * overcast(d)) +
          nightSky(d, std::max(static_cast<double>(c.cityGlow), 0.0));
    }
  }
  direct = direct * sunShare;
  const Vec3 diffuse = onGround(sky);

  Daylight result;
  result.sunDirection = sun;
  result.sunIlluminance = displayableRgb(direct);
  result.skyIlluminance = displayableRgb(diffuse);
  result.width = width;
  result.height = height;
  result.skyRadiance.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (const Vec3& xyz : sky) result.skyRadiance.push_back(displayableRgb(xyz));
  // Below the horizon the ground, lit by both; far off it fades into the haze of the horizon.
  constexpr double kHaze = 1.2 * kPi / 180;
  const Vec3 ground = (diffuse + direct * sinSun) * (albedo / kPi);
  for (int y = rows; y < height; ++y) {
    const double haze = 0.7 * std::exp(grid.elevation(y) / kHaze);
    for (int x = 0; x < width; ++x) {
      const Vec3 horizon = sky[static_cast<std::size_t>((rows - 1) * width + x)];
      result.skyRadiance.push_back(displayableRgb(ground * (1 - haze) + horizon * haze));
    }
  }
  return result;
}

}  // namespace idap
