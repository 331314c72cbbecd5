// GIF pictures of up to 256 colours (GIF87a), through giflib.
#pragma once

#include "base/bytes.h"
#include "formats/pcx/quantizer.h"

namespace idap {

// Throws Error with giflib's reason, and for sides over 65 535 pixels.
Bytes writeGif(const IndexedImage& image);

}  // namespace idap
