// Pictures to files by their extension: developed for PNG, JPEG and PCX; linear with all layers for EXR.
#pragma once

#include <string>
#include <vector>

#include "render/film/develop.h"
#include "render/film/film.h"

namespace idap::cli {

enum class PictureKind { Png, Jpeg, Exr, Pcx };

// By the extension; throws UsageError for one that is not known.
PictureKind pictureKind(const std::string& file);

void savePicture(const std::string& file, PictureKind kind, const render::Film& film,
                 const std::vector<std::string>& lightGroups, const render::DevelopSettings& settings);

}  // namespace idap::cli
