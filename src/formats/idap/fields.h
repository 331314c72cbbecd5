// The one list of what is stored: each struct of the model with the names of its members in home.json.
// Reading and writing both follow it, so a new member is one line here.
#pragma once

#include <array>
#include <string_view>

#include "model/home.h"

namespace idap::idap_format {

// listFields(archive, Of<T>{}) calls archive("name", &T::member) for each stored member of T.
template <class T>
struct Of {};

struct NoArchive {
  template <class Member>
  NoArchive& operator()(const char*, Member);
};
template <class T>
concept Described = requires(NoArchive& archive) {
  listFields(archive, Of<T>{});
};

// The words an enum is stored as, in the order of its values.
template <class E>
struct EnumNames;

template <class E>
concept NamedEnum = requires {
  EnumNames<E>::kNames;
};

template <>
struct EnumNames<Lens> {
  static constexpr auto kNames =
      std::to_array<std::string_view>({"pinhole", "orthographic", "fisheye", "spherical"});
};
template <>
struct EnumNames<OpeningKind> {
  static constexpr auto kNames = std::to_array<std::string_view>({"door", "window", "bare"});
};
template <>
struct EnumNames<TextAlignment> {
  static constexpr auto kNames = std::to_array<std::string_view>({"left", "centre", "right"});
};
template <>
struct EnumNames<PictureLamps> {
  static constexpr auto kNames = std::to_array<std::string_view>({"home", "on", "off"});
};
template <>
struct EnumNames<PictureTone> {
  static constexpr auto kNames = std::to_array<std::string_view>({"neutral", "film", "false-color"});
};
template <>
struct EnumNames<LineDash> {
  static constexpr auto kNames =
      std::to_array<std::string_view>({"solid", "dot", "dash", "dash-dot", "dash-dot-dot"});
};
template <>
struct EnumNames<LineArrow> {
  static constexpr auto kNames = std::to_array<std::string_view>({"none", "delta", "open", "disc"});
};

template <class A>
void listFields(A& a, Of<TextureRef>) {
  using T = TextureRef;
  a("asset", &T::asset)("size", &T::size)("offset", &T::offset)("angle", &T::angle);
  a("fitToArea", &T::fitToArea);
}

template <class A>
void listFields(A& a, Of<Finish>) {
  using T = Finish;
  a("material", &T::material)("color", &T::color)("texture", &T::texture);
  a("roughness", &T::roughness)("metalness", &T::metalness)("transmission", &T::transmission);
}

template <class A>
void listFields(A& a, Of<TextStyle>) {
  using T = TextStyle;
  a("font", &T::font)("size", &T::size)("bold", &T::bold)("italic", &T::italic);
  a("alignment", &T::alignment)("color", &T::color);
}

template <class A>
void listFields(A& a, Of<Site>) {
  using T = Site;
  a("latitude", &T::latitude)("longitude", &T::longitude)("north", &T::north);
  a("timeZone", &T::timeZone)("time", &T::time)("compassPosition", &T::compassPosition);
  a("compassDiameter", &T::compassDiameter)("compassVisible", &T::compassVisible);
}

template <class A>
void listFields(A& a, Of<Environment>) {
  using T = Environment;
  a("ground", &T::ground)("skyColor", &T::skyColor)("skyTexture", &T::skyTexture);
  a("wallTransparency", &T::wallTransparency);
  a("cloudiness", &T::cloudiness);
}

template <class A>
void listFields(A& a, Of<Level>) {
  using T = Level;
  a("name", &T::name)("elevation", &T::elevation)("floorThickness", &T::floorThickness);
  a("height", &T::height)("order", &T::order)("visible", &T::visible);
  a("viewable", &T::viewable);
}

template <class A>
void listFields(A& a, Of<Baseboard>) {
  using T = Baseboard;
  a("thickness", &T::thickness)("height", &T::height)("finish", &T::finish);
}

template <class A>
void listFields(A& a, Of<WallSide>) {
  using T = WallSide;
  a("finish", &T::finish)("baseboard", &T::baseboard);
}

template <class A>
void listFields(A& a, Of<Wall>) {
  using T = Wall;
  a("level", &T::level)("start", &T::start)("end", &T::end)("arcExtent", &T::arcExtent);
  a("thickness", &T::thickness)("heightAtStart", &T::heightAtStart)("heightAtEnd", &T::heightAtEnd);
  a("left", &T::left)("right", &T::right)("top", &T::top)("pattern", &T::pattern);
  a("neighbourAtStart", &T::neighbourAtStart)("neighbourAtEnd", &T::neighbourAtEnd);
}

template <class A>
void listFields(A& a, Of<Room>) {
  using T = Room;
  a("level", &T::level)("name", &T::name)("points", &T::points);
  a("floor", &T::floor)("ceiling", &T::ceiling)("floorVisible", &T::floorVisible);
  a("ceilingVisible", &T::ceilingVisible)("ceilingFlat", &T::ceilingFlat);
  a("areaVisible", &T::areaVisible)("nameOffset", &T::nameOffset)("areaOffset", &T::areaOffset);
  a("nameAngle", &T::nameAngle)("areaAngle", &T::areaAngle);
  a("nameStyle", &T::nameStyle)("areaStyle", &T::areaStyle);
}

template <class A>
void listFields(A& a, Of<ModelRef>) {
  using T = ModelRef;
  a("catalogId", &T::catalogId)("asset", &T::asset)("parameters", &T::parameters);
  a("rotation", &T::rotation)("backFacesShown", &T::backFacesShown)("smoothed", &T::smoothed);
}

template <class A>
void listFields(A& a, Of<Piece>) {
  using T = Piece;
  a("level", &T::level)("group", &T::group)("name", &T::name)("description", &T::description);
  a("model", &T::model)("position", &T::position)("size", &T::size)("angle", &T::angle);
  a("pitch", &T::pitch)("roll", &T::roll)("mirrored", &T::mirrored)("finish", &T::finish);
  a("slotFinishes", &T::slotFinishes)("visible", &T::visible)("nameVisible", &T::nameVisible);
  a("locked", &T::locked)("price", &T::price)("properties", &T::properties);
}

template <class A>
void listFields(A& a, Of<Sash>) {
  using T = Sash;
  a("axis", &T::axis)("width", &T::width);
  a("startAngle", &T::startAngle)("endAngle", &T::endAngle);
}

template <class A>
void listFields(A& a, Of<Opening>) {
  using T = Opening;
  listFields(a, Of<Piece>{});
  a("kind", &T::kind)("wall", &T::wall)("cutOut", &T::cutOut)("cutsWalls", &T::cutsWalls);
  a("cutsBothSides", &T::cutsBothSides)("wallThickness", &T::wallThickness);
  a("wallDistance", &T::wallDistance)("sashes", &T::sashes);
}

template <class A>
void listFields(A& a, Of<LightSource>) {
  using T = LightSource;
  a("position", &T::position)("diameter", &T::diameter)("color", &T::color)("share", &T::share);
}

template <class A>
void listFields(A& a, Of<Lamp>) {
  using T = Lamp;
  a("lumens", &T::lumens)("colorTemperature", &T::colorTemperature)("color", &T::color);
  a("beamAngle", &T::beamAngle)("on", &T::on)("dimmer", &T::dimmer)("sources", &T::sources);
}

template <class A>
void listFields(A& a, Of<Furniture>) {
  using T = Furniture;
  listFields(a, Of<Piece>{});
  a("lamp", &T::lamp)("staircaseCutOut", &T::staircaseCutOut);
  a("dropOnTopHeight", &T::dropOnTopHeight);
}

template <class A>
void listFields(A& a, Of<Group>) {
  using T = Group;
  a("parent", &T::parent)("name", &T::name)("visible", &T::visible);
}

template <class A>
void listFields(A& a, Of<Camera>) {
  using T = Camera;
  a("name", &T::name)("eye", &T::eye)("yaw", &T::yaw)("pitch", &T::pitch);
  a("fieldOfView", &T::fieldOfView)("lens", &T::lens)("time", &T::time);
}

template <class A>
void listFields(A& a, Of<PictureSettings>) {
  using T = PictureSettings;
  a("view", &T::view)("fromAbove", &T::fromAbove)("width", &T::width)("height", &T::height);
  a("classic", &T::classic)("samples", &T::samples)("seconds", &T::seconds)("lamps", &T::lamps);
  a("tone", &T::tone)("brightness", &T::brightness)("upright", &T::upright)("aperture", &T::aperture);
}

template <class A>
void listFields(A& a, Of<Picture>) {
  using T = Picture;
  a("name", &T::name)("settings", &T::settings)("made", &T::made)("samples", &T::samples);
  a("asset", &T::asset);
}

template <class A>
void listFields(A& a, Of<Dimension>) {
  using T = Dimension;
  a("level", &T::level)("start", &T::start)("end", &T::end);
  a("startElevation", &T::startElevation)("endElevation", &T::endElevation);
  a("offset", &T::offset)("pitch", &T::pitch)("color", &T::color)("textSize", &T::textSize);
}

template <class A>
void listFields(A& a, Of<Label>) {
  using T = Label;
  a("level", &T::level)("text", &T::text)("position", &T::position);
  a("elevation", &T::elevation)("angle", &T::angle)("pitch", &T::pitch)("style", &T::style);
}

template <class A>
void listFields(A& a, Of<Polyline>) {
  using T = Polyline;
  a("level", &T::level)("points", &T::points)("closed", &T::closed)("curved", &T::curved);
  a("thickness", &T::thickness)("dash", &T::dash)("startArrow", &T::startArrow);
  a("endArrow", &T::endArrow)("color", &T::color)("elevation", &T::elevation);
}

template <class A>
void listFields(A& a, Of<Background>) {
  using T = Background;
  a("asset", &T::asset)("scale", &T::scale)("origin", &T::origin)("visible", &T::visible);
}

template <class A>
void listFields(A& a, Of<Home>) {
  using T = Home;
  a("name", &T::name)("title", &T::title)("notes", &T::notes)("currency", &T::currency);
  a("wallHeight", &T::wallHeight)("site", &T::site)("environment", &T::environment);
  a("levels", &T::levels)("groups", &T::groups)("walls", &T::walls)("rooms", &T::rooms);
  a("openings", &T::openings)("furniture", &T::furniture)("cameras", &T::cameras);
  a("dimensions", &T::dimensions)("labels", &T::labels)("polylines", &T::polylines);
  a("pictures", &T::pictures);
  a("backgrounds", &T::backgrounds)("properties", &T::properties)("nextId", &T::nextId);
}

}  // namespace idap::idap_format
