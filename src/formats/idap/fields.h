// The one list of what is stored: each struct of the model with the names of its members in home.json.
// Reading and writing both follow it, so a new member is one line here.
#pragma once

#include <array>
#include <string_view>

#include "model/home.h"

namespace idap::idap_format {

// A struct described by Fields<T>::list(archive), which calls archive("name", &T::member) for each member.
template <class T>
struct Fields;

template <class T>
concept Described = requires {
  Fields<T>::kDescribed;
};

// The words an enum is stored as, in the order of its values.
template <class E>
struct EnumNames;

template <class E>
concept NamedEnum = requires {
  EnumNames<E>::kNames;
};

#define IDAP_FIELDS(Type)                    \
  template <>                                \
  struct Fields<Type> {                      \
    using Self = Type;                       \
    static constexpr bool kDescribed = true; \
    template <class A>                       \
    static void list(A& a)

#define IDAP_ENUM(Type, ...)                                                       \
  template <>                                                                      \
  struct EnumNames<Type> {                                                         \
    static constexpr auto kNames = std::to_array<std::string_view>({__VA_ARGS__}); \
  };

IDAP_ENUM(Lens, "pinhole", "orthographic", "fisheye", "spherical")
IDAP_ENUM(OpeningKind, "door", "window", "bare")
IDAP_ENUM(TextAlignment, "left", "centre", "right")
IDAP_ENUM(LineDash, "solid", "dot", "dash", "dash-dot", "dash-dot-dot")
IDAP_ENUM(LineArrow, "none", "delta", "open", "disc")

IDAP_FIELDS(TextureRef) {
  a("asset", &Self::asset)("size", &Self::size)("offset", &Self::offset)("angle", &Self::angle);
  a("fitToArea", &Self::fitToArea);
}
};

IDAP_FIELDS(Finish) {
  a("material", &Self::material)("color", &Self::color)("texture", &Self::texture);
  a("roughness", &Self::roughness)("metalness", &Self::metalness)("transmission", &Self::transmission);
}
}
;

IDAP_FIELDS(TextStyle) {
  a("font", &Self::font)("size", &Self::size)("bold", &Self::bold)("italic", &Self::italic);
  a("alignment", &Self::alignment)("color", &Self::color);
}
}
;

IDAP_FIELDS(Site) {
  a("latitude", &Self::latitude)("longitude", &Self::longitude)("north", &Self::north);
  a("timeZone", &Self::timeZone)("time", &Self::time)("compassPosition", &Self::compassPosition);
  a("compassDiameter", &Self::compassDiameter)("compassVisible", &Self::compassVisible);
}
}
;

IDAP_FIELDS(Environment) {
  a("ground", &Self::ground)("skyColor", &Self::skyColor)("skyTexture", &Self::skyTexture);
  a("wallTransparency", &Self::wallTransparency);
}
}
;

IDAP_FIELDS(Level) {
  a("name", &Self::name)("elevation", &Self::elevation)("floorThickness", &Self::floorThickness);
  a("height", &Self::height)("order", &Self::order)("visible", &Self::visible);
  a("viewable", &Self::viewable);
}
}
;

IDAP_FIELDS(Baseboard) { a("thickness", &Self::thickness)("height", &Self::height)("finish", &Self::finish); }
}
;

IDAP_FIELDS(WallSide) { a("finish", &Self::finish)("baseboard", &Self::baseboard); }
}
;

IDAP_FIELDS(Wall) {
  a("level", &Self::level)("start", &Self::start)("end", &Self::end)("arcExtent", &Self::arcExtent);
  a("thickness", &Self::thickness)("heightAtStart", &Self::heightAtStart)("heightAtEnd", &Self::heightAtEnd);
  a("left", &Self::left)("right", &Self::right)("top", &Self::top)("pattern", &Self::pattern);
  a("neighbourAtStart", &Self::neighbourAtStart)("neighbourAtEnd", &Self::neighbourAtEnd);
}
}
;

IDAP_FIELDS(Room) {
  a("level", &Self::level)("name", &Self::name)("points", &Self::points);
  a("floor", &Self::floor)("ceiling", &Self::ceiling)("floorVisible", &Self::floorVisible);
  a("ceilingVisible", &Self::ceilingVisible)("ceilingFlat", &Self::ceilingFlat);
  a("areaVisible", &Self::areaVisible)("nameOffset", &Self::nameOffset)("areaOffset", &Self::areaOffset);
  a("nameAngle", &Self::nameAngle)("areaAngle", &Self::areaAngle);
  a("nameStyle", &Self::nameStyle)("areaStyle", &Self::areaStyle);
}
}
;

IDAP_FIELDS(ModelRef) {
  a("catalogId", &Self::catalogId)("asset", &Self::asset)("parameters", &Self::parameters);
  a("rotation", &Self::rotation)("backFacesShown", &Self::backFacesShown)("smoothed", &Self::smoothed);
}
}
;

IDAP_FIELDS(Piece) {
  a("level", &Self::level)("group", &Self::group)("name", &Self::name)("description", &Self::description);
  a("model", &Self::model)("position", &Self::position)("size", &Self::size)("angle", &Self::angle);
  a("pitch", &Self::pitch)("roll", &Self::roll)("mirrored", &Self::mirrored)("finish", &Self::finish);
  a("slotFinishes", &Self::slotFinishes)("visible", &Self::visible)("nameVisible", &Self::nameVisible);
  a("locked", &Self::locked)("price", &Self::price)("properties", &Self::properties);
}
}
;

IDAP_FIELDS(Sash) {
  a("axis", &Self::axis)("width", &Self::width);
  a("startAngle", &Self::startAngle)("endAngle", &Self::endAngle);
}
}
;

IDAP_FIELDS(Opening) {
  Fields<Piece>::list(a);
  a("kind", &Self::kind)("wall", &Self::wall)("cutOut", &Self::cutOut)("cutsWalls", &Self::cutsWalls);
  a("cutsBothSides", &Self::cutsBothSides)("wallThickness", &Self::wallThickness);
  a("wallDistance", &Self::wallDistance)("sashes", &Self::sashes);
}
}
;

IDAP_FIELDS(LightSource) {
  a("position", &Self::position)("diameter", &Self::diameter)("color", &Self::color)("share", &Self::share);
}
}
;

IDAP_FIELDS(Lamp) {
  a("lumens", &Self::lumens)("colorTemperature", &Self::colorTemperature)("color", &Self::color);
  a("beamAngle", &Self::beamAngle)("on", &Self::on)("dimmer", &Self::dimmer)("sources", &Self::sources);
}
}
;

IDAP_FIELDS(Furniture) {
  Fields<Piece>::list(a);
  a("lamp", &Self::lamp)("staircaseCutOut", &Self::staircaseCutOut);
  a("dropOnTopHeight", &Self::dropOnTopHeight);
}
}
;

IDAP_FIELDS(Group) { a("parent", &Self::parent)("name", &Self::name)("visible", &Self::visible); }
}
;

IDAP_FIELDS(Camera) {
  a("name", &Self::name)("eye", &Self::eye)("yaw", &Self::yaw)("pitch", &Self::pitch);
  a("fieldOfView", &Self::fieldOfView)("lens", &Self::lens)("time", &Self::time);
}
}
;

IDAP_FIELDS(Dimension) {
  a("level", &Self::level)("start", &Self::start)("end", &Self::end);
  a("startElevation", &Self::startElevation)("endElevation", &Self::endElevation);
  a("offset", &Self::offset)("pitch", &Self::pitch)("color", &Self::color)("textSize", &Self::textSize);
}
}
;

IDAP_FIELDS(Label) {
  a("level", &Self::level)("text", &Self::text)("position", &Self::position);
  a("elevation", &Self::elevation)("angle", &Self::angle)("pitch", &Self::pitch)("style", &Self::style);
}
}
;

IDAP_FIELDS(Polyline) {
  a("level", &Self::level)("points", &Self::points)("closed", &Self::closed)("curved", &Self::curved);
  a("thickness", &Self::thickness)("dash", &Self::dash)("startArrow", &Self::startArrow);
  a("endArrow", &Self::endArrow)("color", &Self::color)("elevation", &Self::elevation);
}
}
;

IDAP_FIELDS(Background) {
  a("asset", &Self::asset)("scale", &Self::scale)("origin", &Self::origin)("visible", &Self::visible);
}
}
;

IDAP_FIELDS(Home) {
  a("name", &Self::name)("title", &Self::title)("notes", &Self::notes)("currency", &Self::currency);
  a("wallHeight", &Self::wallHeight)("site", &Self::site)("environment", &Self::environment);
  a("levels", &Self::levels)("groups", &Self::groups)("walls", &Self::walls)("rooms", &Self::rooms);
  a("openings", &Self::openings)("furniture", &Self::furniture)("cameras", &Self::cameras);
  a("dimensions", &Self::dimensions)("labels", &Self::labels)("polylines", &Self::polylines);
  a("backgrounds", &Self::backgrounds)("properties", &Self::properties)("nextId", &Self::nextId);
}
}
;

#undef IDAP_FIELDS
#undef IDAP_ENUM

}  // namespace idap::idap_format
