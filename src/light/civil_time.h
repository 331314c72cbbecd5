// Clock time at a place and time everywhere: IANA time zones with their daylight saving, by cctz.
#pragma once

#include <cstdint>
#include <string>

namespace idap {

struct CivilTime {
  int year = 1970, month = 1, day = 1;  // month and day from 1
  int hour = 0, minute = 0, second = 0;
  friend bool operator==(const CivilTime&, const CivilTime&) = default;
};

bool isTimeZone(const std::string& zone);  // "Europe/Paris", "UTC", ...

// Milliseconds since 1970. Fields out of their range are carried over (day 32 of a month is the next month's
// 1st). A time that the clocks skip is read as if they had not yet been moved; one that occurs twice is the
// first. Throws Error for an unknown zone.
std::int64_t utcFromCivil(const CivilTime& local, const std::string& zone);

CivilTime civilFromUtc(std::int64_t utc, const std::string& zone);

}  // namespace idap
