#include "scene/scene_builder.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <set>

#include "light/daylight.h"
#include "light/sun_position.h"
#include "model/diff.h"
#include "model/edits/finish_edits.h"
#include "scene/furniture_builder.h"
#include "scene/ground_builder.h"
#include "scene/scene_memory.h"
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

bool sameMesh(const Mesh& a, const Mesh& b) {
  return a.positions == b.positions && a.normals == b.normals && a.uvs == b.uvs &&
         a.triangles == b.triangles && a.slots == b.slots;
}

using MeshPtr = std::shared_ptr<const Mesh>;

// A mesh that came out as it was stays the same one in memory.
void keepEqual(MeshPtr& mesh, const MeshPtr& before) {
  if (mesh && before && sameMesh(*mesh, *before)) mesh = before;
}

constexpr double kNear = 50;         // m that a home may move before the scene's centre follows
constexpr double kBesideWall = 0.3;  // m from a wall's face, where it is indoors or not

std::vector<Storey> storeysOf(const Home& home, bool ceilings, bool hiddenLevels) {
  std::vector<Storey> storeys = shownStoreys(home, hiddenLevels);
  if (!ceilings) dropLids(home, storeys);
  return storeys;
}

std::vector<std::shared_ptr<const Furniture>> stairsOf(const Home& home, const std::vector<Storey>& storeys) {
  std::vector<std::shared_ptr<const Furniture>> stairs;
  for (const auto& [id, piece] : home.furniture) {
    if (!piece->staircaseCutOut.empty() && isShownOn(home, storeys, *piece)) stairs.push_back(piece);
  }
  return stairs;
}

// Whether walls, rooms and openings of the home are those that the structure was made of.
bool isOf(const Structure& structure, const Home& home, bool hiddenLevels) {
  if (structure.hiddenLevels != hiddenLevels || structure.home.wallHeight != home.wallHeight) return false;
  const HomeDiff changes = diff(structure.home, home);
  if (!changes.levels.empty() || !changes.walls.empty() || !changes.rooms.empty() ||
      !changes.openings.empty() || !changes.groups.empty())
    return false;
  if (changes.furniture.empty()) return true;
  // Which storeys are shown may hang on furniture, and so may the plan's extent.
  if (structure.walls.empty() && structure.rooms->rooms().empty()) return false;
  const std::vector<Storey> storeys = storeysOf(home, structure.ceilings, hiddenLevels);
  return storeys.size() == structure.storeys.size() && stairsOf(home, storeys) == structure.stairs;
}

std::shared_ptr<const Structure> buildStructure(const Home& home, bool ceilings, bool hiddenLevels,
                                                const std::shared_ptr<const Structure>& before,
                                                StructureMemo& memo, const Progress& progress) {
  if (before && isOf(*before, home, hiddenLevels)) return before;
  auto made = std::make_shared<Structure>();
  Structure& s = *made;
  s.home = home;
  s.ceilings = ceilings;
  s.hiddenLevels = hiddenLevels;
  s.storeys = storeysOf(home, ceilings, hiddenLevels);
  s.stairs = stairsOf(home, s.storeys);
  s.walls = wallSolids(home, s.storeys);
  s.openings = openingCuts(home, s.storeys);
  s.extent = planBounds(home, s.walls);
  const Vec2 middle = (s.extent.min + s.extent.max) / 2;
  s.centre = {middle.x, middle.y, 0};
  if (before && length(before->centre - s.centre) < kNear) s.centre = before->centre;
  s.cuts = cutsOf(s.walls, s.openings);
  memo.nextRound();
  s.rooms.emplace(home, s.storeys, s.walls, s.cuts, ceilings, &memo);
  progress.check();

  const WallBuilder walls(home, s.walls, s.cuts);
  const std::size_t rooms = s.rooms->rooms().size();
  s.wallMeshes.resize(s.walls.size());
  s.roomMeshes.resize(rooms);
  s.ceilingMeshes.resize(rooms);
  tbb::parallel_for(std::size_t{0}, s.walls.size() + 2 * rooms, [&](std::size_t i) {
    if (i < s.walls.size()) {
      s.wallMeshes[i] = walls.build(i, s.centre, &memo);
    } else if (const std::size_t room = i - s.walls.size(); room < rooms) {
      s.roomMeshes[room] = s.rooms->buildFloor(room, s.centre, &memo);
    } else {
      s.ceilingMeshes[room - rooms] = s.rooms->buildCeiling(room - rooms, s.centre, &memo);
    }
  });
  if (before) {
    std::map<WallId, MeshPtr> old;
    for (std::size_t i = 0; i < before->walls.size(); ++i) old[before->walls[i].id] = before->wallMeshes[i];
    for (std::size_t i = 0; i < s.walls.size(); ++i) keepEqual(s.wallMeshes[i], old[s.walls[i].id]);
    std::map<RoomId, std::pair<MeshPtr, MeshPtr>> oldRooms;
    for (std::size_t i = 0; i < before->roomMeshes.size(); ++i)
      oldRooms[before->rooms->rooms()[i].id] = {before->roomMeshes[i], before->ceilingMeshes[i]};
    for (std::size_t i = 0; i < rooms; ++i) {
      const auto& [floor, ceiling] = oldRooms[s.rooms->rooms()[i].id];
      keepEqual(s.roomMeshes[i], floor);
      keepEqual(s.ceilingMeshes[i], ceiling);
    }
  }
  for (std::size_t i = 0; i < s.storeys.size(); ++i) {
    if (s.storeys[i].elevation < -kGroundBelow) s.openGround = unite(s.openGround, s.rooms->footprint(i));
  }
  for (const WallSolid& wall : s.walls) {
    const Vec2 a = wall.wall->start, b = wall.wall->end;
    if (length(b - a) < 1e-6) continue;
    const Vec2 aside = perpendicular(normalized(b - a)) * (wall.wall->thickness / 2 + kBesideWall);
    const Vec2 on = (a + b) / 2;
    const bool left = s.rooms->isIndoors(wall.storey, on + aside),
               right = s.rooms->isIndoors(wall.storey, on - aside);
    if (left != right) s.outward[wall.id] = normalized(left ? -aside : aside);
  }
  return made;
}

// One build, its parts in the order in which they need each other.
class Build {
 public:
  Build(const Home& home, const Catalog& catalog, const BuildOptions& options, const Progress& progress,
        SceneMemory& memory)
      : home_(home),
        options_(options),
        progress_(progress),
        memory_(memory),
        models_(memory.models),
        textures_(memory.textures),
        surfaces_(home, memory.textures) {
    models_.use(home, catalog);
    memory_.pieceMeshes.nextBuild();
    built_.scene = std::make_shared<render::Scene>();
    built_.scene->lightGroups = {{"sky"}, {"sun"}};
    built_.scene->sunGroup = 1;
    built_.objects.emplace_back();
  }

  BuiltScene run() {
    progress_.report(0.02, "building walls and rooms");
    std::shared_ptr<const Structure>& known = memory_.structure[options_.ceilings ? 1 : 0];
    known = buildStructure(home_, options_.ceilings, options_.hiddenLevels.value_or(options_.ceilings), known,
                           *memory_.structureParts, progress_);
    structure_ = known;
    built_.centre = structure_->centre;
    progress_.report(0.3, "reading models");
    loadModels();
    addDaylight();
    addWalls();
    addRooms();
    if (options_.ground) addGround();
    progress_.check();
    progress_.report(0.8, "placing furniture");
    addPieces();
    const std::vector<std::string>& pictures = textures_.warnings();
    built_.warnings.insert(built_.warnings.end(), pictures.begin(), pictures.end());
    for (const auto& mesh : built_.scene->meshes) built_.triangles += mesh->triangles.size();
    progress_.report(1, "done");
    return std::move(built_);
  }

 private:
  bool isOnShownStorey(const Piece& piece) const { return isShownOn(home_, structure_->storeys, piece); }

  std::uint32_t addSurface(render::Surface surface) {
    built_.scene->surfaces.push_back(std::move(surface));
    return static_cast<std::uint32_t>(built_.scene->surfaces.size() - 1);
  }
  std::uint32_t addSurface(render::Surface surface, const char* part) {
    surface.name = part;
    return addSurface(std::move(surface));
  }
  void addOwnMesh(std::shared_ptr<const Mesh> mesh, std::vector<std::uint32_t> surfaces, ElementId id) {
    render::Instance instance;
    instance.mesh = static_cast<std::uint32_t>(built_.scene->meshes.size());
    instance.surfaces = std::move(surfaces);
    if (!std::holds_alternative<std::monostate>(id)) {
      instance.objectId = static_cast<std::uint32_t>(built_.objects.size());
      built_.objects.push_back(id);
    }
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
    for (const WallSolid& wall : structure_->walls)
      want(wall.wall->left.finish), want(wall.wall->right.finish);
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
    for (const WallSolid& wall : structure_->walls) {
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
    const auto& walls = structure_->walls;
    for (std::size_t i = 0; i < walls.size(); ++i) {
      if (!structure_->wallMeshes[i]) continue;
      const Wall& wall = *walls[i].wall;
      const double l = length(wall.end - wall.start);
      const Box2 area{{0, 0}, {l, std::max(wall.heightAtStart, wall.heightAtEnd)}};
      const auto side = [&](const WallSide& s) {
        return surfaces_.surface(SurfaceMapper::paint(), s.finish, area);
      };
      const auto board = [&](const WallSide& s) {
        const Finish& own = s.baseboard && !s.baseboard->finish.empty() ? s.baseboard->finish : s.finish;
        return surfaces_.surface(SurfaceMapper::paint(), own, area);
      };
      if (const auto outward = structure_->outward.find(walls[i].id); outward != structure_->outward.end()) {
        outer_[walls[i].id] = built_.outerWalls.size();
        const Vec2 on = (wall.start + wall.end) / 2;
        built_.outerWalls.push_back({{on.x, on.y, walls[i].floor},
                                     outward->second,
                                     {static_cast<std::uint32_t>(built_.scene->instances.size())}});
      }
      addOwnMesh(structure_->wallMeshes[i],
                 {addSurface(side(wall.left), kPartLeft), addSurface(side(wall.right), kPartRight),
                  addSurface(surfaces_.surface(SurfaceMapper::paint(), wall.top), kPartTop),
                  addSurface(board(wall.left), kPartBaseboardLeft),
                  addSurface(board(wall.right), kPartBaseboardRight)},
                 walls[i].id);
    }
  }

  void addRooms() {
    for (std::size_t i = 0; i < structure_->roomMeshes.size(); ++i) {
      const MeshPtr &floor = structure_->roomMeshes[i], &ceiling = structure_->ceilingMeshes[i];
      if (!floor && !ceiling) continue;
      const RoomBuilder::Room& room = structure_->rooms->rooms()[i];
      const Box2 area = bounds(room.room->points);
      const std::vector<std::uint32_t> surfaces{
          addSurface(surfaces_.surface(SurfaceMapper::flooring(), room.room->floor, area), kPartFloor),
          addSurface(surfaces_.surface(SurfaceMapper::paint(), room.room->ceiling, area), kPartCeiling),
          addSurface(surfaces_.surface(SurfaceMapper::paint(), {}))};
      if (floor) addOwnMesh(floor, surfaces, room.id);
      if (ceiling) addOwnMesh(ceiling, surfaces, room.id);
    }
  }

  // The land, open where rooms lie below it.
  void addGround() {
    std::optional<SceneMemory::Land>& known = memory_.land;
    const Structure& s = *structure_;
    if (!known || known->open != s.openGround || known->extent != s.extent || known->centre != s.centre ||
        known->soil != soil_.baseColor || known->horizon != horizon_ ||
        known->soilMap != soil_.baseColorMap) {
      SceneMemory::Land land{s.openGround,
                             s.extent,
                             s.centre,
                             soil_.baseColor,
                             horizon_,
                             soil_.baseColorMap,
                             buildGround(soil_, structure_->openGround, structure_->extent, -kGroundBelow,
                                         horizon_, built_.centre)};
      if (known) keepEqual(land.ground.mesh, known->ground.mesh);
      known = std::move(land);
    }
    if (!known->ground.mesh) return;
    std::vector<std::uint32_t> surfaces;
    for (const render::Surface& surface : known->ground.surfaces) surfaces.push_back(addSurface(surface));
    addOwnMesh(known->ground.mesh, std::move(surfaces), {});
  }

  void addPieces() {
    FurnitureBuilder builder(home_, structure_->storeys, surfaces_, built_, memory_);
    builder.setStructure(structure_);
    for (const auto& [id, piece] : home_.furniture) {
      if (isOnShownStorey(*piece)) builder.add(id, piece, options_.lamps);
    }
    std::erase_if(memory_.lamps, [&](const auto& lamp) { return !home_.furniture.contains(lamp.first); });
    for (const auto& [id, opening] : home_.openings) {
      if (!isOnShownStorey(*opening)) continue;
      const auto before = static_cast<std::uint32_t>(built_.scene->instances.size());
      if (builder.add(id, *opening)) addPortal(id, *structure_->rooms);
      const auto host = outer_.find(opening->wall);
      for (auto i = before; i < built_.scene->instances.size() && host != outer_.end(); ++i)
        built_.outerWalls[host->second].instances.push_back(i);
    }
    builder.tellProblems();
  }

  // A rectangle in the wall where an opening leads from indoors to outdoors.
  void addPortal(OpeningId id, const RoomBuilder& rooms) {
    const auto& openings = structure_->openings;
    const auto cut =
        std::find_if(openings.begin(), openings.end(), [&](const OpeningCut& o) { return o.id == id; });
    if (cut == openings.end()) return;
    const double u = (cut->box.min.x + cut->box.max.x) / 2;
    for (std::size_t w = 0; w < structure_->walls.size(); ++w) {
      const WallSolid& wall = structure_->walls[w];
      const auto isCut = [&](const WallCut& c) { return c.opening == &*cut; };
      if (wall.storey != cut->storey || std::ranges::none_of(structure_->cuts[w], isCut)) continue;
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
    const double clouds = options_.cloudiness.value_or(home_.environment.cloudiness);
    conditions.weather = clouds < 0.34 ? Weather::Clear : clouds < 0.75 ? Weather::Partly : Weather::Overcast;
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
    if (!memory_.daylight || memory_.daylight->conditions != conditions)
      memory_.daylight = {conditions, daylightFor(conditions)};
    const Daylight& light = memory_.daylight->light;
    built_.scene->sun.direction = light.sunDirection;
    built_.scene->sun.illuminance = light.sunIlluminance;
    const Rgb falling = light.skyIlluminance + light.sunIlluminance * std::max(light.sunDirection.z, 0.0f);
    const auto row = static_cast<std::size_t>(light.width) * static_cast<std::size_t>(light.height / 2 - 1);
    for (std::size_t x = 0; x < static_cast<std::size_t>(light.width); ++x) {
      horizon_ += light.skyRadiance[row + x] * (float(kPi) / float(light.width));
    }
    for (int k = 0; k < 3; ++k)
      horizon_[k] = std::clamp(horizon_[k] / std::max(falling[k], 1e-6f), 0.0f, 0.9f);
    built_.scene->sky = {light.width, light.height, light.skyRadiance};
  }

  const Home& home_;
  const BuildOptions& options_;
  const Progress& progress_;
  SceneMemory& memory_;
  ModelCache& models_;
  TextureCache& textures_;
  SurfaceMapper surfaces_;
  std::shared_ptr<const Structure> structure_;
  BuiltScene built_;
  std::map<WallId, std::size_t> outer_;  // into BuiltScene::outerWalls
  render::Surface soil_;
  Rgb horizon_;  // reflectance of land that looks as bright as the sky over the horizon
};

}  // namespace

BuiltScene buildScene(const Home& home, const Catalog& catalog, const BuildOptions& options,
                      const Progress& progress, SceneMemory* memory) {
  if (memory) return Build(home, catalog, options, progress, *memory).run();
  SceneMemory own;
  return Build(home, catalog, options, progress, own).run();
}

}  // namespace idap
