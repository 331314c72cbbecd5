// Printing is the studio's work, as it draws plans; here its arguments are read, and it is started without a
// window.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/platform.h"
#include "cli/command.h"

namespace idap::cli {

namespace {

struct Options {
  std::string input, output, scale = "fit", paper = "A4", sheets = "plan", level, room, title,
                             language = "en", unit = "cm";
  bool portrait = false, noTitle = false;
};

int print(const Options& o) {
  const std::filesystem::path studio = programBeside("idap-studio");
  if (studio.empty())
    throw Error("printing needs the studio (idap-studio), which is not installed beside idap");
  std::vector<std::string> arguments{"--print-job", o.input,    "--output", o.output,   "--scale",
                                     o.scale,       "--paper",  o.paper,    "--sheets", o.sheets,
                                     "--language",  o.language, "--unit",   o.unit};
  const auto add = [&](const char* name, const std::string& value) {
    if (value.empty()) return;
    arguments.emplace_back(name);
    arguments.push_back(value);
  };
  add("--level", o.level);
  add("--room", o.room);
  add("--title", o.title);
  if (o.portrait) arguments.emplace_back("--portrait");
  if (o.noTitle) arguments.emplace_back("--no-title");
  throw Error(studio.string() + ": cannot be started: " + becomeProgram(studio, arguments));
}

}  // namespace

Job describePrint(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("FILE", options->input, "Home to print (.idap, .sh3d)")->required();
  app.add_option("-o,--output", options->output, "File to write: .pdf, or .svg with one file a page")
      ->required();
  app.add_option("--scale", options->scale, "1:50 and the like, or fit (fit)")->type_name("1:N");
  app.add_option("--paper", options->paper, "A0 to A6, Letter, Legal or Tabloid (A4)")->type_name("NAME");
  app.add_flag("--portrait", options->portrait, "Upright paper instead of landscape");
  app.add_option("--sheets", options->sheets, "Of plan, xz, yz, walls, list, pictures (plan)")
      ->type_name("LIST");
  app.add_option("--level", options->level, "Only the plan of this level")->type_name("NAME");
  app.add_option("--room", options->room, "Only the walls of this room")->type_name("NAME");
  app.add_option("--title", options->title, "Instead of the home's own title")->type_name("TEXT");
  app.add_option("--language", options->language, "en or th (en)")->check(CLI::IsMember({"en", "th"}));
  app.add_option("--unit", options->unit, "Of what is measured: cm, m or inch (cm)")
      ->check(CLI::IsMember({"cm", "m", "inch"}));
  app.add_flag("--no-title", options->noTitle, "Without title, notes, scale, north and date");
  return [options] { return print(*options); };
}

}  // namespace idap::cli
