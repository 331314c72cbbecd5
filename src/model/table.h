// An ordered map from id to shared immutable element, itself a cheap value: a copy shares everything, a
// change copies one chunk of pointers. What a drag in a home of 10 000 pieces costs is a few microseconds.
// Iterators walk the table as it was when they were made, so a loop may set and erase as it goes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace idap {

template <class IdType, class T>
class Table {
 public:
  using Entry = std::pair<IdType, std::shared_ptr<const T>>;
  using Chunk = std::vector<Entry>;
  using Chunks = std::vector<std::shared_ptr<const Chunk>>;

  class Iterator {
   public:
    using value_type = Entry;
    using reference = const Entry&;
    using pointer = const Entry*;
    using difference_type = std::ptrdiff_t;
    using iterator_category = std::forward_iterator_tag;
    Iterator() = default;
    Iterator(std::shared_ptr<const Chunks> chunks, std::size_t chunk)
        : chunks_(std::move(chunks)), chunk_(chunk) {}
    const Entry& operator*() const { return (*(*chunks_)[chunk_])[index_]; }
    const Entry* operator->() const { return &**this; }
    Iterator& operator++() {
      if (++index_ == (*chunks_)[chunk_]->size()) ++chunk_, index_ = 0;
      return *this;
    }
    Iterator operator++(int) {
      Iterator old = *this;
      ++*this;
      return old;
    }
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    std::shared_ptr<const Chunks> chunks_;
    std::size_t chunk_ = 0, index_ = 0;
  };

  Table() = default;
  // A move is a copy: it costs one more count and leaves a table that can still be used.
  Table(const Table&) = default;
  Table& operator=(const Table&) = default;
  ~Table() = default;

  // A table of many elements at once, in any order; of equal ids the first counts, nulls are left out.
  static Table of(Chunk entries) {
    std::erase_if(entries, [](const Entry& entry) { return !entry.second; });
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& x, const Entry& y) { return x.first < y.first; });
    const auto equal = [](const Entry& x, const Entry& y) { return x.first == y.first; };
    entries.erase(std::unique(entries.begin(), entries.end(), equal), entries.end());
    auto chunks = std::make_shared<Chunks>();
    for (auto from = entries.begin(); from != entries.end();) {
      const auto to = from + std::min<std::ptrdiff_t>(kChunkSize, entries.end() - from);
      chunks->push_back(
          std::make_shared<const Chunk>(std::make_move_iterator(from), std::make_move_iterator(to)));
      from = to;
    }
    Table table;
    table.size_ = entries.size();
    table.chunks_ = std::move(chunks);
    return table;
  }

  Iterator begin() const { return {chunks_, 0}; }
  Iterator end() const { return {chunks_, chunks_->size()}; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  // The element, or null.
  std::shared_ptr<const T> shared(IdType id) const {
    const auto chunk = chunkOf(id);
    if (chunk == chunks_->end()) return nullptr;
    const auto entry = lowerBound(**chunk, id);
    return entry != (*chunk)->end() && entry->first == id ? entry->second : nullptr;
  }
  // Lives as long as this table or a copy of it holds the element.
  const T* find(IdType id) const { return shared(id).get(); }
  bool contains(IdType id) const { return find(id) != nullptr; }

  void set(IdType id, T value) { set(id, std::make_shared<const T>(std::move(value))); }
  void set(IdType id, std::shared_ptr<const T> value) {
    if (!value) {
      erase(id);
      return;
    }
    auto chunks = std::make_shared<Chunks>(*chunks_);
    auto at = chunks->begin() + (chunkOf(id) - chunks_->begin());
    if (at == chunks->end()) {
      if (chunks->empty() || chunks->back()->size() >= kChunkSize) {
        chunks->push_back(std::make_shared<const Chunk>(Chunk{{id, std::move(value)}}));
        ++size_;
        chunks_ = std::move(chunks);
        return;
      }
      --at;
    }
    auto chunk = std::make_shared<Chunk>(**at);
    const auto entry = chunk->begin() + (lowerBound(*chunk, id) - chunk->cbegin());
    if (entry != chunk->end() && entry->first == id) {
      entry->second = std::move(value);
    } else {
      chunk->insert(entry, {id, std::move(value)});
      ++size_;
    }
    if (chunk->size() > 2 * kChunkSize) {
      auto upper = std::make_shared<Chunk>(chunk->begin() + kChunkSize, chunk->end());
      chunk->resize(kChunkSize);
      *at = std::move(chunk);
      chunks->insert(at + 1, std::move(upper));
    } else {
      *at = std::move(chunk);
    }
    chunks_ = std::move(chunks);
  }
  bool erase(IdType id) {
    if (!contains(id)) return false;
    auto chunks = std::make_shared<Chunks>(*chunks_);
    const auto at = chunks->begin() + (chunkOf(id) - chunks_->begin());
    auto chunk = std::make_shared<Chunk>(**at);
    chunk->erase(chunk->begin() + (lowerBound(*chunk, id) - chunk->cbegin()));
    if (chunk->empty()) {
      chunks->erase(at);
    } else {
      *at = std::move(chunk);
    }
    --size_;
    chunks_ = std::move(chunks);
    return true;
  }

  // Same elements by value.
  friend bool operator==(const Table& a, const Table& b) {
    if (a.chunks_ == b.chunks_) return true;
    if (a.size_ != b.size_) return false;
    const auto same = [](const Entry& x, const Entry& y) {
      return x.first == y.first && (x.second == y.second || *x.second == *y.second);
    };
    // Most chunks of two versions of a table are shared; only those split otherwise need the slow walk.
    const bool alike = std::equal(a.chunks_->begin(), a.chunks_->end(), b.chunks_->begin(), b.chunks_->end(),
                                  [](const auto& x, const auto& y) { return x->size() == y->size(); });
    if (!alike) return std::equal(a.begin(), a.end(), b.begin(), same);
    return std::equal(a.chunks_->begin(), a.chunks_->end(), b.chunks_->begin(),
                      [&same](const auto& x, const auto& y) {
                        return x == y || std::equal(x->begin(), x->end(), y->begin(), same);
                      });
  }

  const Chunks& chunks() const { return *chunks_; }  // for diff: equal chunk pointers hold equal elements

 private:
  static constexpr std::ptrdiff_t kChunkSize = 64;

  static typename Chunk::const_iterator lowerBound(const Chunk& chunk, IdType id) {
    return std::lower_bound(chunk.cbegin(), chunk.cend(), id,
                            [](const Entry& entry, IdType key) { return entry.first < key; });
  }
  // The first chunk whose last id is not below id.
  typename Chunks::const_iterator chunkOf(IdType id) const {
    return std::lower_bound(chunks_->cbegin(), chunks_->cend(), id,
                            [](const auto& chunk, IdType key) { return chunk->back().first < key; });
  }

  std::shared_ptr<const Chunks> chunks_ = std::make_shared<const Chunks>();
  std::size_t size_ = 0;
};

}  // namespace idap
