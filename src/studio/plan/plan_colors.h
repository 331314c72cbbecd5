// The colours of the plan, taken from the palette so that it is at home in light and in dark.
#pragma once

#include <QColor>
#include <QPalette>

#include "model/finish.h"

namespace idap {

QColor mixed(const QColor& a, const QColor& b, double shareOfB);

struct PlanColors {
  bool dark = false;
  QColor paper;  // what all is drawn on
  QColor ink;    // lines and texts
  QColor soft;   // texts and lines of lesser weight; still readable
  QColor faint;  // what lies below, swings of windows
  QColor grid;   // fine lines; the strong ones are gridStrong
  QColor gridStrong;
  QColor wall;      // poché
  QColor wallPale;  // walls seen, not cut; ground of hatches
  QColor floor;     // of rooms without a finish
  QColor accent;    // selection, handles
  QColor onAccent;
  QColor guide;  // why the pointer snapped
  QColor wrong;  // what cannot be

  explicit PlanColors(const QPalette& palette);
  static PlanColors forPrint();

  // A material's colour as a wash over the paper.
  QColor wash(const Color& color, double strength) const;
  // A colour of the home that must be read on this paper: black ink turns light on dark paper.
  QColor readable(const Color& color) const;
};

}  // namespace idap
