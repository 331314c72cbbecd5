// Takes the noise out of a rendered picture, guided by the film's albedo and normal layers. Works with the
// published Open Image Denoise networks where their weights are installed (dev/fetch-denoiser), and with a
// filter of our own elsewhere. For pictures only: never for numbers such as lux.
#pragma once

#include <memory>
#include <vector>

#include "base/progress.h"
#include "render/film/film.h"

namespace idap::render {

class DenoiseNetwork;

enum class DenoiseMethod {
  Best,     // the network where its weights are found, else the filter
  Network,  // throws RenderError where the weights are missing or damaged
  Filter,
};

struct DenoiseSettings {
  int threads = 0;    // 0: as many as the machine has
  bool fast = false;  // the small network instead of the normal one
  DenoiseMethod method = DenoiseMethod::Best;
  const Progress* progress = nullptr;  // asked between the network's layers whether to go on
};

// Keeps the network's weights and memory from one picture to the next. One thread at a time.
class Denoiser {
 public:
  Denoiser();
  ~Denoiser();
  Denoiser(Denoiser&&) noexcept;
  Denoiser& operator=(Denoiser&&) noexcept;

  // color: in, mean radiance of every pixel, finite or not; out, the same denoised, finite and not negative.
  // Keeps the picture's overall brightness, and what was traced where the film's own noise is too low to be
  // seen (noiseEstimate()); is deterministic, and takes pictures of any size. Throws
  // Cancelled.
  void run(const Film& film, std::vector<Rgb>& color, const DenoiseSettings& settings = {});

 private:
  std::unique_ptr<DenoiseNetwork> normal_, fast_;
};

// The same for a single picture.
void denoise(const Film& film, std::vector<Rgb>& color, const DenoiseSettings& settings = {});

// True where the network's weights are installed.
bool hasDenoiserNetwork();

}  // namespace idap::render
