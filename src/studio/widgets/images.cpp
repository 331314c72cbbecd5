#include "studio/widgets/images.h"

#include <algorithm>
#include <cstring>

namespace idap {

QImage toQImage(const Image8& image) {
  QImage out(image.width, image.height, QImage::Format_RGB888);
  const auto row = static_cast<std::size_t>(image.width) * 3;
  for (int y = 0; y < image.height; ++y) std::memcpy(out.scanLine(y), image.pixel(0, y), row);
  return out;
}

Image8 toImage8(const QImage& picture) {
  const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
  Image8 image(rgb.width(), rgb.height());
  for (int y = 0; y < rgb.height(); ++y)
    std::copy_n(rgb.constScanLine(y), std::size_t(rgb.width()) * 3, image.pixel(0, y));
  return image;
}

}  // namespace idap
