#include <CLI/App.hpp>
#include <memory>

#include "base/file.h"
#include "base/platform.h"
#include "catalog/catalog.h"
#include "cli/arguments.h"
#include "cli/command.h"
#include "cli/open_home.h"
#include "formats/gltf/gltf_writer.h"
#include "scene/scene_builder.h"

namespace idap::cli {

namespace {

constexpr double kAspect = 1.5;  // of stored points of view, whose pictures have no shape of their own

// The home as others show it: what the renderer sees, with every stored point of view.
Bytes asGlb(const Home& home, const BuildOptions& options, Warnings& warnings, const Progress& progress) {
  const Catalog catalog;
  const BuiltScene built = buildScene(home, catalog, options, progress);
  warnings.add(built.warnings);
  std::vector<GltfCamera> cameras;
  for (const auto& [id, camera] : home.cameras)
    cameras.push_back({camera->name, toRenderCamera(*camera, built, kAspect), kAspect});
  return writeGlb(*built.scene, cameras, built.centre);
}

bool isGlb(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".glb";
}

}  // namespace

Job describeConvert(CLI::App& app) {
  struct Options {
    std::string input, output, lamps = "auto";
  };
  auto options = std::make_shared<Options>();
  app.add_option("IN", options->input, "Home to read (.idap, .sh3d)")->required();
  app.add_option("OUT", options->output,
                 "File to write; its extension says the format: .idap, or .glb (glTF 2.0, for viewers and "
                 "other 3D programs)")
      ->required();
  app.add_option("--lamps", options->lamps, "In .glb: auto: as the home has them; on; off")
      ->check(CLI::IsMember({"auto", "on", "off"}));
  return [options] {
    requireWritable(options->output);
    Progress progress;
    const CancelOnInterrupt interrupt(progress);
    Warnings warnings(options->input);
    const ReadResult read = openHome(options->input, warnings, progress);
    if (isGlb(options->output)) {
      BuildOptions build;
      build.lamps = lampPolicy(options->lamps);
      writeFileAtomically(options->output, asGlb(read.home, build, warnings, progress));
    } else {
      writeHome(read.home, options->output, progress);
    }
    return 0;
  };
}

}  // namespace idap::cli
