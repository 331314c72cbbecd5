#include "pictures/picture_kind.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "base/error.h"
#include "base/file.h"
#include "base/translatable.h"
#include "formats/pcx/pcx.h"
#include "formats/pcx/quantizer.h"
#include "pictures/gif.h"
#include "render/film/picture_file.h"

namespace idap {

namespace {

constexpr std::array<PictureKindInfo, 5> kKinds{{
    {PictureKind::Png, QT_TRANSLATE_NOOP("idap", "PNG picture"), ".png"},
    {PictureKind::Jpeg, QT_TRANSLATE_NOOP("idap", "JPEG picture"), ".jpg"},
    {PictureKind::Exr, QT_TRANSLATE_NOOP("idap", "OpenEXR picture with layers"), ".exr"},
    {PictureKind::Pcx, QT_TRANSLATE_NOOP("idap", "PCX picture of 256 colours"), ".pcx"},
    {PictureKind::Gif, QT_TRANSLATE_NOOP("idap", "GIF picture of 256 colours"), ".gif"},
}};

}  // namespace

std::span<const PictureKindInfo> pictureKinds() { return kKinds; }

std::optional<PictureKind> pictureKindOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".jpeg") extension = ".jpg";
  for (const PictureKindInfo& info : kKinds)
    if (extension == info.extension) return info.kind;
  return std::nullopt;
}

void writePicture(const std::filesystem::path& file, PictureKind kind, const Image8& image) {
  switch (kind) {
    case PictureKind::Png:
    case PictureKind::Jpeg:
      render::savePicture(file, image);
      return;
    case PictureKind::Pcx:
      writeFileAtomically(file, writePcx(image));
      return;
    case PictureKind::Gif:
      writeFileAtomically(file, writeGif(quantize(image)));
      return;
    case PictureKind::Exr:
      throw Error(file.string() + ": an EXR picture needs the light it was made of");
  }
}

void writeFilm(const std::filesystem::path& file, const render::Film& film,
               const std::vector<render::LightGroup>& lightGroups, const std::string& made) {
  render::saveLayers(file, film, lightGroups, made);
}

}  // namespace idap
