#include <fmt/format.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/platform.h"
#include "catalog/catalog.h"
#include "cli/command.h"
#include "cli/open_home.h"
#include "scene/scene_builder.h"

namespace idap::cli {

namespace {

// Counted as Sweet Home 3D's users count: pieces are furniture, doors, windows and lamps in and outside
// groups.
std::vector<std::pair<const char*, std::size_t>> countsOf(const Home& home, const Progress& progress) {
  const auto lamps =
      static_cast<std::size_t>(std::count_if(home.furniture.begin(), home.furniture.end(),
                                             [](const auto& f) { return f.second->lamp.has_value(); }));
  const Catalog catalog;
  const std::size_t triangles = buildScene(home, catalog, {}, progress).triangles;
  return {{"levels", home.levels.size()},
          {"walls", home.walls.size()},
          {"rooms", home.rooms.size()},
          {"pieces", home.furniture.size() + home.openings.size()},
          {"groups", home.groups.size()},
          {"openings", home.openings.size()},
          {"lamps", lamps},
          {"cameras", home.cameras.size()},
          {"dimensions", home.dimensions.size()},
          {"labels", home.labels.size()},
          {"polylines", home.polylines.size()},
          {"pictures", home.pictures.size()},
          {"triangles", triangles}};
}

}  // namespace

Job describeInfo(CLI::App& app) {
  struct Options {
    std::string file;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  app.add_option("FILE", options->file, "Home to look into (.idap, .sh3d)")->required();
  app.add_flag("--json", options->json, "Print one JSON object on standard output");
  return [options] {
    Progress progress;
    const CancelOnInterrupt interrupt(progress);
    Warnings warnings(options->file);
    const ReadResult read = openHome(options->file, warnings, progress);
    const auto counts = countsOf(read.home, progress);
    if (options->json) {
      nlohmann::ordered_json json;
      for (const auto& [key, count] : counts) json[key] = count;
      fmt::print("{}\n", json.dump());
      return 0;
    }
    if (!read.home.name.empty()) fmt::print("{}\n", oneLine(read.home.name));
    for (const auto& [key, count] : counts) fmt::print("{:<11}{:>9}\n", key, count);
    for (const auto& [id, camera] : read.home.cameras) fmt::print("camera     {}\n", oneLine(camera->name));
    return 0;
  };
}

}  // namespace idap::cli
