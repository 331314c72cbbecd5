#include "render/film/picture_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <locale>
#include <sstream>

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

std::string layerName(const std::vector<LightGroup>& groups, std::size_t group) {
  std::string name = group < groups.size() && !groups[group].name.empty() ? groups[group].name
                                                                          : fmt::format("group{}", group);
  // A dot divides layer from channel, a line one name from the next.
  std::ranges::replace(name, '.', '_');
  for (char& c : name)
    if (std::iscntrl(static_cast<unsigned char>(c))) c = ' ';
  return name;
}

constexpr const char* kMade = "idap:made";
constexpr const char* kLightLayers = "idap:lightLayers";  // their names, a line each
constexpr const char* kLightColors = "idap:lightColors";  // linear RGB of each, luminance 1; 0: not known

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

Bytes encodePng(const Texture& picture) {
  const std::size_t pixels = static_cast<std::size_t>(std::max(picture.width, 0)) *
                             static_cast<std::size_t>(std::max(picture.height, 0));
  if (pixels == 0 || picture.rgba.size() < 4 * pixels)
    throw RenderError("a picture without pixels cannot be written");
  OIIO::ImageSpec spec(picture.width, picture.height, picture.hasAlpha ? 4 : 3, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", picture.srgb ? "sRGB" : "linear");
  spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("png:compressionLevel", 6);
  if (picture.hasAlpha) return encode("png", spec, OIIO::TypeDesc::UINT8, picture.rgba.data());
  std::vector<std::uint8_t> rgb(3 * pixels);
  for (std::size_t i = 0; i < pixels; ++i) std::copy_n(&picture.rgba[4 * i], 3, &rgb[3 * i]);
  return encode("png", spec, OIIO::TypeDesc::UINT8, rgb.data());
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

void saveLayers(const std::filesystem::path& path, const Film& film, const std::vector<LightGroup>& groups,
                const std::string& made) {
  std::vector<std::string> channels{"R",        "G",        "B",        "albedo.R", "albedo.G",
                                    "albedo.B", "normal.X", "normal.Y", "normal.Z", "depth.Z",
                                    "objectId", "samples",  "error",    "coverage"};
  std::string names;
  std::vector<float> colors;
  for (std::size_t g = 0; g < film.groups.size(); ++g) {
    std::string name = layerName(groups, g);
    if (std::ranges::find(channels, name + ".R") != channels.end()) name += fmt::format("_{}", g);
    for (const char* c : {".R", ".G", ".B"}) channels.push_back(name + c);
    names += name + '\n';
    const Rgb color = g < groups.size() ? groups[g].color : Rgb{};
    for (int k = 0; k < 3; ++k) colors.push_back(color[k]);
  }
  const std::size_t count = channels.size();
  OIIO::ImageSpec spec(film.width, film.height, static_cast<int>(count), OIIO::TypeDesc::HALF);
  spec.channelnames = channels;
  spec.channelformats.assign(count, OIIO::TypeDesc::HALF);
  for (const std::size_t exact : {9, 10, 11, 12}) spec.channelformats[exact] = OIIO::TypeDesc::FLOAT;
  spec.attribute("compression", "zip");
  spec.attribute("idap:samples", film.samples);
  if (!made.empty()) spec.attribute(kMade, made);
  if (!names.empty()) {
    spec.attribute(kLightLayers, names);
    std::string text;
    for (const float c : colors) text += fmt::format("{} ", c);
    spec.attribute(kLightColors, text);
  }

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
    pixels.push_back(film.weight[i]);
    const float error = film.standardError(i);
    pixels.push_back(std::isfinite(error) ? error : 0.0f);
    pixels.push_back(film.meanCoverage(i));
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

Layers loadLayers(const std::filesystem::path& path) {
  const auto fail = [&path](const std::string& why) -> IoError {
    return IoError(path.string() + ": " + why);
  };
  const auto input = OIIO::ImageInput::open(path.string());
  if (!input) throw fail("cannot be read as a picture: " + OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  if (std::string_view(input->format_name()) != "openexr") throw fail("is no OpenEXR picture");
  const auto channel = [&spec](const std::string& name) { return spec.channelindex(name); };
  if (channel("R") < 0 || channel("G") < 0 || channel("B") < 0) throw fail("has no colours R, G and B");

  Layers layers;
  std::vector<int> first;  // channels R of the groups
  std::istringstream names(std::string(spec.get_string_attribute(kLightLayers)));
  std::istringstream colors(std::string(spec.get_string_attribute(kLightColors)));
  colors.imbue(std::locale::classic());
  for (std::string name; std::getline(names, name);) {
    const int at = channel(name + ".R");
    if (at < 0 || channel(name + ".G") != at + 1 || channel(name + ".B") != at + 2)
      throw fail("lacks a part of the light \"" + name + "\"");
    LightGroup group{name};
    colors >> group.color.x >> group.color.y >> group.color.z;
    for (int k = 0; k < 3; ++k)
      if (!(group.color[k] >= 0 && group.color[k] < 100)) group.color = {};
    first.push_back(at);
    layers.groups.push_back(std::move(group));
  }
  try {
    layers.film = Film(spec.width, spec.height, static_cast<int>(first.size()));
  } catch (const RenderError& error) {
    throw fail(error.what());
  }
  Film& film = layers.film;
  film.samples = std::clamp(spec.get_int_attribute("idap:samples"), 1, 1 << 24);
  layers.made = std::string(spec.get_string_attribute(kMade));
  const auto count = static_cast<std::size_t>(spec.nchannels);
  std::vector<float> row(static_cast<std::size_t>(spec.width) * count);
  const auto read = [&](std::size_t x, int from) {
    const float* at = &row[x * count + static_cast<std::size_t>(from)];
    Vec3f v{at[0], at[1], at[2]};
    for (int k = 0; k < 3; ++k)
      if (!std::isfinite(v[k])) v[k] = 0;
    return v;
  };
  const int albedo = channel("albedo.R"), normal = channel("normal.X"), depth = channel("depth.Z"),
            object = channel("objectId"), color = channel("R"), samples = channel("samples"),
            error = channel("error"), coverage = channel("coverage");
  for (int y = 0; y < spec.height; ++y) {
    if (!input->read_scanline(y + spec.y, 0, OIIO::TypeDesc::FLOAT, row.data()))
      throw fail("is damaged: " + input->geterror());
    for (std::size_t x = 0; x < static_cast<std::size_t>(spec.width); ++x) {
      const std::size_t i = film.index(static_cast<int>(x), y);
      const float* values = &row[x * count];
      const float n = samples >= 0 && values[samples] >= 0 && values[samples] <= 1e7f
                          ? std::round(values[samples])
                          : 1.0f;
      film.weight[i] = n;
      film.color[i] = read(x, color) * n;
      const float mean = luminance(read(x, color));
      if (error >= 0 && n >= 2 && std::isfinite(values[error]))
        film.square[i] = n * mean * mean + values[error] * values[error] * n * (n - 1);
      film.coverage[i] =
          coverage >= 0 && std::isfinite(values[coverage]) ? std::clamp(values[coverage], 0.0f, 1.0f) * n : n;
      if (albedo >= 0) film.albedo[i] = read(x, albedo) * n;
      if (normal >= 0) film.normal[i] = read(x, normal) * n;
      if (depth >= 0 && std::isfinite(values[depth])) film.depth[i] = values[depth] * n;
      if (object >= 0 && values[object] > 0 && values[object] < 4e9f)
        film.objectId[i] = static_cast<std::uint32_t>(values[object]);
      for (std::size_t g = 0; g < first.size(); ++g) film.groups[g][i] = read(x, first[g]) * n;
    }
  }
  return layers;
}

}  // namespace idap::render
