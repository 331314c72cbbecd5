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

void savePicture(const std::string& file, PictureKind kind, const render::Film& film,
                 const std::vector<std::string>& lightGroups, const render::DevelopSettings& settings) {
  if (kind == PictureKind::Exr)
    writeFilm(file, film, lightGroups);
  else
    writePicture(file, kind, render::develop(film, settings));
}

}  // namespace idap::cli
