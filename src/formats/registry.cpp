#include "formats/registry.h"

#include <algorithm>
#include <cctype>

#include "base/error.h"
#include "base/file.h"
#include "formats/idap/idap_format.h"
#include "formats/sh3d/sh3d_reader.h"
#include "model/validate.h"

namespace idap {

namespace {

std::string extensionOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

bool hasExtension(const HomeFormat& format, const std::string& extension) {
  return std::find(format.extensions.begin(), format.extensions.end(), extension) != format.extensions.end();
}

std::string extensionsThat(bool (*can)(const HomeFormat&)) {
  std::string list;
  for (const HomeFormat& format : homeFormats())
    if (can(format))
      for (const std::string& extension : format.extensions) list += (list.empty() ? "." : ", .") + extension;
  return list;
}

}  // namespace

const std::vector<HomeFormat>& homeFormats() {
  static const std::vector<HomeFormat> formats = {
      {"idap", "IDAP home", {"idap"}, sniffIdap, readIdap, writeIdap},
      {"sh3d", "Sweet Home 3D home", {"sh3d"}, sniffSh3d, readSh3d, nullptr},
  };
  return formats;
}

ReadResult readHome(const std::filesystem::path& file, const Progress& progress) {
  const auto bytes = std::make_shared<const Bytes>(readFile(file));
  const std::string name = file.filename().string();
  const std::string extension = extensionOf(file);
  const HomeFormat* chosen = nullptr;
  for (const HomeFormat& format : homeFormats())
    if (!chosen && format.read && format.sniffs && format.sniffs(bytes, name)) chosen = &format;
  for (const HomeFormat& format : homeFormats())
    if (!chosen && format.read && hasExtension(format, extension)) chosen = &format;
  if (!chosen)
    throw ParseError(name, "",
                     "not a home of a known format (known: " + extensionsThat([](const HomeFormat& f) {
                       return f.read != nullptr;
                     }) + ")");
  ReadResult result = chosen->read(bytes, name, progress);
  result.home = validated(std::move(result.home), result.report);
  return result;
}

void writeHome(const Home& home, const std::filesystem::path& file, const Progress& progress) {
  const std::string extension = extensionOf(file);
  for (const HomeFormat& format : homeFormats()) {
    if (!format.write || !hasExtension(format, extension)) continue;
    const Bytes bytes = format.write(home, progress);
    progress.check();
    writeFileAtomically(file, bytes);
    return;
  }
  throw Error(file.string() + ": homes cannot be written as '" + extension +
              "' (possible: " + extensionsThat([](const HomeFormat& f) { return f.write != nullptr; }) + ")");
}

}  // namespace idap
