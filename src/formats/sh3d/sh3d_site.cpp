// The place, the surroundings and the points of view.
#include <cctz/civil_time.h>
#include <cctz/time_zone.h>

#include <cmath>

#include "formats/sh3d/sh3d_context.h"

namespace idap {

namespace {

constexpr double kMaxMilliseconds = 4e14;  // some 12 000 years

// The file's times are clock times at the home, written as if its clock showed UTC.
std::int64_t instantOf(std::int64_t clock, const std::string& zoneName) {
  cctz::time_zone zone;
  if (!cctz::load_time_zone(zoneName, &zone)) return clock;
  using cctz::seconds;
  const std::int64_t whole = clock >= 0 ? clock / 1000 : -((999 - clock) / 1000);
  const auto shown = cctz::convert(cctz::time_point<seconds>(seconds(whole)), cctz::utc_time_zone());
  const auto instant = cctz::convert(shown, zone);
  return instant.time_since_epoch().count() * 1000 + (clock - whole * 1000);
}

Lens lensOf(const std::string& name) {
  if (name == "FISHEYE") return Lens::Fisheye;
  if (name == "SPHERICAL") return Lens::Spherical;
  return Lens::Pinhole;  // and NORMAL, a pinhole with depth of field
}

}  // namespace

void readCompass(Sh3dContext& context, const Sh3dElement& element) {
  Site& site = context.home.site;
  site.north = sh3dAngle(element.number("northDirection", 0));
  if (const auto latitude = element.number("latitude"); latitude && std::abs(*latitude) <= kPi / 2 + 1e-6)
    site.latitude = *latitude;
  if (const auto longitude = element.number("longitude"))
    site.longitude = std::remainder(*longitude, 2 * kPi);
  if (element.has("timeZone")) {
    cctz::time_zone zone;
    if (cctz::load_time_zone(element.text("timeZone"), &zone)) {
      site.timeZone = element.text("timeZone");
    } else {
      context.report.add(element.place(),
                         "unknown time zone \"" + element.text("timeZone") + "\": UTC taken");
    }
  }
  if (const auto position = element.point("x", "y")) site.compassPosition = *position;
  site.compassDiameter = element.length("diameter", site.compassDiameter);
  site.compassVisible = element.flag("visible", true);
}

void readEnvironment(Sh3dContext& context, const Sh3dElement& element) {
  Environment& environment = context.home.environment;
  const Finish ground = sh3dFinish(context, element, "groundColor", "groundTexture", nullptr);
  if (!ground.empty()) environment.ground = ground;
  environment.skyColor = element.color("skyColor");
  environment.skyTexture = sh3dTexture(context, element, "skyTexture");
  const double transparency = element.number("wallsAlpha", 0);
  if (transparency >= 0 && transparency <= 1) environment.wallTransparency = transparency;
}

void readCamera(Sh3dContext& context, const Sh3dElement& element) {
  const auto eye = element.point("x", "y");
  const auto height = element.length("z");
  const auto yaw = element.number("yaw"), pitch = element.number("pitch");
  if (!eye || !height || !yaw || !pitch) {
    context.report.add(element.place(), "a point of view without a place or a direction: dropped");
    return;
  }
  Camera camera;
  camera.name = element.text("name");
  camera.eye = {eye->x, eye->y, *height};
  // The file looks along (-sin yaw, cos yaw) with y down: the mirror image, seen from y up, of the yaw beyond
  // pi.
  camera.yaw = std::remainder(kPi - *yaw, 2 * kPi);
  camera.pitch = std::remainder(*pitch, 2 * kPi);
  const double field = element.number("fieldOfView", camera.fieldOfView);
  if (field > 0 && field <= 2 * kPi) camera.fieldOfView = field;
  camera.lens = lensOf(element.text("lens"));
  // Milliseconds: more than number() takes for a length.
  const double time = element.node().attribute("time").as_double(0);
  if (element.has("time") && std::abs(time) < kMaxMilliseconds)
    camera.time = instantOf(std::int64_t(time), context.home.site.timeZone);

  const std::string attribute = element.text("attribute");
  if (attribute == "storedCamera") {
    context.home.cameras.set(context.home.newId<CameraId>(), std::move(camera));
  } else if (attribute == "observerCamera") {
    if (camera.time) context.home.site.time = *camera.time;
    context.home.observer = std::move(camera);
  } else if (attribute == "topCamera") {
    context.home.aerial = std::move(camera);
  }  // the points of a video's path are not kept
}

}  // namespace idap
