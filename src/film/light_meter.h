// How bright and of what colour the light is along a film: measured in some frames, smooth in between, so
// that the picture adapts as an eye does and never flickers.
#pragma once

#include <vector>

#include "light/rgb.h"

namespace idap {

struct MeteredLight {
  float ev = 8;  // EV100
  Rgb illuminant{1, 1, 1};
};

class LightCurve {
 public:
  // frame: rising.
  void add(std::size_t frame, MeteredLight light) { keys_.push_back({frame, light}); }
  // Averages over about this many frames to both sides.
  void smooth(double frames);
  // Every frame as bright as the middle one of them by brightness.
  void makeConstant();
  MeteredLight at(std::size_t frame) const;

 private:
  struct Key {
    std::size_t frame;
    MeteredLight light;
  };
  std::vector<Key> keys_;
};

}  // namespace idap
