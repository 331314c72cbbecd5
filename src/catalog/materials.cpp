// The catalog's materials, read from share/catalog/materials.json as it was when the program was built.
#include <tbb/task_arena.h>

#include <cstring>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "catalog/embedded_data.h"
#include "catalog/material.h"
#include "catalog/procedural_texture.h"

namespace idap {

namespace {

using nlohmann::json;

struct Entry {
  Material material;
  std::string group;
  std::map<std::string, std::string> names;  // by language
  std::optional<TextureRecipe> recipe;
  bool neutral = false;  // the picture carries no colour of its own: the mean of both is the colour
  bool relief = true;
  bool fit = false;  // one copy over the face's own texture coordinates
  std::once_flag painted;
};

Color colorOf(const std::string& hex) {
  const unsigned long v = std::stoul(hex.substr(1), nullptr, 16);
  const auto channel = [v](int shift) { return static_cast<float>((v >> shift) & 255u) / 255.0f; };
  return {channel(16), channel(8), channel(0)};
}

Vec2 pairOf(const json& j) { return {j.at(0).get<double>(), j.at(1).get<double>()}; }

TextureRecipe recipeOf(const json& j) {
  TextureRecipe recipe;
  for (const auto& [key, value] : j.items()) {
    if (key == "pattern") {
      recipe.pattern = value.get<std::string>();
    } else if (key == "size") {
      recipe.size = pairOf(value);
    } else if (key == "pixels") {
      recipe.width = value.at(0).get<int>();
      recipe.height = value.at(1).get<int>();
    } else if (key == "seed") {
      recipe.seed = value.get<std::uint32_t>();
    } else if (key == "colors") {
      for (const json& c : value) recipe.colors.push_back(colorOf(c.get<std::string>()));
    } else if (value.is_number()) {
      recipe.numbers[key] = value.get<double>();
    }
  }
  return recipe;
}

MaterialTexture textureOf(const Image8& picture, const std::string& name, const Entry& entry) {
  MaterialTexture texture;
  texture.bytes = std::make_shared<const Bytes>(encodePpm(picture));
  texture.name = name;
  texture.size = entry.fit ? Vec2{} : entry.recipe->size;
  return texture;
}

void paintEntry(Entry& entry, const std::string& id) {
  const ProceduralTexture made = makeTexture(*entry.recipe);
  entry.material.texture = textureOf(made.color, id + ".ppm", entry);
  if (entry.relief && made.normal.width > 0)
    entry.material.normalMap = textureOf(made.normal, id + "-normal.ppm", entry);
  if (!entry.neutral) return;
  // Brightens the colour by what the picture takes away, so that the whole looks like the colour named.
  const float mean = luminance(meanReflectance(made.color));
  const auto lifted = [mean](float v) {
    return linearToSrgb(std::fmin(1.0f, srgbToLinear(v) / std::fmax(mean, 0.05f)));
  };
  Color& color = entry.material.color;
  color = {lifted(color.r), lifted(color.g), lifted(color.b)};
}

class Materials {
 public:
  static Materials& instance() {
    static Materials materials;
    return materials;
  }

  Entry* find(const std::string& id) {
    const auto it = entries_.find(id);
    return it == entries_.end() ? nullptr : &it->second;
  }
  const std::vector<std::string>& ids() const { return ids_; }

 private:
  Materials() {
    const std::string file = "materials.json";
    std::map<std::string, json> sources;
    try {
      const json all = json::parse(embeddedCatalogFile(file));
      for (const json& given : all.at("materials")) {
        json j = given;
        if (given.contains("like")) {
          j = sources.at(given.at("like").get<std::string>());
          j.merge_patch(given);
        }
        const std::string id = j.at("id").get<std::string>();
        add(id, j);
        j.erase("like");
        sources[id] = std::move(j);
      }
    } catch (const std::exception& e) {
      throw ParseError(file, ids_.empty() ? "" : "after " + ids_.back(), e.what());
    }
  }

  void add(const std::string& id, const json& j) {
    Entry& entry = entries_[id];
    for (const auto& [language, text] : j.at("name").items()) entry.names[language] = text.get<std::string>();
    entry.group = j.at("group").get<std::string>();
    Material& m = entry.material;
    m.name = entry.names["en"];
    m.color = colorOf(j.at("color").get<std::string>());
    m.metalness = j.value("metalness", m.metalness);
    m.roughness = j.value("roughness", m.roughness);
    m.ior = j.value("ior", m.ior);
    m.transmission = j.value("transmission", m.transmission);
    m.thin = j.value("thin", m.thin);
    m.translucency = j.value("translucency", m.translucency);
    m.opacity = j.value("opacity", m.opacity);
    if (j.contains("texture")) {
      entry.recipe = recipeOf(j.at("texture"));
      entry.neutral = j.at("texture").value("neutral", false);
      entry.relief = j.at("texture").value("relief", true);
      entry.fit = j.at("texture").value("fit", false);
    }
    ids_.push_back(id);
  }

  std::map<std::string, Entry> entries_;
  std::vector<std::string> ids_;
};

}  // namespace

const Material* findMaterial(const std::string& id) {
  Entry* const entry = Materials::instance().find(id);
  if (!entry) return nullptr;
  if (entry->recipe) {
    // Isolated: while it waits for its rows, this thread must not begin a task that waits for this very
    // picture.
    std::call_once(entry->painted, [&] { tbb::this_task_arena::isolate([&] { paintEntry(*entry, id); }); });
  }
  return &entry->material;
}

std::vector<std::string> materialIds() { return Materials::instance().ids(); }

std::string materialName(const std::string& id, std::string_view language) {
  const Entry* const entry = Materials::instance().find(id);
  if (!entry) return {};
  const auto it = entry->names.find(std::string(language));
  return it == entry->names.end() ? entry->material.name : it->second;
}

std::string materialGroup(const std::string& id) {
  const Entry* const entry = Materials::instance().find(id);
  return entry ? entry->group : std::string();
}

}  // namespace idap
