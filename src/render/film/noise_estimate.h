// How noisy each pixel still is, judged by its own samples and those around it.
#pragma once

#include <vector>

#include "render/film/film.h"

namespace idap::render {

// The standard error of each pixel's luminance over its brightness, rows from the top. What is darker than a
// tenth of the picture's mean counts as a tenth: nobody sees the noise there. A pixel's few samples may all
// have missed what makes the noise, so variances are averaged over 7 x 7 pixels (their samples being as many
// as the pixel's own, or more). Infinite where nothing is known.
std::vector<float> noiseEstimate(const Film& film);

// What 95 of 100 pixels stay under; 0 for a film of fewer than two samples a pixel, of which it is not known.
float noiseLevel(const Film& film);

}  // namespace idap::render
