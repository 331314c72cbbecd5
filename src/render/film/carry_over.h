// What a clean picture still says of a view in which something has changed: a chair moved, a lamp brighter.
// The first paths through the new scene are few and noisy; averaged over small and large neighbourhoods they
// tell all the same where light has changed, and elsewhere the clean picture goes on being shown. A preview's
// means only: what is carried over fades as paths come in.
#pragma once

#include <vector>

#include "render/film/film.h"
#include "render/film/pixel_region.h"
#include "render/integrator/features.h"

namespace idap::render {

// A picture without noise.
struct CleanPicture {
  int width = 0, height = 0;
  std::vector<Rgb> color;  // cd/m2
};

// The picture to show now, as large as the clean one. film: the new paths, of any size. seen, sees: what the
// view showed and shows, of equal size. color: what has been made of the new paths, denoised, of the size of
// those. share: of what is unchanged, 0..1. Throws RenderError where sizes that must be equal are not.
CleanPicture carriedOver(const CleanPicture& before, const Features& seen, const Film& film,
                         const Features& sees, const std::vector<Rgb>& color, float share, int threads = 0);

// What encloses all that the view does not show as before, and some pixels around it.
PixelRegion changedRegion(const Features& seen, const Features& sees);

// At a smaller size: every pixel the mean of those that it covers.
std::vector<Rgb> reduced(const CleanPicture& picture, int width, int height);

}  // namespace idap::render
