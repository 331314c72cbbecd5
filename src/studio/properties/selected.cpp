#include "studio/properties/selected.h"

namespace idap {

namespace {

ElementKind kindOf(const Elements& e) {
  std::vector<ElementKind> kinds;
  const auto note = [&kinds](bool there, ElementKind kind) {
    if (there) kinds.push_back(kind);
  };
  note(!e.furniture.empty() || !e.openings.empty(), ElementKind::Piece);
  note(!e.groups.empty(), ElementKind::Group);
  note(!e.walls.empty(), ElementKind::Wall);
  note(!e.rooms.empty(), ElementKind::Room);
  note(!e.cameras.empty(), ElementKind::Camera);
  note(!e.dimensions.empty(), ElementKind::Dimension);
  note(!e.labels.empty(), ElementKind::Label);
  note(!e.polylines.empty(), ElementKind::Polyline);
  if (kinds.empty()) return ElementKind::None;
  return kinds.size() == 1 ? kinds.front() : ElementKind::Mixed;
}

}  // namespace

Selected::Selected(const Editor& editor)
    : home(editor.home()),
      level(editor.level()),
      elevation(editor.elevation()),
      settings(editor.settings()),
      elements(editor.selection()),
      all(withGroups(home, elements)),
      kind(kindOf(elements)),
      count(elements.walls.size() + elements.rooms.size() + elements.openings.size() +
            elements.furniture.size() + elements.groups.size() + elements.cameras.size() +
            elements.dimensions.size() + elements.labels.size() + elements.polylines.size()) {}

std::vector<const Piece*> Selected::pieces() const {
  std::vector<const Piece*> found;
  for (const FurnitureId id : all.furniture)
    if (const Furniture* piece = home.furniture.find(id)) found.push_back(piece);
  for (const OpeningId id : all.openings)
    if (const Opening* opening = home.openings.find(id)) found.push_back(opening);
  return found;
}

double signedDegrees(double angle) {
  const double d = degrees(std::remainder(angle, 2 * kPi));
  return std::abs(d) < 1e-9 ? 0 : d;
}

double positiveDegrees(double angle) {
  const double d = signedDegrees(angle);
  return d < 0 ? d + 360 : d;
}

}  // namespace idap
