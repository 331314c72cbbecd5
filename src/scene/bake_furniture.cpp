#include "scene/bake_furniture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <set>

#include "base/error.h"
#include "model/edits/arrange_edits.h"
#include "render/film/picture_file.h"
#include "scene/scene_builder.h"

namespace idap {

namespace {

SharedBytes bytesOf(const std::string& text) {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return std::make_shared<const Bytes>(first, first + text.size());
}

// What a slot's name may be in an OBJ: without blanks.
std::string plainName(const std::string& name) {
  std::string plain;
  for (const char c : name) plain += std::isspace(static_cast<unsigned char>(c)) || c == '#' ? '_' : c;
  return plain.empty() ? "part" : plain;
}

// The colour that is drawn as this reflectance: SurfaceMapper's way back.
Color encoded(Rgb reflectance, bool diffuse) {
  const auto channel = [diffuse](float r) {
    constexpr float k = 0.18f;
    const float linear =
        diffuse ? (1 - std::sqrt(std::max(0.0f, 1 - 4 * k * std::min(r, 0.82f)))) / (2 * k) : r;
    return linearToSrgb(std::clamp(linear, 0.0f, 1.0f));
  };
  return {channel(reflectance[0]), channel(reflectance[1]), channel(reflectance[2])};
}

bool looksAlike(const render::Surface& a, const render::Surface& b) {
  return a.name == b.name && a.baseColor == b.baseColor && a.metalness == b.metalness &&
         a.roughness == b.roughness && a.transmission == b.transmission && a.opacity == b.opacity &&
         a.baseColorMap == b.baseColorMap && a.uvScale == b.uvScale && a.uvOffset == b.uvOffset &&
         a.uvRotation == b.uvRotation;
}

class Baker {
 public:
  explicit Baker(const BuiltScene& built) : built_(built) {}

  void add(const render::Instance& instance) {
    const Mesh& mesh = *built_.scene->meshes[instance.mesh];
    const Transformf& t = instance.transform;
    const Transformf cofactor = t.cofactor();
    const float sign = t.determinant() < 0 ? -1.0f : 1.0f;
    const std::size_t first = positions_.size();
    for (const Vec3f& p : mesh.positions) positions_.push_back(t.point(p));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const std::uint32_t slot = mesh.slotOf(i);
      if (slot >= instance.surfaces.size()) continue;
      const std::size_t material = materialOf(built_.scene->surfaces[instance.surfaces[slot]]);
      Triangle triangle;
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t v = mesh.triangles[i][std::size_t(k)];
        triangle.position[k] = first + v;
        if (!mesh.normals.empty())
          triangle.normal[k] = normal(normalized(cofactor.vector(mesh.normals[v]) * sign));
        if (!mesh.uvs.empty()) triangle.uv[k] = uv(mesh.uvs[v], materials_[material]);
      }
      if (t.determinant() < 0)
        std::swap(triangle.position[1], triangle.position[2]),
            std::swap(triangle.normal[1], triangle.normal[2]), std::swap(triangle.uv[1], triangle.uv[2]);
      triangles_[material].push_back(triangle);
    }
  }

  bool empty() const { return triangles_.empty(); }
  Box3f bounds() const {
    Box3f box;
    for (const auto& [material, list] : triangles_)
      for (const Triangle& t : list)
        for (const std::size_t p : t.position) box.add(positions_[p]);
    return box;
  }

  void write(BakedFurniture& baked, const Box3f& box) const {
    std::string obj = "mtllib model.mtl\n", mtl;
    const Vec3f base{(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2, box.min.z};
    const auto out = std::back_inserter(obj);
    for (const Vec3f& p : positions_) {
      const Vec3f q = p - base;
      fmt::format_to(out, "v {:.6g} {:.6g} {:.6g}\n", q.x, q.z, -q.y);
    }
    for (const Vec2f& t : uvs_) fmt::format_to(out, "vt {:.6g} {:.6g}\n", t.x, t.y);
    for (const Vec3f& n : normals_) fmt::format_to(out, "vn {:.5g} {:.5g} {:.5g}\n", n.x, n.z, -n.y);
    std::set<std::string> taken;
    std::map<const render::Texture*, std::string> pictures;
    for (std::size_t m = 0; m < materials_.size(); ++m) {
      const auto list = triangles_.find(m);
      if (list == triangles_.end()) continue;
      const render::Surface& s = materials_[m];
      std::string name = plainName(s.name);
      for (int n = 2; !taken.insert(name).second; ++n) name = fmt::format("{}-{}", plainName(s.name), n);
      baked.slots.push_back(name);
      fmt::format_to(out, "usemtl {}\n", name);
      for (const Triangle& t : list->second) {
        obj += 'f';
        for (int k = 0; k < 3; ++k) {
          fmt::format_to(out, " {}", t.position[k] + 1);
          if (t.uv[k] > 0 || t.normal[k] > 0) obj += '/';
          if (t.uv[k] > 0) fmt::format_to(out, "{}", t.uv[k]);
          if (t.normal[k] > 0) fmt::format_to(out, "/{}", t.normal[k]);
        }
        obj += '\n';
      }
      writeMaterial(mtl, name, s, pictures, baked);
    }
    baked.main = "model.obj";
    baked.files["model.obj"] = bytesOf(obj);
    baked.files["model.mtl"] = bytesOf(mtl);
  }

 private:
  struct Triangle {
    std::size_t position[3]{};
    std::size_t normal[3]{}, uv[3]{};  // from 1; 0: none
  };

  std::size_t materialOf(const render::Surface& surface) {
    for (std::size_t i = 0; i < materials_.size(); ++i)
      if (looksAlike(materials_[i], surface)) return i;
    materials_.push_back(surface);
    return materials_.size() - 1;
  }
  std::size_t normal(Vec3f n) {
    normals_.push_back(n);
    return normals_.size();
  }
  // As the renderer places the picture, so that a plain reader does so too.
  std::size_t uv(Vec2f t, const render::Surface& s) {
    const float c = std::cos(-s.uvRotation), d = std::sin(-s.uvRotation);
    const Vec2f turned{t.x * c - t.y * d, t.x * d + t.y * c};
    uvs_.push_back({turned.x * s.uvScale.x - s.uvOffset.x, turned.y * s.uvScale.y - s.uvOffset.y});
    return uvs_.size();
  }

  static void writeMaterial(std::string& mtl, const std::string& name, const render::Surface& s,
                            std::map<const render::Texture*, std::string>& pictures, BakedFurniture& baked) {
    const bool diffuse = s.metalness < 0.5f && s.transmission < 0.5f;
    const Color c = encoded(s.baseColor, diffuse);
    // Polished as strongly as it is smooth: roughnessOfPhong()'s way back.
    const float alpha = std::max(0.02f, s.roughness);
    const double exponent = std::clamp(2 / std::pow(double(alpha), 4) - 2, 0.0, 1000.0);
    const double specular = s.roughness > 0.85f ? 0 : s.metalness > 0.5f ? 0.9 : 0.3;
    const double opacity = s.opacity * (1 - 0.85 * double(s.transmission));
    fmt::format_to(
        std::back_inserter(mtl),
        "newmtl {}\nKd {:.4f} {:.4f} {:.4f}\nKs {:.3f} {:.3f} {:.3f}\nNs {:.1f}\nd {:.3f}\nillum 2\n", name,
        c.r, c.g, c.b, specular, specular, specular, exponent, opacity);
    if (!s.baseColorMap) return;
    std::string& file = pictures[s.baseColorMap.get()];
    if (file.empty()) {
      file = fmt::format("picture{}.png", pictures.size());
      Image8 image(s.baseColorMap->width, s.baseColorMap->height);
      for (std::size_t i = 0; i < image.rgb.size() / 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) image.rgb[3 * i + k] = s.baseColorMap->rgba[4 * i + k];
      baked.files[file] = std::make_shared<const Bytes>(render::encodePicture(image, "png"));
    }
    mtl += fmt::format("map_Kd {}\n", file);
  }

  const BuiltScene& built_;
  std::vector<Vec3f> positions_, normals_;
  std::vector<Vec2f> uvs_;
  std::vector<render::Surface> materials_;
  std::map<std::size_t, std::vector<Triangle>> triangles_;  // by material
};

// Turned so that the largest of the pieces looks to the front: a wardrobe that stood along a side wall is as
// wide and as deep as it was before it was turned there.
Home straightened(const Home& part) {
  double largest = 0, angle = 0;
  Elements all;
  const auto add = [&](const auto& table, auto& ids) {
    for (const auto& [id, piece] : table) {
      ids.push_back(id);
      if (const double volume = piece->size.x * piece->size.y * piece->size.z; volume > largest)
        largest = volume, angle = piece->angle;
    }
  };
  add(part.furniture, all.furniture);
  add(part.openings, all.openings);
  return angle == 0 ? part : turnElements(part, all, {}, -angle);
}

}  // namespace

BakedFurniture bakeFurniture(const Home& home, const Catalog& catalog, const Elements& elements,
                             const Progress& progress) {
  Elements chosen;
  chosen.groups = elements.groups;
  chosen.furniture = elements.furniture;
  chosen.openings = elements.openings;
  Home part = straightened(extractElements(home, chosen));
  // Unlit, and on the floor that they stand on.
  for (const auto& [id, level] : part.levels) {
    Level flat = *level;
    flat.visible = flat.viewable = true;
    part.levels.set(id, flat);
  }
  BuildOptions options;
  options.ground = false;
  options.lamps = LampPolicy::Off;
  const BuiltScene built = buildScene(part, catalog, options, progress);
  Baker baker(built);
  for (const render::Instance& instance : built.scene->instances) {
    const ElementId& id = built.objects[instance.objectId];
    if (std::holds_alternative<FurnitureId>(id) || std::holds_alternative<OpeningId>(id)) baker.add(instance);
    progress.check();
  }
  if (baker.empty()) throw Error("nothing of what is selected has a shape that could be saved");
  const Box3f box = baker.bounds();
  BakedFurniture baked;
  baked.size = toDouble(box.size());
  baker.write(baked, box);
  const Vec3 low = toDouble(box.min) + built.centre;
  double floor = low.z;
  if (!part.furniture.empty()) floor = elevationOf(part, part.furniture.begin()->second->level);
  baked.elevation = std::max(0.0, low.z - floor);
  for (const auto& [id, piece] : part.furniture) {
    if (!piece->lamp) continue;
    if (!baked.lamp) {
      baked.lamp = *piece->lamp;
      baked.lamp->sources.clear();
    }
    std::vector<LightSource> sources = piece->lamp->sources;
    if (sources.empty()) sources.push_back({.position = {0.5, 0.5, 0.5}});
    for (LightSource source : sources) {
      const Vec3 inPiece = (source.position - Vec3{0.5, 0.5, 0}) * piece->size;
      const Vec3 world = placement(*piece).point(inPiece) + Vec3{0, 0, elevationOf(part, piece->level)};
      for (int k = 0; k < 3; ++k)
        source.position[k] = std::clamp((world[k] - low[k]) / std::max(baked.size[k], 1e-6), 0.0, 1.0);
      baked.lamp->sources.push_back(source);
    }
  }
  return baked;
}

}  // namespace idap
