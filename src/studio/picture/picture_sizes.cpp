#include "studio/picture/picture_sizes.h"

#include <array>

#include "base/translatable.h"

namespace idap {

namespace {

// Paper at 300 dots an inch (25.4 mm), landscape.
constexpr std::array<PictureSize, 13> kSizes{{
    {QT_TRANSLATE_NOOP("idap", "As in 1993"), 320, 200, false},
    {"", 640, 400, false},
    {"", 1280, 800, false},
    {"", 1600, 1200, false},
    {"HD", 1920, 1080, false},
    {"QHD", 2560, 1440, false},
    {"4K", 3840, 2160, false},
    {QT_TRANSLATE_NOOP("idap", "Photograph 10 x 15 cm"), 1772, 1181, true},
    {QT_TRANSLATE_NOOP("idap", "Photograph 13 x 18 cm"), 2126, 1535, true},
    {"A5", 2480, 1748, true},
    {QT_TRANSLATE_NOOP("idap", "A4, 150 dots an inch"), 1754, 1240, true},
    {"A4", 3508, 2480, true},
    {"A3", 4961, 3508, true},
}};

constexpr std::array<PictureProportion, 6> kProportions{{
    {QT_TRANSLATE_NOOP("idap", "Free"), 0},
    {"16:10", 16.0 / 10},
    {"16:9", 16.0 / 9},
    {"4:3", 4.0 / 3},
    {"3:2", 3.0 / 2},
    {"1:1", 1},
}};

}  // namespace

std::span<const PictureSize> pictureSizes() { return kSizes; }
std::span<const PictureProportion> pictureProportions() { return kProportions; }

}  // namespace idap
