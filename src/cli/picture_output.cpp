#include "cli/picture_output.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/file.h"
#include "cli/usage_error.h"
#include "formats/pcx/pcx.h"
#include "formats/pcx/quantizer.h"
#include "render/film/picture_file.h"

namespace idap::cli {

namespace fs = std::filesystem;

PictureKind pictureKind(const std::string& file) {
  std::string extension = fs::path(file).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".png") return PictureKind::Png;
  if (extension == ".jpg" || extension == ".jpeg") return PictureKind::Jpeg;
  if (extension == ".exr") return PictureKind::Exr;
  if (extension == ".pcx") return PictureKind::Pcx;
  throw UsageError("-o " + file + ": the name must end in .png, .jpg, .exr or .pcx");
}

void savePicture(const std::string& file, PictureKind kind, const render::Film& film,
                 const std::vector<std::string>& lightGroups, const render::DevelopSettings& settings) {
  switch (kind) {
    case PictureKind::Exr:
      render::saveLayers(file, film, lightGroups);
      return;
    case PictureKind::Pcx:
      writeFileAtomically(file, writePcx(quantize(render::develop(film, settings))));
      return;
    case PictureKind::Png:
    case PictureKind::Jpeg:
      render::savePicture(file, render::develop(film, settings));
      return;
  }
}

}  // namespace idap::cli
