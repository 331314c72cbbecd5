// Sun and sky as lights. Sky directions are sampled where its picture is bright and, indoors, through the
// portals the maker of the scene marked.
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
  bool sampleSun(const Receiver& at, Vec2f u, LightSample& sample) const;
  bool sampleSky(const Receiver& at, float choice, Vec2f u, LightSample& sample) const;

  Rgb skyRadiance(Vec3f direction) const;
  Rgb sunRadiance(Vec3f direction) const;  // 0 off the sun's disc
  // Densities, per steradian, with which this direction is sampled (of the sun: any within its disc).
  float pdfSky(const Receiver& at, Vec3f direction) const;
  float pdfSun(const Receiver& at) const;
  bool hasSun() const { return hasSun_; }
  bool hasSky() const { return hasSky_; }
  // Whether there are windows to look out of on a sunny day.
  bool looksOut() const { return hasSun_ && !openings_.empty(); }
  // A direction for sampleSky(), without asking what the sky is there.
  bool chooseSky(const Receiver& at, float choice, Vec2f u, LightSample& sample) const;
  std::uint16_t sunGroup() const { return sunGroup_; }

 private:
  struct Opening {
    Vec3f corner, edgeU, edgeV, centre, normal;  // normal points outdoors
    float inverseU2 = 0.0f, inverseV2 = 0.0f, area = 0.0f;
    bool bothSides = false;
  };
  bool seesSun(const Receiver& at) const;
  static float importance(const Opening& opening, const Receiver& at);
  static bool crosses(const Opening& opening, Vec3f from, Vec3f direction);
  float pdfMap(Vec3f direction) const;
  float mixturePdf(const Receiver& at, Vec3f direction) const;
  // The same where the sum of importances and the solid angle of one opening are known already.
  float mixturePdf(const Receiver& at, Vec3f direction, float sum, const Opening* known,
                   float solidAngle) const;

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
