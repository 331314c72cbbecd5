// Records of many lanes, of which any may be taken on: those that a mask has close up, so that no lane is
// idle when the records are visited. In the order in which they were pushed.
#pragma once

#include <cstring>
#include <memory>
#include <vector>

#include "render/lanes/lanes.h"

namespace idap::render {

// The lanes' numbers, and so many of them.
inline Ints laneNumbers() {
  return Ints([](int k) { return k; });
}
inline LaneMask firstLanes(int count) { return toMask(laneNumbers() < count); }

// Where the lanes of a mask go when they close up behind so many others.
class CloseUp {
 public:
  CloseUp(LaneMask lanes, int behind) : bits_(bitsOf(lanes)), count_(std::popcount(bits_)), behind_(behind) {
#if defined(__AVX512F__)
    const __m512i own = _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
    const __m512i from = _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits_), own);
    // Lanes are counted modulo their number.
    from_ = _mm512_maskz_permutexvar_epi32(0xffff, _mm512_sub_epi32(own, _mm512_set1_epi32(behind)), from);
    const unsigned taken = ((1u << count_) - 1) << behind;
    here_ = static_cast<__mmask16>(taken);
    next_ = static_cast<__mmask16>(taken >> kLanes);
#endif
  }
  int count() const { return count_; }
  // here, next: of lanes; next is written only where the lanes are more than here has room for.
  void move(const void* from, float* here, float* next) const {
#if defined(__AVX512F__)
    const __m512 moved = _mm512_maskz_permutexvar_ps(0xffff, from_, _mm512_load_ps(from));
    _mm512_mask_store_ps(here, here_, moved);
    if (next_ != 0) _mm512_store_ps(next, moved);
#else
    int to = behind_;
    for (std::uint32_t bits = bits_; bits != 0; bits &= bits - 1, ++to)
      std::memcpy(
          to < kLanes ? here + to : next + (to - kLanes),
          static_cast<const char*>(from) + sizeof(float) * static_cast<unsigned>(std::countr_zero(bits)),
          sizeof(float));
#endif
  }

 private:
  std::uint32_t bits_;
  int count_, behind_;
#if defined(__AVX512F__)
  __m512i from_;
  __mmask16 here_, next_;
#endif
};

// Record: of numbers of four bytes only, one a lane each (Floats, Ints, Words or vectors of them).
template <class Record>
class LaneQueue {
 public:
  static constexpr std::size_t kWords = sizeof(Record) / sizeof(Floats);
  static_assert(sizeof(Record) == kWords * sizeof(Floats) && std::is_trivially_copyable_v<Record>);

  bool empty() const { return count_ == 0; }
  std::size_t size() const { return count_; }
  // The memory is kept.
  void clear() { count_ = 0; }

  void push(LaneMask lanes, const Record& record) {
    const std::size_t block = count_ / kLanes;
    while (chunks_.size() * kChunk < block + 2)
      chunks_.push_back(std::make_unique_for_overwrite<Record[]>(kChunk));
    if (count_ % kLanes == 0 && every(lanes)) {
      at(block) = record;
      count_ += kLanes;
      return;
    }
    const CloseUp closeUp(lanes, static_cast<int>(count_ % kLanes));
    const auto* from = reinterpret_cast<const char*>(&record);
    float *here = words(at(block)), *next = words(at(block + 1));
    for (std::size_t w = 0; w < kWords; ++w)
      closeUp.move(from + w * sizeof(Floats), here + w * kLanes, next + w * kLanes);
    count_ += static_cast<std::size_t>(closeUp.count());
  }

  // Calls f(lanes, record) for as many at a time as there are lanes, until all have been; idle lanes have the
  // first one's numbers.
  template <class Function>
  void visit(Function&& f) const {
    std::size_t block = 0;
    for (; block < count_ / kLanes; ++block) f(LaneMask(true), at(block));
    const auto held = static_cast<int>(count_ % kLanes);
    if (held == 0) return;
    // By memcpy, as not all words are of the same type.
    float* last = words(at(block));
    for (std::size_t w = 0; w < kWords; ++w, last += kLanes)
      for (int k = held; k < kLanes; ++k) std::memcpy(last + k, last, sizeof(float));
    f(firstLanes(held), at(block));
  }

 private:
  static constexpr std::size_t kChunk = 16;  // records that are allocated together
  Record& at(std::size_t block) const { return chunks_[block / kChunk][block % kChunk]; }
  static float* words(Record& record) { return reinterpret_cast<float*>(&record); }

  std::vector<std::unique_ptr<Record[]>> chunks_;
  std::size_t count_ = 0;
};

}  // namespace idap::render
