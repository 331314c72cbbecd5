// A wall's end with the corner it is part of, its arc, and the height of its top.
#pragma once

#include "editor/tools/select/drag.h"
#include "model/edits/wall_edits.h"

namespace idap {

// With the rooms, where the settings want it.
class WallDrag : public EditDrag {
 public:
  WallDrag(Editor& editor, std::string name, const PointerEvent& press, Cursor cursor, WallId id)
      : EditDrag(editor, std::move(name), press, cursor), id_(id), wall_(*before().walls.find(id)) {}

 protected:
  Home settle(const Editor& editor, const Home& before, Home after) override {
    return withRooms(editor, before, std::move(after));
  }
  WallId id_;
  Wall wall_;
};

class WallEndDrag final : public WallDrag {
 public:
  WallEndDrag(Editor& editor, const PointerEvent& press, WallId id, WallEnd end);
  Text hint() const override;

 protected:
  void aim(const Editor& editor, const PointerEvent& event) override;
  Home change(const Home& before) override;
  void show(const Editor& editor, Overlay& overlay, double pixel) const override;

 private:
  Vec2 corner_, fixed_, to_;
  Vec2 offset_;
  Elements ignored_;         // the walls that meet there
  std::vector<Vec2> marks_;  // their other ends
};

class WallArcDrag final : public WallDrag {
 public:
  WallArcDrag(Editor& editor, const PointerEvent& press, WallId id);
  Text hint() const override;

 protected:
  void aim(const Editor& editor, const PointerEvent& event) override;
  Home change(const Home& before) override;

 private:
  Vec2 through_;
};

class WallHeightDrag final : public WallDrag {
 public:
  WallHeightDrag(Editor& editor, const PointerEvent& press, WallId id, bool start, bool end);
  Text hint() const override;

 protected:
  void aim(const Editor& editor, const PointerEvent& event) override;
  Home change(const Home& before) override;

 private:
  bool start_, end_;
  double height_;
};

}  // namespace idap
