#include "model/element_rules.h"

#include "base/error.h"
#include "geometry/svg_path.h"

namespace idap {

namespace {

constexpr double kMinWall = 1e-6;       // m, length
constexpr double kMinRoomArea = 1e-6;   // m2
constexpr double kFirstTime = -62e12;   // ms: about the year 5
constexpr double kLastTime = 253.4e12;  // ms: the year 9999
const std::string kWholeSquare = Opening{}.cutOut;

template <Is<Color> C>
void judgeColor(C& color, Judge& j) {
  j.within(color.r, 0, 1, 1, "colour out of range: brought into it");
  j.within(color.g, 0, 1, 1, "colour out of range: brought into it");
  j.within(color.b, 0, 1, 1, "colour out of range: brought into it");
}

template <class O>
void judgeColorOption(O& color, Judge& j) {
  if (color) judgeColor(*color, j);
}

template <class O>  // an optional TextureRef
void judgeTexture(O& texture, Judge& j) {
  if (!texture) return;
  j.text(texture->asset);
  if (texture->asset.empty() ||
      (!texture->asset.starts_with("catalog:") && !j.home().assets->contains(texture->asset))) {
    j.found("picture of a surface is missing: shown plain");
    if constexpr (!std::is_const_v<O>) texture.reset();
    return;
  }
  j.length(texture->size.x, "size of a surface's picture not usable: changed");
  j.length(texture->size.y, "size of a surface's picture not usable: changed");
  j.place(texture->offset, "offset of a surface's picture not usable: set to zero");
  j.angle(texture->angle, "angle of a surface's picture not usable: set to zero");
}

template <Is<Finish> F>
void judgeFinish(F& finish, Judge& j) {
  j.text(finish.material);
  judgeColorOption(finish.color, j);
  judgeTexture(finish.texture, j);
  j.optional(finish.roughness, 0, 1, "roughness of a surface out of range: left out");
  j.optional(finish.metalness, 0, 1, "metalness of a surface out of range: left out");
  j.optional(finish.transmission, 0, 1, "transparency of a surface out of range: left out");
}

template <Is<TextStyle> S>
void judgeStyle(S& style, Judge& j) {
  j.text(style.font);
  j.within(style.size, 1e-4, 1000, TextStyle{}.size, "size of a text not usable: changed");
  judgeColorOption(style.color, j);
}

template <class Points>
void judgePoints(Points& points, Judge& j) {
  j.atMost(points, kMaxPoints, "too many points: the rest dropped");
  const auto bad = [](Vec2 p) { return !Judge::isPlace(p); };
  if (std::none_of(points.begin(), points.end(), bad)) return;
  j.found("points without a usable place: left out");
  if constexpr (!std::is_const_v<Points>) std::erase_if(points, bad);
}

template <class P>
void judgeCutOut(P& path, const std::string& fallback, Judge& j) {
  if (path == kWholeSquare || path.empty()) return;
  j.text(path);
  try {
    parseSvgPath(path);
  } catch (const Error&) {
    j.found("shape of its cut-out cannot be read: replaced");
    if constexpr (!std::is_const_v<P>) path = fallback;
  }
}

template <Is<ModelRef> M>
void judgeModel(M& model, Judge& j) {
  j.text(model.catalogId);
  j.text(model.asset);
  j.asset(model.asset, "its model is missing: shown without");
  j.atMost(model.parameters, kMaxParts, "too many parameters: the rest dropped");
  const auto bad = [](const auto& entry) {
    return !std::isfinite(entry.second) || !Judge::isText(entry.first);
  };
  if (std::any_of(model.parameters.begin(), model.parameters.end(), bad)) {
    j.found("parameters that are no numbers: left out");
    if constexpr (!std::is_const_v<M>) std::erase_if(model.parameters, bad);
  }
  const auto& r = model.rotation;
  const double volume = dot(r[0], cross(r[1], r[2]));
  const auto sane = [](Vec3 v) { return isFinite(v) && length(v) <= 1e3; };
  if (!(sane(r[0]) && sane(r[1]) && sane(r[2]) && std::abs(volume) >= 1e-9)) {
    j.found("rotation of its model not usable: left out");
    if constexpr (!std::is_const_v<M>) model.rotation = ModelRef{}.rotation;
  }
}

template <class P>
void judgePiece(P& piece, Judge& j) {
  j.link(piece.level, j.home().levels, "on a level that does not exist: put on none");
  j.link(piece.group, j.home().groups, "in a group that does not exist: taken out");
  j.text(piece.name);
  j.text(piece.description);
  judgeModel(piece.model, j);
  j.place(piece.position, "place not usable or over 10 km away: put at the origin");
  j.length(piece.size.x, "size not positive or over 10 km: changed");
  j.length(piece.size.y, "size not positive or over 10 km: changed");
  j.length(piece.size.z, "size not positive or over 10 km: changed");
  j.angle(piece.angle, "angle not usable: set to zero");
  j.angle(piece.pitch, "angle not usable: set to zero");
  j.angle(piece.roll, "angle not usable: set to zero");
  judgeFinish(piece.finish, j);
  j.atMost(piece.slotFinishes, kMaxParts, "too many surfaces: the rest dropped");
  for (auto& [slot, finish] : piece.slotFinishes) judgeFinish(finish, j);
  const auto badSlot = [](const auto& entry) { return !Judge::isText(entry.first); };
  if (std::any_of(piece.slotFinishes.begin(), piece.slotFinishes.end(), badSlot)) {
    j.found("surfaces whose names cannot be read: left out");
    if constexpr (!std::is_const_v<P>) std::erase_if(piece.slotFinishes, badSlot);
  }
  j.optional(piece.price, -1e12, 1e12, "price not usable: left out");
  j.texts(piece.properties);
}

template <Is<Lamp> L>
void judgeLamp(L& lamp, Judge& j) {
  j.within(lamp.lumens, 0, 1e9, Lamp{}.lumens, "brightness not usable: changed");
  j.within(lamp.colorTemperature, 1000, 40000, Lamp{}.colorTemperature,
           "colour temperature out of 1000..40000 K: brought into it");
  judgeColorOption(lamp.color, j);
  j.within(lamp.beamAngle, 0, 2 * kPi, 0, "beam angle not usable: changed");
  j.within(lamp.dimmer, 0, 1, 1, "dimmer out of 0..1: brought into it");
  j.atMost(lamp.sources, kMaxParts, "too many light sources: the rest dropped");
  for (auto& source : lamp.sources) {
    if (!(isFinite(source.position) && length(source.position) <= 1000)) {
      j.found("place of a light source not usable: put in the middle");
      if constexpr (!std::is_const_v<L>) source.position = LightSource{}.position;
    }
    j.within(source.diameter, 0, 100, 0, "size of a light source not usable: changed");
    judgeColorOption(source.color, j);
    j.within(source.share, 0, 1e9, 1, "share of a light source not usable: changed");
  }
}

template <class S>
void judgeSide(S& side, Judge& j) {
  judgeFinish(side.finish, j);
  if (!side.baseboard) return;
  j.within(side.baseboard->thickness, 0, 100, 0.01, "skirting board not usable: changed");
  j.within(side.baseboard->height, 0, 100, 0.07, "skirting board not usable: changed");
  judgeFinish(side.baseboard->finish, j);
}

// The level of a plan element.
template <class E>
void judgeLevel(E& element, Judge& j) {
  j.link(element.level, j.home().levels, "on a level that does not exist: put on none");
}

template <Is<Level> T>
void rules(T& level, Judge& j) {
  j.text(level.name);
  j.finite(level.elevation, kMaxCoordinate, 0, "elevation not usable or over 10 km: set to zero");
  j.within(level.floorThickness, 0, 100, 0.12, "thickness of its floor not usable: changed");
  j.within(level.height, 1e-3, kMaxCoordinate, 2.5, "height not positive or over 10 km: changed");
}

template <Is<Wall> T>
void rules(T& wall, Judge& j) {
  if (!Judge::isPlace(wall.start) || !Judge::isPlace(wall.end))
    return j.drop("place not usable or over 10 km away: dropped");
  if (length(wall.end - wall.start) < kMinWall) return j.drop("zero length: dropped");
  judgeLevel(wall, j);
  // A full circle would need an infinite radius through two different points.
  j.finite(wall.arcExtent, 2 * kPi - 0.01, 0, "roundness not usable: made straight");
  j.within(wall.thickness, 1e-4, 1000, 0.1, "thickness not positive or over 1 km: changed");
  j.within(wall.heightAtStart, 0, kMaxCoordinate, 2.5, "height not usable or over 10 km: changed");
  j.within(wall.heightAtEnd, 0, kMaxCoordinate, 2.5, "height not usable or over 10 km: changed");
  if (wall.heightAtStart < kMinSize && wall.heightAtEnd < kMinSize) {
    j.found("zero height: given 2.5 m");
    if constexpr (!std::is_const_v<T>) wall.heightAtStart = wall.heightAtEnd = 2.5;
  }
  judgeSide(wall.left, j);
  judgeSide(wall.right, j);
  judgeFinish(wall.top, j);
  j.link(wall.neighbourAtStart, j.home().walls, "joined to a wall that does not exist: left free");
  j.link(wall.neighbourAtEnd, j.home().walls, "joined to a wall that does not exist: left free");
  j.text(wall.pattern);
}

template <Is<Room> T>
void rules(T& room, Judge& j) {
  judgePoints(room.points, j);
  const auto hasArea = [](const Polygon& points) {
    // Only a ring that crosses itself needs the long way.
    return std::abs(signedArea(points)) > kMinRoomArea || area(repair(points)) > kMinRoomArea;
  };
  if (room.points.size() < 3) return j.drop("fewer than three points: dropped");
  // Points without a place are findings already; they have no area to ask for.
  if (std::all_of(room.points.begin(), room.points.end(), [](Vec2 p) { return Judge::isPlace(p); }) &&
      !hasArea(room.points))
    return j.drop("no area: dropped");
  judgeLevel(room, j);
  j.text(room.name);
  judgeFinish(room.floor, j);
  judgeFinish(room.ceiling, j);
  j.place(room.nameOffset, "place of its name not usable: put in the middle");
  j.place(room.areaOffset, "place of its area not usable: put in the middle");
  j.angle(room.nameAngle, "angle of its name not usable: set to zero");
  j.angle(room.areaAngle, "angle of its area not usable: set to zero");
  judgeStyle(room.nameStyle, j);
  judgeStyle(room.areaStyle, j);
}

template <Is<Opening> T>
void rules(T& opening, Judge& j) {
  judgePiece(opening, j);
  j.link(opening.wall, j.home().walls, "in a wall that does not exist: set free");
  judgeCutOut(opening.cutOut, kWholeSquare, j);
  j.within(opening.wallThickness, 0, 1000, 1, "part in the wall not usable: changed");
  j.finite(opening.wallDistance, 1000, 0, "part in the wall not usable: changed");
  j.atMost(opening.sashes, kMaxParts, "too many sashes: the rest dropped");
  for (auto& sash : opening.sashes) {
    j.place(sash.axis, "hinge of a sash not usable: put at the corner");
    j.finite(sash.width, 1000, 1, "width of a sash not usable: changed");
    j.angle(sash.startAngle, "angle of a sash not usable: set to zero");
    j.angle(sash.endAngle, "angle of a sash not usable: set to zero");
  }
}

template <Is<Furniture> T>
void rules(T& furniture, Judge& j) {
  judgePiece(furniture, j);
  if (furniture.lamp) judgeLamp(*furniture.lamp, j);
  judgeCutOut(furniture.staircaseCutOut, {}, j);
  j.optional(furniture.dropOnTopHeight, -kMaxCoordinate, kMaxCoordinate,
             "height where things are put on it not usable: left out");
}

template <Is<Group> T>
void rules(T& group, Judge& j) {
  j.link(group.parent, j.home().groups, "in a group that does not exist: taken out");
  j.text(group.name);
}

template <Is<Camera> T>
void rules(T& camera, Judge& j) {
  j.text(camera.name);
  if (!Judge::isPlace(camera.eye)) {
    j.found("place not usable or over 10 km away: put at the origin");
    if constexpr (!std::is_const_v<T>) camera.eye = Camera{}.eye;
  }
  j.angle(camera.yaw, "direction not usable: changed");
  j.angle(camera.pitch, "direction not usable: changed");
  const bool flat = camera.lens == Lens::Pinhole || camera.lens == Lens::Orthographic;
  j.within(camera.fieldOfView, 0.01, flat ? 3.1 : 2 * kPi, Camera{}.fieldOfView,
           "field of view not usable: changed");
  if (camera.time)
    if (const auto time = static_cast<double>(*camera.time); time < kFirstTime || time > kLastTime) {
      j.found("time not usable: the home's");
      if constexpr (!std::is_const_v<T>) camera.time.reset();
    }
}

template <Is<Picture> T>
void rules(T& picture, Judge& j) {
  if (!j.home().assets || !j.home().assets->contains(picture.asset))
    return j.drop("the picture itself is missing: dropped");
  j.text(picture.name);
  rules(picture.settings.view, j);
  const auto pixels = [&j](auto& side, int fallback) {
    if (side >= 1 && side <= kMaxPictureSide) return;
    j.found("size not usable: changed");
    if constexpr (!std::is_const_v<T>) side = fallback;
  };
  pixels(picture.settings.width, PictureSettings{}.width);
  pixels(picture.settings.height, PictureSettings{}.height);
  const auto count = [&j](auto& samples) {
    if (samples >= 0 && samples <= kMaxPictureSamples) return;
    j.found("number of samples not usable: changed");
    if constexpr (!std::is_const_v<T>) samples = PictureSettings{}.samples;
  };
  count(picture.settings.samples);
  count(picture.samples);
  j.within(picture.settings.seconds, 0, 1e7, 0, "time not usable: changed");
  j.within(picture.settings.brightness, -20, 20, 0, "brightness not usable: changed");
  j.within(picture.settings.aperture, 0, 100, 0, "aperture not usable: changed");
  if (const auto time = static_cast<double>(picture.made); time < kFirstTime || time > kLastTime) {
    j.found("time not usable: changed");
    if constexpr (!std::is_const_v<T>) picture.made = 0;
  }
}

template <Is<Dimension> T>
void rules(T& dimension, Judge& j) {
  if (!Judge::isPlace(dimension.start) || !Judge::isPlace(dimension.end))
    return j.drop("place not usable or over 10 km away: dropped");
  judgeLevel(dimension, j);
  j.finite(dimension.startElevation, kMaxCoordinate, 0, "height not usable: set to zero");
  j.finite(dimension.endElevation, kMaxCoordinate, 0, "height not usable: set to zero");
  j.finite(dimension.offset, kMaxCoordinate, 0, "offset not usable: set to zero");
  j.angle(dimension.pitch, "angle not usable: set to zero");
  judgeColorOption(dimension.color, j);
  j.within(dimension.textSize, 1e-4, 1000, Dimension{}.textSize, "size of a text not usable: changed");
}

template <Is<Label> T>
void rules(T& label, Judge& j) {
  judgeLevel(label, j);
  j.text(label.text);
  j.place(label.position, "place not usable or over 10 km away: put at the origin");
  j.finite(label.elevation, kMaxCoordinate, 0, "height not usable: set to zero");
  j.angle(label.angle, "angle not usable: set to zero");
  j.optional(label.pitch, -1e6, 1e6, "angle not usable: left out");
  judgeStyle(label.style, j);
}

template <Is<Polyline> T>
void rules(T& polyline, Judge& j) {
  judgePoints(polyline.points, j);
  if (polyline.points.size() < 2) return j.drop("fewer than two points: dropped");
  judgeLevel(polyline, j);
  j.within(polyline.thickness, 0, 1000, 0.01, "thickness not usable: changed");
  judgeColor(polyline.color, j);
  j.optional(polyline.elevation, -kMaxCoordinate, kMaxCoordinate, "height not usable: left out");
}

template <Is<Background> T>
void rules(T& background, Judge& j) {
  j.text(background.asset);
  if (!j.home().assets->contains(background.asset)) return j.drop("its picture is missing: dropped");
  j.within(background.scale, 1e-9, 1e6, 0.01, "scale not usable: changed");
  j.place(background.origin, "place not usable: put at the origin");
}

template <Is<Site> T>
void judgeSite(T& site, Judge& j) {
  j.within(site.latitude, -kPi / 2, kPi / 2, 0, "latitude out of range: brought into it");
  j.within(site.longitude, -kPi, kPi, 0, "longitude out of range: brought into it");
  j.angle(site.north, "direction of north not usable: set to zero");
  j.text(site.timeZone);
  if (const auto time = static_cast<double>(site.time); time < kFirstTime || time > kLastTime) {
    j.found("time not usable: changed");
    if constexpr (!std::is_const_v<T>) site.time = Site{}.time;
  }
  j.place(site.compassPosition, "place of the compass not usable: put at the origin");
  j.length(site.compassDiameter, "size of the compass not usable: changed");
}

template <Is<Home> T>
void frameRules(T& home, Judge& j) {
  j.text(home.name);
  j.text(home.title);
  j.text(home.notes);
  j.text(home.currency);
  j.within(home.wallHeight, 0.01, 1000, 2.5, "height of new walls not usable: changed");
  judgeSite(home.site, j);
  judgeFinish(home.environment.ground, j);
  judgeColorOption(home.environment.skyColor, j);
  judgeTexture(home.environment.skyTexture, j);
  j.within(home.environment.cloudiness, 0, 1, 0, "cloudiness out of range: brought into it");
  j.within(home.environment.wallTransparency, 0, 1, 0, "transparency of walls out of range: brought into it");
  j.texts(home.properties);
}

}  // namespace

void judge(Level& e, Judge& j) { rules(e, j); }
void judge(const Level& e, Judge& j) { rules(e, j); }
void judge(Wall& e, Judge& j) { rules(e, j); }
void judge(const Wall& e, Judge& j) { rules(e, j); }
void judge(Room& e, Judge& j) { rules(e, j); }
void judge(const Room& e, Judge& j) { rules(e, j); }
void judge(Opening& e, Judge& j) { rules(e, j); }
void judge(const Opening& e, Judge& j) { rules(e, j); }
void judge(Furniture& e, Judge& j) { rules(e, j); }
void judge(const Furniture& e, Judge& j) { rules(e, j); }
void judge(Group& e, Judge& j) { rules(e, j); }
void judge(const Group& e, Judge& j) { rules(e, j); }
void judge(Camera& e, Judge& j) { rules(e, j); }
void judge(const Camera& e, Judge& j) { rules(e, j); }
void judge(Picture& e, Judge& j) { rules(e, j); }
void judge(const Picture& e, Judge& j) { rules(e, j); }
void judge(Dimension& e, Judge& j) { rules(e, j); }
void judge(const Dimension& e, Judge& j) { rules(e, j); }
void judge(Label& e, Judge& j) { rules(e, j); }
void judge(const Label& e, Judge& j) { rules(e, j); }
void judge(Polyline& e, Judge& j) { rules(e, j); }
void judge(const Polyline& e, Judge& j) { rules(e, j); }
void judge(Background& e, Judge& j) { rules(e, j); }
void judge(const Background& e, Judge& j) { rules(e, j); }
void judgeFrame(Home& e, Judge& j) { frameRules(e, j); }
void judgeFrame(const Home& e, Judge& j) { frameRules(e, j); }

}  // namespace idap
