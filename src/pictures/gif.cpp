#include "pictures/gif.h"

#include <gif_lib.h>

#include <memory>
#include <string>

#include "base/error.h"

namespace idap {

namespace {

constexpr int kLongest = 65535;

int append(GifFileType* file, const GifByteType* data, int size) {
  auto& bytes = *static_cast<Bytes*>(file->UserData);
  const auto* first = reinterpret_cast<const std::byte*>(data);
  bytes.insert(bytes.end(), first, first + size);
  return size;
}

[[noreturn]] void fail(int code) {
  const char* why = GifErrorString(code);
  throw Error("the picture cannot be written as GIF: " + std::string(why ? why : "unknown reason"));
}

}  // namespace

Bytes writeGif(const IndexedImage& image) {
  if (image.width < 1 || image.height < 1 || image.width > kLongest || image.height > kLongest)
    throw Error("a GIF picture has 1 to 65535 pixels a side");
  Bytes bytes;
  int code = 0;
  GifFileType* file = EGifOpen(&bytes, append, &code);
  if (!file) fail(code);
  // The map's size must be a power of two.
  int colors = 2;
  while (colors < static_cast<int>(image.palette.size())) colors *= 2;
  const std::unique_ptr<ColorMapObject, void (*)(ColorMapObject*)> map(GifMakeMapObject(colors, nullptr),
                                                                       GifFreeMapObject);
  bool fine = map != nullptr;
  for (std::size_t i = 0; fine && i < image.palette.size(); ++i)
    map->Colors[i] = {image.palette[i][0], image.palette[i][1], image.palette[i][2]};
  fine = fine && EGifPutScreenDesc(file, image.width, image.height, 8, 0, map.get()) == GIF_OK &&
         EGifPutImageDesc(file, 0, 0, image.width, image.height, false, nullptr) == GIF_OK;
  std::vector<GifPixelType> line(static_cast<std::size_t>(image.width));
  for (std::size_t y = 0; fine && y < static_cast<std::size_t>(image.height); ++y) {
    const auto row = image.pixels.begin() + static_cast<std::ptrdiff_t>(y * line.size());
    line.assign(row, row + image.width);
    fine = EGifPutLine(file, line.data(), image.width) == GIF_OK;
  }
  const int trouble = file->Error;
  if (EGifCloseFile(file, &code) != GIF_OK && fine) fail(code);
  if (!fine) fail(trouble);
  return bytes;
}

}  // namespace idap
