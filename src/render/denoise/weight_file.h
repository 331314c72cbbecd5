// Reads the TZA archives that Open Image Denoise publishes its network weights in.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/bytes.h"

namespace idap::render {

struct Tensor {
  std::vector<int> shape;     // outermost first: o, i, h, w for a convolution; one number for a bias
  std::vector<float> values;  // row-major
};

// Tensors by name. Throws ParseError where the bytes are not such an archive, or not a whole one.
std::map<std::string, Tensor> parseWeights(const Bytes& bytes, const std::string& fileName);

}  // namespace idap::render
