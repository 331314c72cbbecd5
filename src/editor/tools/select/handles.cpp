#include "editor/tools/select/handles.h"

#include <cmath>

namespace idap {

Cursor sizeCursor(double direction) {
  static constexpr Cursor kCursors[]{Cursor::SizeHorizontal, Cursor::SizeAntiDiagonal, Cursor::SizeVertical,
                                     Cursor::SizeDiagonal};
  const long eighth = std::lround(direction / (kPi / 4));
  return kCursors[static_cast<std::size_t>(((eighth % 4) + 4) % 4)];
}

SelectHandles selectHandles(const Editor& editor, Plane plane, double pixel) {
  const std::optional<AnyId> one = single(editor.selection());
  if (!one) return empty(editor.selection()) ? SelectHandles{} : boxHandles(editor, plane, pixel);
  if (pieceOf(editor.home(), *one)) return pieceHandles(editor, plane, pixel, *one);
  if (const auto* wall = std::get_if<WallId>(&*one)) return wallHandles(editor, plane, *wall);
  if (const auto* room = std::get_if<RoomId>(&*one)) return roomHandles(editor, plane, *room);
  if (const auto* line = std::get_if<PolylineId>(&*one)) return polylineHandles(editor, plane, *line);
  if (const auto* dimension = std::get_if<DimensionId>(&*one))
    return dimensionHandles(editor, plane, *dimension);
  if (const auto* label = std::get_if<LabelId>(&*one)) return labelHandles(editor, plane, pixel, *label);
  if (const auto* camera = std::get_if<CameraId>(&*one)) return cameraHandles(editor, plane, *camera);
  return boxHandles(editor, plane, pixel);
}

}  // namespace idap
