// Pictures to files by their extension: developed for a screen, or linear with all layers for EXR.
#pragma once

#include <string>
#include <vector>

#include "pictures/picture_kind.h"
#include "render/film/develop.h"

namespace idap::cli {

// By the extension; throws UsageError for one that is not known.
PictureKind pictureKind(const std::string& file);

// By its name; throws UsageError.
render::ToneMap toneMap(const std::string& text);

// transparent: of a film whose sky was hidden, as PNG with alpha.
void savePicture(const std::string& file, PictureKind kind, const render::Film& film,
                 const std::vector<render::LightGroup>& lightGroups, const render::DevelopSettings& settings,
                 bool transparent = false);

}  // namespace idap::cli
