// What must go for somebody outside to see in: ceilings, and the outer walls that turn their outside to the
// eye. World space, metres.
#pragma once

#include "scene/scene_builder.h"

namespace idap {

namespace render {
class CompiledScene;
}

enum class CutAway { ByView, Never };

// The eye is above the ceilings, or beside the walls: nothing inside could be seen.
bool isOutside(const Home& home, Vec3 eye);

// The instances that primary rays must pass; light meets them all the same. Empty for an eye that is inside.
std::vector<std::uint32_t> hiddenFrom(const BuiltScene& built, Vec3 eye, CutAway cut);

// Hides what must go for an eye outside, in a scene compiled of built.
void cutAway(render::CompiledScene& scene, const BuiltScene& built, Vec3 eye);

}  // namespace idap
