#include "studio/plan/painters.h"

namespace idap {

std::vector<const Painter*> painters(Plane plane, bool onPaper) {
  std::vector<const Painter*> all;
  if (plane == Plane::XY) {
    all = {&backgroundPainter(), &gridPainter(),      &levelBelowPainter(), &roomPainter(),
           &wallPainter(),       &openingPainter(),   &furniturePainter(),  &roomTextPainter(),
           &polylinePainter(),   &dimensionPainter(), &labelPainter(),      &compassPainter(),
           &cameraPainter()};
  } else {
    all = {&gridPainter(), &storeyPainter(), &elevationPainter(), &dimensionPainter(), &cameraPainter()};
  }
  if (onPaper)
    std::erase_if(all, [](const Painter* p) {
      return p == &gridPainter() || p == &cameraPainter() || p == &levelBelowPainter();
    });
  return all;
}

}  // namespace idap
