// Puts a lamp's light into the scene: bulbs as spheres where they can be seen from outside; where a shade
// hides them it shines in their place, and where it only hides them from most sides both share the light.
// Scene space, metres.
#pragma once

#include <functional>
#include <vector>

#include "model/lamp.h"
#include "render/scene.h"

namespace idap {

struct Fixture {
  const Mesh* mesh = nullptr;  // null: no geometry
  Transform meshToScene;
  Transform pieceToScene;  // from the piece's object space in metres (origin in the middle of the base)
  Vec3 size{1, 1, 1};
  std::vector<Vec3> bulbs;  // object space in metres: where the model says that its bulbs sit
};

struct LampLight {
  std::vector<render::Lamp> bulbs;
  // A part of the mesh that shines: its triangles move from their slot to a new one of the same surface.
  struct Glow {
    std::uint32_t slot = 0;  // whose surface it has
    Rgb emission{};          // cd/m2
    double area = 0;         // m2 that give light off, both sides of open sheets counted
    std::vector<std::uint32_t> triangles;
  };
  std::vector<Glow> glows;
  std::vector<bool> slotTranslucent;  // by slot: a shade of cloth or glass that a bulb shines through
};

struct LampOptions {
  double lumens = 0;  // after switch and dimmer
  std::uint16_t lightGroup = 0;
  // Moves a point out of walls and ceilings; the sphere of that radius around it should be free.
  std::function<Vec3(Vec3 point, double radius)> intoRoom;
};

// Surfaces of the fixture by slot say what light passes (glass) and what may be a shade (by name). Bulbs and
// glows together give off all the lumens.
LampLight lampLight(const Lamp& lamp, const Fixture& fixture,
                    const std::vector<const render::Surface*>& slots, const LampOptions& options);

// Linear RGB of luminance 1.
Rgb lampColor(const Lamp& lamp, const std::optional<Color>& own);

}  // namespace idap
