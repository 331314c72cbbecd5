// Traces a planned film frame by frame into an MP4 file. The scene is built once for a walk; for a day only
// sun and sky change from frame to frame. Exposure and white balance are measured along the film first and
// smoothed, so that nothing flickers.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "base/image8.h"
#include "catalog/catalog.h"
#include "film/film_plan.h"
#include "scene/scene_builder.h"

namespace idap {

struct FilmSettings {
  int width = 640, height = 360;
  int samples = 12;  // a pixel of a frame; frames that stand still get more
  LampPolicy lamps = LampPolicy::Auto;
  std::optional<double> cloudiness;  // none: the home's
  float compensation = 0;            // stops; positive is brighter
  bool constantExposure = false;     // as the middle of the film needs it, instead of following the light
  int threads = 0;                   // 0: all
};

struct FilmFrame {
  int number = 0, count = 0;  // from 0
  Image8 image;
};

struct FilmResult {
  int frames = 0;
  bool stopped = false;               // cancelled; the file holds the film so far
  std::vector<std::string> warnings;  // of the scene and the encoder
};

// onFrame is called on the calling thread with every finished frame. What progress is told begins with the
// phase: "building", "measuring the light", "filming". Cancelled, it keeps the film so far where that is a
// second or more, and otherwise throws Cancelled and leaves no file. Throws IoError where the file cannot be
// written.
FilmResult makeFilm(const FilmPlan& plan, const Catalog& catalog, const FilmSettings& settings,
                    const std::filesystem::path& file, const Progress& progress = {},
                    const std::function<void(FilmFrame)>& onFrame = {});

// Frames that differ from the one before: what there is to trace.
int tracedFrames(const FilmPlan& plan);
// Roughly how long it will take on this machine, in seconds.
double estimatedSeconds(const FilmPlan& plan, const FilmSettings& settings);

}  // namespace idap
