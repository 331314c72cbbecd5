#include "catalog/library/install_library.h"

#include <algorithm>

#include "base/error.h"
#include "base/file.h"
#include "base/zip.h"
#include "catalog/library/library_index.h"

namespace idap {

namespace {

constexpr std::size_t kNamed = 8;
constexpr std::size_t kMaxBytes = std::size_t{2} << 30;

}  // namespace

LibraryPreview previewLibrary(const std::filesystem::path& file, const Progress& progress) {
  const std::string fileName = file.filename().string();
  const ZipReader archive(file);
  progress.check();
  const LibraryIndex index = readLibraryIndex(archive, fileName);
  LibraryPreview preview{index.name, index.description, index.license, 0, {}, {}};
  for (const LibraryIndex::Entry& entry : index.entries) {
    progress.check();
    if (!archive.contains(entry.model)) {
      preview.faults.push_back(entry.piece.name + ": " + entry.model + " is missing");
      continue;
    }
    ++preview.pieces;
    if (preview.names.size() < kNamed) preview.names.push_back(entry.piece.name);
  }
  if (preview.pieces == 0) throw ParseError(fileName, "", "the library holds no piece that could be used");
  return preview;
}

std::filesystem::path installedLibrary(const std::filesystem::path& file,
                                       const std::filesystem::path& folder) {
  // The catalog looks for this ending.
  return folder / (file.stem().string() + ".sh3f");
}

void installLibrary(const std::filesystem::path& file, const std::filesystem::path& folder) {
  const std::filesystem::path target = installedLibrary(file, folder);
  std::error_code failed;
  if (std::filesystem::equivalent(file, target, failed)) return;
  std::filesystem::create_directories(folder, failed);
  if (failed) throw IoError(folder.string() + ": cannot be made: " + failed.message());
  writeFileAtomically(target, readFile(file, kMaxBytes));
}

}  // namespace idap
