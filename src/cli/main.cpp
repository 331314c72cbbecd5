#include "cli/command.h"

int main(int argc, char** argv) { return idap::cli::runProgram(argc, argv); }
