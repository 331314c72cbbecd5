// Small traced pictures of single pieces, to choose furniture by: in a neutral studio with soft light, from
// the front right and a little above; what hangs on a wall or sits in one is seen with a piece of that wall;
// lamps are lit. The ground is a light grey that suits dark and light windows.
#pragma once

#include "base/image8.h"
#include "base/progress.h"
#include "catalog/catalog.h"
#include "model/home.h"

namespace idap {

namespace render {
class Denoiser;
}

// side x side pixels. Works on the calling thread alone, so that many pictures in a row leave the other
// processors free. Who makes many passes a denoiser to keep between them. Throws Cancelled; ParseError where
// the piece's model is damaged.
Image8 renderThumbnail(const Catalog& catalog, const CatalogPiece& piece, int side,
                       const Progress& progress = {}, render::Denoiser* denoiser = nullptr);

// The same of a piece that is not in the catalog: its model among the assets.
Image8 renderThumbnail(const Catalog& catalog, const Furniture& piece, std::shared_ptr<const Assets> assets,
                       int side, const Progress& progress = {});

}  // namespace idap
