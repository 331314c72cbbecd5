// A library's index on disk, so that the next start needs neither the archive nor its tables.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "catalog/library/library_index.h"

namespace idap {

// What a library file is told by: the same path, size and time mean the same content.
struct LibraryStamp {
  std::string path;
  std::uint64_t size = 0;
  std::int64_t time = 0;  // of the last change, in the file system's own count
  friend bool operator==(const LibraryStamp&, const LibraryStamp&) = default;
};

LibraryStamp stampOf(const std::filesystem::path& library);  // throws IoError

// Nothing when the folder has none, or one of another stamp, another version of the program, or a damaged
// one.
std::optional<LibraryIndex> loadLibraryIndex(const std::filesystem::path& folder, const LibraryStamp& stamp);

// Best effort: where the folder cannot be written nothing happens.
void storeLibraryIndex(const std::filesystem::path& folder, const LibraryStamp& stamp,
                       const LibraryIndex& index);

}  // namespace idap
