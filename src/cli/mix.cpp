#include <fmt/format.h>

#include <CLI/App.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "cli/arguments.h"
#include "cli/command.h"
#include "cli/message.h"
#include "cli/picture_output.h"
#include "cli/usage_error.h"
#include "render/film/exposure.h"
#include "render/film/light_mix.h"
#include "render/film/picture_file.h"

namespace idap::cli {

namespace {

struct Options {
  std::string input, output, tone = "neutral";
  std::vector<std::string> changes;
  std::optional<double> exposure;
  bool adapt = false, noDenoise = false, json = false;
  int threads = 0;
};

// How much each light gives to the picture, of all its light.
void list(const render::Layers& layers, bool json) {
  double all = 0;
  std::vector<double> sums;
  for (const auto& group : layers.film.groups) {
    double sum = 0;
    for (const Rgb& c : group) sum += static_cast<double>(luminance(c));
    sums.push_back(sum);
    all += sum;
  }
  nlohmann::ordered_json lights = nlohmann::ordered_json::array();
  for (std::size_t g = 0; g < sums.size(); ++g) {
    const double share = all > 0 ? sums[g] / all : 0;
    const bool coloured = luminance(layers.groups[g].color) > 0;
    if (json)
      lights.push_back({{"name", layers.groups[g].name}, {"share", share}, {"recolourable", coloured}});
    else
      fmt::print("{:6.2f} %  {}{}\n", 100 * share, oneLine(layers.groups[g].name),
                 coloured ? "" : "  (strength only)");
  }
  if (json) fmt::print("{}\n", lights.dump());
}

std::vector<render::LightChange> changesOf(const Options& options, const render::Layers& layers) {
  std::vector<render::LightChange> changes(layers.groups.size());
  for (const std::string& text : options.changes) {
    const std::size_t at = text.rfind('=');
    if (at == std::string::npos || at == 0)
      throw UsageError("--set " + text + ": write it as \"floor lamp=0.3,2700K\"");
    render::LightChange change;
    try {
      change = render::parseLightChange(std::string_view(text).substr(at + 1));
    } catch (const RenderError& error) {
      throw UsageError("--set " + text + ": " + error.what());
    }
    const auto lights = render::lightsNamed(layers.groups, std::string_view(text).substr(0, at));
    if (lights.empty())
      throw UsageError("--set " + text + ": there is no such light; 'idap mix " + options.input +
                       "' lists those there are");
    for (const std::size_t g : lights) changes[g] = change;
  }
  return changes;
}

int mix(const Options& options) {
  const render::Layers layers = render::loadLayers(options.input);
  if (layers.film.groups.empty())
    throw IoError(
        options.input +
        ": keeps no light by itself; 'idap render HOME -o picture.exr --light-groups' writes one that does");
  if (options.output.empty()) {
    if (!options.changes.empty()) throw UsageError("-o OUT: say where the mixed picture is to go");
    list(layers, options.json);
    return 0;
  }
  const PictureKind kind = pictureKind(options.output);
  const std::vector<render::LightChange> changes = changesOf(options, layers);
  requireWritable(options.output);
  const render::Film film = render::mixed(layers.film, layers.groups, changes);
  render::DevelopSettings develop;
  // As bright and as white as the picture was: a lamp that is dimmed looks dimmed.
  if (options.exposure)
    develop.ev = static_cast<float>(*options.exposure);
  else if (!options.adapt)
    develop.ev = render::autoExposure(layers.film);
  if (!options.adapt) develop.illuminant = render::estimateIlluminant(layers.film);
  develop.toneMap = toneMap(options.tone);
  develop.denoise = !options.noDenoise;
  develop.threads = options.threads;
  savePicture(options.output, kind, film, layers.groups, develop);
  return 0;
}

}  // namespace

Job describeMix(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("FILE", options->input, "OpenEXR picture that 'idap render' made, with its lights in layers")
      ->required();
  app.add_option("-o,--output", options->output, "Picture to write; without it, the lights are listed");
  app.add_option("--set", options->changes,
                 "\"floor lamp=0.3,2700K\", \"sun=off\", \"spot*=#ffb060\"; may be given many times")
      ->type_name("LIGHT=CHANGE");
  app.add_option("--exposure", options->exposure,
                 "Exposure value at ISO 100; without it, that of the picture")
      ->check(within(-30, 60))
      ->type_name("EV");
  app.add_flag("--adapt", options->adapt,
               "Choose exposure and white for the mix instead of keeping the picture's");
  app.add_option("--tone", options->tone,
                 "Tone curve: neutral, agx, classic or linear; false: brightness as colour, in stops")
      ->check(CLI::IsMember({"neutral", "agx", "classic", "linear", "false"}));
  app.add_option("--threads", options->threads, "Processors to use (all)")->check(CLI::Range(1, 1024));
  app.add_flag("--no-denoise", options->noDenoise, "Leave the noise in");
  app.add_flag("--json", options->json, "List the lights as JSON");
  return [options] { return mix(*options); };
}

}  // namespace idap::cli
