#include "render/film/picture_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>

#include "base/error.h"
#include "base/file.h"
#include "render/film/texture_file.h"

namespace idap::render {

namespace {

std::string lowerExtension(std::string_view extension) {
  if (!extension.empty() && extension.front() == '.') extension.remove_prefix(1);
  std::string lower(extension);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

// Writes one image of the given kind into memory.
Bytes encode(const std::string& extension, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
             const void* pixels) {
  const std::string name = "picture." + extension;
  OIIO::Filesystem::IOVecOutput memory;
  const auto output = OIIO::ImageOutput::create(name, &memory);
  if (!output) throw RenderError("pictures of the kind ." + extension + " cannot be written here");
  if (!output->supports("ioproxy"))
    throw RenderError("pictures of the kind ." + extension + " cannot be written");
  output->set_ioproxy(&memory);
  if (!output->open(name, spec) || !output->write_image(type, pixels) || !output->close()) {
    throw RenderError("the picture cannot be written as ." + extension + ": " + output->geterror());
  }
  const auto* first = reinterpret_cast<const std::byte*>(memory.buffer().data());
  return {first, first + memory.buffer().size()};
}

std::string layerName(const std::vector<std::string>& names, std::size_t group) {
  std::string name =
      group < names.size() && !names[group].empty() ? names[group] : fmt::format("group{}", group);
  // A dot divides layer from channel.
  std::ranges::replace(name, '.', '_');
  return name;
}

}  // namespace

Bytes encodePicture(const Image8& image, std::string_view extension, int quality) {
  const std::string kind = lowerExtension(extension);
  constexpr std::array kKinds{"png", "jpg", "jpeg", "bmp"};
  if (std::ranges::find(kKinds, kind) == kKinds.end()) {
    throw RenderError("pictures are written as .png, .jpg or .bmp, not as ." + kind);
  }
  if (image.width < 1 || image.height < 1) throw RenderError("a picture without pixels cannot be written");
  OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("Compression", kind == "jpg" || kind == "jpeg"
                                    ? fmt::format("jpeg:{}", std::clamp(quality, 1, 100))
                                    : std::string());
  if (kind == "png") spec.attribute("png:compressionLevel", 6);
  return encode(kind, spec, OIIO::TypeDesc::UINT8, image.rgb.data());
}

void savePicture(const std::filesystem::path& path, const Image8& image, int quality) {
  Bytes bytes;
  try {
    bytes = encodePicture(image, path.extension().string(), quality);
  } catch (const RenderError& error) {
    throw IoError(path.string() + ": " + error.what());
  }
  writeFileAtomically(path, bytes);
}

Image8 loadPicture(const std::filesystem::path& path) {
  const Bytes bytes = readFile(path, std::size_t{1} << 30);
  TexturePtr texture;
  try {
    texture = decodeTexture(bytes, true);
  } catch (const ParseError& error) {
    throw IoError(path.string() + ": " + error.what());
  }
  Image8 image(texture->width, texture->height);
  for (std::size_t i = 0; i < image.rgb.size() / 3; ++i) {
    const std::uint8_t* from = &texture->rgba[i * 4];
    for (std::size_t k = 0; k < 3; ++k) {
      image.rgb[i * 3 + k] =
          static_cast<std::uint8_t>((from[k] * from[3] + 255 * (255 - from[3]) + 127) / 255);
    }
  }
  return image;
}

void saveLayers(const std::filesystem::path& path, const Film& film,
                const std::vector<std::string>& groupNames) {
  std::vector<std::string> channels{"R",        "G",        "B",        "albedo.R", "albedo.G", "albedo.B",
                                    "normal.X", "normal.Y", "normal.Z", "depth.Z",  "objectId"};
  for (std::size_t g = 0; g < film.groups.size(); ++g) {
    std::string name = layerName(groupNames, g);
    if (std::ranges::find(channels, name + ".R") != channels.end()) name += fmt::format("_{}", g);
    for (const char* c : {".R", ".G", ".B"}) channels.push_back(name + c);
  }
  const std::size_t count = channels.size();
  OIIO::ImageSpec spec(film.width, film.height, static_cast<int>(count), OIIO::TypeDesc::HALF);
  spec.channelnames = channels;
  spec.channelformats.assign(count, OIIO::TypeDesc::HALF);
  spec.channelformats[9] = spec.channelformats[10] = OIIO::TypeDesc::FLOAT;
  spec.attribute("compression", "zip");
  spec.attribute("idap:samples", film.samples);

  std::vector<float> pixels;
  pixels.reserve(film.pixels() * count);
  constexpr float kMaxHalf = 65504;
  const auto put = [&](Vec3f v) {
    for (int k = 0; k < 3; ++k) pixels.push_back(std::clamp(v[k], -kMaxHalf, kMaxHalf));
  };
  for (std::size_t i = 0; i < film.pixels(); ++i) {
    put(film.meanColor(i));
    put(film.meanAlbedo(i));
    put(film.meanNormal(i));
    pixels.push_back(film.meanDepth(i));
    pixels.push_back(static_cast<float>(film.objectId[i]));
    for (std::size_t g = 0; g < film.groups.size(); ++g) put(film.meanGroup(g, i));
  }
  Bytes bytes;
  try {
    bytes = encode("exr", spec, OIIO::TypeDesc::FLOAT, pixels.data());
  } catch (const RenderError& error) {
    throw IoError(path.string() + ": " + error.what());
  }
  writeFileAtomically(path, bytes);
}

}  // namespace idap::render
