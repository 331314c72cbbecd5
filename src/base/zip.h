// Reading and writing ZIP archives held in memory, with bounds that keep a hostile archive from filling it.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/bytes.h"

struct zip_error;
struct zip_source;

namespace idap {

struct ZipLimits {
  std::size_t maxEntries = 100'000;
  std::size_t maxEntryBytes = std::size_t{1} << 30;
  std::size_t maxTotalBytes = std::size_t{4} << 30;
  double maxRatio = 1000;  // uncompressed / compressed, for entries over 1 MiB
};

// An open archive. Entry names use '/'; names that are absolute or leave the archive ("../") are refused.
// read() may be called from several threads. Throws ParseError with the file's name and the entry.
class ZipReader {
 public:
  ZipReader(SharedBytes archive, std::string fileName, ZipLimits limits = {});
  // Reads entries from the file as they are asked for, without holding the archive. Throws IoError too.
  explicit ZipReader(const std::filesystem::path& file, ZipLimits limits = {});
  ~ZipReader();
  ZipReader(ZipReader&&) noexcept;
  ZipReader& operator=(ZipReader&&) noexcept;

  const std::vector<std::string>& entries() const;  // files only, in archive order
  bool contains(const std::string& entry) const;
  std::size_t size(const std::string& entry) const;  // unpacked, as the archive claims
  Bytes read(const std::string& entry) const;

 private:
  struct Impl;
  void open(zip_source* source, zip_error* error);
  std::unique_ptr<Impl> impl_;
};

// True when the bytes start like a ZIP archive.
bool looksLikeZip(const Bytes& bytes);

// Packs entries (name -> bytes) in name order with fixed time stamps, so equal content gives equal archives.
Bytes writeZip(const std::map<std::string, SharedBytes>& entries);

}  // namespace idap
