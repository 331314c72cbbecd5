// A progress bar with the time left, on standard error if that is a terminal; otherwise nothing is shown.
#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>

namespace idap::cli {

class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();  // wipes the line
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // Thread-safe; redraws at most ten times a second. The time left is judged by the pace of the current
  // phase.
  void show(double fraction, std::string_view what);
  // Clears the line for something else; the next show() draws the bar again.
  void wipe();

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_;
  std::mutex mutex_;
  std::string phase_;
  Clock::time_point phaseStart_, lastDrawn_;
  double phaseStartFraction_ = 0;
  bool drawn_ = false;
};

// "45 s", "2 min 10 s", "1 h 5 min"
std::string durationText(double seconds);

}  // namespace idap::cli
