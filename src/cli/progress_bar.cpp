#include "cli/progress_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/platform.h"

namespace idap::cli {

namespace {

constexpr int kWidth = 30;

}  // namespace

std::string durationText(double seconds) {
  const auto s = static_cast<long long>(std::llround(std::max(0.0, seconds)));
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {} s", s / 60, s % 60);
  return fmt::format("{} h {} min", s / 3600, s / 60 % 60);
}

ProgressBar::ProgressBar() : terminal_(standardErrorIsTerminal()), phaseStart_(Clock::now()) {}

ProgressBar::~ProgressBar() { wipe(); }

void ProgressBar::wipe() {
  const std::lock_guard lock(mutex_);
  if (drawn_) std::fputs("\r\x1b[K", stderr);
  drawn_ = false;
}

void ProgressBar::show(double fraction, std::string_view what) {
  if (!terminal_) return;
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  const double done = std::clamp(fraction, 0.0, 1.0);
  if (what != phase_) {
    phase_ = what;
    phaseStart_ = now;
    phaseStartFraction_ = done;
  } else if (drawn_ && now - lastDrawn_ < std::chrono::milliseconds(100)) {
    return;
  }
  lastDrawn_ = now;
  drawn_ = true;
  const double elapsed = std::chrono::duration<double>(now - phaseStart_).count();
  const double progress = done - phaseStartFraction_;
  std::string left;
  if (progress > 0.005 && elapsed > 0.5) left = durationText(elapsed / progress * (1 - done)) + " left";
  const int filled = static_cast<int>(done * kWidth);
  const std::string line = fmt::format("\r\x1b[K{:<10} [{:#<{}}{:.<{}}] {:3.0f} % {}", phase_, "", filled, "",
                                       kWidth - filled, done * 100, left);
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace idap::cli
