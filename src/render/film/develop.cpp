#include "render/film/develop.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "light/color_temperature.h"
#include "render/denoise/denoise.h"
#include "render/film/exposure.h"

namespace idap::render {

namespace {

// sRGB encoding to 0..255 by a table fine enough that interpolation errs by under 1/50 of a step.
class SrgbTable {
 public:
  SrgbTable() {
    for (std::size_t i = 0; i < value_.size(); ++i) {
      value_[i] = 255.0f * linearToSrgb(static_cast<float>(i) / static_cast<float>(kSteps));
    }
    value_[kSteps] = value_[kSteps + 1] = 255;  // rounding must not keep white from being white
  }
  float operator()(float linear) const {
    const float at = linear * static_cast<float>(kSteps);
    const auto i = static_cast<std::size_t>(at);
    const float t = at - static_cast<float>(i);
    return value_[i] + t * (value_[i + 1] - value_[i]);
  }

 private:
  static constexpr std::size_t kSteps = 4096;
  std::array<float, kSteps + 2> value_{};
};

// A dither threshold in [0, 1) whose error lies in high frequencies (interleaved gradient noise), another
// pattern for each channel. @cite jimenez2014ign
float threshold(int x, int y, int channel) {
  const float fx = static_cast<float>(x + 47 * channel), fy = static_cast<float>(y + 17 * channel);
  const float inner = 0.06711056f * fx + 0.00583715f * fy;
  const float outer = 52.9829189f * (inner - std::floor(inner));
  return std::min(outer - std::floor(outer), 0.999f);
}

std::uint8_t quantized(float value, float dither) {
  return static_cast<std::uint8_t>(std::min(value + dither, 255.0f));
}

struct Matrix {
  Vec3f r0, r1, r2;
  Vec3f operator*(Vec3f v) const { return {dot(r0, v), dot(r1, v), dot(r2, v)}; }
};

// Linear Rec. 709 -> CIE XYZ -> Bradford cones, and back.
constexpr Matrix kToXyz{{0.4123908f, 0.3575843f, 0.1804808f},
                        {0.2126390f, 0.7151687f, 0.0721923f},
                        {0.0193308f, 0.1191948f, 0.9505322f}};
constexpr Matrix kFromXyz{{3.2409699f, -1.5373832f, -0.4986108f},
                          {-0.9692436f, 1.8759675f, 0.0415551f},
                          {0.0556301f, -0.2039770f, 1.0569715f}};
constexpr Matrix kToCone{
    {0.8951f, 0.2664f, -0.1614f}, {-0.7502f, 1.7135f, 0.0367f}, {0.0389f, -0.0685f, 1.0296f}};
constexpr Matrix kFromCone{{0.9869929f, -0.1470543f, 0.1599627f},
                           {0.4323053f, 0.5183603f, 0.0492912f},
                           {-0.0085287f, 0.0400428f, 0.9684867f}};

}  // namespace

WhiteBalance::WhiteBalance(Rgb illuminant, float share) {
  const Vec3f white = kToCone * (kToXyz * Rgb{1, 1, 1});
  const float y = std::max(luminance(illuminant), 1e-6f);
  const Vec3f light = kToCone * (kToXyz * (illuminant / y));
  const auto gain = [&](float w, float l) {
    return std::pow(std::clamp(w / std::max(l, 0.02f), 0.05f, 20.0f), share);
  };
  const Vec3f g{gain(white.x, light.x), gain(white.y, light.y), gain(white.z, light.z)};
  const auto balance = [&](Vec3f c) { return kFromXyz * (kFromCone * (g * (kToCone * (kToXyz * c)))); };
  // The light itself must stay as bright as it was.
  const float scale = 1.0f / std::max(luminance(balance(illuminant / y)), 1e-3f);
  const Vec3f x = balance({1, 0, 0}) * scale, yy = balance({0, 1, 0}) * scale, z = balance({0, 0, 1}) * scale;
  row_[0] = {x.x, yy.x, z.x};
  row_[1] = {x.y, yy.y, z.y};
  row_[2] = {x.z, yy.z, z.z};
}

Rgb WhiteBalance::operator()(Rgb c) const {
  return {std::max(dot(row_[0], c), 0.0f), std::max(dot(row_[1], c), 0.0f), std::max(dot(row_[2], c), 0.0f)};
}

Rgb onLocus(Rgb illuminant) {
  if (!(illuminant.x > 0) || !(illuminant.z > 0)) return {1, 1, 1};
  // Red over blue falls all the way from candles to the blue hour, so halving finds the temperature.
  const float wanted = illuminant.x / illuminant.z;
  double warm = 2200, cold = 12'000;
  for (int step = 0; step < 24; ++step) {
    const double middle = std::sqrt(warm * cold);
    const Rgb c = rgbFromTemperature(middle);
    (c.x > wanted * std::max(c.z, 1e-6f) ? warm : cold) = middle;
  }
  const Rgb c = rgbFromTemperature(std::sqrt(warm * cold));
  return c / luminance(c);
}

Rgb estimateIlluminant(const Film& film) {
  // Every pixel says the colour it sees, the brighter ones louder, but none louder than ten average ones: a
  // lamp in the picture or a sun spot must not decide.
  double meanLuminance = 0;
  std::size_t counted = 0;
  const auto light = [&](std::size_t i) -> Rgb {
    const Rgb albedo = film.meanAlbedo(i), color = film.meanColor(i);
    if (film.depth[i] == 0 || !(std::min({albedo.x, albedo.y, albedo.z}) > 0.04f)) return {};
    const Rgb demodulated = color / albedo;
    const float l = luminance(demodulated);
    return std::isfinite(l) && l > 0 ? demodulated : Rgb{};
  };
  for (std::size_t i = 0; i < film.pixels(); ++i) {
    const float l = luminance(light(i));
    if (l <= 0) continue;
    meanLuminance += static_cast<double>(l);
    ++counted;
  }
  if (counted == 0) return {1, 1, 1};
  const float limit = 10.0f * static_cast<float>(meanLuminance / static_cast<double>(counted));
  Vec3 sum;
  for (std::size_t i = 0; i < film.pixels(); ++i) {
    const Rgb c = light(i);
    const float l = luminance(c);
    if (l > 0) sum += toDouble(c * (std::min(l, limit) / l));
  }
  const Rgb total = toFloat(sum / static_cast<double>(counted));
  return onLocus(total);
}

std::vector<Rgb> developLinear(const Film& film, const DevelopSettings& settings, Denoiser* denoiser) {
  std::vector<Rgb> color = film.meanColors();
  if (settings.toneMap == ToneMap::Classic) return color;
  if (settings.denoise) {
    const DenoiseSettings how{
        .threads = settings.threads, .fast = settings.fastDenoise, .progress = settings.progress};
    if (denoiser) {
      denoiser->run(film, color, how);
    } else {
      denoise(film, color, how);
    }
  }
  const float ev = (settings.ev ? *settings.ev : autoExposure(film, color)) - settings.compensation;
  const float multiplier = exposureMultiplier(ev);
  const float share = std::clamp(settings.whiteBalance, 0.0f, 1.0f);
  const WhiteBalance balance(
      share > 0 ? settings.illuminant.value_or(estimateIlluminant(film)) : Rgb{1, 1, 1}, share);
  for (Rgb& c : color) c = (share > 0 ? balance(c) : c) * multiplier;
  return color;
}

Image8 toImage(const std::vector<Rgb>& exposed, int width, int height, ToneMap toneMap) {
  static const SrgbTable encode;
  Image8 image(width, height);
  if (exposed.size() * 3 != image.rgb.size()) throw RenderError("a picture and its colours differ in size");
  tbb::parallel_for(tbb::blocked_range<int>(0, height), [&](const tbb::blocked_range<int>& rows) {
    for (int y = rows.begin(); y < rows.end(); ++y) {
      for (int x = 0; x < width; ++x) {
        const auto i =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
        const Rgb c = toneMapped(exposed[i], toneMap);
        std::uint8_t* out = image.pixel(x, y);
        for (int k = 0; k < 3; ++k) out[k] = quantized(encode(c[k]), threshold(x, y, k));
      }
    }
  });
  return image;
}

Image8 develop(const Film& film, const DevelopSettings& settings, Denoiser* denoiser) {
  return toImage(developLinear(film, settings, denoiser), film.width, film.height, settings.toneMap);
}

Texture developTransparent(const Film& film, const DevelopSettings& settings) {
  std::vector<Rgb> linear = developLinear(film, settings);
  // What a pixel shows is darker by its share of sky; the alpha says so instead.
  for (std::size_t i = 0; i < linear.size(); ++i)
    linear[i] = linear[i] * (1 / std::max(film.meanCoverage(i), 1.0f / 255));
  const Image8 image = toImage(linear, film.width, film.height, settings.toneMap);
  Texture out;
  out.width = film.width, out.height = film.height;
  out.hasAlpha = true;
  out.rgba.resize(4 * film.pixels());
  for (std::size_t i = 0; i < film.pixels(); ++i) {
    std::copy_n(&image.rgb[3 * i], 3, &out.rgba[4 * i]);
    out.rgba[4 * i + 3] =
        static_cast<std::uint8_t>(255 * std::clamp(film.meanCoverage(i), 0.0f, 1.0f) + 0.5f);
  }
  return out;
}

}  // namespace idap::render
