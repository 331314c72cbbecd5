// What is seen above the drawing: the selection, what is under the pointer, and what the tool in hand shows.
#pragma once

#include <optional>

#include "editor/editor.h"
#include "studio/plan/canvas.h"
#include "studio/plan/painter.h"

namespace idap {

// The outline of an element on the plane, as rings; empty for what is not drawn there.
std::vector<Polygon> outlinesOf(const Drawing& drawing, AnyId id);

void paintSelection(const Drawing& drawing, Canvas& canvas, const Elements& selection);
void paintHover(const Drawing& drawing, Canvas& canvas, AnyId id);
// Names of cameras that are selected or under the pointer only: all names would cover the drawing. None
// covers another.
void paintCameraNames(const Drawing& drawing, Canvas& canvas, const Elements& selection,
                      std::optional<AnyId> hovered);
// XZ, YZ: the heights of floors and ceilings, at the left edge.
void paintHeights(const Drawing& drawing, Canvas& canvas, const QRectF& visible);
// visible: of the view, in pixels; what stands beside the pointer stays within.
void paintOverlay(Canvas& canvas, const Overlay& overlay, LengthUnit unit, const QRectF& visible);

}  // namespace idap
