#include "model/diff.h"

namespace idap {

namespace {

// A place in a table that can jump over a whole chunk.
template <class IdType, class T>
class Cursor {
 public:
  using Chunks = typename Table<IdType, T>::Chunks;
  explicit Cursor(const Chunks& chunks) : chunks_(chunks) {}

  bool done() const { return chunk_ == chunks_.size(); }
  bool atChunkStart() const { return index_ == 0; }
  const auto& chunk() const { return chunks_[chunk_]; }
  const auto& entry() const { return (*chunks_[chunk_])[index_]; }
  void nextChunk() { ++chunk_, index_ = 0; }
  void next() {
    if (++index_ == chunks_[chunk_]->size()) nextChunk();
  }

 private:
  const Chunks& chunks_;
  std::size_t chunk_ = 0, index_ = 0;
};

template <class IdType, class T>
Changes<IdType> changes(const Table<IdType, T>& before, const Table<IdType, T>& after) {
  Changes<IdType> result;
  if (&before.chunks() == &after.chunks()) return result;
  Cursor<IdType, T> a(before.chunks()), b(after.chunks());
  while (!a.done() || !b.done()) {
    if (a.done() || (!b.done() && b.entry().first < a.entry().first)) {
      result.added.push_back(b.entry().first);
      b.next();
    } else if (b.done() || a.entry().first < b.entry().first) {
      result.removed.push_back(a.entry().first);
      a.next();
    } else if (a.atChunkStart() && b.atChunkStart() && a.chunk() == b.chunk()) {
      a.nextChunk();
      b.nextChunk();
    } else {
      if (a.entry().second != b.entry().second && !(*a.entry().second == *b.entry().second))
        result.changed.push_back(a.entry().first);
      a.next();
      b.next();
    }
  }
  return result;
}

}  // namespace

bool HomeDiff::empty() const {
  return levels.empty() && walls.empty() && rooms.empty() && openings.empty() && furniture.empty() &&
         groups.empty() && cameras.empty() && dimensions.empty() && labels.empty() && polylines.empty() &&
         pictures.empty() && !site && !environment && !texts && !assets && !backgrounds;
}

HomeDiff diff(const Home& before, const Home& after) {
  HomeDiff result;
  result.levels = changes(before.levels, after.levels);
  result.walls = changes(before.walls, after.walls);
  result.rooms = changes(before.rooms, after.rooms);
  result.openings = changes(before.openings, after.openings);
  result.furniture = changes(before.furniture, after.furniture);
  result.groups = changes(before.groups, after.groups);
  result.cameras = changes(before.cameras, after.cameras);
  result.dimensions = changes(before.dimensions, after.dimensions);
  result.labels = changes(before.labels, after.labels);
  result.polylines = changes(before.polylines, after.polylines);
  result.pictures = changes(before.pictures, after.pictures);
  result.site = before.site != after.site;
  result.environment = before.environment != after.environment;
  result.texts = before.name != after.name || before.title != after.title || before.notes != after.notes ||
                 before.currency != after.currency || before.wallHeight != after.wallHeight ||
                 before.properties != after.properties;
  result.assets = before.assets != after.assets;
  result.backgrounds = before.backgrounds != after.backgrounds;
  return result;
}

}  // namespace idap
