#include "catalog/library/own_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/error.h"
#include "base/file.h"
#include "base/utf8.h"
#include "base/zip.h"
#include "catalog/library/properties.h"

namespace idap {

namespace {

constexpr const char* kTable = "PluginFurnitureCatalog.properties";
constexpr const char* kThai = "PluginFurnitureCatalog_th.properties";

using Fields = std::map<std::string, std::string>;

std::map<std::uint32_t, Fields> readTable(const ZipReader& archive, const char* entry) {
  std::map<std::uint32_t, Fields> table;
  if (!archive.contains(entry)) return table;
  const Bytes bytes = archive.read(entry);
  readProperties(asText(bytes), [&](std::string_view key, std::string_view value) {
    const std::size_t mark = key.rfind('#');
    std::uint32_t number = 0;
    if (mark != std::string_view::npos &&
        std::from_chars(key.data() + mark + 1, key.data() + key.size(), number).ec == std::errc())
      table[number][std::string(key.substr(0, mark))] = value;
  });
  return table;
}

// ISO-8859-1 with \u escapes, as Java reads it.
std::string escaped(const std::string& text) {
  std::string out;
  const auto unit = [&](std::uint32_t u) { out += fmt::format("\\u{:04X}", u); };
  std::size_t i = 0;
  while (i < text.size()) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c < 0x80) {
      if (c == '\n') {
        out += "\\n";
      } else if (c == '\\' || c == '#' || c == '!' || c == '=' || c == ':' || (c == ' ' && i == 0)) {
        out += '\\';
        out += static_cast<char>(c);
      } else if (c >= 0x20) {
        out += static_cast<char>(c);
      }
      ++i;
      continue;
    }
    const int length = c >= 0xF0 ? 4 : c >= 0xE0 ? 3 : 2;
    std::uint32_t code = c & (0xFFu >> (length + 1));
    for (int k = 1; k < length && i + std::size_t(k) < text.size(); ++k)
      code = code << 6 | (static_cast<unsigned char>(text[i + std::size_t(k)]) & 0x3Fu);
    i += std::size_t(length);
    if (code >= 0x10000) {
      unit(0xD800 + ((code - 0x10000) >> 10));
      unit(0xDC00 + ((code - 0x10000) & 0x3FF));
    } else {
      unit(code);
    }
  }
  return out;
}

std::string centimetres(double metres) { return fmt::format("{:.6g}", metres * 100); }

std::optional<double> number(const Fields& fields, const char* key) {
  const auto at = fields.find(key);
  if (at == fields.end()) return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(at->second.data(), at->second.data() + at->second.size(), value);
  return error == std::errc() && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string text(const Fields& fields, const char* key) {
  const auto at = fields.find(key);
  return at == fields.end() ? std::string() : at->second;
}

std::vector<double> numbers(const std::string& text) {
  std::vector<double> values;
  const char* at = text.data();
  const char* end = at + text.size();
  while (at < end) {
    double value = 0;
    const auto [stop, error] = std::from_chars(at, end, value);
    if (error == std::errc()) values.push_back(value);
    at = error == std::errc() ? stop : at + 1;
    while (at < end && *at == ' ') ++at;
  }
  return values;
}

// The first of a list of "#RRGGBB".
std::optional<Color> colorOf(const std::string& text) {
  std::uint32_t rgb = 0;
  if (text.size() < 7 || text[0] != '#') return std::nullopt;
  const char* end = text.data() + 7;
  if (std::from_chars(text.data() + 1, end, rgb, 16).ptr != end) return std::nullopt;
  const auto part = [rgb](int shift) { return static_cast<float>(rgb >> shift & 0xFF) / 255; };
  return Color{part(16), part(8), part(0)};
}

std::string textOf(Color c) {
  const auto part = [](float v) { return static_cast<int>(std::lround(std::clamp(v, 0.f, 1.f) * 255)); };
  return fmt::format("#{:02X}{:02X}{:02X}", part(c.r), part(c.g), part(c.b));
}

OwnPiece pieceOf(const Fields& f, const Fields& thai) {
  OwnPiece p;
  p.id = text(f, "id");
  p.name = text(f, "name");
  p.category = text(f, "category");
  p.nameThai = text(thai, "name");
  p.categoryThai = text(thai, "category");
  p.creator = text(f, "creator");
  const std::string tags = text(f, "tags");
  for (std::size_t begin = 0; begin < tags.size();) {
    const std::size_t end = std::min(tags.find(',', begin), tags.size());
    if (end > begin) p.tags.push_back(tags.substr(begin, end - begin));
    begin = end + 1;
  }
  p.price = number(f, "price");
  if (const std::string currency = text(f, "currency"); !currency.empty()) p.currency = currency;
  const auto length = [&](const char* key) { return number(f, key).value_or(0) / 100; };
  p.size = {length("width"), length("depth"), length("height")};
  p.minSize = {length("minWidth"), length("minDepth"), length("minHeight")};
  p.maxSize = {length("maxWidth"), length("maxDepth"), length("maxHeight")};
  p.elevation = length("elevation");
  p.resizable = text(f, "resizable") != "false";
  p.keepProportions = text(f, "deformable") == "false";
  p.movable = text(f, "movable") != "false";
  const auto x = numbers(text(f, "lightSourceX")), y = numbers(text(f, "lightSourceY")),
             z = numbers(text(f, "lightSourceZ"));
  if (const std::size_t count = std::min({x.size(), y.size(), z.size()}); count > 0) {
    p.lamp.emplace();
    for (std::size_t i = 0; i < count; ++i)
      p.lamp->sources.push_back({.position = Vec3{x[i], y[i], z[i]} / 100.0 / p.size});
    p.lamp->lumens = number(f, "idapLumens").value_or(p.lamp->lumens);
    p.lamp->beamAngle = number(f, "idapBeamAngle").value_or(0) * kPi / 180;
    if (const auto kelvin = number(f, "idapColorTemperature"))
      p.lamp->colorTemperature = *kelvin;
    else
      p.lamp->color = colorOf(text(f, "lightSourceColor"));
  }
  return p;
}

class Table {
 public:
  void put(const std::string& key, const std::string& value) {
    if (!value.empty()) out_ += fmt::format("{}={}\n", key, escaped(value));
  }
  SharedBytes bytes() const {
    const auto* first = reinterpret_cast<const std::byte*>(out_.data());
    return std::make_shared<const Bytes>(first, first + out_.size());
  }

 private:
  std::string out_;
};

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) {
    if (!all.empty()) all += ',';
    all += word;
  }
  return all;
}

void write(Table& table, Table& thai, const OwnPiece& p, const std::string& model, const std::string& icon,
           std::size_t number) {
  const std::string mark = fmt::format("#{}", number);
  const auto put = [&](const char* key, const std::string& value) {
    table.put(fmt::format("{}{}", key, mark), value);
  };
  const auto length = [&](const char* key, double metres) {
    if (metres > 0) put(key, centimetres(metres));
  };
  put("id", p.id);
  put("name", p.name);
  put("category", p.category);
  put("icon", icon.empty() ? icon : fmt::format("/{}", icon));
  put("model", fmt::format("/{}", model));
  put("multiPartModel", "true");
  length("width", p.size.x);
  length("depth", p.size.y);
  length("height", p.size.z);
  length("minWidth", p.minSize.x);
  length("minDepth", p.minSize.y);
  length("minHeight", p.minSize.z);
  length("maxWidth", p.maxSize.x);
  length("maxDepth", p.maxSize.y);
  length("maxHeight", p.maxSize.z);
  length("elevation", p.elevation);
  put("movable", p.movable ? "true" : "false");
  put("doorOrWindow", "false");
  put("resizable", p.resizable ? "true" : "false");
  put("deformable", p.keepProportions ? "false" : "true");
  put("creator", p.creator);
  put("tags", joined(p.tags));
  if (p.price) {
    put("price", fmt::format("{:.2f}", *p.price));
    put("currency", p.currency);
  }
  if (p.lamp && !p.lamp->sources.empty()) {
    std::string x, y, z, colors;
    for (const LightSource& source : p.lamp->sources) {
      const Vec3 at = source.position * p.size;
      const char* blank = x.empty() ? "" : " ";
      x += fmt::format("{}{}", blank, centimetres(at.x));
      y += fmt::format("{}{}", blank, centimetres(at.y));
      z += fmt::format("{}{}", blank, centimetres(at.z));
      const std::optional<Color> color = p.lamp->color ? p.lamp->color : source.color;
      colors += fmt::format("{}{}", blank, textOf(color.value_or(Color{1, 1, 1})));
    }
    put("lightSourceX", x);
    put("lightSourceY", y);
    put("lightSourceZ", z);
    put("lightSourceColor", colors);
    // Sweet Home 3D passes over what it does not know.
    put("idapLumens", fmt::format("{:.9g}", p.lamp->lumens));
    if (!p.lamp->color) put("idapColorTemperature", fmt::format("{:.9g}", p.lamp->colorTemperature));
    if (p.lamp->beamAngle > 0) put("idapBeamAngle", fmt::format("{:.9g}", p.lamp->beamAngle * 180 / kPi));
  }
  thai.put(fmt::format("name{}", mark), p.nameThai);
  thai.put(fmt::format("category{}", mark), p.categoryThai);
}

}  // namespace

std::filesystem::path OwnLibrary::userFile() { return userDataFolder() / "furniture" / "own-furniture.sh3f"; }

OwnLibrary::OwnLibrary(std::filesystem::path file) : file_(std::move(file)) {
  std::error_code error;
  if (!std::filesystem::exists(file_, error)) return;
  const ZipReader archive(file_);
  const auto table = readTable(archive, kTable), thai = readTable(archive, kThai);
  for (const auto& [number, fields] : table) {
    const auto also = thai.find(number);
    OwnPiece piece = pieceOf(fields, also == thai.end() ? Fields() : also->second);
    std::string model = text(fields, "model"), icon = text(fields, "icon");
    for (std::string* path : {&model, &icon})
      path->erase(0, std::min(path->find_first_not_of('/'), path->size()));
    if (piece.id.empty() || find(piece.id) || !archive.contains(model)) continue;
    filesOf_[piece.id] = {model, icon};
    pieces_.push_back(std::move(piece));
  }
  for (const std::string& entry : archive.entries())
    if (entry != kTable && entry != kThai)
      entries_[entry] = std::make_shared<const Bytes>(archive.read(entry));
}

const OwnPiece* OwnLibrary::find(const std::string& id) const {
  const auto at = std::find_if(pieces_.begin(), pieces_.end(), [&](const OwnPiece& p) { return p.id == id; });
  return at == pieces_.end() ? nullptr : &*at;
}

std::string OwnLibrary::freeId(const std::string& name) const {
  std::string stem = "own/";
  for (const char c : name) {
    const auto u = static_cast<unsigned char>(c);
    if (u < 0x80 && std::isalnum(u))
      stem += static_cast<char>(std::tolower(u));
    else if (stem.back() != '-' && stem.back() != '/')
      stem += '-';
  }
  if (stem.back() == '/' || stem.back() == '-') stem += "piece";
  std::string id = stem;
  for (int n = 2; find(id); ++n) id = fmt::format("{}-{}", stem, n);
  return id;
}

void OwnLibrary::add(OwnPiece piece, const std::map<std::string, SharedBytes>& files, const std::string& main,
                     SharedBytes icon) {
  remove(piece.id);
  std::string folder = piece.id.substr(piece.id.find('/') + 1);
  for (const auto& [name, bytes] : files) entries_[fmt::format("{}/{}", folder, name)] = bytes;
  Files& places = filesOf_[piece.id];
  places.model = fmt::format("{}/{}", folder, main);
  if (icon) {
    places.icon = fmt::format("{}/icon.png", folder);
    entries_[places.icon] = std::move(icon);
  }
  pieces_.push_back(std::move(piece));
}

OwnLibrary::Model OwnLibrary::modelOf(const std::string& id) const {
  Model model;
  const auto files = filesOf_.find(id);
  if (files == filesOf_.end()) return model;
  const std::string& path = files->second.model;
  const std::string folder = path.substr(0, path.rfind('/') + 1);
  model.main = path.substr(folder.size());
  for (const auto& [name, bytes] : entries_)
    if (name.starts_with(folder) && name != files->second.icon)
      model.files[name.substr(folder.size())] = bytes;
  return model;
}

void OwnLibrary::change(const OwnPiece& piece) {
  for (OwnPiece& own : pieces_)
    if (own.id == piece.id) own = piece;
}

void OwnLibrary::remove(const std::string& id) {
  const auto files = filesOf_.find(id);
  if (files == filesOf_.end()) return;
  const std::string folder = files->second.model.substr(0, files->second.model.rfind('/') + 1);
  if (!folder.empty())
    std::erase_if(entries_, [&](const auto& entry) { return entry.first.starts_with(folder); });
  filesOf_.erase(files);
  std::erase_if(pieces_, [&](const OwnPiece& p) { return p.id == id; });
}

Bytes OwnLibrary::pack() const {
  Table table, thai;
  table.put("id", "idap-own-furniture");
  table.put("name", "My furniture");
  table.put("description", "Furniture made with IDAP");
  table.put("version", "1.0");
  std::size_t number = 0;
  for (const OwnPiece& piece : pieces_) {
    const Files& files = filesOf_.at(piece.id);
    write(table, thai, piece, files.model, files.icon, ++number);
  }
  auto entries = entries_;
  entries[kTable] = table.bytes();
  entries[kThai] = thai.bytes();
  return writeZip(entries);
}

void OwnLibrary::save() const {
  std::error_code failed;
  std::filesystem::create_directories(file_.parent_path(), failed);
  if (failed) throw IoError(file_.parent_path().string() + ": cannot be made: " + failed.message());
  writeFileAtomically(file_, pack());
}

}  // namespace idap
