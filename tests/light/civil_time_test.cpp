#include "light/civil_time.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace idap {
namespace {

constexpr std::int64_t kHour = 3'600'000;

TEST(CivilTime, UtcCountsFrom1970) {
  EXPECT_EQ(utcFromCivil({1970, 1, 1, 0, 0, 0}, "UTC"), 0);
  EXPECT_EQ(utcFromCivil({2000, 1, 1, 12, 0, 0}, "UTC"), 946'728'000'000);
}

TEST(CivilTime, ParisIsAheadByOneHourInWinterAndTwoInSummer) {
  EXPECT_EQ(utcFromCivil({2024, 1, 15, 12}, "Europe/Paris"), utcFromCivil({2024, 1, 15, 11}, "UTC"));
  EXPECT_EQ(utcFromCivil({2024, 7, 15, 12}, "Europe/Paris"), utcFromCivil({2024, 7, 15, 10}, "UTC"));
}

TEST(CivilTime, ComesBackTheSame) {
  const CivilTime local{2031, 8, 5, 21, 47, 13};
  for (const char* zone : {"UTC", "Asia/Kolkata", "America/St_Johns", "Pacific/Auckland"}) {
    EXPECT_EQ(civilFromUtc(utcFromCivil(local, zone), zone), local) << zone;
  }
  EXPECT_EQ(civilFromUtc(-1, "UTC"), (CivilTime{1969, 12, 31, 23, 59, 59}));
}

TEST(CivilTime, SkippedAndRepeatedHoursHaveAMeaning) {
  // New York, 2024: 2:30 does not exist on 10 March, 1:30 exists twice on 3 November.
  EXPECT_EQ(utcFromCivil({2024, 3, 10, 2, 30}, "America/New_York"),
            utcFromCivil({2024, 3, 10, 7, 30}, "UTC"));
  EXPECT_EQ(utcFromCivil({2024, 11, 3, 1, 30}, "America/New_York"),
            utcFromCivil({2024, 11, 3, 5, 30}, "UTC"));
}

TEST(CivilTime, OverflowIsCarried) {
  EXPECT_EQ(utcFromCivil({2024, 1, 32}, "UTC"), utcFromCivil({2024, 2, 1}, "UTC"));
  EXPECT_EQ(utcFromCivil({2024, 1, 1, 24}, "UTC") - utcFromCivil({2024, 1, 1, 23}, "UTC"), kHour);
}

TEST(CivilTime, UnknownZonesAreRefusedByName) {
  EXPECT_TRUE(isTimeZone("Europe/Vienna"));
  EXPECT_FALSE(isTimeZone("Mars/Olympus"));
  EXPECT_THROW(utcFromCivil({}, "Mars/Olympus"), Error);
  EXPECT_THROW(civilFromUtc(0, "Mars/Olympus"), Error);
}

}  // namespace
}  // namespace idap
