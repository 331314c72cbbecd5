// From cd/m2 to display range, the photographer's way: an exposure value, chosen by hand or from the picture.
#pragma once

#include "render/film/film.h"

namespace idap::render {

// EV100 is the exposure value at ISO 100. The brightest luminance a camera records without clipping is taken
// as 1.2 * 2^EV100 cd/m2 @cite lagarde2014frostbite; the multiplier maps that luminance to 1.
float exposureMultiplier(float ev100);
float ev100FromMultiplier(float multiplier);

// The EV100 at which the room comes out bright: the log-average luminance of the picture's surfaces lands on
// a mid-tone of 0.22 to 0.4, higher in pale rooms than in dark ones. Sky and land (objectId 0) beside the
// home or seen through its windows, the night outside, and the darkest and brightest shares of the picture
// hardly count. Measured over blocks of pixels,
// because single noisy pixels are mostly too dark. 8 for a picture without light; always from kMinEv to
// kMaxEv.
inline constexpr float kMinEv = -6;
inline constexpr float kMaxEv = 18;
float autoExposure(const Film& film);
// The same for a picture made of the film: mean radiance of every pixel, denoised say.
float autoExposure(const Film& film, const std::vector<Rgb>& color);

}  // namespace idap::render
