// Pictures from files into textures.
#pragma once

#include "base/bytes.h"
#include "render/scene.h"

namespace idap::render {

inline constexpr int kMaxPictureSide = 16'384;  // larger pictures are refused
inline constexpr int kMaxTextureSide = 4'096;   // larger ones are shrunk to this

// Decodes a picture held in memory: PNG, JPEG, GIF (its first frame), BMP, TIFF, WebP, Targa, Radiance or
// OpenEXR; grey or colour, with or without alpha, of any bit depth. srgb: the colours are sRGB-encoded (false
// for normal maps). Throws ParseError on anything else. Safe to call from several threads.
TexturePtr decodeTexture(const Bytes& bytes, bool srgb);

}  // namespace idap::render
