#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "film/film_plan.h"
#include "light/sun_position.h"

namespace idap {

namespace {

constexpr std::int64_t kMinute = 60'000;
constexpr std::int64_t kTwilight = 20 * kMinute;

}  // namespace

FilmPlan planDay(const Home& home, const Camera& camera, const DaySettings& settings) {
  FilmPlan plan;
  plan.home = home;
  plan.framesPerSecond = settings.framesPerSecond;
  plan.day = true;
  const std::string zone = isTimeZone(home.site.timeZone) ? home.site.timeZone : "UTC";
  CivilTime midnight = settings.date;
  midnight.hour = midnight.minute = midnight.second = 0;
  const std::int64_t dayStart = utcFromCivil(midnight, zone);
  const SunTimes sun = sunTimes(home.site.latitude, home.site.longitude, dayStart);
  // By the clock on the wall, whatever is done to it that day.
  const auto atHour = [&](double hours) {
    CivilTime t = midnight;
    t.second = static_cast<int>(std::lround(hours * 3600));
    return utcFromCivil(t, zone);
  };
  std::int64_t begin = dayStart, end = atHour(24);
  if (settings.from)
    begin = atHour(*settings.from);
  else if (sun.sunrise)
    begin = *sun.sunrise - kTwilight;
  if (settings.to)
    end = atHour(*settings.to);
  else if (sun.sunset)
    end = *sun.sunset + kTwilight;
  if (end <= begin)
    throw Error("a day's film must end after it begins: choose a later end or an earlier beginning");
  if (!sun.sunrise && !sun.sunset && !(settings.from && settings.to))
    plan.warnings.push_back(
        "the sun neither rises nor sets at this place on that day; the film shows the hours given");
  const auto frames = std::max<std::int64_t>(2, std::llround(settings.seconds * settings.framesPerSecond));
  for (std::int64_t i = 0; i < frames; ++i) {
    Camera frame = camera;
    frame.name.clear();
    frame.time = begin + (end - begin) * i / (frames - 1);
    plan.frames.push_back(std::move(frame));
  }
  return plan;
}

}  // namespace idap
