// A denoiser that needs no weights: an edge-stopping a-trous wavelet filter of the light on the surfaces.
#pragma once

#include <vector>

#include "render/film/film.h"

namespace idap::render {

// Five passes over irradiance (radiance / albedo), each averaging twice as far, stopped by differences in
// normal, depth and albedo, and by differences in light beyond the noise measured around the pixel.
// @cite dammertz2010atrous @cite schied2017svgf
// color: finite and not negative; replaced. threads: at least 1.
void filterByFeatures(const Film& film, std::vector<Rgb>& color, int threads);

}  // namespace idap::render
