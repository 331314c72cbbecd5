// From the film to a picture people look at: denoise, white balance, exposure, tone curve, 8 bits.
#pragma once

#include <optional>
#include <vector>

#include "base/image8.h"
#include "base/progress.h"
#include "render/film/film.h"
#include "render/film/tone_map.h"
#include "render/scene.h"

namespace idap::render {

class Denoiser;

struct DevelopSettings {
  std::optional<float> ev{};  // EV100; none: from the picture
  float compensation = 0;     // stops on top; positive is brighter
  ToneMap toneMap = ToneMap::PbrNeutral;
  float whiteBalance = 0.75f;  // how far the eye adapts to the light's colour: 0 not at all, 1 wholly
  bool denoise = true;
  bool fastDenoise = false;            // the smaller network: about twice as fast, for previews
  int threads = 0;                     // 0: as many as the machine has
  std::optional<Rgb> illuminant{};     // the light's colour, luminance 1; none: from the picture
  const Progress* progress = nullptr;  // whether to go on denoising; then Cancelled is thrown
};

// The picture, ready for a screen: sRGB, dithered so that smooth walls show no bands. The same film and
// settings always give the same bytes. Who develops many pictures passes a denoiser to keep between them.
Image8 develop(const Film& film, const DevelopSettings& settings = {}, Denoiser* denoiser = nullptr);

// A picture of a film rendered without its sky, see-through where that was, for laying over another.
Texture developTransparent(const Film& film, const DevelopSettings& settings = {});

// The picture without tone curve and 8 bits: linear light in which 1 is the exposure's white.
std::vector<Rgb> developLinear(const Film& film, const DevelopSettings& settings = {},
                               Denoiser* denoiser = nullptr);

// 8-bit picture of linear colours that are already exposed.
Image8 toImage(const std::vector<Rgb>& exposed, int width, int height, ToneMap toneMap);

// The light of a lamp or the day (2200 to 12 000 K) that is as warm as this one, luminance 1. What is green
// or purple in an estimate comes from lawns and painted walls, and must not tint the picture.
Rgb onLocus(Rgb illuminant);

// The colour of the light in the room, luminance 1: radiance divided by reflectance, over the surfaces seen,
// then onLocus().
// White where the film has nothing to tell it from.
Rgb estimateIlluminant(const Film& film);

// Moves colours under `illuminant` towards how they look under white light, by a share of 0..1, in the cone
// space of Bradford; white light of luminance 1 keeps its luminance. @cite lam1985bradford
struct WhiteBalance {
  WhiteBalance(Rgb illuminant, float share);
  Rgb operator()(Rgb c) const;

 private:
  Vec3f row_[3];
};

}  // namespace idap::render
