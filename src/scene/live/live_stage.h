// The scene that the live view traces, kept in step with the home request by request: what did not change
// stays as it is.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "render/accel/compiled_scene.h"
#include "scene/live/live_render.h"
#include "scene/scene_memory.h"

namespace idap {

class LiveStage {
 public:
  using PartNames = std::vector<std::vector<std::string>>;

  explicit LiveStage(int threads) : threads_(threads) {}

  // Throws as buildScene() and CompiledScene do, and Cancelled.
  void follow(const LiveRequest& request, const Progress& progress);

  const render::CompiledScene& scene() const { return *scene_; }
  const BuiltScene& built() const { return built_; }
  bool outside() const { return outside_; }
  std::shared_ptr<const PartNames> parts() const { return parts_; }

 private:
  int threads_;
  SceneMemory memory_;
  Home home_;
  std::shared_ptr<const Catalog> catalog_;
  bool outside_ = false;
  LampPolicy lamps_ = LampPolicy::Auto;
  std::optional<std::int64_t> time_;
  BuiltScene built_;
  std::shared_ptr<const PartNames> parts_;
  std::unique_ptr<render::CompiledScene> scene_;
  std::vector<std::uint32_t> hidden_;
};

}  // namespace idap
