#include "cli/studio.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/platform.h"
#include "cli/command.h"
#include "formats/registry.h"

namespace idap::cli {

namespace {

bool hasExtensionOfHome(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  if (extension.empty()) return false;
  extension.erase(0, 1);
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return std::any_of(homeFormats().begin(), homeFormats().end(), [&extension](const HomeFormat& format) {
    return std::find(format.extensions.begin(), format.extensions.end(), extension) !=
           format.extensions.end();
  });
}

}  // namespace

bool meansStudio(int argc, char** argv) {
  if (argc <= 1) return true;
  const std::string first = argv[1];
  if (first.empty() || first[0] == '-') return false;
  if (std::any_of(commands().begin(), commands().end(),
                  [&first](const Command& command) { return first == command.name; }))
    return false;
  std::error_code error;
  return std::filesystem::is_regular_file(first, error) || hasExtensionOfHome(first);
}

std::string startStudio(const std::vector<std::string>& arguments) {
  if (!hasDisplay())
    return "there is no display to open the studio on; 'idap render FILE -o picture.png' makes pictures "
           "without one "
           "(see 'idap --help')";
  const std::filesystem::path studio = programBeside("idap-studio");
  if (studio.empty())
    return "the studio (idap-studio) is not installed beside idap; 'idap render FILE -o picture.png' works "
           "without it "
           "(see 'idap --help')";
  return studio.string() + ": cannot be started: " + becomeProgram(studio, arguments);
}

}  // namespace idap::cli
