// The commands of the program without a desktop. To add one: write its file, and one line in commands.cpp.
#pragma once

#include <functional>
#include <vector>

namespace CLI {
class App;
}

namespace idap::cli {

// Runs after the options were read; returns the exit status: 0 done, 1 the job failed. Throws idap::Error.
using Job = std::function<int()>;

struct Command {
  const char* name;
  const char* summary;
  Job (*describe)(CLI::App& app);  // adds the command's options and gives the job that uses them
};

const std::vector<Command>& commands();

// The whole program: reads the arguments, runs a command, turns errors into one line on standard error.
int runProgram(int argc, char** argv);

}  // namespace idap::cli
