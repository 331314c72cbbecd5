// The program's own file format, .idap: a ZIP archive of home.json and the files the home uses. Described in
// docs/idap-format.md.
#pragma once

#include "formats/registry.h"

namespace idap {

bool sniffIdap(const SharedBytes& bytes, const std::string& fileName);

// The home is valid; what had to be mended, and members that a newer minor change may have added, are in the
// report. Throws ParseError with the entry or the JSON pointer, UnsupportedVersion, Cancelled.
ReadResult readIdap(const SharedBytes& bytes, const std::string& fileName, const Progress& progress);

// Equal homes give equal bytes. Files that nothing in the home uses are left out. Throws InvalidHome rather
// than write what could not be read again.
Bytes writeIdap(const Home& home, const Progress& progress);

}  // namespace idap
