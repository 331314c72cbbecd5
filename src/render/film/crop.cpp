#include "render/film/crop.h"

namespace idap::render {

Film cropped(const Film& film, const PixelRegion& r) {
  Film out;
  const auto part = [&](const auto& layer) { return cropped(layer, film.width, r); };
  out.width = r.width, out.height = r.height, out.samples = film.samples;
  out.color = part(film.color), out.albedo = part(film.albedo), out.normal = part(film.normal);
  out.depth = part(film.depth), out.square = part(film.square), out.coverage = part(film.coverage);
  out.weight = part(film.weight), out.objectId = part(film.objectId);
  return out;
}

Features cropped(const Features& f, const PixelRegion& r) {
  const auto part = [&](const auto& layer) { return cropped(layer, f.width, r); };
  return {r.width,       r.height,         part(f.albedo),   part(f.normal),
          part(f.depth), part(f.distance), part(f.objectId), part(f.slot)};
}

}  // namespace idap::render
