// The perceptually uniform curve that Open Image Denoise feeds its networks with: unbounded linear light into
// 0..1 and back, by tables. @cite afra2024oidn
#pragma once

#include <vector>

namespace idap::render {

class TransferCurve {
 public:
  TransferCurve();
  float forward(float linear) const;   // 0..65504 -> 0..1; clamps
  float inverse(float encoded) const;  // 0..1 -> 0..65504; clamps

 private:
  std::vector<float> forward_, inverse_;
};

}  // namespace idap::render
