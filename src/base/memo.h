// Results of pure functions by the exact bytes of what they were made from, kept for as long as somebody asks
// for them now and then. Any number of threads at once.
#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <unordered_map>
#include <utility>

namespace idap {

template <class T>
class Memo {
 public:
  // The value made before from that key, or what make gives. Two threads that ask for the same at once may
  // both make it.
  template <class Make>
  T get(std::string key, Make&& make) {
    {
      const std::lock_guard lock(mutex_);
      if (const auto at = entries_.find(key); at != entries_.end()) {
        at->second.usedAt = round_;
        return at->second.value;
      }
    }
    T value = make();
    const std::lock_guard lock(mutex_);
    return entries_.insert_or_assign(std::move(key), Entry{std::move(value), round_}).first->second.value;
  }

  // Forgets what nobody asked for in that many rounds.
  void nextRound(std::uint64_t kept = 16) {
    const std::lock_guard lock(mutex_);
    ++round_;
    std::erase_if(entries_, [&](const auto& entry) { return entry.second.usedAt + kept < round_; });
  }

 private:
  struct Entry {
    T value;
    std::uint64_t usedAt = 0;
  };
  std::mutex mutex_;
  std::unordered_map<std::string, Entry> entries_;
  std::uint64_t round_ = 0;
};

}  // namespace idap
