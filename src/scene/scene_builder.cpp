#include "scene/scene_builder.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <set>

#include "light/daylight.h"
#include "light/sun_position.h"
#include "scene/furniture_builder.h"
#include "scene/ground_builder.h"
#include "scene/wall_builder.h"

namespace idap {

namespace {

constexpr double kGroundBelow = 0.015;  // m, of the land below the ground floor
constexpr float kGroundGrey = 0.55f;    // share of grey that is mixed into the land's colour

Box2 planBounds(const Home& home, const std::vector<WallSolid>& walls) {
  Box2 box;
  for (const WallSolid& wall : walls) box.add(wall.box.min), box.add(wall.box.max);
  for (const auto& [id, room] : home.rooms) {
    for (const Vec2& p : room->points) {
      if (isFinite(p)) box.add(p);
    }
  }
  if (!box.empty()) return box;
  for (const auto& [id, piece] : home.furniture) {
    if (isFinite(piece->position)) box.add({piece->position.x, piece->position.y});
  }
  for (const auto& [id, opening] : home.openings) {
    if (isFinite(opening->position)) box.add({opening->position.x, opening->position.y});
  }
  if (box.empty()) box.add({0, 0});
  return box;
}

// Storeys that are only a lid: floors, and nothing that stands on them. Left out of views from above.
void dropLids(const Home& home, std::vector<Storey>& storeys) {
  const auto inUse = [&](LevelId level) {
    const auto on = [&](const auto& entry) { return entry.second->level == level; };
    return std::any_of(home.walls.begin(), home.walls.end(), on) ||
           std::any_of(home.furniture.begin(), home.furniture.end(), on);
  };
  while (storeys.size() > 1 && !inUse(storeys.back().id)) storeys.pop_back();
}

// One build, its parts in the order in which they need each other.
class Build {
 public:
  Build(const Home& home, const Catalog& catalog, const BuildOptions& options, const Progress& progress)
      : home_(home),
        options_(options),
        progress_(progress),
        storeys_(storeysOf(home, options)),
        walls_(wallSolids(home, storeys_)),
        openings_(openingCuts(home, storeys_)),
        models_(home, catalog),
        surfaces_(home, textures_) {
    built_.scene = std::make_shared<render::Scene>();
    built_.objects.emplace_back();
    const Box2 box = planBounds(home, walls_);
    const Vec2 middle = (box.min + box.max) / 2;
    built_.centre = {middle.x, middle.y, 0};
    extent_ = box;
  }

  BuiltScene run() {
    progress_.report(0.02, "reading models");
    loadModels();
    addDaylight();
    progress_.report(0.6, "building walls and rooms");
    const RoomBuilder rooms(home_, storeys_, walls_, openings_, options_.ceilings);
    progress_.check();
    addWalls();
    addRooms(rooms);
    if (options_.ground) addGround(rooms);
    progress_.check();
    progress_.report(0.8, "placing furniture");
    addPieces(rooms);
    const std::vector<std::string>& pictures = textures_.warnings();
    built_.warnings.insert(built_.warnings.end(), pictures.begin(), pictures.end());
    for (const auto& mesh : built_.scene->meshes) built_.triangles += mesh->triangles.size();
    progress_.report(1, "done");
    return std::move(built_);
  }

 private:
  static std::vector<Storey> storeysOf(const Home& home, const BuildOptions& options) {
    std::vector<Storey> storeys = shownStoreys(home, options.hiddenLevels.value_or(options.ceilings));
    if (!options.ceilings) dropLids(home, storeys);
    return storeys;
  }
  bool isOnShownStorey(const Piece& piece) const { return isShownOn(home_, storeys_, piece); }

  std::uint32_t addSurface(render::Surface surface) {
    built_.scene->surfaces.push_back(std::move(surface));
    return static_cast<std::uint32_t>(built_.scene->surfaces.size() - 1);
  }
  void addOwnMesh(std::shared_ptr<const Mesh> mesh, std::vector<std::uint32_t> surfaces, ElementId id) {
    render::Instance instance;
    instance.mesh = static_cast<std::uint32_t>(built_.scene->meshes.size());
    instance.surfaces = std::move(surfaces);
    instance.objectId = static_cast<std::uint32_t>(built_.objects.size());
    built_.objects.push_back(id);
    built_.scene->meshes.push_back(std::move(mesh));
    built_.scene->instances.push_back(std::move(instance));
  }

  void loadModels() {
    std::vector<const Piece*> pieces;
    for (const auto& [id, piece] : home_.furniture) {
      if (isOnShownStorey(*piece)) pieces.push_back(piece.get());
    }
    for (const auto& [id, opening] : home_.openings) {
      if (isOnShownStorey(*opening) && opening->kind != OpeningKind::Bare) pieces.push_back(opening.get());
    }
    tbb::parallel_invoke([&] { models_.prepare(pieces, progress_); }, [&] { paintMaterials(pieces); });
    std::vector<TextureCache::Request> pictures;
    const auto wantOf = [&](const Material& m) {
      pictures.push_back(colorPicture(m));
      if (m.normalMap) pictures.push_back({m.normalMap->bytes, m.normalMap->name, false, nullptr});
    };
    const auto want = [&](const Finish& finish) {
      if (const Material* m = finish.material.empty() ? nullptr : findMaterial(finish.material)) wantOf(*m);
      if (!finish.texture) return;
      if (const auto t = surfaces_.texture(*finish.texture))
        pictures.push_back({t->bytes, t->name, true, nullptr});
    };
    for (const Piece* piece : pieces) {
      want(piece->finish);
      for (const auto& [name, finish] : piece->slotFinishes) want(finish);
      const ModelCache::Entry& entry = models_.get(*piece);
      if (!entry.model) continue;
      for (const SurfaceModel::Slot& slot : entry.model->slots) wantOf(slot.material);
    }
    for (const WallSolid& wall : walls_) want(wall.wall->left.finish), want(wall.wall->right.finish);
    for (const auto& [id, room] : home_.rooms) want(room->floor), want(room->ceiling);
    want(home_.environment.ground);
    textures_.prepare(pictures);
    progress_.check();
  }

  // Has the catalog make the pictures of its materials that finishes name, all at once.
  void paintMaterials(const std::vector<const Piece*>& pieces) const {
    constexpr std::string_view kCatalog = "catalog:";
    std::set<std::string> ids;
    const auto want = [&](const Finish& finish) {
      if (!finish.material.empty()) ids.insert(finish.material);
      if (finish.texture && finish.texture->asset.starts_with(kCatalog)) {
        ids.insert(finish.texture->asset.substr(kCatalog.size()));
      }
    };
    for (const auto& [id, room] : home_.rooms) want(room->floor), want(room->ceiling);
    for (const WallSolid& wall : walls_) {
      for (const WallSide* side : {&wall.wall->left, &wall.wall->right}) {
        want(side->finish);
        if (side->baseboard) want(side->baseboard->finish);
      }
      want(wall.wall->top);
    }
    for (const Piece* piece : pieces) {
      want(piece->finish);
      for (const auto& [name, finish] : piece->slotFinishes) want(finish);
    }
    want(home_.environment.ground);
    const std::vector<std::string> all(ids.begin(), ids.end());
    tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) { findMaterial(all[i]); });
  }

  void addWalls() {
    const WallBuilder builder(home_, walls_, openings_);
    std::vector<std::shared_ptr<const Mesh>> meshes(walls_.size());
    tbb::parallel_for(std::size_t{0}, walls_.size(),
                      [&](std::size_t i) { meshes[i] = builder.build(i, built_.centre); });
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      if (!meshes[i]) continue;
      const Wall& wall = *walls_[i].wall;
      const double l = length(wall.end - wall.start);
      const Box2 area{{0, 0}, {l, std::max(wall.heightAtStart, wall.heightAtEnd)}};
      const auto side = [&](const WallSide& s) {
        return surfaces_.surface(SurfaceMapper::paint(), s.finish, area);
      };
      const auto board = [&](const WallSide& s) {
        const Finish& own = s.baseboard && !s.baseboard->finish.empty() ? s.baseboard->finish : s.finish;
        return surfaces_.surface(SurfaceMapper::paint(), own, area);
      };
      addOwnMesh(std::move(meshes[i]),
                 {addSurface(side(wall.left)), addSurface(side(wall.right)),
                  addSurface(surfaces_.surface(SurfaceMapper::paint(), wall.top)),
                  addSurface(board(wall.left)), addSurface(board(wall.right))},
                 walls_[i].id);
    }
  }

  void addRooms(const RoomBuilder& rooms) {
    std::vector<std::shared_ptr<const Mesh>> meshes(rooms.rooms().size());
    tbb::parallel_for(std::size_t{0}, meshes.size(),
                      [&](std::size_t i) { meshes[i] = rooms.build(i, built_.centre); });
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      if (!meshes[i]) continue;
      const RoomBuilder::Room& room = rooms.rooms()[i];
      const Box2 area = bounds(room.room->points);
      addOwnMesh(std::move(meshes[i]),
                 {addSurface(surfaces_.surface(SurfaceMapper::flooring(), room.room->floor, area)),
                  addSurface(surfaces_.surface(SurfaceMapper::paint(), room.room->ceiling, area)),
                  addSurface(surfaces_.surface(SurfaceMapper::paint(), {}))},
                 room.id);
    }
  }

  // The land, open where rooms lie below it.
  void addGround(const RoomBuilder& rooms) {
    Regions open;
    for (std::size_t s = 0; s < storeys_.size(); ++s) {
      if (storeys_[s].elevation < -kGroundBelow) open = unite(open, rooms.footprint(s));
    }
    Ground ground = buildGround(soil_, open, extent_, -kGroundBelow, horizon_, built_.centre);
    if (!ground.mesh) return;
    std::vector<std::uint32_t> surfaces;
    for (render::Surface& surface : ground.surfaces) surfaces.push_back(addSurface(std::move(surface)));
    addOwnMesh(std::move(ground.mesh), std::move(surfaces), {});
  }

  void addPieces(const RoomBuilder& rooms) {
    FurnitureBuilder builder(home_, storeys_, models_, surfaces_, built_);
    builder.setRooms(&rooms, &walls_);
    for (const auto& [id, piece] : home_.furniture) {
      if (isOnShownStorey(*piece)) builder.add(id, *piece, options_.lamps);
    }
    for (const auto& [id, opening] : home_.openings) {
      if (!isOnShownStorey(*opening)) continue;
      if (builder.add(id, *opening)) addPortal(id, rooms);
    }
    builder.tellProblems();
  }

  // A rectangle in the wall where an opening leads from indoors to outdoors.
  void addPortal(OpeningId id, const RoomBuilder& rooms) {
    const auto cut =
        std::find_if(openings_.begin(), openings_.end(), [&](const OpeningCut& o) { return o.id == id; });
    if (cut == openings_.end()) return;
    const double u = (cut->box.min.x + cut->box.max.x) / 2;
    for (const WallSolid& wall : walls_) {
      if (wall.storey != cut->storey || cutsOf(wall, {*cut}).empty()) continue;
      double low = 0, high = 0;
      if (!wallSpanAt(wall, *cut, u, low, high)) continue;
      const bool before = rooms.isIndoors(cut->storey, cut->plan(u, low - 0.3));
      const bool behind = rooms.isIndoors(cut->storey, cut->plan(u, high + 0.3));
      if (before == behind) continue;
      const double v = std::clamp((cut->v0 + cut->v1) / 2, low, high);
      const Vec2 corner = cut->plan(cut->box.min.x, v);
      const double z0 = std::max(cut->box.min.y, wall.floor);
      const double z1 = std::min(cut->box.max.y, wall.topAt(cut->plan(u, v)));
      if (z1 - z0 < 0.02) continue;
      render::Portal portal;
      portal.corner = toFloat(Vec3{corner.x, corner.y, z0} - built_.centre);
      const double width = cut->box.max.x - cut->box.min.x;
      portal.edgeU = toFloat(Vec3{cut->uAxis.x * width, cut->uAxis.y * width, 0});
      portal.edgeV = toFloat(Vec3{0, 0, z1 - z0});
      built_.scene->portals.push_back(portal);
      return;
    }
  }

  void addDaylight() {
    const Site& site = home_.site;
    const SunPosition sun = sunPosition(site.latitude, site.longitude, options_.time.value_or(site.time));
    DaylightConditions conditions;
    conditions.sunDirection = sunDirection(sun, site.north);
    conditions.weather = options_.cloudiness < 0.34   ? Weather::Clear
                         : options_.cloudiness < 0.75 ? Weather::Partly
                                                      : Weather::Overcast;
    Material soil = SurfaceMapper::paint();
    soil.color = {0.66f, 0.66f, 0.66f};
    soil.roughness = 0.95;
    soil_ = surfaces_.surface(soil, home_.environment.ground);
    // No grass or earth is as pure a colour as a screen can show; it would tint every ceiling.
    if (!soil_.baseColorMap) {
      const float grey = luminance(soil_.baseColor);
      soil_.baseColor = soil_.baseColor * (1 - kGroundGrey) + Rgb{grey, grey, grey} * kGroundGrey;
    }
    const Rgb albedo =
        soil_.baseColor * (soil_.baseColorMap ? meanReflectance(*soil_.baseColorMap) : Rgb{1, 1, 1});
    conditions.groundAlbedo = std::clamp(luminance(albedo), 0.03f, 0.6f);
    Daylight light = daylightFor(conditions);
    built_.scene->sun.direction = light.sunDirection;
    built_.scene->sun.illuminance = light.sunIlluminance;
    const Rgb falling = light.skyIlluminance + light.sunIlluminance * std::max(light.sunDirection.z, 0.0f);
    const auto row = static_cast<std::size_t>(light.width) * static_cast<std::size_t>(light.height / 2 - 1);
    for (std::size_t x = 0; x < static_cast<std::size_t>(light.width); ++x) {
      horizon_ += light.skyRadiance[row + x] * (float(kPi) / float(light.width));
    }
    for (int k = 0; k < 3; ++k)
      horizon_[k] = std::clamp(horizon_[k] / std::max(falling[k], 1e-6f), 0.0f, 0.9f);
    built_.scene->sky = {light.width, light.height, std::move(light.skyRadiance)};
  }

  const Home& home_;
  const BuildOptions& options_;
  const Progress& progress_;
  std::vector<Storey> storeys_;
  std::vector<WallSolid> walls_;
  std::vector<OpeningCut> openings_;
  ModelCache models_;
  TextureCache textures_;
  SurfaceMapper surfaces_;
  BuiltScene built_;
  Box2 extent_;  // of the plan
  render::Surface soil_;
  Rgb horizon_;  // reflectance of land that looks as bright as the sky over the horizon
};

}  // namespace

BuiltScene buildScene(const Home& home, const Catalog& catalog, const BuildOptions& options,
                      const Progress& progress) {
  return Build(home, catalog, options, progress).run();
}

}  // namespace idap
