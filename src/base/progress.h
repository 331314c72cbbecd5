// How a long job tells its caller how far it is, and learns that it should stop. Thread-safe.
#pragma once

#include <atomic>
#include <functional>
#include <string_view>
#include <utility>

#include "base/error.h"

namespace idap {

class Progress {
 public:
  // Called with the fraction done in 0..1 and what is being done; may be called from any thread.
  using Callback = std::function<void(double fraction, std::string_view what)>;

  Progress() = default;
  explicit Progress(Callback callback) : callback_(std::move(callback)) {}

  void report(double fraction, std::string_view what) const {
    if (callback_) callback_(fraction, what);
  }
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
  // Throws Cancelled when the job was asked to stop.
  void check() const {
    if (cancelled()) throw Cancelled();
  }

 private:
  Callback callback_;
  std::atomic<bool> cancelled_{false};
};

}  // namespace idap
