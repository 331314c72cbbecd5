#include "base/platform.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <limits>
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
