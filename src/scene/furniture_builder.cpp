#include "scene/furniture_builder.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/box_mapping.h"
#include "scene/lamp_builder.h"

namespace idap {

namespace {

constexpr double kThinnest = 1e-4;  // m; a size of 0 would make the transform singular
constexpr std::size_t kMostGroups = 4096;
constexpr std::size_t kNamed = 3;  // pieces named in a warning

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n"), last = text.find_last_not_of(" \t\r\n");
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

// A box with chamfered edges: what stands for a piece whose model cannot be had.
std::shared_ptr<const Mesh> unitBox() {
  auto mesh = std::make_shared<Mesh>();
  constexpr float b = 0.02f;
  // Eight corners, each cut into three points: one on each of its faces.
  const auto at = [&](int corner, int face) {
    Vec3f p{corner & 1 ? 0.5f : -0.5f, corner & 2 ? 0.5f : -0.5f, corner & 4 ? 1.0f : 0.0f};
    for (int axis = 0; axis < 3; ++axis) {
      if (axis != face) p[axis] += (corner >> axis & 1) ? -b : b;
    }
    return p;
  };
  const Vec3f middle{0, 0, 0.5f};
  const auto polygon = [&](std::initializer_list<Vec3f> points) {
    const auto base = static_cast<std::uint32_t>(mesh->positions.size());
    mesh->positions.insert(mesh->positions.end(), points);
    const Vec3f a = mesh->positions[base], c = mesh->positions[base + 2];
    const bool flip = dot(cross(mesh->positions[base + 1] - a, c - a), a - middle) < 0;
    for (std::uint32_t i = 1; i + 1 < points.size(); ++i) {
      if (flip) {
        mesh->triangles.push_back({base, base + i + 1, base + i});
      } else {
        mesh->triangles.push_back({base, base + i, base + i + 1});
      }
    }
  };
  for (int face = 0; face < 3; ++face) {
    const int u = 1 << ((face + 1) % 3), v = 1 << ((face + 2) % 3), w = 1 << face;
    for (const int side : {0, w})
      polygon({at(side, face), at(side | u, face), at(side | u | v, face), at(side | v, face)});
    // The edges along axis `face`.
    const int faceU = (face + 1) % 3, faceV = (face + 2) % 3;
    for (const int corner : {0, u, v, u | v}) {
      polygon({at(corner, faceU), at(corner | w, faceU), at(corner | w, faceV), at(corner, faceV)});
    }
  }
  for (int corner = 0; corner < 8; ++corner) polygon({at(corner, 0), at(corner, 1), at(corner, 2)});
  return mesh;
}

Material boxMaterial() {
  Material m;
  m.name = "missing model";
  m.color = {0.75f, 0.75f, 0.75f};
  m.roughness = 0.7;
  return m;
}

}  // namespace

std::uint32_t FurnitureBuilder::addSurface(render::Surface surface) {
  built_.scene->surfaces.push_back(std::move(surface));
  return static_cast<std::uint32_t>(built_.scene->surfaces.size() - 1);
}

std::uint32_t FurnitureBuilder::meshIndex(const std::shared_ptr<const Mesh>& mesh) {
  const auto [at, added] =
      meshes_.try_emplace(mesh.get(), static_cast<std::uint32_t>(built_.scene->meshes.size()));
  if (added) built_.scene->meshes.push_back(mesh);
  return at->second;
}

std::vector<std::uint32_t> FurnitureBuilder::surfacesOf(const SurfaceModel& model, const Piece& piece,
                                                        bool& needsMapping, std::vector<bool>& mappedSlots) {
  SlotFinishes bySlot;
  for (const auto& [name, finish] : piece.slotFinishes) bySlot.emplace(trimmed(name), finish);
  std::vector<std::uint32_t> result;
  mappedSlots.assign(model.slots.size(), false);
  needsMapping = false;
  for (std::size_t i = 0; i < model.slots.size(); ++i) {
    const SurfaceModel::Slot& slot = model.slots[i];
    const auto own = bySlot.find(trimmed(slot.name));
    if (piece.finish.empty() && own == bySlot.end()) {
      const auto [at, added] = plain_.try_emplace({&model, i}, 0);
      if (added) {
        render::Surface surface = toSurface(slot.material, surfaces_.textures());
        surface.name = slot.name;
        at->second = addSurface(std::move(surface));
      }
      result.push_back(at->second);
    } else {
      Material material = slot.material;
      if (!piece.finish.empty()) material = surfaces_.finished(material, piece.finish);
      if (own != bySlot.end()) material = surfaces_.finished(material, own->second);
      // Pictures in metres need coordinates in metres.
      const bool inMetres = material.texture && material.texture->size.x > 0 && material.texture->size.y > 0;
      if (inMetres && (!slot.material.texture || slot.material.texture->bytes != material.texture->bytes)) {
        mappedSlots[i] = needsMapping = true;
      }
      render::Surface surface = toSurface(material, surfaces_.textures());
      surface.name = slot.name;
      result.push_back(addSurface(std::move(surface)));
    }
  }
  if (result.empty()) result.push_back(addSurface(toSurface(boxMaterial(), surfaces_.textures())));
  return result;
}

std::optional<FurnitureBuilder::Placed> FurnitureBuilder::place(ElementId id, const Piece& piece,
                                                                bool boxIfMissing) {
  if (!isFinite(piece.position) || !isFinite(piece.size)) return std::nullopt;
  const ModelCache::Entry& entry = models_.get(piece);
  Placed placed;
  placed.size = {std::max(piece.size.x, kThinnest), std::max(piece.size.y, kThinnest),
                 std::max(piece.size.z, kThinnest)};
  placed.pieceToScene =
      Transform::translation(Vec3{0, 0, elevationOf(home_, piece.level)} - built_.centre) * placement(piece);
  const bool missing = !entry.model;
  if (missing) {
    if (!entry.problem.empty()) {
      Problem& problem = problems_[entry.problem + (boxIfMissing ? "; a box stands in its place" : "")];
      if (problem.count++ < kNamed) problem.names.push_back(piece.name.empty() ? "a piece" : piece.name);
    }
    if (!boxIfMissing) return std::nullopt;
    if (!memory_.missingModel) memory_.missingModel = unitBox();
    placed.mesh = memory_.missingModel;
  } else {
    placed.model = entry.model.get();
    placed.mesh = entry.mesh;
  }
  const bool unit = missing || entry.model->unitBox;
  placed.meshToScene = unit ? placed.pieceToScene * Transform::scaling(placed.size) : placed.pieceToScene;

  render::Instance instance;
  if (missing) {
    instance.surfaces = {addSurface(surfaces_.surface(boxMaterial(), piece.finish))};
  } else {
    bool needsMapping = false;
    std::vector<bool> mappedSlots;
    instance.surfaces = surfacesOf(*entry.model, piece, needsMapping, mappedSlots);
    if (needsMapping) {
      const Vec3 scale = unit ? placed.size : Vec3{1, 1, 1};
      std::string key =
          fmt::format("{} {} {} {} ", static_cast<const void*>(entry.mesh.get()), scale.x, scale.y, scale.z);
      for (const bool b : mappedSlots) key += b ? '1' : '0';
      placed.mesh = memory_.pieceMeshes.get(key, entry.mesh, [&] {
        return std::make_shared<const Mesh>(boxMapped(*entry.mesh, mappedSlots, scale));
      });
    }
  }
  instance.mesh = meshIndex(placed.mesh);
  instance.transform = toFloat(placed.meshToScene);
  instance.objectId = static_cast<std::uint32_t>(built_.objects.size());
  built_.objects.push_back(id);
  placed.instance = static_cast<std::uint32_t>(built_.scene->instances.size());
  built_.scene->instances.push_back(std::move(instance));
  return placed;
}

// Out of ceilings and walls that a source was drawn into a little.
Vec3 FurnitureBuilder::intoRoom(std::size_t storey, Vec3 point, double radius) const {
  Vec3 p = point + built_.centre;
  constexpr double kClear = 0.005;
  if (structure_ && structure_->rooms) {
    if (const auto ceiling = structure_->rooms->ceilingOver(storey, {p.x, p.y})) {
      if (p.z + radius > *ceiling - kClear && p.z < *ceiling + 0.4) p.z = *ceiling - kClear - radius;
    }
  }
  if (structure_) {
    for (const WallSolid& wall : structure_->walls) {
      const Vec2 q{p.x, p.y};
      if (wall.storey != storey || p.z < wall.bottom || p.z > wall.topAt(q) || !contains(wall.polygon, q))
        continue;
      double nearest = 1e300;
      Vec2 out = q;
      for (const auto& line : {wall.outline.left, wall.outline.right}) {
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
          const Vec2 d = line[i + 1] - line[i];
          const double t = dot(q - line[i], d) / std::max(dot(d, d), 1e-12);
          if (t < 0 || t > 1) continue;
          const Vec2 foot = line[i] + d * t;
          const double distance = length(foot - q);
          if (distance < nearest && distance > 1e-9) {
            nearest = distance;
            out = foot + (foot - q) * ((radius + kClear) / distance);
          }
        }
      }
      p.x = out.x, p.y = out.y;
    }
  }
  return p - built_.centre;
}

LampLight FurnitureBuilder::lightOf(const Furniture& piece, const Placed& placed,
                                    const LampOptions& options) const {
  const render::Scene& scene = *built_.scene;
  Fixture fixture;
  fixture.mesh = placed.model ? placed.mesh.get() : nullptr;
  fixture.meshToScene = placed.meshToScene;
  fixture.pieceToScene = placed.pieceToScene;
  fixture.size = placed.size;
  if (placed.model) {
    for (const Vec3& p : placed.model->lightPositions) {
      fixture.bulbs.push_back(placed.model->unitBox ? Vec3{p * placed.size} : p);
    }
  }
  std::vector<const render::Surface*> slots;
  for (const std::uint32_t s : scene.instances[placed.instance].surfaces) slots.push_back(&scene.surfaces[s]);
  return lampLight(*piece.lamp, fixture, slots, options);
}

// The fixture's mesh with slots of their own, from firstSlot on, for the parts that shine.
std::shared_ptr<const Mesh> FurnitureBuilder::glowingMesh(const Placed& placed, const LampLight& light,
                                                          std::uint32_t firstSlot) {
  std::vector<std::uint32_t> slots(placed.mesh->triangles.size());
  for (std::size_t t = 0; t < slots.size(); ++t) slots[t] = placed.mesh->slotOf(t);
  for (const LampLight::Glow& glow : light.glows) {
    for (const std::uint32_t t : glow.triangles) slots[t] = firstSlot;
    ++firstSlot;
  }
  std::string key = fmt::format("{} ", static_cast<const void*>(placed.mesh.get()));
  key.append(reinterpret_cast<const char*>(slots.data()), slots.size() * sizeof slots[0]);
  return memory_.pieceMeshes.get(key, placed.mesh, [&] {
    Mesh mesh = *placed.mesh;
    mesh.slots = std::move(slots);
    return std::make_shared<const Mesh>(std::move(mesh));
  });
}

void FurnitureBuilder::addLight(FurnitureId id, const std::shared_ptr<const Furniture>& piece,
                                const Placed& placed, double lumens) {
  render::Scene& scene = *built_.scene;
  LampOptions options;
  options.lumens = lumens;
  if (scene.lightGroups.size() < kMostGroups) {
    built_.lamps.resize(scene.lightGroups.size());
    built_.lamps.push_back(id);
    options.lightGroup = static_cast<std::uint16_t>(scene.lightGroups.size());
    const auto& sources = piece->lamp->sources;
    scene.lightGroups.push_back(
        {piece->name.empty() ? "lamp" : piece->name,
         lampColor(*piece->lamp, sources.empty() ? std::optional<Color>() : sources.front().color)});
  } else {
    options.lightGroup = static_cast<std::uint16_t>(kMostGroups - 1);
  }
  const std::size_t storey = storeyOf(storeys_, piece->level);

  // Where light leaves a fixture takes many rays to find out.
  SceneMemory::LampEntry& known = memory_.lamps[id];
  if (known.piece != piece || known.mesh != placed.mesh || known.meshToScene != placed.meshToScene ||
      known.lumens != lumens) {
    known = {piece, placed.mesh, placed.meshToScene, lumens, lightOf(*piece, placed, options)};
  }
  const LampLight& light = known.light;
  for (render::Lamp bulb : light.bulbs) {
    bulb.lightGroup = options.lightGroup;
    bulb.position = toFloat(intoRoom(storey, toDouble(bulb.position), double(bulb.radius)));
    scene.lamps.push_back(bulb);
  }
  render::Instance& instance = scene.instances[placed.instance];
  instance.lightGroup = options.lightGroup;
  for (std::size_t slot = 0; slot < light.slotTranslucent.size(); ++slot) {
    if (!light.slotTranslucent[slot]) continue;
    render::Surface surface = scene.surfaces[instance.surfaces[slot]];
    surface.translucency = std::max(surface.translucency, 0.35f);
    instance.surfaces[slot] = addSurface(std::move(surface));
  }
  if (light.glows.empty()) return;
  instance.mesh = meshIndex(glowingMesh(placed, light, static_cast<std::uint32_t>(instance.surfaces.size())));
  for (const LampLight::Glow& glow : light.glows) {
    render::Surface surface = scene.surfaces[instance.surfaces[glow.slot]];
    surface.emission = glow.emission;
    instance.surfaces.push_back(addSurface(std::move(surface)));
  }
}

void FurnitureBuilder::add(FurnitureId id, const std::shared_ptr<const Furniture>& piece, LampPolicy lamps) {
  const auto placed = place(id, *piece, true);
  if (!placed || !piece->lamp || lamps == LampPolicy::Off) return;
  const bool on = piece->lamp->on || lamps == LampPolicy::On;
  if (on) addLight(id, piece, *placed, piece->lamp->lumens * std::clamp(piece->lamp->dimmer, 0.0, 1.0));
}

bool FurnitureBuilder::add(OpeningId id, const Opening& opening) {
  if (opening.kind == OpeningKind::Bare) return true;
  const auto placed = place(id, opening, false);
  if (!placed) return true;
  const render::Instance& instance = built_.scene->instances[placed->instance];
  return std::any_of(instance.surfaces.begin(), instance.surfaces.end(), [&](std::uint32_t s) {
    const render::Surface& surface = built_.scene->surfaces[s];
    return surface.transmission > 0.2f || surface.opacity < 0.8f;
  });
}

void FurnitureBuilder::tellProblems() {
  for (const auto& [what, problem] : problems_) {
    const std::size_t others = problem.count - problem.names.size();
    built_.warnings.push_back(fmt::format("\"{}\"{}: {}", fmt::join(problem.names, "\", \""),
                                          others > 0 ? fmt::format(" and {} more", others) : "", what));
  }
  problems_.clear();
}

}  // namespace idap
