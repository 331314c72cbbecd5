// Single points of what is drawn on the plan: corners of rooms, points of polylines, ends of dimensions; and
// how far a dimension line stands off.
#pragma once

#include <functional>

#include "editor/tools/select/drag.h"

namespace idap {

class PointDrag final : public EditDrag {
 public:
  using Place = std::function<Home(const Home&, Vec2)>;
  struct Source {
    std::string name;  // of the edit
    Vec2 point;
    std::optional<Vec2> from;  // the point before it: its length and angle count from there
    bool angles = true;        // snaps to steps of angles from there
    std::vector<Vec2> marks;   // points to be in line with
    Elements ignored;
    bool faces = true;
    Place place;  // puts it there
  };
  PointDrag(Editor& editor, const PointerEvent& press, Source source);
  Text hint() const override;

 protected:
  void aim(const Editor& editor, const PointerEvent& event) override;
  Home change(const Home& before) override;
  void show(const Editor& editor, Overlay& overlay, double pixel) const override;

 private:
  Source source_;
  Vec2 offset_, to_;
};

class OffsetDrag final : public EditDrag {
 public:
  OffsetDrag(Editor& editor, const PointerEvent& press, DimensionId id);
  Text hint() const override;

 protected:
  void aim(const Editor& editor, const PointerEvent& event) override;
  Home change(const Home& before) override;

 private:
  DimensionId id_;
  double offset_;
};

}  // namespace idap
