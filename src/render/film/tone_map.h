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
};

std::string_view name(ToneMap toneMap);  // "neutral", "agx", "classic", "linear"

// Input: linear, finite or not. Output: linear, every channel in 0..1.
Rgb toneMapped(Rgb color, ToneMap toneMap);

}  // namespace idap::render
