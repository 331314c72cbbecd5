#include "catalog/library/library_index.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <unordered_map>

#include "base/error.h"
#include "catalog/library/properties.h"
#include "catalog/light_power.h"
#include "catalog/model_rotation.h"
#include "catalog/opening_kind.h"
#include "catalog/text_scan.h"

namespace idap {

namespace {

constexpr std::string_view kTable = "PluginFurnitureCatalog";
constexpr std::string_view kTableEnd = ".properties";
constexpr std::size_t kMaxTableBytes = std::size_t{64} << 20;
constexpr std::size_t kMaxPieces = 100'000;
constexpr double kCentimetre = 0.01;
constexpr double kMaxSize = 1e5;          // cm
constexpr double kDefaultPower = 0.5;     // what Sweet Home 3D gives a new lamp
constexpr double kCeilings[] = {2.5, 3};  // m, of the rooms that the libraries are made for

using Fields = std::unordered_map<std::string, std::string>;  // of one piece

struct Table {
  Fields library;  // keys without a number
  std::map<std::uint32_t, Fields> pieces;
};

Table readTable(const ZipReader& archive, const std::string& entry) {
  Table table;
  const Bytes bytes = archive.read(entry);
  if (bytes.size() > kMaxTableBytes) throw ParseError(entry, "", "the table is too large");
  readProperties(asText(bytes), [&](std::string_view key, std::string_view value) {
    const std::size_t mark = key.rfind('#');
    if (mark == std::string_view::npos) {
      table.library.insert_or_assign(std::string(key), std::string(value));
      return;
    }
    std::uint32_t number = 0;
    const auto [stop, error] = std::from_chars(key.data() + mark + 1, key.data() + key.size(), number);
    if (error != std::errc{} || stop != key.data() + key.size() || table.pieces.size() > kMaxPieces) return;
    table.pieces[number].insert_or_assign(std::string(key.substr(0, mark)), std::string(value));
  });
  return table;
}

// Reads the fields of one piece.
class PieceFields {
 public:
  explicit PieceFields(const Fields& fields) : fields_(fields) {}

  std::string text(const std::string& key) const {
    const auto found = fields_.find(key);
    return found == fields_.end() ? std::string() : found->second;
  }
  std::optional<double> number(const std::string& key) const {
    const auto all = numbers(key);
    return all.empty() ? std::nullopt : std::optional(all.front());
  }
  std::optional<double> length(const std::string& key) const {
    const auto centimetres = number(key);
    return centimetres ? std::optional(*centimetres * kCentimetre) : std::nullopt;
  }
  bool flag(const std::string& key, bool fallback) const {
    const std::string value = text(key);
    return value.empty() ? fallback : value == "true";
  }
  std::vector<double> numbers(const std::string& key) const {
    std::vector<double> values;
    const std::string value = text(key);
    TextScan scan(value);
    for (double number = 0; scan.number(number) && std::abs(number) <= kMaxSize;) values.push_back(number);
    return values;
  }
  std::vector<Color> colors(const std::string& key) const {
    std::vector<Color> values;
    const std::string value = text(key);
    TextScan scan(value);
    for (std::string_view word = scan.word(); !word.empty(); word = scan.word()) {
      if (word.front() == '#') word.remove_prefix(1);
      std::uint32_t rgb = 0;
      std::from_chars(word.data(), word.data() + word.size(), rgb, 16);
      values.push_back(
          {float(rgb >> 16 & 0xFF) / 255, float(rgb >> 8 & 0xFF) / 255, float(rgb & 0xFF) / 255});
    }
    return values;
  }
  std::vector<std::string> list(const std::string& key) const {
    std::vector<std::string> values;
    const std::string value = text(key);
    std::size_t begin = 0;
    while (begin <= value.size()) {
      const std::size_t end = std::min(value.find(',', begin), value.size());
      const std::size_t first = value.find_first_not_of(' ', begin);
      if (first < end)
        values.push_back(value.substr(first, value.find_last_not_of(' ', end - 1) + 1 - first));
      begin = end + 1;
    }
    return values;
  }

 private:
  const Fields& fields_;
};

std::optional<Lamp> lampOf(const PieceFields& fields, Vec3 size) {
  const auto x = fields.numbers("lightSourceX"), y = fields.numbers("lightSourceY"),
             z = fields.numbers("lightSourceZ");
  const auto colors = fields.colors("lightSourceColor");
  const auto diameters = fields.numbers("lightSourceDiameter");
  const std::size_t count = std::min({x.size(), y.size(), z.size(), colors.size()});
  if (count == 0) return std::nullopt;
  std::vector<Sh3dLightSource> sources(count);
  for (std::size_t i = 0; i < count; ++i) {
    sources[i].position = Vec3{x[i], y[i], z[i]} * kCentimetre / size;
    sources[i].color = colors[i];
    if (i < diameters.size() && diameters[i] > 0) sources[i].diameter = diameters[i] * kCentimetre;
  }
  Lamp lamp = lampOf(kDefaultPower, sources);
  // The program's own additions, which others pass over.
  if (const auto lumens = fields.number("idapLumens"); lumens && *lumens >= 0) lamp.lumens = *lumens;
  if (const auto kelvin = fields.number("idapColorTemperature"); kelvin && *kelvin > 0) {
    lamp.colorTemperature = *kelvin;
    lamp.color.reset();
    for (LightSource& source : lamp.sources) source.color.reset();
  }
  if (const auto degrees = fields.number("idapBeamAngle"); degrees && *degrees > 0 && *degrees < 180)
    lamp.beamAngle = *degrees * kPi / 180;
  return lamp;
}

std::vector<Sash> sashesOf(const PieceFields& fields, Vec3 size) {
  const auto x = fields.numbers("doorOrWindowSashXAxis"), y = fields.numbers("doorOrWindowSashYAxis"),
             width = fields.numbers("doorOrWindowSashWidth"),
             start = fields.numbers("doorOrWindowSashStartAngle"),
             end = fields.numbers("doorOrWindowSashEndAngle");
  std::vector<Sash> sashes(std::min({x.size(), y.size(), width.size(), start.size(), end.size()}));
  for (std::size_t i = 0; i < sashes.size(); ++i)
    sashes[i] = {{x[i] * kCentimetre / size.x, y[i] * kCentimetre / size.y},
                 width[i] * kCentimetre / size.x,
                 start[i] * kPi / 180,
                 end[i] * kPi / 180};
  return sashes;
}

void readOpening(const PieceFields& fields, CatalogPiece& piece) {
  if (const std::string shape = fields.text("doorOrWindowCutOutShape"); !shape.empty()) piece.cutOut = shape;
  if (const auto part = fields.length("doorOrWindowWallThickness"))
    piece.wallThickness = *part / piece.size.y;
  if (const auto distance = fields.length("doorOrWindowWallDistance"))
    piece.wallDistance = *distance / piece.size.y;
  piece.cutsBothSides = fields.flag("doorOrWindowWallCutOutOnBothSides", true);
  piece.sashes = sashesOf(fields, piece.size);
  const OpeningKind kind =
      openingKindOf(piece.id, piece.name, piece.elevation, piece.size.z, !piece.sashes.empty());
  piece.kind = kind == OpeningKind::Window ? PieceKind::Window : PieceKind::Door;
}

std::string withoutLeadingSlash(std::string path) {
  path.erase(0, std::min(path.find_first_not_of('/'), path.size()));
  return path;
}

// Nothing for a piece without a name, a size or a model.
std::optional<LibraryIndex::Entry> readPiece(const PieceFields& fields, std::uint32_t number,
                                             const std::string& fileName) {
  LibraryIndex::Entry entry;
  CatalogPiece& piece = entry.piece;
  piece.name = fields.text("name");
  entry.model = withoutLeadingSlash(fields.text("model"));
  entry.icon = withoutLeadingSlash(fields.text("icon"));
  piece.size = {fields.length("width").value_or(0), fields.length("depth").value_or(0),
                fields.length("height").value_or(0)};
  if (piece.name.empty() || entry.model.empty() ||
      !(piece.size.x > 0 && piece.size.y > 0 && piece.size.z > 0))
    return std::nullopt;
  piece.id = fields.text("id");
  if (piece.id.empty())
    piece.id = std::filesystem::path(fileName).stem().string() + '#' + std::to_string(number);
  piece.category = fields.text("category");
  piece.tags = fields.list("tags");
  piece.elevation = fields.length("elevation").value_or(0);
  piece.minSize = {fields.length("minWidth").value_or(0), fields.length("minDepth").value_or(0),
                   fields.length("minHeight").value_or(0)};
  piece.maxSize = {fields.length("maxWidth").value_or(0), fields.length("maxDepth").value_or(0),
                   fields.length("maxHeight").value_or(0)};
  piece.price = fields.number("price");
  piece.creator = fields.text("creator");
  if (const auto top = fields.length("dropOnTopElevation"); top && *top >= 0) piece.dropOnTopHeight = *top;
  if (const auto rotation = modelRotationOf(fields.text("modelRotation"))) piece.modelRotation = *rotation;
  piece.staircaseCutOut = fields.text("staircaseCutOutShape");
  piece.lamp = lampOf(fields, piece.size);
  if (fields.flag("doorOrWindow", false)) {
    readOpening(fields, piece);
  } else if (piece.lamp) {
    piece.kind = PieceKind::Lamp;
    const double top = piece.elevation + piece.size.z;
    piece.ceilingMounted =
        piece.elevation > 0 && std::any_of(std::begin(kCeilings), std::end(kCeilings),
                                           [&](double c) { return std::abs(top - c) < 0.02; });
  } else if (!piece.staircaseCutOut.empty()) {
    piece.kind = PieceKind::Staircase;
  }
  return entry;
}

// "fr" of "PluginFurnitureCatalog_fr.properties"; nothing for other entries; empty for the table itself.
std::optional<std::string> languageOf(std::string_view entry) {
  if (!entry.starts_with(kTable) || !entry.ends_with(kTableEnd)) return std::nullopt;
  entry.remove_prefix(kTable.size());
  entry.remove_suffix(kTableEnd.size());
  if (entry.empty()) return std::string();
  if (entry.front() != '_' || entry.size() > 20) return std::nullopt;
  return std::string(entry.substr(1));
}

}  // namespace

LibraryIndex readLibraryIndex(const ZipReader& archive, const std::string& fileName) {
  const std::string main = std::string(kTable) + std::string(kTableEnd);
  if (!archive.contains(main))
    throw ParseError(fileName, "", "not a furniture library (" + main + " is missing)");
  const Table table = readTable(archive, main);
  LibraryIndex index;
  const PieceFields about(table.library);
  index.id = about.text("id");
  index.name = about.text("name");
  index.description = about.text("description");
  index.version = about.text("version");
  index.license = about.text("license");
  index.provider = about.text("provider");
  if (index.name.empty()) index.name = std::filesystem::path(fileName).stem().string();

  std::map<std::uint32_t, std::size_t> entryOf;
  for (const auto& [number, fields] : table.pieces) {
    auto entry = readPiece(PieceFields(fields), number, fileName);
    if (!entry) continue;
    entry->piece.library = fileName;
    const std::string license = PieceFields(fields).text("license");
    entry->piece.license = license.empty() ? index.license : license;
    entryOf[number] = index.entries.size();
    index.entries.push_back(std::move(*entry));
  }
  for (const std::string& translation : archive.entries()) {
    const auto language = languageOf(translation);
    if (!language || language->empty()) continue;
    const Table translated = readTable(archive, translation);
    for (const auto& [number, fields] : translated.pieces) {
      const auto found = entryOf.find(number);
      if (found == entryOf.end()) continue;
      auto& texts = index.entries[found->second].piece.translations[*language];
      for (const char* key : {"name", "category", "tags", "description"})
        if (const auto text = fields.find(key); text != fields.end() && !text->second.empty())
          texts[key] = text->second;
    }
  }
  return index;
}

}  // namespace idap
