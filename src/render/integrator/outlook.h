// Where daylight comes into rooms: the sky through the windows, and what the sun shines on, the patches of
// sun on floors and walls as well as the ground before the house. A path looks there from every point that
// scatters widely, beside following one ray on: small bright things are then found by design and not by luck.
#pragma once

#include "render/accel/compiled_scene.h"
#include "render/emitter/lights.h"

namespace idap::render {

// F: float, or Floats for one point a lane.
template <class F>
class OutlookT {
 public:
  OutlookT(const CompiledScene& scene, const ReceiverT<F>& at);

  // A direction worth looking in; false where there is none.
  Mask<F> sample(F choice, const Vec2T<F>& u, Vec3T<F>& direction, F& pdf) const;
  F pdf(const Vec3T<F>& direction) const;  // 1/sr

 private:
  const Daylight& daylight_;
  ReceiverT<F> at_;
  SunPatchViewT<F> patches_;
  F patchShare_;
};
using Outlook = OutlookT<float>;

extern template class OutlookT<float>;
extern template class OutlookT<Floats>;

// What looks find, cd/m2: the sky if nothing is in between, and on the first surface sunlight and, inside
// lamps, one lamp's light, all weakened by the glass they come through.
struct Seen {
  LaneVec sky, sun, lamp;
  Ints lampGroup = 0;
};
// Random numbers for what looks find.
struct LookDraws {
  LaneVec2 sun, lamp;
  Floats lampChoice;
};
// From those lanes that the mask has. Adds the rays that it takes.
Seen look(const CompiledScene& scene, LaneMask active, const LaneVec& origin, const LaneVec& direction,
          const LookDraws& draws, std::uint64_t& rays);

}  // namespace idap::render
