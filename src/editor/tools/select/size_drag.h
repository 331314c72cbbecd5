// Stretching a piece by its sides and corners, and several as one.
#pragma once

#include <array>

#include "editor/tools/select/drag.h"

namespace idap {

struct SizeLimits {
  Vec3 min, max;  // m
};
SizeLimits sizeLimits(const Catalog& catalog, const Piece& piece);

class SizeDrag final : public EditDrag {
 public:
  // side: -1, 0 or 1 for each of the piece's own axes: the side that is dragged. The opposite one stays.
  SizeDrag(Editor& editor, const PointerEvent& press, AnyId piece, std::array<int, 3> side, Cursor cursor);
  Text hint() const override;

 protected:
  void aim(const Editor& editor, const PointerEvent& event) override;
  Home change(const Home& before) override;
  void show(const Editor& editor, Overlay& overlay, double pixel) const override;

 private:
  Vec3 local(const Vec3& size, int towards) const;  // the dragged point (1) or the opposite one (-1)
  Vec2 seen(const Piece& piece, Vec3 at) const;
  Piece sized() const;

  AnyId id_;
  Piece piece_;
  std::array<int, 3> side_;
  std::vector<int> axes_;
  double floor_;
  SizeLimits limits_;
  Vec2 offset_;  // from the pointer to the side
  Vec3 size_;
};

class ScaleDrag final : public EditDrag {
 public:
  // About fixed, the corner of the box that is opposite to the dragged one; base: the height that stays.
  ScaleDrag(Editor& editor, const PointerEvent& press, Elements pieces, Vec3 fixed, Vec2 corner,
            Cursor cursor);
  Text hint() const override;

 protected:
  void aim(const Editor& editor, const PointerEvent& event) override;
  Home change(const Home& before) override;

 private:
  Elements elements_;
  Vec3 fixed_;
  Vec2 diagonal_;
  double width_, least_ = 0.01, most_ = 100, ratio_ = 1;
};

}  // namespace idap
