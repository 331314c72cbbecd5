// The kinds of files that pictures are written to, by the end of their names.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/image8.h"
#include "render/film/film.h"
#include "render/light_group.h"

namespace idap {

enum class PictureKind { Png, Jpeg, Exr, Pcx, Gif };

struct PictureKindInfo {
  PictureKind kind;
  const char* name;       // "PNG picture", marked for translation
  const char* extension;  // ".png"
};
std::span<const PictureKindInfo> pictureKinds();

// By the extension, in either case (".jpeg" too); none for others.
std::optional<PictureKind> pictureKindOf(const std::filesystem::path& file);

// A finished picture; PCX and GIF have 256 colours, chosen as in 1993. Throws Error: an EXR needs the film.
void writePicture(const std::filesystem::path& file, PictureKind kind, const Image8& image);
// Linear light with all its layers, as EXR.
void writeFilm(const std::filesystem::path& file, const render::Film& film,
               const std::vector<render::LightGroup>& lightGroups, const std::string& made = {});

}  // namespace idap
