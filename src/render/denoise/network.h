// Open Image Denoise's U-Net for colour, albedo and normal, run through oneDNN. @cite afra2024oidn
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/progress.h"
#include "render/film/film.h"

namespace idap::render {

class DenoiseNetwork {
 public:
  // fast: the small network. Throws IoError or ParseError where the weights are missing or damaged.
  explicit DenoiseNetwork(bool fast);
  ~DenoiseNetwork();
  DenoiseNetwork(const DenoiseNetwork&) = delete;
  DenoiseNetwork& operator=(const DenoiseNetwork&) = delete;

  static bool available(bool fast);

  // color: finite and not negative; replaced. Large pictures go through in tiles. threads: at least 1.
  // Throws Cancelled where progress asks to stop, between two layers.
  void run(const Film& film, std::vector<Rgb>& color, int threads, const Progress* progress = nullptr);

  // What oneDNN chose for the first convolution, for logs: for instance "brgconv:avx512_core_bf16_amx_bf16".
  const std::string& implementation() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap::render
