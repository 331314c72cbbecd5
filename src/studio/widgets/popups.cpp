#include "studio/widgets/popups.h"

#include <QScreen>

namespace idap {

void showBeside(QWidget& popup, const QWidget& widget) {
  const QRect screen = widget.screen()->availableGeometry();
  const QPoint below = widget.mapToGlobal(QPoint(0, widget.height()));
  const QSize size = popup.size();
  int y = below.y();
  if (y + size.height() > screen.bottom()) {
    const int above = widget.mapToGlobal(QPoint(0, 0)).y() - size.height();
    y = above >= screen.top() ? above : std::max(screen.top(), screen.bottom() - size.height());
  }
  // The right edges line up: panels of fields stand at the right of the window.
  const int right = std::max(screen.left(), screen.right() - size.width());
  const int x = std::clamp(below.x() + widget.width() - size.width(), screen.left(), right);
  popup.move(x, y);
  popup.show();
}

}  // namespace idap
