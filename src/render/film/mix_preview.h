// A picture's lights kept ready for mixing: small and free of noise, each by itself, so that a mix is a sum
// that takes milliseconds.
#pragma once

#include "base/image8.h"
#include "render/film/develop.h"
#include "render/film/light_mix.h"

namespace idap::render {

class MixPreview {
 public:
  // Pictures of more pixels are made smaller. Takes about a second for each dozen lights; throws Cancelled,
  // and RenderError for a film without groups.
  MixPreview(const Film& film, std::vector<LightGroup> groups, std::size_t mostPixels = 200'000,
             const Progress& progress = {});

  // The mix, exposed and white-balanced as the picture was; compensation: stops on top, as
  // DevelopSettings::compensation. See mixed() for changes.
  Image8 picture(const std::vector<LightChange>& changes, ToneMap toneMap = ToneMap::PbrNeutral,
                 float compensation = 0) const;

  const std::vector<LightGroup>& groups() const { return groups_; }
  // What of the picture's light each group makes, 0..1.
  const std::vector<float>& shares() const { return shares_; }

 private:
  Film film_;  // noise-free means, one sample a pixel
  std::vector<LightGroup> groups_;
  std::vector<float> shares_;
  float ev_ = 0;
  Rgb illuminant_{1, 1, 1};
};

// Sums of the film's pixels in squares, side by side: a smaller film of the same picture with at most so many
// pixels; the film itself if it has no more.
Film reduced(const Film& film, std::size_t mostPixels);

}  // namespace idap::render
