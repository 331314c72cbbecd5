#include "editor/tools/solid_piece.h"

#include <algorithm>
#include <cmath>

#include "editor/snap.h"
#include "editor/tools/place_tool.h"
#include "editor/tools/unseen.h"
#include "model/edits/piece_edits.h"

namespace idap {

Furniture solidPiece(const Editor& editor, const char* catalogId, const Box3& box) {
  Furniture piece;
  if (const CatalogPiecePtr known = editor.catalog().find(catalogId))
    piece = readyFurniture(editor, *known, {});
  piece.level = editor.level();
  const Vec3 centre = box.centre(), size = box.size();
  piece.position = {centre.x, centre.y, box.min.z - editor.elevation()};
  for (int i = 0; i < 3; ++i) piece.size[i] = std::max(size[i], kThinnestSolid);
  return piece;
}

double axisAcross(Plane plane) { return plane == Plane::XY ? 0 : plane == Plane::YZ ? 1 : 2; }

Box3 boxOver(const Editor& editor, Plane plane, const Box2& drawn, double unseen, double across) {
  const double floor = editor.elevation();
  const double from = plane == Plane::XY ? floor : unseen - across / 2;
  Box3 box;
  box.add(inSpace(plane, drawn.min, from));
  box.add(inSpace(plane, drawn.max, from + across));
  return box;
}

void SolidPreview::show(Editor& editor, const Furniture& piece) {
  if (!editor.document().inTransaction()) editor.document().begin(kAddSolid);
  editor.preview([&](const Home& home) {
    FurnitureEdit edit = addFurniture(home, piece);
    id_ = edit.furniture;
    return std::move(edit.home);
  });
}

Elements SolidPreview::elements() const {
  Elements elements;
  if (id_) elements.furniture.push_back(id_);
  return elements;
}

void SolidPreview::commit(Editor& editor) {
  if (!id_) return;
  const FurnitureId id = std::exchange(id_, {});
  editor.document().commit();
  editor.select(only(id));
}

void SolidPreview::drop(Editor& editor) {
  if (id_) editor.document().cancel();
  id_ = {};
}

const char* AcrossStep::label(Plane plane) {
  switch (plane) {
    case Plane::XZ:
      return QT_TRANSLATE_NOOP("idap", "Depth");
    case Plane::YZ:
      return QT_TRANSLATE_NOOP("idap", "Width");
    default:
      return QT_TRANSLATE_NOOP("idap", "Height");
  }
}

void AcrossStep::begin(Plane plane, const Box2& drawn, double unseen) {
  active_ = true;
  plane_ = plane;
  drawn_ = drawn;
  unseen_ = unseen;
  fields_.define({{label(plane), Field::Kind::Length}});
  fields_.show(0, last_);
}

double AcrossStep::value() const {
  const std::optional<double> typed = fields_.value(0);
  return std::max(typed && *typed > 0 ? *typed : last_, kThinnestSolid);
}

AcrossStep::Answer AcrossStep::pointer(const Editor& editor, const PointerEvent& event) {
  if (event.kind == PointerEvent::Kind::Press && event.button == PointerEvent::Button::Left) {
    if (fields_.wrong()) return Answer::None;
    last_ = value();
    return Answer::Done;
  }
  if (event.kind != PointerEvent::Kind::Move || event.plane == plane_ || fields_.typing())
    return Answer::None;
  const Vec3 at = inSpace(event.plane, event.at, 0);
  // The line of sight of the plane that it was drawn on is an axis of this one.
  const double shown = plane_ == Plane::XY   ? at.z - editor.elevation()
                       : plane_ == Plane::XZ ? 2 * std::abs(at.y - unseen_)
                                             : 2 * std::abs(at.x - unseen_);
  const double step =
      event.modifiers.alt ? kThinnestSolid : gridStep(event.pixel * 0.999, editor.settings().unit);
  last_ = std::max(std::round(shown / step) * step, step);
  fields_.show(0, last_);
  return Answer::Changed;
}

AcrossStep::Answer AcrossStep::key(const Editor& editor, const KeyEvent& event) {
  switch (fields_.key(event, editor.settings().unit)) {
    case TypedFields::Answer::Changed:
    case TypedFields::Answer::Wrong:
      return Answer::Changed;
    case TypedFields::Answer::Apply:
      last_ = value();
      return Answer::Done;
    case TypedFields::Answer::Unused:
      break;
  }
  return event.key == Key::Enter ? Answer::Done : Answer::None;
}

void AcrossStep::into(Overlay& overlay, Plane plane) const {
  if (plane == plane_) {
    fields_.into(overlay, {drawn_.max.x, drawn_.min.y});
    return;
  }
  // In the others the distance itself is seen.
  const bool upright = plane_ == Plane::XY;
  const double from = upright ? 0 : unseen_ - value() / 2;
  const Vec2 middle = (drawn_.min + drawn_.max) / 2;
  const Vec2 a = project(plane, inSpace(plane_, middle, from)),
             b = project(plane, inSpace(plane_, middle, from + value()));
  overlay.measures.push_back({a, b, true});
}

}  // namespace idap
