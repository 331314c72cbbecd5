#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <tuple>

#include "base/file.h"
#include "base/platform.h"
#include "catalog/catalog.h"
#include "cli/arguments.h"
#include "cli/command.h"
#include "cli/open_home.h"
#include "cli/progress_bar.h"
#include "cli/usage_error.h"
#include "film/film_job.h"

namespace idap::cli {

namespace {

struct Options {
  std::string input, output, size = "640x360", at, lamps = "auto", day, from, to;
  std::vector<std::string> cameras;
  double speed = 1.2, pause = 1;
  std::optional<double> seconds, clouds;
  int framesPerSecond = 25, spp = 12, threads = 0;
  bool constantExposure = false;
};

// "06:00" as hours; none for an empty text.
std::optional<double> hourArgument(const char* option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  int hour = 0, minute = 0, used = 0;
  if (std::sscanf(text.c_str(), "%2d:%2d%n", &hour, &minute, &used) != 2 ||
      used != static_cast<int>(text.size()) || hour < 0 || minute < 0 || minute > 59 ||
      hour * 60 + minute > 24 * 60)
    throw UsageError(
        fmt::format("{} {}: give an hour from 00:00 to 24:00, for instance 06:30", option, text));
  return hour + minute / 60.0;
}

std::vector<Camera> chosenStops(const Home& home, const Options& options) {
  if (options.cameras.empty()) return defaultStops(home);
  std::vector<Camera> stops;
  for (const std::string& wish : options.cameras) {
    bool fromAbove = false;
    stops.push_back(chooseCamera(home, wish, 16.0 / 9, fromAbove));
  }
  return stops;
}

FilmPlan plan(const Home& home, const Options& options, const std::optional<CivilTime>& at,
              const std::optional<CivilTime>& day, std::optional<double> from, std::optional<double> to) {
  const std::vector<Camera> stops = chosenStops(home, options);
  if (stops.empty())
    throw Error(options.input + ": no point of view to film from: add cameras in the studio, or draw rooms");
  if (day) {
    DaySettings settings;
    settings.framesPerSecond = options.framesPerSecond;
    settings.seconds = options.seconds.value_or(settings.seconds);
    settings.date = *day;
    settings.from = from;
    settings.to = to;
    return planDay(home, stops.front(), settings);
  }
  WalkSettings settings;
  settings.framesPerSecond = options.framesPerSecond;
  settings.pace.speed = options.speed;
  settings.pace.pause = options.pause;
  settings.seconds = options.seconds;
  if (at) settings.time = utcAtHome(home, *at);
  return planWalk(home, stops, settings);
}

int makeFilm(const Options& options) {
  FilmSettings settings;
  std::tie(settings.width, settings.height) = parseSize(options.size);
  if (std::filesystem::path(options.output).extension() != ".mp4")
    throw UsageError(options.output + ": films are .mp4 files");
  requireWritable(options.output);
  const auto at = dateTimeArgument("--at", options.at), day = dateTimeArgument("--day", options.day);
  const auto from = hourArgument("--from", options.from), to = hourArgument("--to", options.to);

  ProgressBar bar;
  Warnings warnings(options.input, [&] { bar.wipe(); });
  Progress progress([&](double fraction, std::string_view what) { bar.show(fraction, what); });
  const CancelOnInterrupt interrupt(progress);
  const ReadResult read = openHome(options.input, warnings, progress);
  const FilmPlan film = plan(read.home, options, at, day, from, to);
  warnings.add(film.warnings);

  settings.samples = options.spp;
  settings.lamps = lampPolicy(options.lamps);
  settings.cloudiness = options.clouds;
  settings.constantExposure = options.constantExposure;
  settings.threads = options.threads;
  if (standardErrorIsTerminal()) {
    bar.wipe();
    printMessage(fmt::format("{:.0f} s of film in {} frames; it will take about {}", film.seconds(),
                             film.frames.size(), durationText(estimatedSeconds(film, settings))));
  }
  const FilmResult made = idap::makeFilm(film, Catalog(), settings, options.output, progress);
  warnings.add(made.warnings);
  if (made.stopped) {
    bar.wipe();
    printMessage(fmt::format("stopped; {} holds the first {:.1f} of {:.1f} seconds", options.output,
                             double(made.frames) / film.framesPerSecond, film.seconds()));
  }
  return 0;
}

}  // namespace

Job describeFilm(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("FILE", options->input, "Home to film (.idap, .sh3d)")->required();
  app.add_option("-o,--output", options->output, "Film to write (.mp4)")->required();
  app.add_option("--camera", options->cameras,
                 "Points of view to walk through, in order: names, or numbers from 1 (all that are stored)")
      ->type_name("NAME|N");
  app.add_option("--speed", options->speed, "Metres a second to walk (1.2)")->check(within(0.05, 20));
  app.add_option("--pause", options->pause, "Seconds to look at each point of view (1)")
      ->check(within(0, 60));
  app.add_option("--size", options->size, "Width and height in pixels (640x360)")->type_name("WxH");
  app.add_option("--fps", options->framesPerSecond, "Frames a second (25)")->check(CLI::Range(1, 120));
  app.add_option("--seconds", options->seconds, "Length of the film (a walk as long as it takes, a day 10)")
      ->check(within(0.1, 3600));
  app.add_option("--spp", options->spp, "Samples a pixel of every frame (12)")->check(CLI::Range(1, 100'000));
  CLI::Option* day =
      app.add_option("--day", options->day, "A day of sunlight from the first point of view: its date")
          ->type_name("DATE");
  app.add_option("--from", options->from, "Hour at which the day begins (sunrise)")
      ->type_name("HH:MM")
      ->needs(day);
  app.add_option("--to", options->to, "Hour at which it ends (sunset)")->type_name("HH:MM")->needs(day);
  app.add_option("--at", options->at, "Date and time of a walk, for instance 2026-06-21T16:30")
      ->type_name("DATETIME")
      ->excludes(day);
  app.add_option("--lamps", options->lamps, "auto: as the home has them; on; off")
      ->check(CLI::IsMember({"auto", "on", "off"}));
  app.add_option("--clouds", options->clouds, "0 clear sky to 1 overcast; without it, as the home has it")
      ->check(within(0, 1));
  app.add_flag("--constant-exposure", options->constantExposure,
               "Keep the exposure instead of following the light");
  app.add_option("--threads", options->threads, "Processors to use (all)")->check(CLI::Range(1, 1024));
  return [options] { return makeFilm(*options); };
}

}  // namespace idap::cli
