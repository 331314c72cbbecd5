// Where a camera looks, and how wide.
#pragma once

#include "editor/tools/select/drag.h"

namespace idap {

class CameraDrag final : public EditDrag {
 public:
  enum class What { Aim, FieldOfView };
  CameraDrag(Editor& editor, const PointerEvent& press, CameraId id, What what);
  Text hint() const override;

 protected:
  void aim(const Editor& editor, const PointerEvent& event) override;
  Home change(const Home& before) override;

 private:
  void aimAt(Vec2 at, bool free);

  CameraId id_;
  What what_;
  Camera camera_;
};

}  // namespace idap
