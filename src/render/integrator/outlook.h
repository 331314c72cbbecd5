// Where daylight comes into rooms: the sky through the windows, and what the sun shines on, the patches of
// sun on floors and walls as well as the ground before the house. A path looks there from every point that
// scatters widely, beside following one ray on: small bright things are then found by design and not by luck.
#pragma once

#include "render/accel/compiled_scene.h"
#include "render/emitter/lights.h"

namespace idap::render {

class Outlook {
 public:
  Outlook(const CompiledScene& scene, const Receiver& at);

  // A direction worth looking in; false where there is none.
  bool sample(float choice, Vec2f u, Vec3f& direction, float& pdf) const;
  float pdf(Vec3f direction) const;  // 1/sr

  // What a look finds, cd/m2: the sky if nothing is in between, and sunlight on the first surface, both
  // weakened by the glass they come through. Counts the rays that it takes.
  struct Seen {
    Rgb sky{}, sun{};
  };
  static Seen look(const CompiledScene& scene, Vec3f origin, Vec3f direction, Vec2f u, std::uint32_t& rays);

 private:
  const Daylight& daylight_;
  Receiver at_;
  SunPatchView patches_;
  float patchShare_;
};

}  // namespace idap::render
