// A finish in the hand: shows on what it is held over, and stays where it is let go, as one undo step.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "editor/editor.h"

namespace idap {

// An element, not its group, and the name of its part (model/edits/finish_edits.h); no name: all of it.
using ElementPart = std::pair<AnyId, std::string>;

// What a finish would be for at a point of a plane: a piece, the side of a wall that is nearer to the point
// or turned to who looks at the plane, a room's floor. tolerance in metres.
std::optional<ElementPart> partAt(const Editor& editor, Plane plane, Vec2 at, double tolerance);

class FinishDrag {
 public:
  FinishDrag(Editor& editor, Finish finish);
  ~FinishDrag();  // takes back what drop() has not made lasting
  FinishDrag(const FinishDrag&) = delete;
  FinishDrag& operator=(const FinishDrag&) = delete;

  void over(const std::optional<ElementPart>& part);
  void drop();

 private:
  Editor& editor_;
  Finish finish_;
  std::optional<ElementPart> shown_;
};

}  // namespace idap
