#include "cli/command.h"

namespace idap::cli {

Job describeInfo(CLI::App& app);
Job describeRender(CLI::App& app);
Job describeMix(CLI::App& app);
Job describeFilm(CLI::App& app);
Job describePrint(CLI::App& app);
Job describeConvert(CLI::App& app);
Job describeCatalog(CLI::App& app);

const std::vector<Command>& commands() {
  static const std::vector<Command> all{
      {"info", "Say what a home holds", describeInfo},
      {"render", "Make a ray-traced picture of a home", describeRender},
      {"mix", "Dim, recolour and switch the lights of a picture that is made", describeMix},
      {"film", "Make a film of a walk through a home, or of a day of sunlight in it", describeFilm},
      {"print", "Print plans, elevations and lists to scale, as PDF or SVG", describePrint},
      {"convert", "Read a home in one format and write it in another", describeConvert},
      {"catalog", "List, search and show furniture", describeCatalog},
  };
  return all;
}

}  // namespace idap::cli
