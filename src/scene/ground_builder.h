// The land around a home: level, open where rooms lie below it, with the mottle of things that grow, and
// fading into the haze towards the horizon. World space, metres.
#pragma once

#include <memory>
#include <vector>

#include "geometry/polygon.h"
#include "render/scene.h"
#include "scene/mesh_sink.h"

namespace idap {

struct Ground {
  std::shared_ptr<const Mesh> mesh;       // null: nothing to see
  std::vector<render::Surface> surfaces;  // by slot
};

// soil: the land close by. open: what is left out. around: the plan of the home. horizon: reflectance that
// looks as bright as the sky over the horizon does.
Ground buildGround(render::Surface soil, const Regions& open, const Box2& around, double height,
                   const Rgb& horizon, Vec3 centre);

// Of a picture, from some of its texels; linear.
Rgb meanReflectance(const render::Texture& picture);

// Irregular light and dark patches for land of one colour.
render::TexturePtr mottle();

}  // namespace idap
