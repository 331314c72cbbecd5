#include <CLI/App.hpp>
#include <memory>

#include "base/file.h"
#include "base/platform.h"
#include "cli/command.h"
#include "cli/open_home.h"

namespace idap::cli {

Job describeConvert(CLI::App& app) {
  struct Options {
    std::string input, output;
  };
  auto options = std::make_shared<Options>();
  app.add_option("IN", options->input, "Home to read (.idap, .sh3d)")->required();
  app.add_option("OUT", options->output, "Home to write; its extension says the format (.idap)")->required();
  return [options] {
    requireWritable(options->output);
    Progress progress;
    const CancelOnInterrupt interrupt(progress);
    Warnings warnings(options->input);
    const ReadResult read = openHome(options->input, warnings, progress);
    writeHome(read.home, options->output, progress);
    return 0;
  };
}

}  // namespace idap::cli
