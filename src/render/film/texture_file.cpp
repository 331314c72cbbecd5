#include "render/film/texture_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <exception>

#include "base/error.h"

namespace idap::render {

namespace {

[[noreturn]] void fail(const std::string& reason) { throw ParseError("picture", "", reason); }

// Targa has no signature: the header must at least make sense.
bool looksLikeTarga(std::string_view text) {
  if (text.size() < 18) return false;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const int type = byte(2), depth = byte(16);
  const bool knownType = type == 1 || type == 2 || type == 3 || type == 9 || type == 10 || type == 11;
  const bool mapped = type == 1 || type == 9;
  const int width = byte(12) | byte(13) << 8, height = byte(14) | byte(15) << 8;
  return knownType && byte(1) == (mapped ? 1 : 0) && width > 0 && height > 0 &&
         (depth == 8 || depth == 15 || depth == 16 || depth == 24 || depth == 32);
}

// The kind by the first bytes; the name a file had says little.
const char* kindOf(const Bytes& bytes) {
  const std::string_view text = asText(bytes);
  using namespace std::string_view_literals;
  if (text.starts_with("\x89PNG\r\n\x1a\n")) return "png";
  if (text.starts_with("\xff\xd8\xff")) return "jpg";
  if (text.starts_with("GIF87a") || text.starts_with("GIF89a")) return "gif";
  if (text.starts_with("BM")) return "bmp";
  if (text.starts_with("II*\0"sv) || text.starts_with("MM\0*"sv)) return "tif";
  if (text.size() > 12 && text.starts_with("RIFF") && text.substr(8, 4) == "WEBP") return "webp";
  if (text.starts_with("#?RADIANCE") || text.starts_with("#?RGBE")) return "hdr";
  if (text.starts_with("P6") && text.size() > 2 && std::isspace(static_cast<unsigned char>(text[2])))
    return "ppm";
  if (text.starts_with("\x76\x2f\x31\x01")) return "exr";
  if (looksLikeTarga(text)) return "tga";
  return nullptr;
}

struct Decoded {
  int width = 0, height = 0, channels = 0;
  std::vector<std::uint8_t> samples;
};

// The chunks of a PNG that make its pixels, each whole by its checksum; profiles, texts and times are left
// out. The library behind OpenImageIO complains of odd and damaged ones on standard error, where it has no
// business.
Bytes plainPng(const Bytes& bytes) {
  constexpr std::size_t kSignature = 8, kFrame = 12;  // length, name, checksum
  const auto word = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
    return value;
  };
  Bytes plain(bytes.begin(), bytes.begin() + kSignature);
  for (std::size_t at = kSignature; bytes.size() - at >= kFrame;) {
    const std::size_t size = word(at);
    if (bytes.size() - at - kFrame < size) break;
    const std::string_view name = asText(bytes).substr(at + 4, 4);
    const bool pixels =
        name == "IHDR" || name == "PLTE" || name == "tRNS" || name == "IDAT" || name == "IEND";
    if (pixels) {
      const auto* checked = reinterpret_cast<const Bytef*>(&bytes[at + 4]);
      if (crc32_z(0, checked, size + 4) != word(at + 8 + size)) fail("is damaged");
      const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at);
      plain.insert(plain.end(), begin, begin + static_cast<std::ptrdiff_t>(size + kFrame));
    }
    if (name == "IEND") return plain;
    at += size + kFrame;
  }
  fail("is damaged: its end is missing");
}

Decoded decode(const Bytes& original, const char* kind) {
  const bool png = std::string_view(kind) == "png";
  const Bytes rewritten = png ? plainPng(original) : Bytes();
  const Bytes& bytes = png ? rewritten : original;
  OIIO::Filesystem::IOMemReader memory(const_cast<std::byte*>(bytes.data()), bytes.size());
  OIIO::ImageSpec wish;
  wish.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::create(kind, false, nullptr, &memory);
  if (!input || !input->supports("ioproxy"))
    fail(std::string("is of a kind that cannot be read here: ") + kind);
  input->set_ioproxy(&memory);
  OIIO::ImageSpec spec;
  if (!input->open(std::string("picture.") + kind, spec, wish)) fail("cannot be read: " + input->geterror());
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) fail("has no pixels");
  if (spec.width > kMaxPictureSide || spec.height > kMaxPictureSide) {
    fail(fmt::format("is too large: {} x {} pixels (the limit is {} a side)", spec.width, spec.height,
                     kMaxPictureSide));
  }
  // No real picture packs more than this; a few bytes that promise gigabytes are an attack.
  constexpr std::size_t kMaxPixelsPerByte = 5'000;
  const std::size_t pixels = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
  if (pixels / kMaxPixelsPerByte > bytes.size()) fail("promises more pixels than it can hold");

  Decoded d{spec.width, spec.height, std::min(spec.nchannels, 4), {}};
  d.samples.resize(pixels * static_cast<std::size_t>(d.channels));
  const bool floating = spec.format.is_floating_point();
  if (!floating) {
    if (!input->read_image(0, 0, 0, d.channels, OIIO::TypeDesc::UINT8, d.samples.data())) {
      fail("is damaged: " + input->geterror());
    }
    return d;
  }
  // Linear light: clipped at white and encoded like the rest.
  std::vector<float> linear(d.samples.size());
  if (!input->read_image(0, 0, 0, d.channels, OIIO::TypeDesc::FLOAT, linear.data())) {
    fail("is damaged: " + input->geterror());
  }
  for (std::size_t i = 0; i < linear.size(); ++i) {
    const bool alpha = d.channels % 2 == 0 &&
                       i % static_cast<std::size_t>(d.channels) + 1 == static_cast<std::size_t>(d.channels);
    const float v = linear[i] > 0 ? std::min(linear[i], 1.0f) : 0.0f;
    d.samples[i] = static_cast<std::uint8_t>(std::lround(255.0f * (alpha ? v : linearToSrgb(v))));
  }
  return d;
}

// Binary portable pixmaps of 8 bits, which OpenImageIO reads from files only: "P6", width, height, 255,
// samples.
Decoded decodePixmap(const Bytes& bytes) {
  const std::string_view text = asText(bytes);
  std::size_t at = 2;
  const auto number = [&] {
    while (at < text.size() && (std::isspace(static_cast<unsigned char>(text[at])) || text[at] == '#')) {
      if (text[at] == '#') at = std::min(text.find('\n', at), text.size() - 1);
      ++at;
    }
    int value = 0;
    const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), value);
    if (error != std::errc()) fail("is damaged: its header holds no number");
    at = static_cast<std::size_t>(end - text.data());
    return value;
  };
  const int width = number(), height = number(), white = number();
  if (width < 1 || height < 1 || width > kMaxPictureSide || height > kMaxPictureSide)
    fail("has a wrong size");
  if (white != 255) fail("is a pixmap of another depth than 8 bits");
  const std::size_t size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3;
  ++at;  // the one white space after the header
  if (at > text.size() || text.size() - at < size) fail("is damaged: pixels are missing");
  const auto* samples = reinterpret_cast<const std::uint8_t*>(text.data() + at);
  return {width, height, 3, {samples, samples + size}};
}

// One to four channels as RGBA.
Texture spread(const Decoded& d, bool srgb) {
  Texture t;
  t.width = d.width;
  t.height = d.height;
  t.srgb = srgb;
  const std::size_t pixels = static_cast<std::size_t>(d.width) * static_cast<std::size_t>(d.height);
  t.rgba.resize(pixels * 4);
  const auto channels = static_cast<std::size_t>(d.channels);
  const bool grey = channels < 3;
  const bool alpha = channels % 2 == 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::uint8_t* from = &d.samples[i * channels];
    std::uint8_t* to = &t.rgba[i * 4];
    for (std::size_t k = 0; k < 3; ++k) to[k] = from[grey ? 0 : k];
    to[3] = alpha ? from[channels - 1] : 255;
    if (to[3] != 255) t.hasAlpha = true;
  }
  return t;
}

// Halves, thirds, ... both sides until they fit, averaging light and not its encoding; what is transparent
// has no say in the colour.
Texture shrunk(const Texture& t) {
  const int factor = (std::max(t.width, t.height) + kMaxTextureSide - 1) / kMaxTextureSide;
  std::array<float, 256> toLinear{};
  for (std::size_t i = 0; i < toLinear.size(); ++i) {
    const float v = static_cast<float>(i) / 255.0f;
    toLinear[i] = t.srgb ? srgbToLinear(v) : v;
  }
  Texture small;
  small.srgb = t.srgb;
  small.hasAlpha = t.hasAlpha;
  small.width = std::max(t.width / factor, 1);
  small.height = std::max(t.height / factor, 1);
  small.rgba.resize(static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height) * 4);
  const int nx = std::min(factor, t.width), ny = std::min(factor, t.height);
  std::size_t out = 0;
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      float sum[3] = {0, 0, 0}, alpha = 0;
      for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
          const std::size_t at =
              (static_cast<std::size_t>(y * factor + j) * static_cast<std::size_t>(t.width) +
               static_cast<std::size_t>(x * factor + i)) *
              4;
          const float a = static_cast<float>(t.rgba[at + 3]);
          alpha += a;
          for (std::size_t k = 0; k < 3; ++k) sum[k] += a * toLinear[t.rgba[at + k]];
        }
      }
      for (float s : sum) {
        const float v = alpha > 0 ? s / alpha : 0.0f;
        small.rgba[out++] = static_cast<std::uint8_t>(std::lround(255.0f * (t.srgb ? linearToSrgb(v) : v)));
      }
      small.rgba[out++] = static_cast<std::uint8_t>(std::lround(alpha / static_cast<float>(nx * ny)));
    }
  }
  return small;
}

}  // namespace

TexturePtr decodeTexture(const Bytes& bytes, bool srgb) {
  const char* kind = kindOf(bytes);
  if (!kind) fail("is not a picture of a known kind");
  try {
    const Decoded decoded = std::string_view(kind) == "ppm" ? decodePixmap(bytes) : decode(bytes, kind);
    Texture texture = spread(decoded, srgb);
    if (std::max(texture.width, texture.height) > kMaxTextureSide) texture = shrunk(texture);
    return std::make_shared<const Texture>(std::move(texture));
  } catch (const ParseError&) {
    throw;
  } catch (const std::exception& error) {
    fail(std::string("cannot be read: ") + error.what());
  }
}

}  // namespace idap::render
