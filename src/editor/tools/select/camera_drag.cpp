#include "editor/tools/select/camera_drag.h"

#include <algorithm>

#include "editor/hit_test_shapes.h"
#include "editor/tools/select/handles.h"

namespace idap {

namespace {

constexpr double kNarrowest = 0.087, kWidest = 2.97;  // radians: 5 and 170 degrees
}  // namespace

CameraDrag::CameraDrag(Editor& editor, const PointerEvent& press, CameraId id, What what)
    : EditDrag(editor,
               what == What::Aim ? QT_TRANSLATE_NOOP("idap", "Aim camera")
                                 : QT_TRANSLATE_NOOP("idap", "Change field of view"),
               press, Cursor::Move),
      id_(id),
      what_(what),
      camera_(*before().cameras.find(id)) {
  const bool pitch = plane() != Plane::XY;
  fields_.define({{.label = what == What::FieldOfView ? QT_TRANSLATE_NOOP("idap", "Field of view")
                            : pitch                   ? QT_TRANSLATE_NOOP("idap", "Pitch")
                                                      : QT_TRANSLATE_NOOP("idap", "Yaw"),
                   .kind = Field::Kind::Angle,
                   .value = what == What::FieldOfView ? camera_.fieldOfView
                            : pitch                   ? camera_.pitch
                                                      : camera_.yaw,
                   .active = true}});
}

void CameraDrag::aim(const Editor& editor, const PointerEvent& event) {
  const bool free = event.modifiers.alt || !editor.settings().snapping;
  const std::optional<double> typed = fields_.value(0);
  if (what_ == What::FieldOfView) {
    const Vec2 eye = project(plane(), camera_.eye), ahead = cameraAim(plane(), camera_) - eye;
    const Vec2 to = event.at - eye;
    double wide = 2 * std::abs(std::atan2(cross(ahead, to), dot(ahead, to)));
    if (!free) wide = std::round(wide / (kPi / 36)) * (kPi / 36);
    fields_.show(0, std::clamp(wide, kNarrowest, kWidest));
    camera_.fieldOfView = std::clamp(typed.value_or(wide), kNarrowest, kWidest);
    return;
  }
  aimAt(event.at, free);
  fields_.show(0, plane() == Plane::XY ? camera_.yaw : camera_.pitch);
  if (typed) (plane() == Plane::XY ? camera_.yaw : camera_.pitch) = *typed;
}

void CameraDrag::aimAt(Vec2 at, bool free) {
  const Camera& was = *before().cameras.find(id_);
  const Vec2 to = at - project(plane(), was.eye);
  if (length(to) < 1e-6) return;
  if (plane() == Plane::XY) {
    camera_.yaw = std::remainder(stepped(std::atan2(-to.x, to.y), free), 2 * kPi);
    return;
  }
  // What this plane does not show of the view stays as it is. The handle stands off further than the view
  // is long here, by so much the pointer counts less.
  Vec3 view = viewDirection(was) * kCameraCone;
  const Vec2 grip = cameraAim(plane(), was) - project(plane(), was.eye);
  const Vec2 meant = to * (length(project(plane(), view)) / std::max(length(grip), 1e-6));
  (plane() == Plane::XZ ? view.x : view.y) = meant.x;
  view.z = meant.y;
  const double along = std::hypot(view.x, view.y);
  if (along > 1e-6) camera_.yaw = std::atan2(-view.x, view.y);
  camera_.pitch = std::clamp(-std::atan2(view.z, along), -kPi / 2, kPi / 2);
}

Home CameraDrag::change(const Home& before) {
  Home next = before;
  next.cameras.set(id_, camera_);
  return next;
}

Text CameraDrag::hint() const {
  return what_ == What::Aim
             ? QT_TRANSLATE_NOOP("idap",
                                 "Turns the view in steps of 15°; Alt turns freely. Or type the angle.")
             : QT_TRANSLATE_NOOP("idap", "How wide the lens sees. Or type the angle.");
}

SelectHandles cameraHandles(const Editor& editor, Plane plane, CameraId id) {
  const Camera* camera = editor.home().cameras.find(id);
  if (!camera) return {};
  const Vec2 eye = project(plane, camera->eye), aim = cameraAim(plane, *camera);
  const auto handle = [id](HandleKind kind, Vec2 at, double direction, const char* tip,
                           CameraDrag::What what) {
    return SelectHandle{{kind, at, direction, false},
                        Cursor::Move,
                        tip,
                        [id, what](Editor& e, const PointerEvent& press) -> std::unique_ptr<Drag> {
                          return std::make_unique<CameraDrag>(e, press, id, what);
                        }};
  };
  SelectHandles handles;
  // Looking along the line of sight there is nothing to take hold of beside the body.
  if (!(aim == eye))
    handles.push_back(handle(HandleKind::Aim, aim, std::atan2(aim.y - eye.y, aim.x - eye.x),
                             QT_TRANSLATE_NOOP("idap", "Drag to aim the camera."), CameraDrag::What::Aim));
  if (plane != Plane::XY) return handles;
  const Vec2 side = cameraCone(plane, *camera)[2];
  handles.push_back(handle(HandleKind::Offset, side, std::atan2(side.y - eye.y, side.x - eye.x) + kPi / 2,
                           QT_TRANSLATE_NOOP("idap", "Drag to widen or narrow the view."),
                           CameraDrag::What::FieldOfView));
  return handles;
}

}  // namespace idap
