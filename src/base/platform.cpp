#include "base/platform.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

namespace idap {

namespace {

std::atomic<Progress*> interruptible{nullptr};

// Storing to a lock-free atomic is all that a signal handler may do.
void onSignal(int signal) {
  if (Progress* progress = interruptible.exchange(nullptr)) {
    progress->cancel();
    return;
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

void setUpProcess() {
  std::signal(SIGXFSZ, SIG_IGN);
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // The lowest free number is taken, which is fd; read-only, so that writing to it is an error still.
    if (::fcntl(fd, F_GETFD) == -1 && ::open("/dev/null", O_RDONLY) != fd) return;
  }
}

void lowerThreadPriority() {
#ifdef __linux__
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), 10);  // of this thread alone, on Linux
#endif
}

bool standardErrorIsTerminal() { return ::isatty(STDERR_FILENO) != 0; }

std::size_t availableMemoryBytes() {
  std::ifstream file("/proc/meminfo");
  std::string name, unit;
  for (std::size_t kibibytes = 0; file >> name >> kibibytes && std::getline(file, unit);) {
    if (name == "MemAvailable:") return kibibytes * 1024;
  }
  return std::numeric_limits<std::size_t>::max();
}

double peakMemoryMegabytes() {
  struct rusage usage {};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024.0 / 1e6;
}

double processAgeSeconds() {
  std::ifstream self("/proc/self/stat"), up("/proc/uptime");
  std::string line;
  double uptime = 0;
  if (!std::getline(self, line) || !(up >> uptime)) return 0;
  // The program's name stands in brackets and may hold anything; the start is the 20th field after it.
  const std::size_t bracket = line.rfind(')');
  if (bracket == std::string::npos) return 0;
  std::istringstream fields(line.substr(bracket + 1));
  std::string field;
  for (int i = 0; i < 20; ++i) fields >> field;
  const double ticks = std::strtod(field.c_str(), nullptr);
  return uptime - ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

std::filesystem::path programBeside(const std::string& name) {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return {};
  const std::filesystem::path program = self.parent_path() / name;
  return ::access(program.c_str(), X_OK) == 0 ? program : std::filesystem::path();
}

std::string becomeProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execv(program.c_str(), pointers.data());
  return std::strerror(errno);
}

bool hasDisplay() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
    if (const char* value = std::getenv(name); value && *value) return true;
  return false;
}

CancelOnInterrupt::CancelOnInterrupt(Progress& progress) {
  interruptible.store(&progress);
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
}

CancelOnInterrupt::~CancelOnInterrupt() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  interruptible.store(nullptr);
}

}  // namespace idap
