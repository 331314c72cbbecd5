// Every file format by one table: to add one, write its folder and add one line in registry.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"
#include "model/home.h"
#include "model/import_report.h"

namespace idap {

struct ReadResult {
  Home home;
  ImportReport report;
};

struct HomeFormat {
  std::string id;                       // "idap"
  std::string name;                     // "IDAP home"
  std::vector<std::string> extensions;  // without dot, lower case
  bool (*sniffs)(const SharedBytes& bytes, const std::string& fileName) = nullptr;
  ReadResult (*read)(const SharedBytes& bytes, const std::string& fileName,
                     const Progress& progress) = nullptr;                // null: cannot
  Bytes (*write)(const Home& home, const Progress& progress) = nullptr;  // null: cannot
};

const std::vector<HomeFormat>& homeFormats();

// Reads a home of any known format, by content first and extension second; the result is validated. Throws
// IoError, ParseError, UnsupportedVersion, Cancelled.
ReadResult readHome(const std::filesystem::path& file, const Progress& progress = {});

// Writes a home in the format of the extension, atomically. Throws IoError, or Error for an unknown
// extension.
void writeHome(const Home& home, const std::filesystem::path& file, const Progress& progress = {});

}  // namespace idap
