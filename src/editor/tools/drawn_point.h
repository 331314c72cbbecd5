// The next point of a line that is being drawn on a plane: where the pointer snaps to, or where a typed
// length and angle put it. Walls, rooms, polylines and dimensions share it.
#pragma once

#include <optional>
#include <vector>

#include "editor/snap.h"
#include "editor/tools/typed_fields.h"

namespace idap {

class DrawnPoint {
 public:
  // Fields that follow the length and the angle, with indices from kMore.
  static constexpr std::size_t kLength = 0, kAngle = 1, kMore = 2;
  explicit DrawnPoint(const std::vector<Field>& more = {});

  struct Line {
    std::optional<Vec2> from;     // where it starts; none: the first point is looked for
    std::optional<double> along;  // direction of the stretch before, radians
    std::vector<Vec2> own;        // points to close it onto
    Elements ignored;             // what is previewed
    bool wallFaces = false;
  };
  void follow(const Editor& editor, const PointerEvent& event, const Line& line);
  // A new stretch starts: what was typed is dropped. along: where it goes while the pointer does not say.
  void startFrom(Vec2 from, std::optional<double> along = {});
  void forget();  // nothing is drawn any more

  Vec2 at() const;  // m on the plane, with what was typed
  std::optional<Vec2> from() const { return from_; }
  // What it snapped to; Nothing when a value is typed, which goes before.
  SnappedPoint::To snappedTo() const;
  bool known() const { return known_; }  // the pointer has been seen

  TypedFields& fields() { return fields_; }
  const TypedFields& fields() const { return fields_; }
  // Keys count only while a line is drawn.
  TypedFields::Answer key(const KeyEvent& event, LengthUnit unit);

  // Guides, the point, the length and angle of the stretch, the fields.
  void into(Overlay& overlay, double pixel) const;

 private:
  void showValues();
  void roundLength(const Editor& editor, const PointerEvent& event, Vec2 from);

  TypedFields fields_;
  std::optional<Vec2> from_;
  std::optional<double> along_;
  SnappedPoint snapped_;
  bool known_ = false;
};

// How near the pointer has to come to what it snaps to, and how far a press must be dragged to be no click.
inline constexpr double kSnapPixels = 10, kDragPixels = 12;

// A turn in [0, 2 pi).
double fullTurn(double angle);

}  // namespace idap
