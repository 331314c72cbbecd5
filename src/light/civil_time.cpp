#include "light/civil_time.h"

#include <cctz/civil_time.h>
#include <cctz/time_zone.h>

#include <chrono>

#include "base/error.h"

namespace idap {

namespace {

cctz::time_zone load(const std::string& name) {
  cctz::time_zone zone;
  if (!cctz::load_time_zone(name, &zone)) throw Error("unknown time zone \"" + name + "\"");
  return zone;
}

}  // namespace

bool isTimeZone(const std::string& zone) {
  cctz::time_zone ignored;
  return cctz::load_time_zone(zone, &ignored);
}

std::int64_t utcFromCivil(const CivilTime& local, const std::string& zone) {
  const cctz::civil_second civil(local.year, local.month, local.day, local.hour, local.minute, local.second);
  const cctz::time_zone::civil_lookup found = load(zone).lookup(civil);
  return std::int64_t{1000} * found.pre.time_since_epoch().count();
}

CivilTime civilFromUtc(std::int64_t utc, const std::string& zone) {
  const std::chrono::time_point<std::chrono::system_clock, cctz::seconds> time{
      std::chrono::floor<cctz::seconds>(std::chrono::milliseconds(utc))};
  const cctz::civil_second civil = cctz::convert(time, load(zone));
  return {static_cast<int>(civil.year()),
          civil.month(),
          civil.day(),
          civil.hour(),
          civil.minute(),
          civil.second()};
}

}  // namespace idap
