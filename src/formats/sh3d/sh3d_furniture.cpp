// Pieces of furniture, lamps, doors, windows and groups.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "catalog/light_power.h"
#include "catalog/model_file_material.h"
#include "catalog/model_rotation.h"
#include "catalog/opening_kind.h"
#include "formats/sh3d/opening_hosts.h"
#include "formats/sh3d/sh3d_context.h"
#include "geometry/svg_path.h"

namespace idap {

namespace {

constexpr int kMaxGroupDepth = 64;
constexpr int kShowBackFaces = 1;  // of modelFlags

// Only these leave the middle of a model's box where it is.
bool isQuarterTurns(const std::array<Vec3, 3>& rotation) {
  return std::ranges::all_of(rotation, [](const Vec3& axis) {
    return std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)}) > 1 - 1e-6;
  });
}

ModelRef readModel(Sh3dContext& context, const Sh3dElement& element) {
  ModelRef model;
  model.catalogId = element.text("catalogId");
  if (element.has("model")) {
    model.asset = context.contents.model(element.text("model"), element.place(), context.report);
  } else {
    context.report.add(element.place(), "the file names no model for it");
  }
  if (element.has("modelRotation")) {
    if (const auto rotation = modelRotationOf(element.text("modelRotation"))) {
      model.rotation = *rotation;
      if (!element.flag("modelCenteredAtOrigin", true) && !isQuarterTurns(*rotation))
        context.report.add(element.place(), "its turned model is not centred in the file: centred here");
    } else {
      context.report.add(element.place(), "its model's rotation cannot be read: ignored");
    }
  }
  model.backFacesShown =
      element.flag("backFaceShown", false) || (int(element.number("modelFlags", 0)) & kShowBackFaces) != 0;
  return model;
}

SlotFinishes readMaterials(Sh3dContext& context, const Sh3dElement& element) {
  SlotFinishes finishes;
  for (const pugi::xml_node node : element.node().children("material")) {
    const Sh3dElement material(node, context.report);
    Finish finish;
    finish.texture = sh3dTexture(context, material, nullptr);
    if (!finish.texture) {
      if (const auto color = material.colorValue("color")) {
        if (color->transparent) {
          finish.material = "invisible";  // how the file takes a part of a model away
        } else {
          finish.color = color->color;
        }
      }
    }
    if (const auto s = material.number("shininess")) finish.roughness = roughnessOfPhong(*s, *s * 128);
    if (!finish.empty()) finishes[material.text("name")] = std::move(finish);
  }
  return finishes;
}

// The file turns a piece by its pitch, then its roll, then its angle; we by roll, pitch, angle. Its positive
// pitch lifts the front.
void setAngles(Piece& piece, double angle, double pitch, double roll) {
  piece.angle = sh3dAngle(angle);
  piece.pitch = sh3dAngle(pitch);
  piece.roll = std::remainder(roll, 2 * kPi);
  if (piece.pitch == 0 || piece.roll == 0) return;
  const Transform whole = Transform::rotationZ(piece.angle) * Transform::rotationY(piece.roll) *
                          Transform::rotationX(piece.pitch);
  piece.pitch = std::asin(std::clamp(whole.y.z, -1.0, 1.0));
  piece.angle = std::atan2(-whole.y.x, whole.y.y);
  piece.roll = std::atan2(-whole.x.z, whole.z.z);
}

// The height of the tilted piece's box: the file's elevation is that of its lowest point.
double tiltedHeight(const Piece& piece) {
  const Transform turn = Transform::rotationX(piece.pitch) * Transform::rotationY(piece.roll);
  return std::abs(turn.x.z) * piece.size.x + std::abs(turn.y.z) * piece.size.y +
         std::abs(turn.z.z) * piece.size.z;
}

bool readPiece(Sh3dContext& context, const Sh3dElement& element, LevelId level, GroupId group, Piece& piece) {
  const auto position = element.point("x", "y");
  const auto width = element.length("width"), depth = element.length("depth"),
             height = element.length("height");
  if (!position || !width || !depth || !height) {
    context.report.add(element.place(), "a piece without a place or a size: dropped");
    return false;
  }
  piece.level = level;
  piece.group = group;
  piece.name = element.text("name");
  piece.description = element.text("description");
  piece.model = readModel(context, element);
  piece.size = {*width, *depth, *height};
  piece.position = {position->x, position->y, element.length("elevation", 0)};
  const bool tilts = element.flag("horizontallyRotatable", true);
  setAngles(piece, element.number("angle", 0), tilts ? element.number("pitch", 0) : 0,
            tilts ? element.number("roll", 0) : 0);
  if (piece.pitch != 0 || piece.roll != 0)
    piece.position.z += (element.length("heightInPlan", tiltedHeight(piece)) - piece.size.z) / 2;
  piece.mirrored = element.flag("modelMirrored", false);
  piece.finish = sh3dFinish(context, element, "color", nullptr, nullptr);
  if (const auto s = element.number("shininess")) piece.finish.roughness = roughnessOfPhong(*s, *s * 128);
  piece.slotFinishes = readMaterials(context, element);
  piece.visible = element.flag("visible", true);
  piece.nameVisible = element.flag("nameVisible", false);
  const bool movable = element.flag("movable", true);
  piece.locked = context.basePlanLocked && !movable;
  piece.price = element.number("price");
  for (const char* name : {"creator", "license", "information", "currency", "valueAddedTaxPercentage"})
    if (element.has(name)) piece.properties[name] = element.text(name);
  if (!movable) piece.properties["movable"] = "false";
  for (const pugi::xml_node node : element.node().children("property"))
    piece.properties[node.attribute("name").as_string()] = node.attribute("value").as_string();
  if (element.child("transformation"))
    context.report.add(element.place(), "moved parts of its model: shown where the model has them");
  return true;
}

// The part of its outline that an opening cuts out of the wall: the shape fills that part, as fractions from
// the left and the top.
void cutPartOnly(Sh3dContext& context, const Sh3dElement& element, Opening& opening) {
  const double left = element.number("wallLeft", 0), top = element.number("wallTop", 0);
  const double width = element.number("wallWidth", 1), height = element.number("wallHeight", 1);
  if (left == 0 && top == 0 && width == 1 && height == 1) return;
  const auto within = [](double from, double size) {
    return from >= 0 && size > 0 && from + size <= 1 + 1e-6;
  };
  if (!within(left, width) || !within(top, height)) {
    context.report.add(element.place(),
                       "the part that it cuts out of the wall is not within it: cuts the whole");
    return;
  }
  std::string path;
  try {
    for (const Polygon& ring : parseSvgPath(opening.cutOut)) {
      for (const Vec2& p : ring) {
        path += fmt::format("{}{:.6f},{:.6f}", path.empty() || path.back() == 'z' ? "M" : " L",
                            left + p.x * width, top + p.y * height);
      }
      path += " z";
    }
  } catch (const ParseError&) {
  }
  if (!path.empty()) opening.cutOut = path;
}

void readOpening(Sh3dContext& context, const Sh3dElement& element, LevelId level, GroupId group) {
  Opening opening;
  if (!readPiece(context, element, level, group, opening)) return;
  const std::string shape = element.text("cutOutShape");
  if (!shape.empty()) opening.cutOut = shape;
  opening.cutsBothSides = element.flag("wallCutOutOnBothSides", false);
  opening.wallThickness = element.number("wallThickness", 1);
  opening.wallDistance = element.number("wallDistance", 0);
  for (const pugi::xml_node node : element.node().children("sash")) {
    const Sh3dElement sash(node, context.report);
    const auto x = sash.number("xAxis"), y = sash.number("yAxis"), width = sash.number("width");
    const auto start = sash.number("startAngle"), end = sash.number("endAngle");
    // Sash angles, unlike all others of the file, turn counter-clockwise already.
    if (x && y && width && start && end) opening.sashes.push_back({{*x, *y}, *width, *start, *end});
  }
  cutPartOnly(context, element, opening);
  opening.kind = openingKindOf(opening.model.catalogId, opening.name, opening.position.z, opening.size.z,
                               !opening.sashes.empty());
  opening.wall = hostOf(context.home, opening);
  opening.cutsWalls = bool(opening.wall);
  context.home.openings.set(context.home.newId<OpeningId>(), std::move(opening));
}

Lamp readLamp(Sh3dContext& context, const Sh3dElement& element, const Piece& piece) {
  std::vector<Sh3dLightSource> sources;
  for (const pugi::xml_node node : element.node().children("lightSource")) {
    const Sh3dElement source(node, context.report);
    const auto x = source.number("x"), y = source.number("y"), z = source.number("z");
    if (!x || !y || !z) continue;
    Sh3dLightSource& to = sources.emplace_back();
    to.position = {*x, *y, *z};  // depth runs from the front to the back, as ours
    to.color = source.color("color").value_or(Color{1, 1, 1});
    if (const auto diameter = source.number("diameter"); diameter && *diameter > 0)
      to.diameter = *diameter * piece.size.x;
  }
  return lampOf(element.number("power", 0.5), sources);
}

void readPlainPiece(Sh3dContext& context, const Sh3dElement& element, LevelId level, GroupId group) {
  Furniture furniture;
  if (!readPiece(context, element, level, group, furniture)) return;
  furniture.staircaseCutOut = element.text("staircaseCutOutShape");
  // Below 0 nothing stands on it, 1 is its top.
  if (const auto drop = element.number("dropOnTopElevation"); drop && *drop >= 0 && *drop < 1)
    furniture.dropOnTopHeight = *drop * furniture.size.z;
  if (element.kind() == "light") furniture.lamp = readLamp(context, element, furniture);
  context.home.furniture.set(context.home.newId<FurnitureId>(), std::move(furniture));
}

void readAny(Sh3dContext& context, const Sh3dElement& element, LevelId level, GroupId group, int depth) {
  context.progress.check();
  if (element.has("level")) level = context.levelOf(element);
  if (element.kind() == "furnitureGroup") {
    if (depth >= kMaxGroupDepth) {
      context.report.add(element.place(), "groups nested too deeply: dropped");
      return;
    }
    const GroupId id = context.home.newId<GroupId>();
    context.home.groups.set(id, Group{group, element.text("name"), element.flag("visible", true)});
    for (const pugi::xml_node node : element.node().children())
      if (isSh3dFurniture(node.name())) readAny(context, {node, context.report}, level, id, depth + 1);
  } else if (element.kind() == "doorOrWindow" || element.flag("doorOrWindow", false)) {
    readOpening(context, element, level, group);
  } else {
    readPlainPiece(context, element, level, group);
  }
}

}  // namespace

bool isSh3dFurniture(std::string_view kind) {
  return kind == "pieceOfFurniture" || kind == "doorOrWindow" || kind == "light" || kind == "furnitureGroup";
}

void readFurniture(Sh3dContext& context, const Sh3dElement& element) { readAny(context, element, {}, {}, 0); }

}  // namespace idap
