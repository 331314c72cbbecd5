#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <map>
#include <new>
#include <system_error>

#include "base/error.h"
#include "base/log.h"
#include "base/platform.h"
#include "cli/command.h"
#include "cli/message.h"
#include "cli/studio.h"
#include "cli/usage_error.h"

namespace idap::cli {

namespace {

constexpr const char* kVersion = "idap " IDAP_VERSION;

int fail(int status, const std::string& message) {
  printMessage(message);
  return status;
}

// What could not be written is not done.
int afterWriting(int status) {
  std::cout.flush();
  if (std::cout && std::fflush(stdout) == 0 && !std::ferror(stdout)) return status;
  return fail(1, fmt::format("standard output: cannot write: {}", std::strerror(errno)));
}

}  // namespace

int runProgram(int argc, char** argv) {
  setUpProcess();
  setUpLogging();
  if (meansStudio(argc, argv)) return fail(1, startStudio({argv + 1, argv + argc}));
  CLI::App app{
      "IDAP: draw a home, furnish it, see it ray-traced. Without arguments, or with the FILE of a home, it "
      "opens "
      "the studio. Run 'idap COMMAND --help' for one command."};
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
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Success is how CLI11 says that help or the version was asked for.
    const int code = app.exit(error);
    return afterWriting(code == static_cast<int>(CLI::ExitCodes::Success) ? 0 : 2);
  }
  try {
    for (const CLI::App* sub : app.get_subcommands()) return afterWriting(jobs.at(sub)());
    return 2;
  } catch (const UsageError& error) {
    return fail(2, error.what());
  } catch (const Error& error) {
    return fail(1, error.what());
  } catch (const std::bad_alloc&) {
    return fail(1, "out of memory: the job needs more than this machine has");
  } catch (const std::system_error& error) {
    if (std::ferror(stdout)) return fail(1, "standard output: cannot write: " + error.code().message());
    return fail(1, error.what());
  } catch (const std::exception& error) {
    return fail(1, fmt::format("unexpected failure: {}", error.what()));
  }
}

}  // namespace idap::cli
