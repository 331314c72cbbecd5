// Levels, walls and rooms. On the file's plan y runs down; turned up, the left hand stays the left hand,
// while clockwise sweeps become negative.
#include <cmath>

#include "formats/sh3d/sh3d_context.h"

namespace idap {

namespace {

// A wall's sweep bends it by less than a whole turn.
constexpr double kMaxSweep = 2 * kPi * 0.999;

std::optional<Baseboard> readBaseboard(Sh3dContext& context, const Sh3dElement& wall, const char* attribute) {
  const auto element = wall.child("baseboard", attribute);
  if (!element) return std::nullopt;
  const auto thickness = element->length("thickness"), height = element->length("height");
  if (!thickness || !height || !(*thickness > 0) || !(*height > 0)) return std::nullopt;
  return Baseboard{*thickness, *height, sh3dFinish(context, *element, "color", nullptr, nullptr)};
}

}  // namespace

void readBackground(Sh3dContext& context, const Sh3dElement& element, LevelId level) {
  const std::string asset =
      context.contents.picture(element.text("image"), "background of the plan", context.report);
  if (asset.empty()) return;
  Background background;
  background.asset = asset;
  const double pixels =
      std::hypot(element.number("scaleDistanceXEnd", 0) - element.number("scaleDistanceXStart", 0),
                 element.number("scaleDistanceYEnd", 0) - element.number("scaleDistanceYStart", 0));
  const double distance = element.length("scaleDistance", 0);
  if (pixels > 0 && distance > 0) background.scale = distance / pixels;
  background.origin = {-element.length("xOrigin", 0), element.length("yOrigin", 0)};
  background.visible = element.flag("visible", true);
  context.home.backgrounds[level] = background;
}

void readLevel(Sh3dContext& context, const Sh3dElement& element) {
  Level level;
  level.name = element.text("name");
  level.elevation = element.length("elevation", 0);
  level.floorThickness = element.length("floorThickness", level.floorThickness);
  level.height = element.length("height", level.height);
  const double order = element.number("elevationIndex", 0);
  if (std::abs(order) < 1e6) level.order = int(order);
  // The file's "visible" only tells which level was being edited (those above it are out of the way); what
  // the user chose to hide is "viewable".
  level.viewable = element.flag("viewable", true);
  const LevelId id = context.home.newId<LevelId>();
  if (!context.levels.emplace(element.text("id"), id).second)
    context.report.add(element.place(), "a second level with this id: what is on it went to the first");
  if (const auto background = element.child("backgroundImage")) readBackground(context, *background, id);
  context.home.levels.set(id, std::move(level));
}

void Sh3dWalls::read(Sh3dContext& context, const Sh3dElement& element) {
  const auto start = element.point("xStart", "yStart"), end = element.point("xEnd", "yEnd");
  const auto thickness = element.length("thickness");
  if (!start || !end || !thickness) {
    context.report.add(element.place(), "a wall without ends or thickness: dropped");
    return;
  }
  Wall wall;
  wall.level = context.levelOf(element);
  wall.start = *start;
  wall.end = *end;
  wall.thickness = *thickness;
  wall.heightAtStart = element.length("height", context.home.wallHeight);
  wall.heightAtEnd = element.length("heightAtEnd", wall.heightAtStart);
  wall.arcExtent = -element.number("arcExtent", 0);
  if (std::abs(wall.arcExtent) > kMaxSweep) {
    context.report.add(element.place(), "bent by more than a whole turn: made straight");
    wall.arcExtent = 0;
  }
  wall.left.finish = sh3dFinish(context, element, "leftSideColor", "leftSideTexture", "leftSideShininess");
  wall.right.finish =
      sh3dFinish(context, element, "rightSideColor", "rightSideTexture", "rightSideShininess");
  wall.left.baseboard = readBaseboard(context, element, "leftSideBaseboard");
  wall.right.baseboard = readBaseboard(context, element, "rightSideBaseboard");
  wall.top.color = element.color("topColor");
  wall.pattern = element.text("pattern");
  const WallId id = context.home.newId<WallId>();
  if (element.has("id")) ids_.emplace(element.text("id"), id);
  joins_.push_back({id, element.text("wallAtStart"), element.text("wallAtEnd")});
  context.home.walls.set(id, std::move(wall));
}

void Sh3dWalls::join(Sh3dContext& context) {
  for (const Joins& joins : joins_) {
    const auto neighbour = [&](const std::string& name) -> WallId {
      if (name.empty()) return {};
      const auto found = ids_.find(name);
      if (found == ids_.end()) {
        context.report.add("wall " + name,
                           "another wall is joined to it, but it does not exist: joint dropped");
        return {};
      }
      return found->second == joins.wall ? WallId{}
                                         : found->second;  // version 6.4 wrote walls joined to themselves
    };
    const WallId atStart = neighbour(joins.atStart), atEnd = neighbour(joins.atEnd);
    if (!atStart && !atEnd) continue;
    Wall wall = *context.home.walls.find(joins.wall);
    wall.neighbourAtStart = atStart;
    wall.neighbourAtEnd = atEnd;
    context.home.walls.set(joins.wall, std::move(wall));
  }
}

void readRoom(Sh3dContext& context, const Sh3dElement& element) {
  Room room;
  room.level = context.levelOf(element);
  room.name = element.text("name");
  for (const pugi::xml_node node : element.node().children("point"))
    if (const auto point = Sh3dElement(node, context.report).point("x", "y")) room.points.push_back(*point);
  if (room.points.size() < 3) {
    context.report.add(element.place(), "a room of fewer than three points: dropped");
    return;
  }
  room.floor = sh3dFinish(context, element, "floorColor", "floorTexture", "floorShininess");
  room.ceiling = sh3dFinish(context, element, "ceilingColor", "ceilingTexture", "ceilingShininess");
  room.floorVisible = element.flag("floorVisible", true);
  room.ceilingVisible = element.flag("ceilingVisible", true);
  room.ceilingFlat = element.flag("ceilingFlat", false);
  room.areaVisible = element.flag("areaVisible", false);
  room.nameOffset = {element.length("nameXOffset", 0), -element.length("nameYOffset", -0.4)};
  room.areaOffset = {element.length("areaXOffset", 0), -element.length("areaYOffset", 0)};
  room.nameAngle = sh3dAngle(element.number("nameAngle", 0));
  room.areaAngle = sh3dAngle(element.number("areaAngle", 0));
  room.nameStyle = sh3dTextStyle(element, "nameStyle");
  room.areaStyle = sh3dTextStyle(element, "areaStyle");
  context.home.rooms.set(context.home.newId<RoomId>(), std::move(room));
}

}  // namespace idap
