// Curves that bring exposed linear light (1 = the display's white) into 0..1.
#pragma once

#include <string_view>

#include "light/rgb.h"

namespace idap::render {

enum class ToneMap {
  PbrNeutral,  // keeps colours true and rolls off highlights @cite khronos2024neutral
  AgX,         // film-like, softer contrast, highlights go to white @cite sobotka2022agx
  Classic,     // clipped channel by channel, as in 1993; not exposed either
  Linear,      // exposed and clipped
  FalseColor,  // brightness as colour: see falseColor()
};

inline constexpr ToneMap kToneMaps[] = {ToneMap::PbrNeutral, ToneMap::AgX, ToneMap::Classic, ToneMap::Linear,
                                        ToneMap::FalseColor};

std::string_view name(ToneMap toneMap);  // "neutral", "agx", "classic", "linear", "false"

// Brightness in stops about middle grey (0.18), from dark to bright: 6 and more below black to purple, blue
// at -4, cyan at -2, green at 0, yellow at +1, orange at +2, red at 2.5 (the display's white), from 3.5 on
// white. Linear.
Rgb falseColor(float luminance);

// Input: linear, finite or not. Output: linear, every channel in 0..1.
Rgb toneMapped(Rgb color, ToneMap toneMap);

}  // namespace idap::render
