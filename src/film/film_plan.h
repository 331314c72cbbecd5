// What every frame of a film shows, decided before anything is traced: a walk through points of view, or a
// day of sunlight in one of them. Seconds, metres.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "film/camera_path.h"
#include "light/civil_time.h"
#include "model/home.h"

namespace idap {

struct FilmPlan {
  Home home;                      // as the film shows it: doors that are walked through stand open
  std::vector<Camera> frames;     // with the time in each
  std::vector<std::size_t> cuts;  // frames that begin another take; the one before dissolves into it
  int framesPerSecond = 25;
  bool day = false;                     // the light changes, the camera does not
  std::vector<std::vector<Vec2>> ways;  // of the walk, on the plan, one a take
  std::vector<std::string> warnings;    // what could not be as wished, in words

  double seconds() const { return static_cast<double>(frames.size()) / framesPerSecond; }
};

struct WalkSettings {
  int framesPerSecond = 25;
  WalkPace pace;
  std::optional<double> seconds;     // length of the film; none: as long as it takes
  std::optional<std::int64_t> time;  // ms since 1970; none: the first point of view's, or the home's
};

// In order. Where nobody can walk from one to the next, the film cuts, with a warning. Throws Error without
// any.
FilmPlan planWalk(const Home& home, const std::vector<Camera>& stops, const WalkSettings& settings = {});

// Points of view for a walk through a home that has none stored: where it was last looked from, or its rooms
// from their best corner, the nearest one next.
std::vector<Camera> defaultStops(const Home& home);

struct DaySettings {
  int framesPerSecond = 25;
  double seconds = 10;
  CivilTime date;                  // year, month and day at the home
  std::optional<double> from, to;  // hours of the day; none: a little before sunrise and after sunset
};

FilmPlan planDay(const Home& home, const Camera& camera, const DaySettings& settings);

}  // namespace idap
