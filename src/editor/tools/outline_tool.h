// Drawing point by point, with typed lengths and angles: what rooms, polylines and outlines of solids have in
// common.
#pragma once

#include <vector>

#include "editor/tools/drawn_point.h"

namespace idap {

class OutlineTool : public Tool {
 public:
  Text hint() const override;
  bool cancel(Editor& editor) override;
  Response pointer(Editor& editor, const PointerEvent& event) override;
  Response key(Editor& editor, const KeyEvent& event) override;
  Overlay overlay(const Editor& editor, Plane plane, double pixel) const override;
  Cursor cursor(const Editor& editor, Plane plane) const override;

 protected:
  struct Manner {
    bool area = false;          // an area is drawn: it closes by itself, and snaps to the faces of walls
    const char* next = "";      // the hint while drawing; marked for translation
    const char* planOnly = "";  // the note in the other planes; marked for translation
    bool anyPlane = false;      // it is drawn in whichever plane its first point is
  };
  explicit OutlineTool(Manner manner) : manner_(manner) {}

  // Makes one undo step of the points: at least three when closed, at least two otherwise.
  virtual void finish(Editor& editor, std::vector<Vec2> points, bool closed) = 0;
  // The points so far and where the next one would be, after each change.
  virtual void drawn(Editor&, const std::vector<Vec2>&) {}
  // What a subclass previews, for points not to snap to it.
  virtual Elements ignored() const { return {}; }
  Plane plane() const { return last_.plane; }
  // A double click where nothing was begun.
  virtual void fill(Editor&, Vec2) {}
  // Shown while nothing is begun: what a double click here would do.
  virtual void offer(const Editor&, Vec2, Overlay&) const {}

 private:
  std::size_t fewest() const { return manner_.area ? 3 : 2; }
  void follow(Editor& editor, const PointerEvent& event);
  void place(Editor& editor);
  void stop(Editor& editor);
  void tellDrawn(Editor& editor);

  Manner manner_;
  DrawnPoint point_;
  std::vector<Vec2> points_;
  PointerEvent last_;
  std::optional<Vec2> pressedAt_;
};

}  // namespace idap
