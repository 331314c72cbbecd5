#include "catalog/parametric/builtin.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "catalog/embedded_data.h"
#include "catalog/parametric/declarations.h"
#include "catalog/parametric/outline_parameter.h"

namespace idap::parametric {
namespace {

using nlohmann::json;

Vec3 vec3Of(const json& j) { return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()}; }

double radiansOf(const json& j, const char* key) { return j.value(key, 0.0) * kPi / 180; }

Color colorOf(const std::string& hex) {
  if (hex.size() != 7 || hex[0] != '#')
    throw std::invalid_argument("'" + hex + "' is no colour like #a0b1c2");
  const unsigned long v = std::stoul(hex.substr(1), nullptr, 16);
  const auto channel = [v](int shift) { return static_cast<float>((v >> shift) & 255u) / 255.0f; };
  return {channel(16), channel(8), channel(0)};
}

PieceKind kindOf(const json& j) {
  const std::string kind = j.value("kind", "");
  if (kind == "furniture") return PieceKind::Furniture;
  if (kind == "lamp") return PieceKind::Lamp;
  if (kind == "door") return PieceKind::Door;
  if (kind == "window") return PieceKind::Window;
  if (kind == "staircase") return PieceKind::Staircase;
  if (!kind.empty()) throw std::invalid_argument("unknown kind '" + kind + "'");
  return j.contains("lamp")              ? PieceKind::Lamp
         : j.contains("staircaseCutOut") ? PieceKind::Staircase
         : j.contains("opening")         ? PieceKind::Door
                                         : PieceKind::Furniture;
}

void readOpening(const json& j, CatalogPiece& piece) {
  piece.cutOut = j.value("cutOut", piece.cutOut);
  piece.wallThickness = j.value("wallThickness", piece.wallThickness);
  piece.wallDistance = j.value("wallDistance", piece.wallDistance);
  piece.cutsBothSides = j.value("cutsBothSides", piece.cutsBothSides);
  for (const json& s : j.value("sashes", json::array())) {
    const json axis = s.value("axis", json::array({0, 1}));
    piece.sashes.push_back({{axis.at(0).get<double>(), axis.at(1).get<double>()},
                            s.value("width", 1.0),
                            radiansOf(s, "start"),
                            radiansOf(s, "end")});
  }
}

Lamp lampOf(const json& j) {
  Lamp lamp;
  lamp.lumens = j.value("lumens", lamp.lumens);
  lamp.colorTemperature = j.value("temperature", lamp.colorTemperature);
  lamp.beamAngle = radiansOf(j, "beamAngle");
  for (const json& s : j.value("sources", json::array())) {
    LightSource source;
    source.position = vec3Of(s.at("position"));
    source.diameter = s.value("diameter", 0.0);
    source.share = s.value("share", 1.0);
    lamp.sources.push_back(source);
  }
  return lamp;
}

void readParameters(const json& j, BuiltinPiece& built, CatalogPiece& piece) {
  for (const auto& [name, value] : j.items()) {
    if (value.is_string()) {
      built.parameters.texts[name] = value.get<std::string>();
    } else if (value.is_array()) {
      for (const json& point : value)
        built.parameters.outline.push_back({point.at(0).get<double>(), point.at(1).get<double>()});
    } else if (value.is_object()) {
      PieceParameter p = describedParameter(name);
      p.value = value.at("value").get<double>();
      p.min = value.value("min", p.value);
      p.max = value.value("max", p.value);
      p.whole = value.value("whole", false);
      if (p.whole) p.kind = PieceParameter::Kind::Count;
      built.parameters.numbers[name] = p.value;
      piece.parameters.push_back(p);
    } else {
      built.parameters.numbers[name] =
          value.is_boolean() ? (value.get<bool>() ? 1.0 : 0.0) : value.get<double>();
    }
  }
}

BuiltinPiece pieceOf(const json& j, const std::string& category, const BuiltinCatalog& catalog) {
  BuiltinPiece built;
  CatalogPiece piece;
  piece.id = j.at("id").get<std::string>();
  piece.category = j.value("category", category);
  for (const auto& [language, name] : j.at("name").items()) {
    if (language == "en")
      piece.name = name.get<std::string>();
    else
      piece.translations[language]["name"] = name.get<std::string>();
  }
  if (const auto names = catalog.categoryNames.find(piece.category); names != catalog.categoryNames.end())
    for (const auto& [language, name] : names->second) piece.translations[language]["category"] = name;
  piece.tags = j.value("tags", std::vector<std::string>{});
  piece.kind = kindOf(j);
  piece.size = vec3Of(j.at("size"));
  piece.minSize = j.contains("minSize") ? vec3Of(j.at("minSize")) : Vec3{};
  piece.maxSize = j.contains("maxSize") ? vec3Of(j.at("maxSize")) : Vec3{};
  piece.ceilingMounted = j.value("ceilingMounted", false);
  // Under a ceiling of ordinary height until somebody knows better.
  piece.elevation = j.value("elevation", piece.ceilingMounted ? std::max(0.0, 2.5 - piece.size.z) : 0.0);
  if (j.contains("price")) piece.price = j.at("price").get<double>();
  if (j.contains("dropOnTop")) piece.dropOnTopHeight = j.at("dropOnTop").get<double>();
  if (j.contains("lamp")) piece.lamp = lampOf(j.at("lamp"));
  if (j.contains("opening")) readOpening(j.at("opening"), piece);
  piece.staircaseCutOut = j.value("staircaseCutOut", "");
  const json slots = j.value("slots", json::object());
  for (const auto& [slot, value] : slots.items()) {
    SlotMaterial material;
    if (value.is_string()) {
      material.material = value.get<std::string>();
    } else {
      material.material = value.at("material").get<std::string>();
      if (value.contains("color")) material.color = colorOf(value.at("color").get<std::string>());
    }
    piece.slots.push_back(slot);
    built.slots[slot] = material;
  }
  readParameters(j.value("parameters", json::object()), built, piece);
  const std::string generator = j.at("generator").get<std::string>();
  addDeclared(generator, built.parameters, piece.parameters);
  const auto it = generators().find(generator);
  if (it == generators().end()) throw std::invalid_argument("unknown generator '" + generator + "'");
  built.generator = it->second;
  built.piece = std::make_shared<const CatalogPiece>(std::move(piece));
  return built;
}

BuiltinCatalog readAll() {
  BuiltinCatalog catalog;
  const json categories = json::parse(embeddedCatalogFile("categories.json"));
  for (const json& c : categories.at("categories")) {
    const std::string id = c.at("id").get<std::string>();
    catalog.categories.push_back({id, c.at("name").at("en").get<std::string>(), 0});
    for (const auto& [language, name] : c.at("name").items())
      if (language != "en") catalog.categoryNames[id][language] = name.get<std::string>();
  }
  for (const EmbeddedFile& file : embeddedCatalogFiles())
    readPieces(file.text, std::string(file.name), catalog);
  // In the order of the categories; within one, as the files have them.
  const auto rank = [&](const BuiltinPiece& p) {
    return std::find_if(catalog.categories.begin(), catalog.categories.end(),
                        [&](const Catalog::Category& c) { return c.id == p.piece->category; }) -
           catalog.categories.begin();
  };
  std::stable_sort(catalog.pieces.begin(), catalog.pieces.end(),
                   [&](const BuiltinPiece& a, const BuiltinPiece& b) { return rank(a) < rank(b); });
  catalog.byId.clear();
  for (std::size_t i = 0; i < catalog.pieces.size(); ++i) {
    catalog.byId[catalog.pieces[i].piece->id] = i;
    for (Catalog::Category& c : catalog.categories)
      if (c.id == catalog.pieces[i].piece->category) ++c.pieces;
  }
  return catalog;
}

// Parts that a piece does not come with, but has by a user's choice, look as they do where they are usual: on
// a piece of the same generator, else on any.
const SlotMaterial* materialOf(const BuiltinPiece& built, const std::string& name) {
  if (const auto slot = built.slots.find(name); slot != built.slots.end()) return &slot->second;
  const SlotMaterial* usual = nullptr;
  for (const BuiltinPiece& other : builtinCatalog().pieces) {
    const auto slot = other.slots.find(name);
    if (slot == other.slots.end()) continue;
    if (other.generator == built.generator) return &slot->second;
    if (!usual) usual = &slot->second;
  }
  return usual;
}

}  // namespace

const BuiltinPiece* BuiltinCatalog::find(std::string_view id) const {
  const auto it = byId.find(id);
  return it == byId.end() ? nullptr : &pieces[it->second];
}

void readPieces(std::string_view text, const std::string& file, BuiltinCatalog& into) {
  std::string place;
  try {
    const json root = json::parse(text);
    if (!root.is_object() || !root.contains("pieces")) return;
    const std::string category = root.value("category", "");
    for (const json& j : root.at("pieces")) {
      place = j.value("id", "");
      BuiltinPiece piece = pieceOf(j, category, into);
      if (!into.byId.emplace(place, into.pieces.size()).second)
        throw std::invalid_argument("the id is used twice");
      into.pieces.push_back(std::move(piece));
    }
  } catch (const std::exception& e) {
    throw ParseError(file, place, e.what());
  }
}

const BuiltinCatalog& builtinCatalog() {
  static const BuiltinCatalog catalog = readAll();
  return catalog;
}

Parameters withChanges(const BuiltinPiece& piece, const std::map<std::string, double>& changes) {
  Parameters result = piece.parameters;
  for (const PieceParameter& p : piece.piece->parameters) {
    const auto it = changes.find(p.name);
    if (it == changes.end() || !std::isfinite(it->second)) continue;
    double value = std::clamp(it->second, p.min, p.max);
    if (p.whole) value = std::round(value);
    if (p.kind == PieceParameter::Kind::Choice)
      result.texts[p.name] = p.choices.at(static_cast<std::size_t>(value)).name;
    else
      result.numbers[p.name] = value;
  }
  if (!result.outline.empty())
    if (std::vector<Vec2> drawn = outlineFrom(changes); !drawn.empty()) result.outline = std::move(drawn);
  return result;
}

SurfaceModel buildModel(const BuiltinPiece& built, Vec3 size, const std::map<std::string, double>& changes) {
  const CatalogPiece& piece = *built.piece;
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(size[i]) || size[i] <= 0) size[i] = piece.size[i];
    if (piece.minSize[i] > 0) size[i] = std::max(size[i], piece.minSize[i]);
    if (piece.maxSize[i] > 0) size[i] = std::min(size[i], piece.maxSize[i]);
  }
  Builder builder(size);
  built.generator(builder, withChanges(built, changes));
  Builder::Result result = builder.finish();
  SurfaceModel model;
  model.mesh = std::move(result.mesh);
  model.lightPositions = std::move(result.lights);
  for (const std::string& name : result.slots) {
    Material material;
    if (const SlotMaterial* slot = materialOf(built, name)) {
      if (const Material* known = findMaterial(slot->material)) material = *known;
      if (slot->color) material.color = *slot->color;
    }
    model.slots.push_back({name, std::move(material)});
  }
  return model;
}

}  // namespace idap::parametric
