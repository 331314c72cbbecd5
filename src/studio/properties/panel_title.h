// What is selected, in words.
#pragma once

#include <QString>

#include "studio/properties/selected.h"

namespace idap {

struct PanelTitle {
  QString name;     // "Double bed", "3 pieces of furniture", "Wall", "5 elements"
  QString details;  // "2 walls, 1 room, 2 pieces of furniture"; empty where the name says it all
};
PanelTitle panelTitle(const Selected& selected);

}  // namespace idap
