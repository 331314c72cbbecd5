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

namespace idap::render {

// Kinds by file name extension: .png, .jpg/.jpeg, .bmp; any other is refused by name.
// quality: of a JPEG, 1..100.
void savePicture(const std::filesystem::path& path, const Image8& image, int quality = 92);

// The same into memory; extension with or without its dot. Throws RenderError.
Bytes encodePicture(const Image8& image, std::string_view extension, int quality = 92);

// A picture of any common kind as 8-bit sRGB; transparency is laid over white.
Image8 loadPicture(const std::filesystem::path& path);

// The film as a half-float OpenEXR file in cd/m2: R, G, B; albedo.R.., normal.X.., depth.Z and objectId in
// full floats, and one layer a light group, named by groupNames (missing names become "group0", ...).
void saveLayers(const std::filesystem::path& path, const Film& film,
                const std::vector<std::string>& groupNames = {});

}  // namespace idap::render
