// A sharp picture out of a small one: the light of few pixels is spread over many, guided by what the eye
// sees at each of them (joint bilateral upsampling of light divided by reflectance). @cite kopf2007joint
#pragma once

#include <vector>

#include "render/film/film.h"
#include "render/integrator/features.h"

namespace idap::render {

// color: of the small film's pixels, without noise. One colour for each pixel of the features.
std::vector<Rgb> enlarged(const Film& film, const std::vector<Rgb>& color, const Features& features,
                          int threads = 0);

}  // namespace idap::render
