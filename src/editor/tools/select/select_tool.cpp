#include "editor/tools/select/select_tool.h"

#include <algorithm>

#include "editor/hit_test.h"
#include "editor/tools/select/move_drag.h"
#include "editor/tools/select/moving.h"
#include "editor/tools/select/rectangle_drag.h"
#include "editor/tools/select/under_pointer.h"
#include "editor/tools/tool_list.h"
#include "model/edits/piece_edits.h"

namespace idap {

namespace {

constexpr double kDragFrom = 4;  // pixels: a click shakes less

const SelectHandle* handleAt(const SelectHandles& handles, const PointerEvent& event) {
  const SelectHandle* nearest = nullptr;
  double least = kHandleReach * event.pixel;
  for (const SelectHandle& handle : handles) {
    const double off = length(handle.shown.at - event.at);
    if (off > least) continue;
    least = off;
    nearest = &handle;
  }
  return nearest;
}

}  // namespace

const ToolInfo& SelectTool::info() const {
  static const ToolInfo info{
      .id = "select",
      .name = QT_TRANSLATE_NOOP("idap", "Point"),
      .tip = QT_TRANSLATE_NOOP("idap", "Select things, and move, turn and resize them by their handles"),
      .hint = QT_TRANSLATE_NOOP("idap",
                                "Click to select, drag to move. Drag over an empty place to select all in a "
                                "rectangle."),
      .shortcut = "V",
      .keys = {
          {"Shift", QT_TRANSLATE_NOOP("idap", "add to the selection; keep to one axis or the proportions")},
          {"Ctrl", QT_TRANSLATE_NOOP("idap", "take out or add; copy while dragging")},
          {"Alt", QT_TRANSLATE_NOOP("idap", "no snapping")},
          {"Tab", QT_TRANSLATE_NOOP("idap", "the next value to type while dragging")},
          {"Arrow keys", QT_TRANSLATE_NOOP("idap", "move by 1 cm; Shift 10 cm, Alt 1 mm")},
          {"Page Up, Page Down", QT_TRANSLATE_NOOP("idap", "lift, lower")},
          {"Delete", QT_TRANSLATE_NOOP("idap", "delete; over the point of a room or line only that")},
          {"Escape", QT_TRANSLATE_NOOP("idap", "take back the drag; select nothing")}}};
  return info;
}

Text SelectTool::hint() const {
  if (drag_) return drag_->hint();
  if (hovered_ && *hovered_->tip) return hovered_->tip;
  if (overSelected_)
    return QT_TRANSLATE_NOOP("idap", "Drag to move, with Ctrl to copy. Click again for what lies under it.");
  return info().hint;
}

bool SelectTool::cancel(Editor& editor) {
  pressed_.reset();
  handle_.reset();
  if (!drag_) return false;
  const std::unique_ptr<Drag> drag = std::move(drag_);
  drag->cancel(editor);
  return true;
}

Response SelectTool::pointer(Editor& editor, const PointerEvent& event) {
  switch (event.kind) {
    case PointerEvent::Kind::Press:
      return press(editor, event);
    case PointerEvent::Kind::Move:
      return move(editor, event);
    case PointerEvent::Kind::Release:
      return release(editor, event);
    case PointerEvent::Kind::DoubleClick:
      return doubleClick(editor, event);
    case PointerEvent::Kind::Leave:
      if (!drag_) hovered_.reset(), overSelected_ = false;
      break;
  }
  return {};
}

Response SelectTool::press(Editor& editor, const PointerEvent& event) {
  plane_ = event.plane;
  if (event.button == PointerEvent::Button::Right) {
    if (drag_) return {};
    // The context menu is about what is under the pointer.
    const std::vector<AnyId> hits = meantAt(editor, event);
    const bool selected = std::any_of(hits.begin(), hits.end(),
                                      [&editor](AnyId id) { return contains(editor.selection(), id); });
    if (!selected) editor.select(hits.empty() ? Elements{} : only(hits.front()));
    return {.used = false};
  }
  if (event.button != PointerEvent::Button::Left || drag_) return {};
  pressed_ = event;
  handle_.reset();
  grabbed_.reset();
  hits_.clear();
  const SelectHandles handles = selectHandles(editor, event.plane, event.pixel);
  if (const SelectHandle* handle = handleAt(handles, event)) {
    handle_ = *handle;
    return {};
  }
  hits_ = meantAt(editor, event);
  if (hits_.empty()) return {};
  // What a click has brought up from below, or the edge of the room being worked on, is meant again.
  grabbed_ = hits_.front();
  if (sameSpot(event) || ownEdge(editor, event))
    for (const AnyId id : hits_)
      if (contains(editor.selection(), id)) {
        grabbed_ = id;
        break;
      }
  const bool selected = contains(editor.selection(), *grabbed_);
  if (event.modifiers.shift && !selected) {
    Elements more = editor.selection();
    add(more, *grabbed_);
    editor.select(std::move(more));
    hits_.clear();  // the click has done its work
  } else if (!selected && !event.modifiers.control && !isGround(editor, event.plane, *grabbed_)) {
    editor.select(only(*grabbed_));
  }
  return {};
}

void SelectTool::startDrag(Editor& editor) {
  const PointerEvent press = *pressed_;
  pressed_.reset();
  lastClick_.reset();
  editor.document().cancel();  // what somebody else left half done
  if (handle_) {
    drag_ = handle_->grab(editor, press);
    handle_.reset();
    return;
  }
  // A drag that begins on the floor of a room draws the rectangle, unless that room is selected.
  if (!grabbed_ || (!contains(editor.selection(), *grabbed_) && isGround(editor, press.plane, *grabbed_))) {
    drag_ = std::make_unique<RectangleDrag>(editor, press);
    return;
  }
  if (!contains(editor.selection(), *grabbed_)) editor.select(only(*grabbed_));
  Elements elements = movable(editor.home(), editor.selection());
  if (empty(elements)) {
    editor.say(QT_TRANSLATE_NOOP("idap", "What is locked does not move. Unlock it first."));
    return;
  }
  if (!contains(elements, *grabbed_)) grabbed_ = list(elements).front();
  drag_ = std::make_unique<MoveDrag>(editor, press, std::move(elements), *grabbed_);
}

Response SelectTool::move(Editor& editor, const PointerEvent& event) {
  if (drag_) {
    if (event.plane == plane_) drag_->move(editor, event);
    return {};
  }
  if (pressed_) {
    if (event.plane != pressed_->plane || length(event.at - pressed_->at) < kDragFrom * event.pixel)
      return {};
    startDrag(editor);
    if (drag_) drag_->move(editor, event);
    return {};
  }
  hover(editor, event);
  return {};
}

Response SelectTool::release(Editor& editor, const PointerEvent& event) {
  if (event.button == PointerEvent::Button::Right) return {.used = false};
  if (drag_) {
    const std::unique_ptr<Drag> drag = std::move(drag_);
    drag->finish(editor);
  } else if (pressed_ && !handle_) {
    click(editor);
  }
  pressed_.reset();
  handle_.reset();
  hover(editor, event);
  return {};
}

void SelectTool::click(Editor& editor) {
  const PointerEvent press = *pressed_;
  const bool again = sameSpot(press);
  beforeCycle_.reset();
  lastClick_ = press;
  if (!grabbed_) {
    if (!press.modifiers.shift && !press.modifiers.control) editor.select({});
    return;
  }
  if (press.modifiers.control) {
    Elements toggled = editor.selection();
    if (contains(toggled, *grabbed_))
      remove(toggled, *grabbed_);
    else
      add(toggled, *grabbed_);
    editor.select(std::move(toggled));
    return;
  }
  if (press.modifiers.shift || hits_.empty()) return;
  AnyId next = *grabbed_;
  const std::optional<AnyId> one = single(editor.selection());
  if (again && one && hits_.size() > 1) {
    const auto now = std::find(hits_.begin(), hits_.end(), *one);
    if (now != hits_.end()) {
      beforeCycle_ = editor.selection();
      next = now + 1 == hits_.end() ? hits_.front() : *(now + 1);
    }
  }
  editor.select(only(next));
}

bool SelectTool::sameSpot(const PointerEvent& event) const {
  return lastClick_ && lastClick_->plane == event.plane &&
         length(lastClick_->at - event.at) <= kDragFrom * event.pixel;
}

Response SelectTool::doubleClick(Editor& editor, const PointerEvent& event) {
  pressed_.reset();
  if (event.button != PointerEvent::Button::Left || drag_) return {};
  if (beforeCycle_) editor.select(*std::exchange(beforeCycle_, std::nullopt));
  const std::optional<AnyId> one = single(editor.selection());
  if (one && std::holds_alternative<GroupId>(*one)) {
    for (const AnyId id : membersAt(editor, event.plane, event.at, kClickReach * event.pixel))
      if (byGroup(editor.home(), id) == *one) {
        editor.select(only(id));
        return {};
      }
  }
  const SelectHandles handles = selectHandles(editor, event.plane, event.pixel);
  if (const auto edge = ownEdge(editor, event); edge && !handleAt(handles, event)) {
    editor.apply(QT_TRANSLATE_NOOP("idap", "Add point"),
                 [&](const Home& home) { return withPoint(home, *one, *edge, event.at); });
    return {};
  }
  return {.used = false};
}

void SelectTool::hover(const Editor& editor, const PointerEvent& event) {
  plane_ = event.plane;
  const SelectHandles handles = selectHandles(editor, event.plane, event.pixel);
  const SelectHandle* handle = handleAt(handles, event);
  hovered_ = handle ? std::optional(*handle) : std::nullopt;
  overSelected_ = false;
  if (handle || empty(editor.selection())) return;
  const std::vector<AnyId> hits = meantAt(editor, event);
  overSelected_ = !hits.empty() && contains(editor.selection(), hits.front());
}

Response SelectTool::key(Editor& editor, const KeyEvent& event) {
  if (drag_) {
    switch (drag_->key(editor, event)) {
      case Drag::Answer::Done: {
        const std::unique_ptr<Drag> drag = std::move(drag_);
        drag->finish(editor);
        return {};
      }
      case Drag::Answer::Used:
        return {};
      case Drag::Answer::Unused:
        // Nothing else happens to the home in the middle of a drag; Escape takes it back.
        return {.used = event.key != Key::Escape};
    }
  }
  if (event.key == Key::Delete || event.key == Key::Backspace) return {.used = deleteSelected(editor)};
  return {.used = nudge(editor, event)};
}

bool SelectTool::deleteSelected(Editor& editor) {
  if (hovered_ && hovered_->remove) {
    const auto change = hovered_->remove;
    hovered_.reset();
    return editor.apply(QT_TRANSLATE_NOOP("idap", "Remove point"), change);
  }
  if (empty(editor.selection())) return false;
  const Elements gone = editor.selection();
  hovered_.reset();
  return editor.apply(QT_TRANSLATE_NOOP("idap", "Delete"), [&](const Home& home) {
    Home next = deleteElements(home, gone);
    return gone.walls.empty() ? next : withRooms(editor, home, std::move(next));
  });
}

bool SelectTool::nudge(Editor& editor, const KeyEvent& event) {
  Vec2 step;
  double rise = 0;
  switch (event.key) {
    case Key::Left:
      step = {-1, 0};
      break;
    case Key::Right:
      step = {1, 0};
      break;
    case Key::Up:
      step = {0, 1};
      break;
    case Key::Down:
      step = {0, -1};
      break;
    case Key::PageUp:
      rise = 1;
      break;
    case Key::PageDown:
      rise = -1;
      break;
    default:
      return false;
  }
  const Elements elements = movable(editor.home(), editor.selection());
  if (empty(elements)) return false;
  const double size = event.modifiers.shift ? 0.1 : event.modifiers.alt ? 0.001 : 0.01;
  const Vec3 by = inWorld(editor.lastPointer().plane, step * size) + Vec3{0, 0, rise * size};
  editor.apply(QT_TRANSLATE_NOOP("idap", "Move"), [&](const Home& home) {
    Home next = moved(home, elements, by);
    if (!elements.walls.empty()) next = withRooms(editor, home, std::move(next));
    return dimensionsFollow(home, next);
  });
  return true;
}

Overlay SelectTool::overlay(const Editor& editor, Plane plane, double pixel) const {
  if (drag_) return drag_->overlay(editor, plane, pixel);
  Overlay overlay;
  for (SelectHandle& handle : selectHandles(editor, plane, pixel)) {
    handle.shown.active = plane == plane_ && hovered_ && hovered_->shown.kind == handle.shown.kind &&
                          length(hovered_->shown.at - handle.shown.at) < pixel;
    overlay.handles.push_back(handle.shown);
  }
  return overlay;
}

Cursor SelectTool::cursor(const Editor&, Plane plane) const {
  if (drag_) return drag_->cursor();
  if (plane != plane_) return Cursor::Arrow;
  if (hovered_) return hovered_->cursor;
  return overSelected_ ? Cursor::Move : Cursor::Arrow;
}

ToolEntry selectTool() {
  static const SelectTool tool;
  return {&tool.info(), [] { return std::make_unique<SelectTool>(); }};
}

}  // namespace idap
