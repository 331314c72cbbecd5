#include "base/units.h"

#include <gtest/gtest.h>

#include <clocale>
#include <random>

#include "base/error.h"

namespace idap {
namespace {

TEST(Units, ReadsLengthsAsPeopleWriteThem) {
  const std::pair<const char*, double> cases[] = {
      {"3.25", 3.25},
      {"325cm", 3.25},
      {"2.5 m", 2.5},
      {"2,5 m", 2.5},
      {"1200mm", 1.2},
      {"3 dm", 0.3},
      {"10'8\"", 3.2512},
      {"10' 8 1/2\"", 3.2639},
      {"10'8", 3.2512},
      {"10ft 8in", 3.2512},
      {"8 1/2\"", 0.2159},
      {"1/2\"", 0.0127},
      {"10'", 3.048},
      {"8\"", 0.2032},
      {"10' 1/2\"", 3.0607},
      {"10\xE2\x80\xB2 8\xE2\x80\xB3", 3.2512},
      {"  4 ", 4},
      {".5", 0.5},
      {"-2cm", -0.02},
      {"\xE2\x88\x92"
       "2cm",
       -0.02},
      {"120cm+15cm", 1.35},
      {"2*60cm", 1.2},
      {"60cm*2", 1.2},
      {"2 \xC3\x97 60 cm", 1.2},
      {"3m/4", 0.75},
      {"(3m - 2*24cm)/2", 1.26},
      {"1m+1", 2},
      {"3 - 1", 2},
      {"2*3", 6},
      {"3.5\xC2\xA0m", 3.5},
  };
  for (const auto& [text, metres] : cases) EXPECT_NEAR(parseLength(text), metres, 1e-12) << text;
}

TEST(Units, ABareNumberCountsInTheChosenUnit) {
  EXPECT_NEAR(parseLength("120+15", LengthUnit::Centimetre), 1.35, 1e-12);
  EXPECT_NEAR(parseLength("2*60cm", LengthUnit::Millimetre), 1.2, 1e-12);
  EXPECT_NEAR(parseLength("1m + 20", LengthUnit::Centimetre), 1.2, 1e-12);
  EXPECT_NEAR(parseLength("10", LengthUnit::FeetInches), 3.048, 1e-12);
  EXPECT_NEAR(parseLength("1/2", LengthUnit::Centimetre), 0.005, 1e-12);
}

TEST(Units, SaysWhereALengthIsWrong) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "position 1"},     {"abc", "position 1"},       {"3 x", "position 3"},  {"2m*3m", "position 6"},
      {"1/0", "position 4"},  {"(1+2", "position 5"},      {"1..2", "position 5"}, {"4+", "position 3"},
      {"3/2m", "position 5"}, {"10' 8 1/2", "position 7"}, {"inf", "position 1"},  {"5 5", "position 3"},
  };
  for (const auto& [text, place] : cases) {
    try {
      parseLength(text);
      ADD_FAILURE() << text << " was read";
    } catch (const ParseError& error) {
      EXPECT_EQ(error.place(), place) << text << ": " << error.what();
    }
  }
  EXPECT_THROW(parseLength(std::string(100'000, '(')), ParseError);
  EXPECT_THROW(parseLength(std::string(100'000, '-')), ParseError);
  EXPECT_THROW(parseLength(std::string(400, '9')), ParseError);
}

TEST(Units, WritesLengths) {
  EXPECT_EQ(formatLength(3.25, LengthUnit::Metre), "3.25 m");
  EXPECT_EQ(formatLength(3, LengthUnit::Metre), "3 m");
  EXPECT_EQ(formatLength(3.25, LengthUnit::Centimetre), "325 cm");
  EXPECT_EQ(formatLength(100, LengthUnit::Centimetre, 0), "10000 cm");
  EXPECT_EQ(formatLength(0.0123, LengthUnit::Millimetre), "12.3 mm");
  EXPECT_EQ(formatLength(-1e-9, LengthUnit::Metre), "0 m");
  EXPECT_EQ(formatLength(2.345, LengthUnit::Metre, 1), "2.3 m");
  EXPECT_EQ(formatLength(3.2639, LengthUnit::FeetInches), "10' 8 1/2\"");
  EXPECT_EQ(formatLength(3.048, LengthUnit::FeetInches), "10'");
  EXPECT_EQ(formatLength(0.3047, LengthUnit::FeetInches), "1'");
  EXPECT_EQ(formatLength(0.0127, LengthUnit::FeetInches), "1/2\"");
  EXPECT_EQ(formatLength(0, LengthUnit::FeetInches), "0\"");
  EXPECT_EQ(formatLength(-0.2032, LengthUnit::FeetInches), "-8\"");
}

TEST(Units, WhatIsWrittenReadsBack) {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const double metres = std::uniform_real_distribution(0.0, 50.0)(random);
    EXPECT_NEAR(parseLength(formatLength(metres, LengthUnit::Metre)), metres, 0.5e-4);
    EXPECT_NEAR(parseLength(formatLength(metres, LengthUnit::Centimetre)), metres, 0.5e-4);
    EXPECT_NEAR(parseLength(formatLength(metres, LengthUnit::Millimetre)), metres, 0.5e-4);
    EXPECT_NEAR(parseLength(formatLength(metres, LengthUnit::FeetInches)), metres, 0.0254 / 32 + 1e-9);
  }
}

TEST(Units, DoNotDependOnTheLocale) {
  const char* set = std::setlocale(LC_ALL, "de_DE.UTF-8");
  EXPECT_EQ(formatLength(3.25, LengthUnit::Metre), "3.25 m");
  EXPECT_DOUBLE_EQ(parseLength("3.25"), 3.25);
  if (set) std::setlocale(LC_ALL, "C");
}

}  // namespace
}  // namespace idap
