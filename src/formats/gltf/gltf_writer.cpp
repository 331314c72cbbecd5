#include "formats/gltf/gltf_writer.h"

#include <fmt/format.h>

#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <tuple>

#include "base/error.h"
#include "formats/gltf/glb_buffer.h"
#include "formats/gltf/gltf_material.h"

namespace idap {

namespace {

using Json = nlohmann::ordered_json;

// How far from square the axes of a node may be before its mesh is written in place instead: a node of glTF
// can be moved, turned and scaled, not sheared.
constexpr float kSquare = 1e-4f;

bool square(const Transformf& t) {
  const auto cosine = [](Vec3f a, Vec3f b) { return std::fabs(dot(a, b)) / (length(a) * length(b)); };
  return cosine(t.x, t.y) < kSquare && cosine(t.y, t.z) < kSquare && cosine(t.z, t.x) < kSquare;
}

bool usable(const Transformf& t) {
  const float d = t.determinant();
  return std::isfinite(d) && std::fabs(d) > 1e-12f && std::isfinite(dot(t.origin, t.origin));
}

Json matrix(const Transformf& t) {
  return {t.x.x, t.x.y, t.x.z, 0, t.y.x,      t.y.y,      t.y.z,      0,
          t.z.x, t.z.y, t.z.z, 0, t.origin.x, t.origin.y, t.origin.z, 1};
}

// Cameras and lights of glTF look along -z.
Transformf lookingAlong(Vec3f forward, Vec3f up, Vec3f origin) {
  const Vec3f z = normalized(-forward);
  Vec3f x = cross(up, z);
  if (dot(x, x) < 1e-6f) x = cross(Vec3f{1, 0, 0}, z);
  x = normalized(x);
  return {x, cross(z, x), z, origin};
}

// The same mesh under the same transform of its texture coordinates.
using UvKey = std::tuple<const Mesh*, float, float, float, float, float>;

class Writer {
 public:
  explicit Writer(const render::Scene& scene) : scene_(scene), materials_(buffer_) {}

  Bytes write(std::span<const GltfCamera> cameras, Vec3 origin) {
    for (std::size_t i = 0; i < scene_.instances.size(); ++i) addInstance(scene_.instances[i], i);
    addLights();
    for (const GltfCamera& camera : cameras) addCamera(camera);
    return join(origin);
  }

 private:
  void addNode(Json node) {
    children_.push_back(nodes_.size());
    nodes_.push_back(std::move(node));
  }

  void addInstance(const render::Instance& instance, std::size_t number) {
    if (!usable(instance.transform)) return;
    std::shared_ptr<const Mesh> mesh = scene_.meshes[instance.mesh];
    Transformf placed = instance.transform;
    if (!square(placed)) {
      auto moved = std::make_shared<Mesh>();
      append(*moved, *mesh, placed);
      placedMeshes_.push_back(moved);
      mesh = moved;
      placed = {};
    }
    const std::optional<std::size_t> index = meshOf(*mesh, instance.surfaces);
    if (!index) return;
    Json node{{"name", fmt::format("part {}", number + 1)}, {"mesh", *index}};
    if (!(placed == Transformf{})) node["matrix"] = matrix(placed);
    addNode(std::move(node));
  }

  // None where the mesh has no triangles.
  std::optional<std::size_t> meshOf(const Mesh& mesh, const std::vector<std::uint32_t>& surfaces) {
    const auto [it, isNew] = meshes_.try_emplace({&mesh, surfaces});
    if (!isNew) return it->second;
    const auto& bySlot = indicesOf(mesh);
    Json primitives = Json::array();
    for (const auto& [slot, indices] : bySlot) {
      if (slot >= surfaces.size()) continue;
      const render::Surface& surface = scene_.surfaces[surfaces[slot]];
      Json attributes{{"POSITION", positionsOf(mesh)}};
      if (const auto normals = normalsOf(mesh)) attributes["NORMAL"] = *normals;
      if (!mesh.uvs.empty() && hasMaps(surface)) attributes["TEXCOORD_0"] = uvsOf(mesh, surface);
      primitives.push_back({{"attributes", std::move(attributes)},
                            {"indices", indices},
                            {"material", materials_.indexOf(surface, !mesh.uvs.empty())}});
    }
    if (primitives.empty()) return it->second;
    it->second = meshList_.size();
    meshList_.push_back({{"primitives", std::move(primitives)}});
    return it->second;
  }

  const std::map<std::uint32_t, std::size_t>& indicesOf(const Mesh& mesh) {
    const auto [it, isNew] = indices_.try_emplace(&mesh);
    if (!isNew) return it->second;
    std::map<std::uint32_t, std::vector<std::uint32_t>> corners;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      corners[mesh.slotOf(t)].insert(corners[mesh.slotOf(t)].end(), mesh.triangles[t].begin(),
                                     mesh.triangles[t].end());
    for (const auto& [slot, list] : corners) it->second[slot] = buffer_.addIndices(list);
    return it->second;
  }

  std::size_t positionsOf(const Mesh& mesh) {
    const auto [it, isNew] = positions_.try_emplace(&mesh);
    if (isNew) it->second = buffer_.addPositions(mesh.positions);
    return it->second;
  }

  std::optional<std::size_t> normalsOf(const Mesh& mesh) {
    if (mesh.normals.empty()) return std::nullopt;
    const auto [it, isNew] = normals_.try_emplace(&mesh);
    if (!isNew) return it->second;
    std::vector<Vec3f> unit = mesh.normals;
    for (Vec3f& n : unit) {
      const float l = length(n);
      n = l > 1e-20f && std::isfinite(l) ? n * (1 / l) : Vec3f{0, 0, 1};
    }
    return it->second = buffer_.addVectors(std::span<const Vec3f>(unit));
  }

  // glTF's v runs down; scale, turn and shift of a surface's maps are written into the coordinates.
  std::size_t uvsOf(const Mesh& mesh, const render::Surface& s) {
    const UvKey key{&mesh, s.uvScale.x, s.uvScale.y, s.uvOffset.x, s.uvOffset.y, s.uvRotation};
    const auto [it, isNew] = uvs_.try_emplace(key);
    if (!isNew) return it->second;
    const float c = std::cos(s.uvRotation), n = std::sin(s.uvRotation);
    std::vector<Vec2f> moved = mesh.uvs;
    for (Vec2f& uv : moved) {
      const Vec2f p{uv.x * s.uvScale.x, uv.y * s.uvScale.y};
      const Vec2f q{c * p.x - n * p.y + s.uvOffset.x, n * p.x + c * p.y + s.uvOffset.y};
      uv = std::isfinite(q.x + q.y) ? Vec2f{q.x, 1 - q.y} : Vec2f{};
    }
    return it->second = buffer_.addVectors(std::span<const Vec2f>(moved));
  }

  void addLight(Json light, const Transformf& placed, std::string name) {
    addNode({{"name", std::move(name)},
             {"matrix", matrix(placed)},
             {"extensions", {{"KHR_lights_punctual", {{"light", lights_.size()}}}}}});
    lights_.push_back(std::move(light));
  }

  static Json color(Rgb c, float strongest) { return {c.x / strongest, c.y / strongest, c.z / strongest}; }

  void addLights() {
    for (const render::Lamp& lamp : scene_.lamps) {
      const float strongest = maxComponent(lamp.intensity);
      if (!(strongest > 0) || !std::isfinite(strongest)) continue;
      const std::string name = lamp.lightGroup < scene_.lightGroups.size()
                                   ? scene_.lightGroups[lamp.lightGroup].name
                                   : std::string("lamp");
      const bool spot = lamp.beamAngle > 0 || lamp.lambertian;
      Json light{{"name", name},
                 {"type", spot ? "spot" : "point"},
                 {"color", color(lamp.intensity, strongest)},
                 {"intensity", strongest}};
      if (spot) {
        const float half = 0.5f * std::numbers::pi_v<float>;
        const float outer = lamp.lambertian ? half : std::min(lamp.beamAngle, half);
        light["spot"] = {{"innerConeAngle", 0.0f}, {"outerConeAngle", outer}};
      }
      if (lamp.radius > 0) light["extras"] = {{"radius", lamp.radius}};
      addLight(std::move(light), lookingAlong(lamp.axis, {0, 1, 0}, lamp.position), name);
    }
    const float strongest = maxComponent(scene_.sun.illuminance);
    if (strongest > 0 && std::isfinite(strongest)) {
      addLight({{"name", "sun"},
                {"type", "directional"},
                {"color", color(scene_.sun.illuminance, strongest)},
                {"intensity", strongest},
                {"extras", {{"angularRadius", scene_.sun.angularRadius}}}},
               lookingAlong(-scene_.sun.direction, {0, 0, 1}, {}), "sun");
    }
  }

  void addCamera(const GltfCamera& named) {
    const render::Camera& c = named.camera;
    const double aspect = named.aspect;
    Json camera{{"name", named.name}};
    if (c.projection == render::Projection::Perspective) {
      const double vertical = 2 * std::atan(std::tan(0.5 * static_cast<double>(c.horizontalFov)) / aspect);
      camera["type"] = "perspective";
      camera["perspective"] = {{"yfov", vertical}, {"aspectRatio", aspect}, {"znear", 0.01}};
    } else if (c.projection == render::Projection::Orthographic) {
      const double half = 0.5 * static_cast<double>(c.orthographicWidth);
      camera["type"] = "orthographic";
      camera["orthographic"] = {{"xmag", half}, {"ymag", half / aspect}, {"znear", 0.01}, {"zfar", 1000.0}};
    } else {
      return;
    }
    addNode({{"name", named.name},
             {"matrix", matrix(lookingAlong(c.forward, c.up, c.eye))},
             {"camera", cameras_.size()}});
    cameras_.push_back(std::move(camera));
  }

  Bytes join(Vec3 origin) {
    const double h = std::sqrt(0.5);
    Json root{{"name", "home"}, {"rotation", {-h, 0.0, 0.0, h}}};
    if (origin.x != 0 || origin.y != 0 || origin.z != 0)
      root["translation"] = {origin.x, origin.z, -origin.y};
    if (!children_.empty()) root["children"] = children_;
    nodes_.push_back(std::move(root));

    Json json{{"asset", {{"version", "2.0"}, {"generator", "IDAP"}}},
              {"scene", 0},
              {"scenes", Json::array({{{"nodes", {nodes_.size() - 1}}}})},
              {"nodes", std::move(nodes_)}};
    const auto put = [&](const char* key, const Json& list) {
      if (!list.empty()) json[key] = list;
    };
    put("meshes", meshList_);
    put("cameras", cameras_);
    put("materials", materials_.materials());
    put("textures", materials_.textures());
    put("images", materials_.images());
    put("samplers", materials_.samplers());
    put("accessors", buffer_.accessors());
    put("bufferViews", buffer_.views());
    std::set<std::string> used = materials_.extensions();
    if (!lights_.empty()) {
      json["extensions"] = {{"KHR_lights_punctual", {{"lights", lights_}}}};
      used.insert("KHR_lights_punctual");
    }
    if (!used.empty()) json["extensionsUsed"] = used;
    if (!buffer_.data().empty()) json["buffers"] = Json::array({{{"byteLength", buffer_.data().size()}}});
    return container(json.dump(-1, ' ', false, Json::error_handler_t::replace), buffer_.data());
  }

  static Bytes container(std::string text, const Bytes& binary) {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::size_t padded = (binary.size() + 3) / 4 * 4;
    const std::size_t total = 12 + 8 + text.size() + (padded > 0 ? 8 + padded : 0);
    if (total > 0xffffffffu)
      throw Error(fmt::format("the home's shapes and pictures take {:.1f} GB, more than a .glb file can hold",
                              static_cast<double>(total) / (1 << 30)));
    Bytes out;
    out.reserve(total);
    const auto word = [&](std::size_t value) {
      for (unsigned shift = 0; shift < 32; shift += 8)
        out.push_back(static_cast<std::byte>((value >> shift) & 0xffu));
    };
    word(0x46546c67u), word(2), word(total);  // "glTF"
    word(text.size()), word(0x4e4f534au);     // "JSON"
    for (const char c : text) out.push_back(static_cast<std::byte>(c));
    if (padded > 0) {
      word(padded), word(0x004e4942u);  // "BIN"
      out.insert(out.end(), binary.begin(), binary.end());
      out.resize(total, std::byte{0});
    }
    return out;
  }

  const render::Scene& scene_;
  GlbBuffer buffer_;
  GltfMaterials materials_;
  Json nodes_ = Json::array(), children_ = Json::array(), meshList_ = Json::array(), cameras_ = Json::array(),
       lights_ = Json::array();
  std::vector<std::shared_ptr<const Mesh>> placedMeshes_;  // the maps below know meshes by address
  std::map<std::pair<const Mesh*, std::vector<std::uint32_t>>, std::optional<std::size_t>> meshes_;
  std::map<const Mesh*, std::map<std::uint32_t, std::size_t>> indices_;
  std::map<const Mesh*, std::size_t> positions_, normals_;
  std::map<UvKey, std::size_t> uvs_;
};

}  // namespace

Bytes writeGlb(const render::Scene& scene, std::span<const GltfCamera> cameras, Vec3 origin) {
  return Writer(scene).write(cameras, origin);
}

}  // namespace idap
