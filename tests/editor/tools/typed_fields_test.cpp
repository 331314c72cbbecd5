#include "editor/tools/typed_fields.h"

#include <gtest/gtest.h>

namespace idap {
namespace {

using Answer = TypedFields::Answer;

class TypedFieldsTest : public testing::Test {
 protected:
  Answer type(const std::string& text, LengthUnit unit = LengthUnit::Metre) {
    Answer answer = Answer::Unused;
    for (const char c : text) answer = fields.key({Key::Character, std::string(1, c), {}}, unit);
    return answer;
  }
  Answer key(Key key, Modifiers modifiers = {}) {
    return fields.key({key, {}, modifiers}, LengthUnit::Metre);
  }

  TypedFields fields{{{"Length", Field::Kind::Length}, {"Angle", Field::Kind::Angle}}};
};

TEST_F(TypedFieldsTest, TakesLengthsInTheUsersUnit) {
  EXPECT_EQ(type("325", LengthUnit::Centimetre), Answer::Changed);
  EXPECT_NEAR(fields.value(0).value(), 3.25, 1e-12);
  EXPECT_EQ(key(Key::Enter), Answer::Apply);
}

TEST_F(TypedFieldsTest, TakesUnitsFeetAndSums) {
  type("325cm");
  EXPECT_NEAR(fields.value(0).value(), 3.25, 1e-12);
  fields.clear();
  type("10'8\"");
  EXPECT_NEAR(fields.value(0).value(), 3.2512, 1e-9);
  fields.clear();
  type("1,2+0.3");
  EXPECT_NEAR(fields.value(0).value(), 1.5, 1e-12);
}

TEST_F(TypedFieldsTest, TabGoesToTheAngleInDegreesAndRound) {
  EXPECT_EQ(key(Key::Tab), Answer::Changed);
  EXPECT_EQ(fields.active(), 1u);
  type("90-45");
  EXPECT_NEAR(fields.value(1).value(), kPi / 4, 1e-12);
  EXPECT_FALSE(fields.value(0));
  key(Key::Tab);
  EXPECT_EQ(fields.active(), 0u);
  key(Key::BackTab);
  EXPECT_EQ(fields.active(), 1u);
}

TEST_F(TypedFieldsTest, LettersBeginNothingSoThatShortcutsWork) {
  EXPECT_EQ(type("m"), Answer::Unused);
  EXPECT_EQ(type("r"), Answer::Unused);
  EXPECT_FALSE(fields.typing());
}

TEST_F(TypedFieldsTest, WhatCannotBeUnderstoodIsMarkedAndNotApplied) {
  type("3+");
  EXPECT_TRUE(fields.wrong());
  EXPECT_FALSE(fields.value(0));
  EXPECT_EQ(key(Key::Enter), Answer::Wrong);
  type("1");
  EXPECT_FALSE(fields.wrong());
  EXPECT_EQ(key(Key::Enter), Answer::Apply);
}

TEST_F(TypedFieldsTest, BackspaceAndEscapeTakeBack) {
  type("35");
  EXPECT_EQ(key(Key::Backspace), Answer::Changed);
  EXPECT_NEAR(fields.value(0).value(), 3, 1e-12);
  EXPECT_EQ(key(Key::Escape), Answer::Changed);
  EXPECT_FALSE(fields.typing());
  EXPECT_EQ(key(Key::Escape), Answer::Unused);
  EXPECT_EQ(key(Key::Backspace), Answer::Unused);
  EXPECT_EQ(key(Key::Enter), Answer::Unused);
}

TEST_F(TypedFieldsTest, TextsTakeAnythingAndWholeCharactersBack) {
  fields.define({{"Text", Field::Kind::Text}});
  fields.key({Key::Character, "\xE0\xB8\x81", {}}, LengthUnit::Metre);
  fields.key({Key::Character, "a", {}}, LengthUnit::Metre);
  Modifiers shift;
  shift.shift = true;
  key(Key::Enter, shift);
  EXPECT_EQ(fields.text(0),
            "\xE0\xB8\x81"
            "a\n");
  key(Key::Backspace);
  key(Key::Backspace);
  key(Key::Backspace);
  EXPECT_EQ(fields.text(0), "");
}

TEST(ParseAngle, ReadsDegrees) {
  EXPECT_NEAR(parseAngle("30\xC2\xB0").value(), kPi / 6, 1e-12);
  EXPECT_NEAR(parseAngle("-22,5").value(), -kPi / 8, 1e-12);
  EXPECT_NEAR(parseAngle("45deg").value(), kPi / 4, 1e-12);
  EXPECT_FALSE(parseAngle("3m"));
  EXPECT_FALSE(parseAngle(""));
}

}  // namespace
}  // namespace idap
