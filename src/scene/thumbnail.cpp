#include "scene/thumbnail.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "render/denoise/denoise.h"
#include "render/film/develop.h"
#include "render/film/exposure.h"
#include "render/session/render_job.h"
#include "scene/mesh_sink.h"
#include "scene/scene_builder.h"

namespace idap {

namespace {

constexpr int kSamples = 32;
constexpr int kEdge = 2;  // pixels around the picture that are traced and cut off: denoising spoils corners
constexpr double kLens = 20 * kPi / 180;  // narrow: shapes keep their proportions
constexpr double kMargin = 0.07;          // of the picture's side, left free at each edge
constexpr double kFar = 60;               // m, how far floor and wall reach
constexpr double kWallAround = 0.22;      // m of wall beside and above a door or window
constexpr double kSill = 0.3;             // m below a window: its own would leave it small
constexpr float kGround = 0.6f;           // reflectance of floor and wall
constexpr float kFill = 300;              // cd/m2 of the light from all around
constexpr float kKey = 5200;              // cd/m2 more in the middle of the soft light from the front left
constexpr float kWhite = 640;             // cd/m2 that come out white
constexpr float kLampStudio = 0.5f;       // of all of these around a lamp, so that it is seen to shine
constexpr double kLampWarmth = 4000;      // K at most below: nothing tells the eye to get used to warm light
constexpr Color kWallColor{0.70f, 0.73f, 0.76f};  // white doors show against it

// How a piece is shown.
enum class Pose { Standing, Hanging, OnWall, InWall };

Pose poseOf(const CatalogPiece& piece) {
  if (piece.kind == PieceKind::Door || piece.kind == PieceKind::Window) return Pose::InWall;
  if (piece.ceilingMounted) return Pose::Hanging;
  const bool thin = piece.size.y < 0.25 * std::max(piece.size.x, piece.size.z) || piece.size.y < 0.12;
  return piece.elevation > 1.0 || (piece.elevation > 0.2 && thin) ? Pose::OnWall : Pose::Standing;
}

// Light from everywhere, and more from above, left of the camera: shapes read by their shading, shadows are
// soft.
render::Sky studioSky(float level) {
  render::Sky sky;
  sky.width = 64;
  sky.height = 32;
  sky.radiance.reserve(std::size_t{64} * 32);
  const Vec3 key = normalized(Vec3{-0.75, -0.75, 1.0});
  for (int row = 0; row < sky.height; ++row) {
    const double polar = kPi * (row + 0.5) / sky.height;
    for (int column = 0; column < sky.width; ++column) {
      const double azimuth = 2 * kPi * (column + 0.5) / sky.width;
      const Vec3 direction{std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                           std::cos(polar)};
      const auto lobe = static_cast<float>(std::exp(12 * (dot(direction, key) - 1)));
      const float radiance = level * (kFill + kKey * lobe);
      sky.radiance.push_back({radiance, radiance, radiance});
    }
  }
  return sky;
}

class Studio {
 public:
  Studio(const Home& home, const Catalog& catalog, Pose pose, Vec3 size, const Progress& progress)
      : pose_(pose), size_(size), progress_(progress) {
    for (const auto& [id, piece] : home.furniture)
      if (piece->lamp) level_ = kLampStudio;
    BuildOptions options;
    options.ground = false;
    options.lamps = LampPolicy::On;
    built_ = buildScene(home, catalog, options, progress);
    frameWhole();
    built_.scene->sun.illuminance = {};
    built_.scene->sky = studioSky(level_);
    built_.scene->portals.clear();
    addBackdrop();
  }

  Image8 picture(int side, render::Denoiser* denoiser) const {
    progress_.check();
    const render::CompiledScene compiled(built_.scene, 1);
    render::RenderSettings settings;
    const int whole = side + 2 * kEdge;
    settings.width = settings.height = whole;
    settings.spp = kSamples;
    settings.threads = 1;
    settings.clampIndirect = 4 * kWhite * level_;
    render::Camera camera = camera_;
    camera.horizontalFov = static_cast<float>(2 * std::atan(std::tan(kLens / 2) * whole / side));
    render::Film film(whole, whole);
    render::render(compiled, camera, settings, film, progress_);
    progress_.check();
    render::DevelopSettings develop;
    develop.ev = render::ev100FromMultiplier(1 / (kWhite * level_));
    develop.whiteBalance = 0;
    develop.fastDenoise = true;
    develop.threads = 1;
    const Image8 picture = render::develop(film, develop, denoiser);
    Image8 inner(side, side);
    for (int y = 0; y < side; ++y) std::copy_n(picture.pixel(kEdge, y + kEdge), 3 * side, inner.pixel(0, y));
    return inner;
  }

 private:
  // Puts the camera where everything in the scene just fits into the picture, seen in the direction of the
  // pose. With the camera at e and the tangent t of half the lens, a point p is inside to the right when
  // (p - e).right <= t (p - e).forward: the points that bind on both sides give the nearest place.
  void frameWhole() {
    double turn = 32, down = 22;
    if (pose_ == Pose::OnWall) turn = 20, down = 10;
    if (pose_ == Pose::InWall) turn = 20, down = 14;
    if (pose_ == Pose::Hanging) down = -14;  // what hangs is seen from below
    if (pose_ == Pose::Standing && size_.z < 0.3 * std::max(size_.x, size_.y)) down = 34;
    const double yaw = turn * kPi / 180, pitch = down * kPi / 180;
    const Vec3 forward{-std::sin(yaw) * std::cos(pitch), std::cos(yaw) * std::cos(pitch), -std::sin(pitch)};
    const Vec3 right{std::cos(yaw), std::sin(yaw), 0};
    const Vec3 up = cross(right, forward);
    const double t = std::tan(kLens / 2) * (1 - 2 * kMargin);

    constexpr double kNone = -std::numeric_limits<double>::infinity();
    double r0 = kNone, r1 = kNone, u0 = kNone, u1 = kNone;
    for (const render::Instance& instance : built_.scene->instances) {
      for (const Vec3f& vertex : built_.scene->meshes[instance.mesh]->positions) {
        const Vec3f placed = instance.transform.point(vertex);
        const Vec3 p{placed.x, placed.y, placed.z};
        const double f = t * dot(p, forward), r = dot(p, right), u = dot(p, up);
        r0 = std::max(r0, r - f), r1 = std::max(r1, -r - f);
        u0 = std::max(u0, u - f), u1 = std::max(u1, -u - f);
      }
    }
    if (r0 == kNone) r0 = r1 = u0 = u1 = 1;
    const double back = std::min(-(r0 + r1), -(u0 + u1)) / (2 * t);
    const Vec3 eye = right * ((r0 - r1) / 2) + up * ((u0 - u1) / 2) + forward * back;
    camera_.eye = toFloat(eye);
    camera_.forward = toFloat(forward);
    camera_.up = toFloat(up);
  }

  // The floor, or the wall behind what hangs on one; they fill the picture, so that no horizon is seen.
  void addBackdrop() {
    render::Scene& scene = *built_.scene;
    MeshSink sink({0, 0, 0});
    const std::array<Vec2, 4> uvs{};
    if (pose_ == Pose::OnWall || pose_ == Pose::Hanging) {
      const double b = size_.y / 2 + (pose_ == Pose::OnWall ? 0.001 : 0.5);
      sink.quad({Vec3{-kFar, b, -kFar}, {kFar, b, -kFar}, {kFar, b, kFar}, {-kFar, b, kFar}}, uvs, 0);
    } else {
      const double z = -0.001;
      sink.quad({Vec3{-kFar, -kFar, z}, {kFar, -kFar, z}, {kFar, kFar, z}, {-kFar, kFar, z}}, uvs, 0);
    }
    render::Surface surface;
    surface.baseColor = {kGround, kGround, kGround};
    surface.ior = 1;
    render::Instance instance;
    instance.mesh = static_cast<std::uint32_t>(scene.meshes.size());
    instance.surfaces = {static_cast<std::uint32_t>(scene.surfaces.size())};
    scene.meshes.push_back(sink.take());
    scene.surfaces.push_back(std::move(surface));
    scene.instances.push_back(std::move(instance));
  }

  Pose pose_;
  Vec3 size_;
  float level_ = 1;
  const Progress& progress_;
  BuiltScene built_;
  render::Camera camera_;
};

Home homeOf(const CatalogPiece& piece, Pose pose) {
  Home home;
  if (pose != Pose::InWall) {
    Furniture furniture = makeFurniture(piece, {0, 0, 0});
    furniture.position = {0, 0, 0};
    if (furniture.lamp)
      furniture.lamp->colorTemperature = std::max(furniture.lamp->colorTemperature, kLampWarmth);
    home.furniture.set(home.newId<FurnitureId>(), std::move(furniture));
    return home;
  }
  const double sill = piece.elevation > 0.05 ? kSill : 0;
  Opening opening = makeOpening(piece, {0, 0, sill});
  opening.position = {0, 0, sill};
  Wall wall;
  const double reach = piece.size.x / 2 + kWallAround;
  // What the model has in the wall is centred on it.
  const double middle = piece.size.y / 2 - piece.size.y * (piece.wallDistance + piece.wallThickness / 2);
  wall.thickness = std::clamp(piece.size.y * piece.wallThickness, 0.08, 0.3);
  wall.start = {-reach, middle};
  wall.end = {reach, middle};
  wall.heightAtStart = wall.heightAtEnd = sill + piece.size.z + kWallAround;
  wall.left.finish = wall.right.finish = wall.top = plain(kWallColor);
  const WallId id = home.newId<WallId>();
  home.walls.set(id, wall);
  opening.wall = id;
  home.openings.set(home.newId<OpeningId>(), std::move(opening));
  return home;
}

Image8 onThisThread(const std::function<Image8()>& work) {
  tbb::task_arena arena(1);
  return arena.execute(work);
}

}  // namespace

Image8 renderThumbnail(const Catalog& catalog, const CatalogPiece& piece, int side, const Progress& progress,
                       render::Denoiser* denoiser) {
  return onThisThread([&] {
    if (!catalog.model(piece.id, piece.size)) throw ParseError(piece.id, "", "the catalog has no such piece");
    const Pose pose = poseOf(piece);
    return Studio(homeOf(piece, pose), catalog, pose, piece.size, progress).picture(side, denoiser);
  });
}

Image8 renderThumbnail(const Catalog& catalog, const Furniture& piece, std::shared_ptr<const Assets> assets,
                       int side, const Progress& progress) {
  return onThisThread([&] {
    Home home;
    home.assets = std::move(assets);
    Furniture here = piece;
    here.level = {};
    here.group = {};
    here.visible = true;
    here.position = {0, 0, 0};
    home.furniture.set(home.newId<FurnitureId>(), here);
    return Studio(home, catalog, Pose::Standing, here.size, progress).picture(side, nullptr);
  });
}

}  // namespace idap
