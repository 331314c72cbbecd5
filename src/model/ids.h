// The ids of a home's elements. One counter (Home::nextId) serves all kinds, so an id is unique in its home.
#pragma once

#include "base/id.h"

namespace idap {

using LevelId = Id<struct LevelTag>;
using WallId = Id<struct WallTag>;
using RoomId = Id<struct RoomTag>;
using OpeningId = Id<struct OpeningTag>;
using FurnitureId = Id<struct FurnitureTag>;
using GroupId = Id<struct GroupTag>;
using CameraId = Id<struct CameraTag>;
using DimensionId = Id<struct DimensionTag>;
using LabelId = Id<struct LabelTag>;
using PolylineId = Id<struct PolylineTag>;
using PictureId = Id<struct PictureTag>;

}  // namespace idap
