#include "base/error.h"

#include <gtest/gtest.h>

#include "base/progress.h"

namespace idap {
namespace {

TEST(Error, AParseErrorNamesFilePlaceAndReason) {
  const ParseError error("home.idap", "home.json#/walls/3", "expected a number");
  EXPECT_STREQ(error.what(), "home.idap: home.json#/walls/3: expected a number");
  EXPECT_STREQ(ParseError("a.zip", "", "damaged").what(), "a.zip: damaged");
  EXPECT_EQ(error.file(), "home.idap");
  EXPECT_EQ(error.place(), "home.json#/walls/3");
}

TEST(Progress, TellsAndStops) {
  double last = 0;
  Progress progress([&](double fraction, std::string_view) { last = fraction; });
  progress.report(0.5, "half");
  EXPECT_EQ(last, 0.5);
  EXPECT_NO_THROW(progress.check());
  progress.cancel();
  EXPECT_THROW(progress.check(), Cancelled);
  Progress().report(1, "nobody listens");
}

}  // namespace
}  // namespace idap
