#include "scene/live/live_stage.h"

#include "model/diff.h"
#include "scene/cut_away.h"

namespace idap {

namespace {

using PartNames = LiveStage::PartNames;

std::shared_ptr<const PartNames> partNames(const BuiltScene& built) {
  auto names = std::make_shared<PartNames>(built.objects.size());
  for (const render::Instance& instance : built.scene->instances) {
    std::vector<std::string>& of = (*names)[instance.objectId];
    for (const std::uint32_t surface : instance.surfaces) of.push_back(built.scene->surfaces[surface].name);
  }
  return names;
}

// Whether a picture could tell the homes apart.
bool showsOther(const Home& before, const Home& after) {
  const HomeDiff d = diff(before, after);
  return !(d.levels.empty() && d.walls.empty() && d.rooms.empty() && d.openings.empty() &&
           d.furniture.empty() && d.groups.empty()) ||
         d.site || d.environment || d.assets || before.wallHeight != after.wallHeight;
}

}  // namespace

void LiveStage::follow(const LiveRequest& r, const Progress& progress) {
  const bool outside = r.cut == CutAway::ByView && isOutside(r.home, r.camera.eye);
  BuildOptions options;
  options.ceilings = !outside;
  options.lamps = r.lamps;
  options.time = r.camera.time;
  if (!scene_ || catalog_ != r.catalog || outside != outside_ || options.lamps != lamps_ ||
      options.time != time_ || showsOther(home_, r.home)) {
    if (catalog_ != r.catalog) memory_ = {};
    BuiltScene built = buildScene(r.home, *r.catalog, options, progress, &memory_);
    auto scene = std::make_unique<render::CompiledScene>(built.scene, threads_, scene_.get());
    scene_ = std::move(scene);
    built_ = std::move(built);
    parts_ = partNames(built_);
    hidden_.clear();
    catalog_ = r.catalog;
    lamps_ = options.lamps;
    time_ = options.time;
  }
  home_ = r.home;
  outside_ = outside;
  std::vector<std::uint32_t> hidden;
  if (outside) hidden = hiddenFrom(built_, r.camera.eye, r.cut);
  if (hidden != hidden_) {
    for (const std::uint32_t i : hidden_) scene_->setVisibleToCamera(i, true);
    for (const std::uint32_t i : hidden) scene_->setVisibleToCamera(i, false);
    scene_->commit();
    hidden_ = std::move(hidden);
  }
}

}  // namespace idap
