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

struct SceneMemory;  // scene/scene_memory.h

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
  std::optional<double> cloudiness;  // 0 clear .. 1 overcast; none: the home's own
};

// What an object id in the film stands for; monostate: the ground.
using ElementId = std::variant<std::monostate, WallId, RoomId, OpeningId, FurnitureId>;

// An outer wall with the doors and windows in it, which hides what is behind it from an eye outdoors.
struct OuterWall {
  Vec3 middle;   // world, m
  Vec2 outward;  // unit, on the plan
  std::vector<std::uint32_t> instances;
};

struct BuiltScene {
  std::shared_ptr<render::Scene> scene;
  Vec3 centre;
  std::vector<ElementId> objects;  // by render::Instance::objectId; [0] is "none": the land
  std::vector<FurnitureId> lamps;  // by light group: the lamp whose light it is; none for sky and sun
  std::vector<OuterWall> outerWalls;
  std::vector<std::string> warnings;  // what could not be shown as the home asks, in words
  std::size_t triangles = 0;          // of the meshes, each counted once
};

// Throws Cancelled where progress asks to stop. Never throws for a home that validates: what cannot be built
// is left out with a warning.
// memory: of the builds before, where there will be more of them; the scene is the same with and without, but
// for its centre, which stays where it was while the home is near it.
BuiltScene buildScene(const Home& home, const Catalog& catalog, const BuildOptions& options = {},
                      const Progress& progress = {}, SceneMemory* memory = nullptr);

// aspect: width / height of the picture.
render::Camera toRenderCamera(const Camera& camera, const BuiltScene& built, double aspect);

// A view from above on the whole home; build the scene with ceilings = false for it.
Camera topCamera(const Home& home, double aspect = 4.0 / 3.0);

}  // namespace idap
