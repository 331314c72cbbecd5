#include "cli/picture_output.h"

#include "cli/usage_error.h"

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
  for (const auto map :
       {render::ToneMap::PbrNeutral, render::ToneMap::AgX, render::ToneMap::Classic, render::ToneMap::Linear})
    if (render::name(map) == text) return map;
  throw UsageError("--tone " + text + ": choose neutral, agx, classic or linear");
}

void savePicture(const std::string& file, PictureKind kind, const render::Film& film,
                 const std::vector<render::LightGroup>& lightGroups,
                 const render::DevelopSettings& settings) {
  if (kind == PictureKind::Exr)
    writeFilm(file, film, lightGroups);
  else
    writePicture(file, kind, render::develop(film, settings));
}

}  // namespace idap::cli
