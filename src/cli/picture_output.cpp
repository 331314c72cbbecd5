#include "cli/picture_output.h"

#include <fmt/format.h>

#include "base/file.h"
#include "cli/usage_error.h"
#include "render/film/picture_file.h"

namespace idap::cli {

PictureKind pictureKind(const std::string& file) {
  if (const auto kind = pictureKindOf(file)) return *kind;
  std::string endings;
  for (const PictureKindInfo& info : pictureKinds())
    endings += (endings.empty()                   ? ""
                : &info == &pictureKinds().back() ? " or "
                                                  : ", ") +
               std::string(info.extension);
  throw UsageError("-o " + file + ": the name must end in " + endings);
}

render::ToneMap toneMap(const std::string& text) {
  std::string all;
  for (const auto map : render::kToneMaps) {
    if (render::name(map) == text) return map;
    all += fmt::format("{}{}", all.empty() ? "" : ", ", render::name(map));
  }
  throw UsageError(fmt::format("--tone {}: choose one of {}", text, all));
}

void savePicture(const std::string& file, PictureKind kind, const render::Film& film,
                 const std::vector<render::LightGroup>& lightGroups, const render::DevelopSettings& settings,
                 bool transparent) {
  if (kind == PictureKind::Exr)
    writeFilm(file, film, lightGroups);
  else if (transparent)
    writeFileAtomically(file, render::encodePng(render::developTransparent(film, settings)));
  else
    writePicture(file, kind, render::develop(film, settings));
}

}  // namespace idap::cli
