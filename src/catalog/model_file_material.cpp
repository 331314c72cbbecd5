#include "catalog/model_file_material.h"

#include <algorithm>
#include <cmath>

#include "catalog/default_materials.h"
#include "catalog/text_scan.h"

namespace idap {

namespace {

constexpr double kMatt = 0.9;
// Highlights this strong count as a fully polished surface; it is what the default materials have.
constexpr double kFullSpecular = 0.3;
// What a surface with Ke = 1 gives off: about a bright screen's luminance.
constexpr double kEmissionLuminance = 200;  // cd/m2

double strongest(const Color& c) { return std::max({c.r, c.g, c.b}); }
double weakest(const Color& c) { return std::min({c.r, c.g, c.b}); }

Color mixed(const Color& a, const Color& b, double share) {
  const auto t = float(share);
  return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t};
}

// The file name of a map statement: what follows the options (-s 1 1 1, -clamp on, …).
std::string mapFile(TextScan line) {
  while (true) {
    line.skipBlanks();
    if (line.peek() != '-') break;
    const std::string_view option = line.word();
    const bool takesWord = option == "-clamp" || option == "-blendu" || option == "-blendv" ||
                           option == "-cc" || option == "-imfchan" || option == "-type";
    if (takesWord) {
      line.word();
    } else {
      for (double ignored; line.number(ignored);) {
      }
    }
  }
  std::string file(line.rest());
  std::replace(file.begin(), file.end(), '\\', '/');
  return file;
}

std::optional<Color> readColor(TextScan& line) {
  double r = 0, g = 0, b = 0;
  if (!line.number(r)) return std::nullopt;  // "spectral file" and "xyz" are not read
  if (!line.number(g))
    g = b = r;
  else if (!line.number(b))
    b = g;
  const auto channel = [](double v) { return float(std::clamp(v, 0.0, 1.0)); };
  return Color{channel(r), channel(g), channel(b)};
}

SharedBytes loadBeside(const SiblingFiles& siblings, const std::string& path) {
  if (!siblings || path.empty()) return nullptr;
  if (SharedBytes bytes = siblings(path)) return bytes;
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? nullptr : siblings(path.substr(slash + 1));
}

std::optional<MaterialTexture> loadTexture(const SiblingFiles& siblings, const std::string& path) {
  SharedBytes bytes = loadBeside(siblings, path);
  if (!bytes || bytes->empty()) return std::nullopt;
  return MaterialTexture{.bytes = std::move(bytes), .name = path.substr(path.rfind('/') + 1)};
}

}  // namespace

std::vector<PhongMaterial> parseMtl(std::string_view text) {
  std::vector<PhongMaterial> materials;
  for (TextScan file(text); !file.atEnd();) {
    TextScan line = file.line();
    const std::string_view key = line.word();
    if (key.empty() || key.front() == '#') continue;
    if (key == "newmtl") {
      materials.emplace_back().name = std::string(line.rest());
      continue;
    }
    if (materials.empty()) continue;
    PhongMaterial& m = materials.back();
    double value = 0;
    if (key == "Kd") {
      if (const auto c = readColor(line)) m.diffuse = *c;
    } else if (key == "Ks") {
      if (const auto c = readColor(line)) m.specular = *c;
    } else if (key == "Ke") {
      double r = 0, g = 0, b = 0;
      if (line.number(r) && line.number(g) && line.number(b) && std::isfinite(r + g + b))
        m.emission = {std::clamp(r, 0.0, 1e4), std::clamp(g, 0.0, 1e4), std::clamp(b, 0.0, 1e4)};
    } else if (key == "Ns") {
      if (line.number(value) && value >= 0) m.exponent = std::min(value, 10'000.0);
    } else if (key == "d" || key == "Tr") {
      line.skipBlanks();
      if (line.peek() == '-') line.word();  // -halo
      if (line.number(value) && std::isfinite(value))
        m.opacity = std::clamp(key == "d" ? value : 1 - value, 0.0, 1.0);
    } else if (key == "Ni") {
      if (line.number(value) && std::isfinite(value)) m.ior = value;
    } else if (key == "illum") {
      if (line.number(value) && value >= 0 && value <= 10) m.illumination = int(value);
    } else if (key == "map_Kd") {
      m.diffuseMap = mapFile(line);
    } else if (key == "map_d") {
      m.opacityMap = mapFile(line);
    } else if (key == "norm" || key == "map_Kn") {
      m.normalMap = mapFile(line);
    }
  }
  return materials;
}

double roughnessOfPhong(double specular, double exponent) {
  const double polished = std::pow(2 / (std::max(exponent, 0.0) + 2), 0.25);  // sqrt(alpha)
  const double share = std::clamp(specular / kFullSpecular, 0.0, 1.0);
  return kMatt + (std::min(polished, kMatt) - kMatt) * share;
}

PhongMaterial defaultPhongMaterial(std::string_view name) {
  const DefaultMaterial* found = findDefaultMaterial(name);
  if (!found) found = findDefaultMaterial("default");
  PhongMaterial phong;
  phong.name = std::string(name);
  phong.diffuse = found->color;
  const auto specular = float(found->specular);
  phong.specular = {specular, specular, specular};
  phong.exponent = found->exponent;
  phong.opacity = 1 - found->transparency;
  return phong;
}

Material materialOf(const PhongMaterial& phong, SlotRole role, const SiblingFiles& siblings) {
  Material m;
  m.name = phong.name;
  m.color = phong.diffuse;
  m.ior = phong.ior > 1 ? std::min(phong.ior, 3.0) : 1.5;
  const bool shines = phong.illumination >= 2;
  m.roughness = roughnessOfPhong(shines ? strongest(phong.specular) : 0, phong.exponent);
  m.emission = phong.emission * kEmissionLuminance;
  m.texture = loadTexture(siblings, phong.diffuseMap);
  m.normalMap = loadTexture(siblings, phong.normalMap);
  // The same picture for both: its own alpha says it all.
  if (phong.opacityMap != phong.diffuseMap) m.opacityMap = loadTexture(siblings, phong.opacityMap);
  if (m.texture) m.color = {1, 1, 1};  // the picture alone, as the models' makers saw it

  if (role == SlotRole::Mirror || (shines && (phong.illumination == 3 || phong.illumination == 5) &&
                                   weakest(phong.specular) > 0.7 && strongest(phong.diffuse) < 0.3)) {
    m.metalness = 1;
    m.roughness = 0.02;
    m.color = {0.95f, 0.95f, 0.95f};
    m.texture.reset();
    m.opacityMap.reset();
    return m;
  }
  double opacity = phong.opacity;
  if (opacity >= 1 && role == SlotRole::Pane) opacity = 0;
  if (opacity >= 1) return m;
  if (m.texture || m.opacityMap) {  // a curtain, a leaf: the picture thinned
    m.opacity = opacity;
    return m;
  }
  // A pane: its tint is the colour to the degree that it is there at all.
  m.transmission = 1 - opacity;
  m.thin = true;
  m.color = mixed({1, 1, 1}, phong.diffuse, opacity);
  m.roughness = role == SlotRole::Pane || opacity < 0.5 ? 0.02 : m.roughness;
  return m;
}

}  // namespace idap
