// How a picture is taken and developed: lens, focus, filter, tone, white balance. Options of `idap render`.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

#include "cli/picture_output.h"
#include "render/accel/compiled_scene.h"
#include "render/film/develop.h"
#include "render/session/render_job.h"

namespace idap::cli {

struct Look {
  std::string lens, tone = "neutral", filter = "smooth";
  std::optional<double> exposure, whiteBalance, aperture, focus;
  bool upright = false, transparent = false;

  void describe(CLI::App& app);
  // Throws UsageError where the kind of picture cannot show what is asked for.
  void check(PictureKind kind) const;
  // Without --focus, what is in the middle of the picture is sharp.
  render::Camera camera(render::Camera camera, const render::CompiledScene& scene) const;
  void apply(render::RenderSettings& settings) const;
  void apply(render::DevelopSettings& settings) const;
  // In words, of all that changes what the film holds.
  std::string words() const;
};

}  // namespace idap::cli
