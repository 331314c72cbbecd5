// A picture that was made of the home and is kept with it: from where, how, when, and the picture itself
// among the home's files.
#pragma once

#include <cstdint>
#include <string>

#include "model/camera.h"

namespace idap {

enum class PictureLamps { AsTheHome, On, Off };

enum class PictureTone { Neutral, Film, FalseColor };

// How a picture is made; the same again makes the same picture of a changed home.
struct PictureSettings {
  Camera view;             // its time, where it has one, is the picture's
  bool fromAbove = false;  // the whole home without its ceilings, from above; view only gives the time
  int width = 1280, height = 800;  // pixels
  bool classic = false;            // the shading of 1993 instead of traced light
  int samples = 64;                // a pixel; 0: by time
  double seconds = 0;              // of tracing; 0: by samples
  PictureLamps lamps = PictureLamps::AsTheHome;
  PictureTone tone = PictureTone::Neutral;
  double brightness = 0;  // stops beside what the picture itself asks for; positive is brighter
  bool upright = false;   // vertical lines stay vertical
  double aperture = 0;    // f-number of the lens; 0: all is sharp
  friend bool operator==(const PictureSettings&, const PictureSettings&) = default;
};

struct Picture {
  std::string name;
  PictureSettings settings;
  std::int64_t made = 0;  // milliseconds since 1970-01-01T00:00Z
  int samples = 0;        // a pixel, that it was made of
  std::string asset;      // the picture as PNG: its name among Home::assets
  friend bool operator==(const Picture&, const Picture&) = default;
};

}  // namespace idap
