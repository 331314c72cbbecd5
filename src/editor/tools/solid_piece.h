// Solids on their way into the home: as pieces of furniture, and previewed in a transaction of the document
// so that every view shows them while they are drawn.
#pragma once

#include <vector>

#include "editor/editor.h"
#include "editor/tools/typed_fields.h"

namespace idap {

// The piece that fills a box of the world (m), standing on the level that is drawn on. catalogId:
// "idap/solid-box".
Furniture solidPiece(const Editor& editor, const char* catalogId, const Box3& box);

// Where the axis of a solid drawn on a plane points: across it. The number of its "axis" parameter.
double axisAcross(Plane plane);

// The box over a rectangle of a plane: in the plan upwards from the level's floor, in the upright planes to
// both sides of a coordinate along the line of sight.
Box3 boxOver(const Editor& editor, Plane plane, const Box2& drawn, double unseen, double across);

class SolidPreview {
 public:
  void show(Editor& editor, const Furniture& piece);
  bool shown() const { return bool(id_); }
  Elements elements() const;
  // Makes it one undo step and selects it.
  void commit(Editor& editor);
  void drop(Editor& editor);

 private:
  FurnitureId id_;
};

// The last step of drawing: how far a solid goes across its plane. It is typed, or the pointer shows it in
// one of the other planes; a click or Enter ends.
class AcrossStep {
 public:
  enum class Answer { None, Changed, Done };
  // m, until another is given.
  void begin(Plane plane, const Box2& drawn, double unseen);
  void end() { active_ = false; }
  bool active() const { return active_; }
  double value() const;
  Answer pointer(const Editor& editor, const PointerEvent& event);
  Answer key(const Editor& editor, const KeyEvent& event);
  void into(Overlay& overlay, Plane plane) const;
  static const char* label(Plane plane);

 private:
  bool active_ = false;
  Plane plane_ = Plane::XY;
  Box2 drawn_;
  double unseen_ = 0;
  double last_ = 0.5;  // kept from solid to solid
  TypedFields fields_;
};

inline constexpr const char* kAddSolid = QT_TRANSLATE_NOOP("idap", "Add solid");
inline constexpr const char* kAcrossHint = QT_TRANSLATE_NOOP(
    "idap", "Type how far it goes across, or show it in another plane; click or Enter ends");
inline constexpr double kThinnestSolid = 1e-3;  // m

}  // namespace idap
