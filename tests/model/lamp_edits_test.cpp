#include "model/edits/lamp_edits.h"

#include <gtest/gtest.h>

namespace idap {
namespace {

struct LampEdits : testing::Test {
  LampEdits() {
    Furniture piece;
    piece.name = "floor lamp";
    piece.size = {0.3, 0.3, 1.6};
    piece.lamp = Lamp{.lumens = 800, .dimmer = 0.5};
    piece.lamp->sources.push_back({.color = Color{1, 0, 0}});
    lamp = home.newId<FurnitureId>();
    home.furniture.set(lamp, piece);
  }
  const Lamp& after(const LampChange& change) {
    changed = withLampsChanged(home, {change});
    return *changed.furniture.find(lamp)->lamp;
  }
  Home home, changed;
  FurnitureId lamp;
};

TEST_F(LampEdits, StrengthDimsAndBeyondItsPowerMakesAStrongerLamp) {
  EXPECT_NEAR(after({lamp, 0.4}).dimmer, 0.2, 1e-12);
  const Lamp& bright = after({lamp, 3});
  EXPECT_EQ(bright.dimmer, 1);
  EXPECT_NEAR(bright.lumens, 1200, 1e-9);
}

TEST_F(LampEdits, NoughtSwitchesOff) {
  EXPECT_FALSE(after({lamp, 0}).on);
  EXPECT_EQ(after({lamp, 0}).dimmer, 0.5);
}

TEST_F(LampEdits, AColourTemperatureTakesTheColoursPlace) {
  const Lamp& warm = after({lamp, 1, 2200.0});
  EXPECT_EQ(warm.colorTemperature, 2200);
  EXPECT_FALSE(warm.sources.front().color);
}

TEST_F(LampEdits, WhatIsNoLampIsPassedOver) {
  EXPECT_EQ(withLampsChanged(home, {{FurnitureId{4711}, 0}}).furniture, home.furniture);
}

}  // namespace
}  // namespace idap
