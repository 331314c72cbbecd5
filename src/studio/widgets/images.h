// Between the renderer's pictures and Qt's.
#pragma once

#include <QImage>

#include "base/image8.h"

namespace idap {

QImage toQImage(const Image8& image);
Image8 toImage8(const QImage& picture);  // transparency is dropped

}  // namespace idap
