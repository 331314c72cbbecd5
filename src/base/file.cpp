#include "base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include "base/error.h"

namespace idap {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* action, int error) {
  throw IoError(path.string() + ": cannot " + action + ": " + std::strerror(error));
}

// A file descriptor that closes itself, and a temporary file that removes itself unless kept.
class OpenFile {
 public:
  explicit OpenFile(int fd) : fd_(fd) {}
  ~OpenFile() {
    if (fd_ >= 0) ::close(fd_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int get() const { return fd_; }
  int close() {
    const int result = ::close(fd_);
    fd_ = -1;
    return result;
  }

 private:
  int fd_;
};

class TemporaryName {
 public:
  explicit TemporaryName(std::string name) : name_(std::move(name)) {}
  ~TemporaryName() {
    if (!name_.empty()) ::unlink(name_.c_str());
  }
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;
  void keep() { name_.clear(); }

 private:
  std::string name_;
};

std::filesystem::path userFolder(const char* variable, const char* fallback) {
  if (const char* folder = std::getenv(variable); folder && *folder)
    return std::filesystem::path(folder) / "idap";
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home && *home ? home : "/tmp") / fallback / "idap";
}

}  // namespace

Bytes readFile(const std::filesystem::path& path, std::size_t maxBytes) {
  OpenFile file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) fail(path, "open", errno);
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) fail(path, "read", errno);
  if (S_ISDIR(info.st_mode)) fail(path, "read", EISDIR);
  if (S_ISCHR(info.st_mode) || S_ISBLK(info.st_mode))
    throw IoError(path.string() + ": cannot read: a device, not a file");  // some never end
  if (static_cast<std::size_t>(info.st_size) > maxBytes) throw IoError(path.string() + ": file is too large");
  Bytes bytes(static_cast<std::size_t>(info.st_size));
  std::size_t done = 0;
  for (;;) {
    if (done == bytes.size()) bytes.resize(bytes.size() + 65536);  // pipes, and files that grow
    const ssize_t got = ::read(file.get(), bytes.data() + done, bytes.size() - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path, "read", errno);
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
    if (done > maxBytes) throw IoError(path.string() + ": file is too large");
  }
  bytes.resize(done);
  return bytes;
}

void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  // A link is written through, not replaced.
  std::error_code ignored;
  std::filesystem::path target = std::filesystem::weakly_canonical(path, ignored);
  if (target.empty()) target = path;
  if (std::filesystem::is_directory(target, ignored)) fail(path, "write", EISDIR);
  if (std::filesystem::exists(target, ignored) && !std::filesystem::is_regular_file(target, ignored)) {
    // A device or pipe cannot be replaced by renaming; it is written directly.
    OpenFile file(::open(target.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.get() < 0) fail(path, "write", errno);
    for (std::size_t done = 0; done < bytes.size();) {
      const ssize_t put = ::write(file.get(), bytes.data() + done, bytes.size() - done);
      if (put < 0 && errno == EINTR) continue;
      if (put < 0) fail(path, "write", errno);
      done += static_cast<std::size_t>(put);
    }
    return;
  }
  std::string name = target.string() + ".XXXXXX";
  OpenFile file(::mkostemp(name.data(), O_CLOEXEC));
  if (file.get() < 0) fail(path, "write", errno);
  TemporaryName temporary(name);
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t put = ::write(file.get(), bytes.data() + done, bytes.size() - done);
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) fail(path, "write", errno);
    done += static_cast<std::size_t>(put);
  }
  struct stat old {};
  mode_t mode = 0;
  if (::stat(target.c_str(), &old) == 0) {
    mode = old.st_mode & 07777;
  } else {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    mode = 0666 & ~mask;
  }
  if (::fchmod(file.get(), mode) != 0) fail(path, "write", errno);
  if (::fsync(file.get()) != 0) fail(path, "write", errno);
  if (file.close() != 0) fail(path, "write", errno);
  if (::rename(name.c_str(), target.c_str()) != 0) fail(path, "write", errno);
  temporary.keep();
  OpenFile folder(::open(target.has_parent_path() ? target.parent_path().c_str() : ".",
                         O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.get() >= 0) ::fsync(folder.get());
}

void requireWritable(const std::filesystem::path& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) == 0) {
    if (S_ISDIR(info.st_mode)) fail(path, "write", EISDIR);
    if (::access(path.c_str(), W_OK) != 0) fail(path, "write", errno);
    return;
  }
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(path, "write", errno);
}

std::filesystem::path userCacheFolder() { return userFolder("XDG_CACHE_HOME", ".cache"); }
std::filesystem::path userDataFolder() { return userFolder("XDG_DATA_HOME", ".local/share"); }

}  // namespace idap
