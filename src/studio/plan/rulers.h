// The rulers along the top and the left of a view, with the pointer's mark.
#pragma once

#include <QPainter>
#include <QRect>
#include <optional>

#include "base/units.h"
#include "studio/plan/plan_colors.h"
#include "studio/plan/view_map.h"

namespace idap {

int rulerThickness(const QFont& font);

// frame: of the whole view; pointer: where its mark stands.
void paintRulers(QPainter& painter, const QRect& frame, const ViewMap& view, const PlanColors& colors,
                 const QFont& font, LengthUnit unit, const std::optional<QPointF>& pointer);

}  // namespace idap
