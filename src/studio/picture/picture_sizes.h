// The sizes that pictures are commonly made in, on screens and on paper. Pixels.
#pragma once

#include <span>

namespace idap {

struct PictureSize {
  const char* name;  // marked for translation; empty: the pixels say it
  int width, height;
  bool paper;
};
std::span<const PictureSize> pictureSizes();

struct PictureProportion {
  const char* name;  // "16:9"
  double ratio;      // width / height; 0: free
};
std::span<const PictureProportion> pictureProportions();

}  // namespace idap
