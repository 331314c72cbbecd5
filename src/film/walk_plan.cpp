#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>

#include "base/error.h"
#include "film/film_plan.h"
#include "film/walk_map.h"
#include "model/room_geometry.h"
#include "scene/wall_solid.h"

namespace idap {

namespace {

// A film is seen through one kind of lens, neither a keyhole nor a fish's eye.
Camera filmed(Camera camera) {
  camera.lens = Lens::Pinhole;
  camera.fieldOfView = std::clamp(camera.fieldOfView, 0.6, 1.7);
  camera.time.reset();
  camera.name.clear();
  return camera;
}

std::string nameOf(const Camera& camera, std::size_t number) {
  return camera.name.empty() ? fmt::format("point of view {}", number) : "'" + camera.name + "'";
}

// The smooth curve along a way, straighter where a bend would swing into something.
std::vector<Vec2> curveAlong(const WalkMap& map, const WalkMap::Way& way) {
  std::vector<Vec2> points = way.points;
  const auto holds = [&](const std::vector<Vec2>& curve) {
    return std::all_of(curve.begin(), curve.end(), [&](Vec2 p) { return map.seeable(p); });
  };
  std::vector<Vec2> curve = smoothCurve(points);
  // Points in the middle of the stretches hold the curve nearer to them.
  for (int round = 0; round < 3 && !holds(curve); ++round) {
    std::vector<Vec2> more;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      more.push_back(points[i]);
      more.push_back((points[i] + points[i + 1]) * 0.5);
    }
    more.push_back(points.back());
    points = std::move(more);
    curve = smoothCurve(points);
  }
  return curve;
}

// Frames out of poses that lie kStep apart.
void addTake(FilmPlan& plan, const std::vector<Camera>& poses, double stretch, std::int64_t time) {
  const double seconds = static_cast<double>(poses.size()) * CameraPath::kStep * stretch;
  const auto frames =
      std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(seconds * plan.framesPerSecond)));
  if (!plan.frames.empty()) plan.cuts.push_back(plan.frames.size());
  for (std::size_t i = 0; i < frames; ++i) {
    const double at = std::min(static_cast<double>(i) / plan.framesPerSecond / stretch / CameraPath::kStep,
                               static_cast<double>(poses.size() - 1));
    const auto before = static_cast<std::size_t>(at);
    Camera frame = poses[before];
    if (before + 1 < poses.size()) {
      // Between two poses: a frame of the nearer one would make the walk stutter.
      const Camera& after = poses[before + 1];
      const double share = at - static_cast<double>(before);
      frame.eye += (after.eye - frame.eye) * share;
      frame.yaw += std::remainder(after.yaw - frame.yaw, 2 * kPi) * share;
      frame.pitch += (after.pitch - frame.pitch) * share;
      frame.fieldOfView += (after.fieldOfView - frame.fieldOfView) * share;
    }
    frame.time = time;
    plan.frames.push_back(std::move(frame));
  }
}

void openDoors(Home& home, const std::set<OpeningId>& passed) {
  for (const OpeningId id : passed) {
    Opening open = *home.openings.find(id);
    open.kind = OpeningKind::Bare;
    home.openings.set(id, open);
  }
}

}  // namespace

FilmPlan planWalk(const Home& home, const std::vector<Camera>& stops, const WalkSettings& settings) {
  if (stops.empty()) throw Error("a walk needs a point of view to begin at");
  FilmPlan plan;
  plan.home = home;
  plan.framesPerSecond = settings.framesPerSecond;
  const std::int64_t time = settings.time.value_or(stops.front().time.value_or(home.site.time));

  std::map<double, std::unique_ptr<WalkMap>> maps;
  const auto mapOf = [&](double floor) -> const WalkMap& {
    std::unique_ptr<WalkMap>& map = maps[floor];
    if (!map) map = std::make_unique<WalkMap>(home, floor);
    return *map;
  };
  std::vector<CameraPath> takes;
  std::set<OpeningId> passed;
  double floor = 0;
  const auto begin = [&](const Camera& stop) {
    floor = floorBelow(home, stop.eye.z);
    takes.emplace_back(filmed(stop), floor, settings.pace);
    takes.back().stay(std::max(settings.pace.pause, 0.2));
    plan.ways.push_back({{stop.eye.x, stop.eye.y}});
  };
  begin(stops.front());
  for (std::size_t i = 1; i < stops.size(); ++i) {
    const Camera &from = stops[i - 1], &to = stops[i];
    const Vec2 a{from.eye.x, from.eye.y}, b{to.eye.x, to.eye.y};
    const double nextFloor = floorBelow(home, to.eye.z);
    std::optional<WalkMap::Way> way;
    if (std::abs(nextFloor - floor) < 0.05) way = mapOf(floor).way(a, b);
    if (!way) {
      plan.warnings.push_back(fmt::format(
          "nobody can walk from {} to {} ({}); the film cuts there", nameOf(from, i), nameOf(to, i + 1),
          std::abs(nextFloor - floor) < 0.05 ? "no open way between them" : "they are on different levels"));
      begin(to);
      continue;
    }
    if (way->overFurniture)
      plan.warnings.push_back(
          fmt::format("the way from {} to {} leads over furniture; nothing leads round it", nameOf(from, i),
                      nameOf(to, i + 1)));
    const std::vector<Vec2> curve = curveAlong(mapOf(floor), *way);
    passed.merge(mapOf(floor).doorsOn(curve));
    takes.back().walkTo(filmed(to), curve);
    takes.back().stay(settings.pace.pause);
    plan.ways.back().insert(plan.ways.back().end(), curve.begin(), curve.end());
  }
  double whole = 0;
  for (const CameraPath& take : takes) whole += take.seconds();
  const double stretch = settings.seconds ? *settings.seconds / whole : 1;
  for (const CameraPath& take : takes) addTake(plan, take.poses(), stretch, time);
  openDoors(plan.home, passed);
  return plan;
}

std::vector<Camera> defaultStops(const Home& home) {
  std::vector<Camera> stops;
  for (const auto& [id, camera] : home.cameras) stops.push_back(*camera);
  if (!stops.empty()) return stops;

  // Each room from its widest place towards its farthest corner.
  std::vector<std::pair<Polygon, LevelId>> areas;
  for (const auto& [id, room] : home.rooms)
    if (floorArea(*room) > 2) areas.push_back({room->points, room->level});
  if (areas.empty()) {
    for (const Storey& storey : shownStoreys(home, true))
      for (const Polygon& area : closedAreas(home, storey.id))
        if (std::abs(signedArea(area)) > 2) areas.push_back({area, storey.id});
  }
  for (const auto& [area, level] : areas) {
    const double floor = elevationOf(home, level);
    const WalkMap map(home, floor);
    const Box2 box = bounds(area);
    Vec2 stand = (box.min + box.max) * 0.5;
    double widest = -1;
    for (double y = box.min.y; y <= box.max.y; y += 0.1)
      for (double x = box.min.x; x <= box.max.x; x += 0.1) {
        const Vec2 p{x, y};
        const double wide = contains(area, p) ? map.clearance(p) : -1;
        if (wide > widest) widest = wide, stand = p;
      }
    if (widest < WalkMap::kBodyRadius) continue;
    Camera camera;
    double farthest = 0;
    for (const Vec2& corner : area)
      if (length(corner - stand) > farthest) {
        farthest = length(corner - stand);
        camera.yaw = std::atan2(-(corner.x - stand.x), corner.y - stand.y);
      }
    camera.eye = {stand.x, stand.y, floor + 1.6};
    camera.pitch = 0.08;
    stops.push_back(camera);
  }
  // The nearest one next, storey by storey.
  for (std::size_t i = 1; i < stops.size(); ++i) {
    const auto far = [&](const Camera& c) { return length(c.eye - stops[i - 1].eye); };
    std::iter_swap(stops.begin() + static_cast<std::ptrdiff_t>(i),
                   std::min_element(stops.begin() + static_cast<std::ptrdiff_t>(i), stops.end(),
                                    [&](const Camera& a, const Camera& b) { return far(a) < far(b); }));
  }
  if (stops.empty() && home.observer) stops.push_back(*home.observer);
  return stops;
}

}  // namespace idap
