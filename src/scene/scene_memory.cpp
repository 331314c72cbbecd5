#include "scene/scene_memory.h"

namespace idap {

namespace {

constexpr std::uint64_t kBuildsKept = 32;  // an undo or two away

}  // namespace

void MeshStore::nextBuild() {
  ++build_;
  std::erase_if(entries_, [this](const auto& entry) { return entry.second.usedAt + kBuildsKept < build_; });
}

}  // namespace idap
