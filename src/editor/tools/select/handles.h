// The handles of what is selected, on one plane: where they are and what dragging them does.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "editor/tools/select/drag.h"

namespace idap {

struct SelectHandle {
  Handle shown;
  Cursor cursor = Cursor::Move;
  const char* tip = "";  // marked for translation: the hint while the pointer is on it
  std::function<std::unique_ptr<Drag>(Editor&, const PointerEvent&)> grab;
  std::function<Home(const Home&)> remove = nullptr;  // Delete while the pointer is on it
};
using SelectHandles = std::vector<SelectHandle>;

inline constexpr double kHandleOutside = 18;  // pixels that turning handles stand off
inline constexpr double kHandleReach = 7;     // pixels around a handle that are still on it
inline constexpr double kTiny = 24;           // pixels: what is smaller has no handles at its sides

// All of the selection; none for what is locked.
SelectHandles selectHandles(const Editor& editor, Plane plane, double pixel);

// The shape of the cursor for dragging along a direction of the plane.
Cursor sizeCursor(double direction);

// One kind each, a file each.
SelectHandles pieceHandles(const Editor& editor, Plane plane, double pixel, AnyId id);
SelectHandles boxHandles(const Editor& editor, Plane plane, double pixel);
SelectHandles wallHandles(const Editor& editor, Plane plane, WallId id);
SelectHandles roomHandles(const Editor& editor, Plane plane, RoomId id);
SelectHandles polylineHandles(const Editor& editor, Plane plane, PolylineId id);
SelectHandles dimensionHandles(const Editor& editor, Plane plane, DimensionId id);
SelectHandles labelHandles(const Editor& editor, Plane plane, double pixel, LabelId id);
SelectHandles cameraHandles(const Editor& editor, Plane plane, CameraId id);

}  // namespace idap
