// Whole files in and out, and the user's folders. Everything throws IoError with the path and the reason.
#pragma once

#include <filesystem>
#include <span>

#include "base/bytes.h"

namespace idap {

// Reads a whole file; refuses files over maxBytes.
Bytes readFile(const std::filesystem::path& path, std::size_t maxBytes = std::size_t{4} << 30);

// Writes to a temporary file beside the target, flushes it to the disk, then renames it over the target: the
// target is either the old file or the whole new one, never half of it.
void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

// Throws IoError when the file certainly cannot be written, so that nobody waits for a result in vain.
void requireWritable(const std::filesystem::path& path);

// Folders by the XDG base directory rules: $XDG_CACHE_HOME/idap, $XDG_DATA_HOME/idap. Not created.
std::filesystem::path userCacheFolder();
std::filesystem::path userDataFolder();

}  // namespace idap
