// An ordered map from id to shared immutable element, itself a cheap value: a copy shares everything, a
// change copies one chunk of pointers. What a drag in a home of 10 000 pieces costs is a few microseconds.
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
    using difference_type = std::ptrdiff_t;
    using iterator_category = std::forward_iterator_tag;
    Iterator() = default;
    Iterator(const Chunks* chunks, std::size_t chunk) : chunks_(chunks), chunk_(chunk) {}
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
    const Chunks* chunks_ = nullptr;
    std::size_t chunk_ = 0, index_ = 0;
  };

  Iterator begin() const { return {chunks_.get(), 0}; }
  Iterator end() const { return {chunks_.get(), chunks_->size()}; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  // The element, or null.
  std::shared_ptr<const T> shared(IdType id) const {
    const auto chunk = chunkOf(id);
    if (chunk == chunks_->end()) return nullptr;
    const auto entry = lowerBound(**chunk, id);
    return entry != (*chunk)->end() && entry->first == id ? entry->second : nullptr;
  }
  const T* find(IdType id) const {
    return shared(id).get();
  }  // lives as long as this table or a copy holds it
  bool contains(IdType id) const { return find(id) != nullptr; }

  void set(IdType id, T value) { set(id, std::make_shared<const T>(std::move(value))); }
  void set(IdType id, std::shared_ptr<const T> value) {
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
    return std::equal(a.begin(), a.end(), b.begin(), [](const Entry& x, const Entry& y) {
      return x.first == y.first && (x.second == y.second || *x.second == *y.second);
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
