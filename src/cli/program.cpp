#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdio>
#include <map>
#include <new>

#include "base/error.h"
#include "base/log.h"
#include "cli/command.h"
#include "cli/usage_error.h"

namespace idap::cli {

namespace {

constexpr const char* kVersion = "idap " IDAP_VERSION;

int fail(int status, const std::string& message) {
  std::string line = message;
  for (char& c : line) {
    if (c == '\n' || c == '\r') c = ' ';  // one clear line, whatever a library said
  }
  fmt::print(stderr, "idap: {}\n", line);
  return status;
}

}  // namespace

int runProgram(int argc, char** argv) {
  setUpLogging();
  CLI::App app{"IDAP: open a home, see it ray-traced, convert it. Run 'idap COMMAND --help' for one command."};
  app.name("idap");
  app.set_version_flag("--version", kVersion);
  app.require_subcommand(1);
  app.fallthrough(false);

  std::map<const CLI::App*, Job> jobs;
  for (const Command& command : commands()) {
    CLI::App* sub = app.add_subcommand(command.name, command.summary);
    sub->set_version_flag("--version", kVersion);
    jobs[sub] = command.describe(*sub);
  }
  if (argc <= 1) {
    fmt::print("{}", app.help());
    return 0;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Success is how CLI11 says that help or the version was asked for.
    const int code = app.exit(error);
    return code == static_cast<int>(CLI::ExitCodes::Success) ? 0 : 2;
  }
  try {
    for (const CLI::App* sub : app.get_subcommands()) return jobs.at(sub)();
    return 2;
  } catch (const UsageError& error) {
    return fail(2, error.what());
  } catch (const Error& error) {
    return fail(1, error.what());
  } catch (const std::bad_alloc&) {
    return fail(1, "out of memory: the job needs more than this machine has");
  } catch (const std::exception& error) {
    return fail(1, fmt::format("unexpected failure: {}", error.what()));
  }
}

}  // namespace idap::cli
