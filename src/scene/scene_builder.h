// Builds the renderer's scene out of a home: walls, openings, rooms, ground, furniture, lamps, daylight.
// Metres; the scene's coordinates are float and relative to BuiltScene::centre (world = scene + centre).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/progress.h"
#include "catalog/catalog.h"
#include "model/home.h"
#include "render/scene.h"

namespace idap {

enum class LampPolicy {
  Auto,  // as the home says: each lamp by its own switch and dimmer
  On,    // every lamp at its dimmer, switched off ones too
  Off,
};

struct BuildOptions {
  bool ceilings = true;  // false: open from above (rooms' ceilings and slabs over the top left out)
  // Levels that the plan hides at the moment (Level::visible); none: as ceilings, so that a view from inside
  // is of the whole house and one from above of the levels that are shown.
  std::optional<bool> hiddenLevels;
  bool ground = true;  // the land around the house
  LampPolicy lamps = LampPolicy::Auto;
  std::optional<std::int64_t> time;  // ms since 1970 (UTC); none: the home's own
  double cloudiness = 0;             // 0 clear .. 1 overcast
};

// What an object id in the film stands for; monostate: the ground.
using ElementId = std::variant<std::monostate, WallId, RoomId, OpeningId, FurnitureId>;

struct BuiltScene {
  std::shared_ptr<render::Scene> scene;
  Vec3 centre;
  std::vector<ElementId> objects;     // by render::Instance::objectId; [0] is "none"
  std::vector<std::string> warnings;  // what could not be shown as the home asks, in words
  std::size_t triangles = 0;          // of the meshes, each counted once
};

// Throws Cancelled where progress asks to stop. Never throws for a home that validates: what cannot be built
// is left out with a warning.
BuiltScene buildScene(const Home& home, const Catalog& catalog, const BuildOptions& options = {},
                      const Progress& progress = {});

// aspect: width / height of the picture.
render::Camera toRenderCamera(const Camera& camera, const BuiltScene& built, double aspect);

// A view from above on the whole home; build the scene with ceilings = false for it.
Camera topCamera(const Home& home, double aspect = 4.0 / 3.0);

}  // namespace idap
