// Sun and sky as lights. Sky directions are sampled where its picture is bright and, indoors, through the
// portals the maker of the scene marked. F: float, or Floats for one receiver a lane.
#pragma once

#include <vector>

#include "render/emitter/light_sample.h"
#include "render/sampling/distribution.h"
#include "render/scene.h"

namespace idap::render {

class CompiledScene;

class Daylight {
 public:
  explicit Daylight(const CompiledScene& scene);

  // One direction of the sun, or of the sky. False where it cannot reach the receiver.
  template <class F>
  Mask<F> sampleSun(const ReceiverT<F>& at, const Vec2T<F>& u, LightSampleT<F>& sample) const;
  template <class F>
  Mask<F> sampleSky(const ReceiverT<F>& at, std::type_identity_t<F> choice, const Vec2T<F>& u,
                    LightSampleT<F>& sample) const;

  template <class F>
  Vec3T<F> skyRadiance(const Vec3T<F>& direction) const;
  template <class F>
  Vec3T<F> sunRadiance(const Vec3T<F>& direction) const;  // 0 off the sun's disc
  // Densities, per steradian, with which this direction is sampled (of the sun: any within its disc).
  template <class F>
  F pdfSky(const ReceiverT<F>& at, const Vec3T<F>& direction) const;
  template <class F>
  F pdfSun(const ReceiverT<F>& at) const;
  bool hasSun() const { return hasSun_; }
  bool hasSky() const { return hasSky_; }
  // Whether there are windows to look out of on a sunny day.
  bool looksOut() const { return hasSun_ && !openings_.empty(); }
  // A direction for sampleSky(), and of any direction the density with which it is chosen there.
  template <class F>
  struct SkyChoice {
    Mask<F> found{false};
    Vec3T<F> wi;
    F importance = 0.0f;  // of all openings together
    Int<F> opening = -1;  // that it goes through
  };
  template <class F>
  SkyChoice<F> chooseSky(const ReceiverT<F>& at, std::type_identity_t<F> choice, const Vec2T<F>& u) const;
  // chosen: lanes whose direction it is.
  template <class F>
  F pdfSky(const ReceiverT<F>& at, const Vec3T<F>& direction, const SkyChoice<F>& choice,
           Mask<F> chosen) const {
    return mixturePdf<F>(at, direction, choice.importance, select(chosen, choice.opening, Int<F>(-1)));
  }
  std::uint16_t sunGroup() const { return sunGroup_; }

 private:
  struct Opening {
    Vec3f corner, edgeU, edgeV, centre, normal;  // normal points outdoors
    float inverseU2 = 0.0f, inverseV2 = 0.0f, area = 0.0f, inverseArea = 0.0f;
    bool bothSides = false;
  };
  template <class F>
  Mask<F> seesSun(const ReceiverT<F>& at) const;
  template <class F>
  static F importance(const Opening& opening, const ReceiverT<F>& at);
  template <class F>
  static Mask<F> crosses(const Opening& opening, const Vec3T<F>& from, const Vec3T<F>& direction);
  template <class F>
  F pdfMap(const Vec3T<F>& direction) const;
  // sum: of the importances; through: openings that the direction is known to cross, -1: none.
  template <class F>
  F mixturePdf(const ReceiverT<F>& at, const Vec3T<F>& direction, F sum, Int<F> through) const;

  Sun sun_;
  Rgb sunRadiance_{};
  float sunCone_ = 0.0f;  // 1 - cos of its radius
  bool hasSun_ = false, hasSky_ = false;
  std::uint16_t sunGroup_ = 0;
  const Sky& sky_;
  Distribution2D map_;
  std::vector<Opening> openings_;
};

}  // namespace idap::render
