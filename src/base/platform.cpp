#include "base/platform.h"

#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <csignal>

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

bool standardErrorIsTerminal() { return ::isatty(STDERR_FILENO) != 0; }

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
