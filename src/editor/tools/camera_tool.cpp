// Points of view: pressed at the eye, dragged (or clicked again) to where it looks.
#include <cmath>

#include "editor/tools/drawn_point.h"
#include "editor/tools/tool_list.h"
#include "editor/tools/unseen.h"

namespace idap {

namespace {

constexpr double kEyeHeight = 1.6;  // m above the level: of a standing person
constexpr double kNear = 0.05;      // m: an aim nearer than this aims nowhere
constexpr double kSteepest = 1.5;   // radians: straight up and down have no left and right

const ToolInfo kInfo{
    "camera",
    QT_TRANSLATE_NOOP("idap", "Camera"),
    QT_TRANSLATE_NOOP("idap", "Put a point of view and aim it, for pictures and the live view"),
    QT_TRANSLATE_NOOP("idap", "Press where the eye is and drag to what it looks at"),
    "C",
    {{"0-9", QT_TRANSLATE_NOOP("idap", "type the height of the eye")},
     {"Enter", QT_TRANSLATE_NOOP("idap", "done")},
     {"Alt", QT_TRANSLATE_NOOP("idap", "any angle")}}};

// "View 3": the first that no camera has yet.
std::string numbered(const char* pattern, const Home& home) {
  for (std::size_t n = 1;; ++n) {
    std::string name = pattern;
    name.replace(name.find("%1"), 2, std::to_string(n));
    bool taken = false;
    for (const auto& [id, camera] : home.cameras) taken = taken || camera->name == name;
    if (!taken) return name;
  }
}

class CameraTool : public Tool {
 public:
  const ToolInfo& info() const override { return kInfo; }

  Text hint() const override {
    return aiming_ ? QT_TRANSLATE_NOOP("idap", "Let go, or click, at what it looks at") : kInfo.hint;
  }

  bool cancel(Editor& editor) override {
    if (!aiming_) return false;
    editor.document().cancel();
    aiming_ = false;
    camera_ = {};
    pressedAt_.reset();
    height_.clear();
    return true;
  }

  Response pointer(Editor& editor, const PointerEvent& event) override {
    if (aiming_ && event.plane != plane_) return {.used = false};
    switch (event.kind) {
      case PointerEvent::Kind::Move:
        if (aiming_) aim(editor, event);
        return {};
      case PointerEvent::Kind::Press:
        if (event.button == PointerEvent::Button::Right) return {.used = cancel(editor)};
        if (aiming_) {
          aim(editor, event);
          return finish(editor);
        }
        begin(editor, event);
        return {};
      case PointerEvent::Kind::Release: {
        const std::optional<Vec2> from = std::exchange(pressedAt_, std::nullopt);
        if (!aiming_ || !from || length(event.at - *from) < kDragPixels * event.pixel) return {};
        aim(editor, event);
        return finish(editor);
      }
      default:
        return {};
    }
  }

  Response key(Editor& editor, const KeyEvent& event) override {
    if (!aiming_) return {.used = false};
    switch (height_.key(event, editor.settings().unit)) {
      case TypedFields::Answer::Changed:
        show(editor);
        return {};
      case TypedFields::Answer::Apply:
        eye_.z = editor.elevation() + *height_.value(0);
        height_.clear();
        show(editor);
        return {};
      case TypedFields::Answer::Wrong:
        return {};
      case TypedFields::Answer::Unused:
        return event.key == Key::Enter ? finish(editor) : Response{.used = false};
    }
    return {.used = false};
  }

  Overlay overlay(const Editor&, Plane plane, double) const override {
    Overlay overlay;
    if (!aiming_ || plane != plane_) return overlay;
    overlay.handles.push_back({HandleKind::Aim, pointer_, 0, true});
    overlay.guides.push_back({project(plane, eye_), pointer_});
    height_.into(overlay, pointer_);
    return overlay;
  }

 private:
  void begin(Editor& editor, const PointerEvent& event) {
    plane_ = event.plane;
    pressedAt_ = pointer_ = event.at;
    aiming_ = true;
    eye_ = plane_ == Plane::XY ? Vec3{event.at.x, event.at.y, editor.elevation() + kEyeHeight}
                               : inSpace(plane_, event.at, unseenCoordinate(editor, plane_, event.at));
    yaw_ = pitch_ = 0;
    if (plane_ == Plane::XZ) yaw_ = -kPi / 2;
    show(editor);
  }

  void aim(Editor& editor, const PointerEvent& event) {
    pointer_ = event.at;
    const Vec2 by = event.at - project(plane_, eye_);
    if (length(by) < kNear) return;
    double angle = std::atan2(by.y, by.x);
    const double step = std::round(angle / (kPi / 12)) * (kPi / 12);
    if (!event.modifiers.alt && editor.settings().snapping && std::abs(angle - step) < kPi / 90) angle = step;
    if (plane_ == Plane::XY) {
      yaw_ = std::remainder(angle - kPi / 2, 2 * kPi);
    } else {
      const bool back = std::cos(angle) < 0;
      // To the right of XZ lies +x, to the right of YZ +y.
      yaw_ = plane_ == Plane::XZ ? (back ? kPi / 2 : -kPi / 2) : (back ? kPi : 0);
      pitch_ = std::clamp(-std::atan2(std::sin(angle), std::abs(std::cos(angle))), -kSteepest, kSteepest);
    }
    show(editor);
  }

  void show(Editor& editor) {
    Camera camera;
    camera.eye = eye_;
    if (const auto typed = height_.value(0)) camera.eye.z = editor.elevation() + *typed;
    camera.yaw = yaw_;
    camera.pitch = pitch_;
    height_.show(0, camera.eye.z - editor.elevation());
    if (!editor.document().inTransaction()) editor.document().begin(QT_TRANSLATE_NOOP("idap", "Add camera"));
    editor.preview([&](const Home& home) {
      Home next = home;
      camera.name = numbered("View %1", home);
      camera_ = next.newId<CameraId>();
      next.cameras.set(camera_, camera);
      return next;
    });
  }

  Response finish(Editor& editor) {
    show(editor);
    const CameraId id = camera_;
    editor.document().commit();
    cancel(editor);
    editor.select(only(id));
    return {.finished = true};
  }

  TypedFields height_{{{QT_TRANSLATE_NOOP("idap", "Eye height"), Field::Kind::Length}}};
  bool aiming_ = false;
  Plane plane_ = Plane::XY;
  Vec3 eye_;
  Vec2 pointer_;
  double yaw_ = 0, pitch_ = 0;
  CameraId camera_;
  std::optional<Vec2> pressedAt_;
};

}  // namespace

ToolEntry cameraTool() {
  return {&kInfo, [] { return std::make_unique<CameraTool>(); }};
}

}  // namespace idap
