#include "base/zip.h"

#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <mutex>
#include <unordered_map>

#include "base/error.h"

namespace idap {

namespace {

bool leavesArchive(const std::string& name) {
  if (name.empty() || name.front() == '/' || name.find('\\') != std::string::npos) return true;
  if (name.size() > 1 && name[1] == ':') return true;
  std::size_t begin = 0;
  while (begin <= name.size()) {
    std::size_t end = name.find('/', begin);
    if (end == std::string::npos) end = name.size();
    if (name.compare(begin, end - begin, "..") == 0) return true;
    begin = end + 1;
  }
  return false;
}

std::string reasonOf(zip_error_t* error) {
  std::string reason = zip_error_strerror(error);
  zip_error_fini(error);
  return reason;
}

}  // namespace

struct ZipReader::Impl {
  SharedBytes archive;  // null when read from a file
  std::size_t archiveBytes = 0;
  std::string fileName;
  ZipLimits limits;
  zip_t* zip = nullptr;
  std::mutex mutex;
  std::vector<std::string> names;
  std::unordered_map<std::string, zip_uint64_t> index;

  ~Impl() {
    if (zip) zip_discard(zip);
  }
};

ZipReader::ZipReader(SharedBytes archive, std::string fileName, ZipLimits limits)
    : impl_(std::make_unique<Impl>()) {
  impl_->archive = std::move(archive);
  impl_->archiveBytes = impl_->archive->size();
  impl_->fileName = std::move(fileName);
  impl_->limits = limits;
  if (impl_->archive->empty()) throw ParseError(impl_->fileName, "", "the file is empty");
  zip_error_t error;
  zip_error_init(&error);
  open(zip_source_buffer_create(impl_->archive->data(), impl_->archive->size(), 0, &error), &error);
}

ZipReader::ZipReader(const std::filesystem::path& file, ZipLimits limits) : impl_(std::make_unique<Impl>()) {
  impl_->fileName = file.string();
  impl_->limits = limits;
  if (std::error_code failed; !std::filesystem::is_regular_file(file, failed))
    throw IoError(impl_->fileName + ": no such file");
  std::error_code unknown;
  impl_->archiveBytes = std::filesystem::file_size(file, unknown);  // the largest number when unknown
  zip_error_t error;
  zip_error_init(&error);
  open(zip_source_file_create(impl_->fileName.c_str(), 0, -1, &error), &error);
}

void ZipReader::open(zip_source* source, zip_error* opening) {
  zip_error_t& error = *opening;
  const ZipLimits& limits = impl_->limits;
  if (!source) throw ParseError(impl_->fileName, "", "not a ZIP archive: " + reasonOf(&error));
  impl_->zip = zip_open_from_source(source, ZIP_RDONLY, &error);
  if (!impl_->zip) {
    zip_source_free(source);
    throw ParseError(impl_->fileName, "", "damaged or not a ZIP archive: " + reasonOf(&error));
  }
  zip_error_fini(&error);
  const auto count = static_cast<zip_uint64_t>(zip_get_num_entries(impl_->zip, 0));
  if (count > limits.maxEntries)
    throw ParseError(impl_->fileName, "", fmt::format("too many entries ({})", count));
  std::size_t total = 0;
  for (zip_uint64_t i = 0; i < count; ++i) {
    zip_stat_t info;
    if (zip_stat_index(impl_->zip, i, 0, &info) != 0 || !(info.valid & ZIP_STAT_NAME)) continue;
    std::string name = info.name;
    if (name.empty() || name.back() == '/') continue;
    if (leavesArchive(name)) throw ParseError(impl_->fileName, name, "the entry's path leaves the archive");
    const std::size_t size = (info.valid & ZIP_STAT_SIZE) ? info.size : 0;
    const std::size_t packed = (info.valid & ZIP_STAT_COMP_SIZE) ? info.comp_size : 0;
    // A claim that would make room for more than the archive can hold is not believed.
    if (packed > impl_->archiveBytes) throw ParseError(impl_->fileName, name, "the entry is damaged");
    if (size > limits.maxEntryBytes) throw ParseError(impl_->fileName, name, "the entry is too large");
    if (size > (std::size_t{1} << 20) &&
        static_cast<double>(size) > limits.maxRatio * static_cast<double>(packed + 1))
      throw ParseError(impl_->fileName, name, "the entry's compression ratio is not plausible");
    total += size;
    if (total > limits.maxTotalBytes)
      throw ParseError(impl_->fileName, name, "the archive unpacks to too much");
    if (impl_->index.emplace(name, i).second) impl_->names.push_back(std::move(name));
  }
}

ZipReader::~ZipReader() = default;
ZipReader::ZipReader(ZipReader&&) noexcept = default;
ZipReader& ZipReader::operator=(ZipReader&&) noexcept = default;

const std::vector<std::string>& ZipReader::entries() const { return impl_->names; }
bool ZipReader::contains(const std::string& entry) const { return impl_->index.contains(entry); }

std::size_t ZipReader::size(const std::string& entry) const {
  const auto found = impl_->index.find(entry);
  if (found == impl_->index.end()) throw ParseError(impl_->fileName, entry, "no such entry");
  const std::lock_guard lock(impl_->mutex);
  zip_stat_t info;
  if (zip_stat_index(impl_->zip, found->second, 0, &info) != 0)
    throw ParseError(impl_->fileName, entry, zip_strerror(impl_->zip));
  return info.size;
}

Bytes ZipReader::read(const std::string& entry) const {
  const auto found = impl_->index.find(entry);
  if (found == impl_->index.end()) throw ParseError(impl_->fileName, entry, "no such entry");
  const std::lock_guard lock(impl_->mutex);
  zip_stat_t info;
  if (zip_stat_index(impl_->zip, found->second, 0, &info) != 0)
    throw ParseError(impl_->fileName, entry, zip_strerror(impl_->zip));
  zip_file_t* file = zip_fopen_index(impl_->zip, found->second, 0);
  if (!file) throw ParseError(impl_->fileName, entry, zip_strerror(impl_->zip));
  Bytes bytes(info.size);
  std::size_t done = 0;
  while (done < bytes.size()) {
    const zip_int64_t got = zip_fread(file, bytes.data() + done, bytes.size() - done);
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  // Reading past the end makes libzip compare the checksum.
  std::byte extra;
  const bool whole = done == bytes.size() && zip_fread(file, &extra, 1) == 0;
  const int closed = zip_fclose(file);
  if (!whole || closed != 0) throw ParseError(impl_->fileName, entry, "the entry is damaged");
  return bytes;
}

bool looksLikeZip(const Bytes& bytes) {
  const std::string_view text = asText(bytes);
  return text.starts_with("PK\x03\x04") || text.starts_with("PK\x05\x06");
}

Bytes writeZip(const std::map<std::string, SharedBytes>& entries) {
  if (entries.empty()) {  // libzip would write nothing at all; this is the end record of an empty archive
    Bytes bytes(22);
    constexpr std::string_view kSignature = "PK\x05\x06";
    std::transform(kSignature.begin(), kSignature.end(), bytes.begin(), [](char c) { return std::byte(c); });
    return bytes;
  }
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, &error);
  if (!target) throw IoError("cannot make an archive: " + reasonOf(&error));
  zip_source_keep(target);
  zip_t* zip = zip_open_from_source(target, ZIP_TRUNCATE, &error);
  if (!zip) {
    zip_source_free(target);
    throw IoError("cannot make an archive: " + reasonOf(&error));
  }
  for (const auto& [name, bytes] : entries) {
    zip_source_t* source = zip_source_buffer(zip, bytes->data(), bytes->size(), 0);
    const zip_int64_t index = source ? zip_file_add(zip, name.c_str(), source, ZIP_FL_ENC_UTF_8) : -1;
    if (index < 0) {
      if (source) zip_source_free(source);
      const std::string reason = zip_strerror(zip);
      zip_discard(zip);
      zip_source_free(target);
      throw IoError("cannot add " + name + " to the archive: " + reason);
    }
    zip_file_set_dostime(zip, static_cast<zip_uint64_t>(index), 0, 0x21, 0);  // 1980-01-01
  }
  if (zip_close(zip) != 0) {
    const std::string reason = zip_strerror(zip);
    zip_discard(zip);
    zip_source_free(target);
    throw IoError("cannot write the archive: " + reason);
  }
  zip_source_open(target);
  zip_source_seek(target, 0, SEEK_END);
  Bytes bytes(static_cast<std::size_t>(zip_source_tell(target)));
  zip_source_seek(target, 0, SEEK_SET);
  const zip_int64_t got = zip_source_read(target, bytes.data(), bytes.size());
  zip_source_close(target);
  zip_source_free(target);
  if (got != static_cast<zip_int64_t>(bytes.size())) throw IoError("cannot write the archive");
  return bytes;
}

}  // namespace idap
