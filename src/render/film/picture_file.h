// Finished pictures to and from files. Files appear whole or not at all. Throws IoError with the path and the
// reason where a file cannot be written or read.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "base/image8.h"
#include "render/film/film.h"
#include "render/light_group.h"
#include "render/scene.h"

namespace idap::render {

// Kinds by file name extension: .png, .jpg/.jpeg, .bmp; any other is refused by name.
// quality: of a JPEG, 1..100.
void savePicture(const std::filesystem::path& path, const Image8& image, int quality = 92);

// The same into memory; extension with or without its dot. Throws RenderError.
Bytes encodePicture(const Image8& image, std::string_view extension, int quality = 92);

// As PNG, with its alpha where it has some. Throws RenderError.
Bytes encodePng(const Texture& picture);

// A picture of any common kind as 8-bit sRGB; transparency is laid over white.
Image8 loadPicture(const std::filesystem::path& path);

// The film as a half-float OpenEXR file in cd/m2: R, G, B; albedo.R.., normal.X.., depth.Z and objectId in
// full floats, each pixel's samples, coverage and standard error (of the luminance), and one layer a light
// group (missing names become "group0", ...). made: words for what the film shows, for whoever goes on with
// it.
void saveLayers(const std::filesystem::path& path, const Film& film,
                const std::vector<LightGroup>& groups = {}, const std::string& made = {});

// What saveLayers() wrote, with the names that the layers have in the file. Other OpenEXR files come as one
// sample a pixel without light groups; without their colours R, G and B they are refused.
struct Layers {
  Film film;
  std::vector<LightGroup> groups;
  std::string made;
};
Layers loadLayers(const std::filesystem::path& path);

}  // namespace idap::render
