// The picture of 1993: Whitted's recursive ray tracing with the surface of scene.h's ClassicSurface. One ray
// gives one colour, nothing is random. Colours are linear, each channel from 0 to 1; docs/classic.md tells
// the whole model.
#pragma once

#include <vector>

#include "render/accel/compiled_scene.h"
#include "render/accel/ray.h"

namespace idap::render {

inline constexpr float kClassicEpsilon = 1e-3f;  // m; nearer hits are the surface the ray came from
inline constexpr int kClassicDepth = 5;          // reflections and transmissions after the first hit

// The viewpoint: the eye, the way to the middle of the view plane (its length sets the field of view), and
// the full width and height of the view plane. Negating one of the latter mirrors the picture.
struct ClassicCamera {
  Vec3f location;
  Vec3f direction{0, 1, 0};
  Vec3f right{1.3333f, 0, 0};
  Vec3f up{0, 0, 1};
};

// The ray of pixel (px, py), counted from the top left, of a picture of W x H. Fractions of pixels are
// allowed.
Ray classicRay(float px, float py, int width, int height, const ClassicCamera& camera);

// The viewpoint that sees what a perspective camera sees; aspect: width / height of the picture.
ClassicCamera classicCamera(const Camera& camera, float aspect);

// A point light, or one infinitely far away, with a colour of 0..1.
struct ClassicLight {
  Vec3f position;  // or, when far, the unit direction towards it
  Rgb color{1, 1, 1};
  float radius = 0;  // shadow rays stop this far before the position, m
  bool far = false;
};

// Lamps and sun as colours: docs/classic.md says how. Empty where nothing shines.
std::vector<ClassicLight> classicLights(const Scene& scene);

// Terms of the shading of one light, without its shadow. All vectors unit; n faces the eye; ray: from the
// eye.
Rgb classicShade(const ClassicSurface& surface, Rgb own, Rgb light, Vec3f n, Vec3f toLight, Vec3f ray);

// The way on behind a surface: n12 is the ratio of the indices (before / behind), n faces the ray. False
// where the light is totally reflected.
bool classicRefract(Vec3f ray, Vec3f n, float n12, Vec3f& out);

class ClassicTracer {
 public:
  // The scene must outlive the tracer. Where it has no light, the eye carries a white lamp.
  explicit ClassicTracer(const CompiledScene& scene);
  ClassicTracer(const CompiledScene& scene, std::vector<ClassicLight> lights);
  Rgb trace(const Ray& ray) const;

 private:
  Rgb follow(Ray ray, int depth, Vec3f eye) const;
  bool lit(const ClassicLight& light, Vec3f point, Vec3f normal, Vec3f& toLight) const;

  const CompiledScene& scene_;
  std::vector<ClassicLight> lights_;
};

// For a single ray; who traces many keeps a ClassicTracer.
Rgb classicRadiance(const CompiledScene& scene, const Ray& ray);

}  // namespace idap::render
