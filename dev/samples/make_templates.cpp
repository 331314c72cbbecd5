// Builds the templates of the welcome page, share/templates/*.idap: furnished rooms and homes of built-in
// pieces, to begin with instead of an empty plan. dev/templates runs it and makes their pictures.
//   ninja -C build/release make_templates && build/release/dev/samples/make_templates share/templates
#include <cstdio>
#include <string>

#include "base/error.h"
#include "formats/registry.h"
#include "rooms.h"

int main(int argc, char** argv) {
  using namespace idap;
  const std::filesystem::path folder = argc > 1 ? argv[1] : "share/templates";
  try {
    const std::pair<const char*, Home (*)()> homes[] = {
        {"bedroom.idap", samples::bedroom},
        {"living-room.idap", samples::livingRoom},
        {"kitchen.idap", samples::kitchen},
        {"bathroom.idap", samples::bathroom},
        {"office.idap", samples::office},
        {"studio-apartment.idap", samples::studioApartment},
        {"two-bedroom-apartment.idap", samples::twoBedroomApartment},
    };
    for (const auto& [file, make] : homes) writeHome(make(), folder / file);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_templates: %s\n", error.what());
    return 1;
  }
}
