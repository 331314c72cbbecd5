#include "editor/tools/outline_tool.h"

#include <cmath>

namespace idap {

namespace {

constexpr double kSamePlace = 1e-3;  // m

}  // namespace

Text OutlineTool::hint() const { return points_.empty() ? Text(info().hint) : Text(manner_.next); }

bool OutlineTool::cancel(Editor&) {
  const bool begun = !points_.empty();
  points_.clear();
  pressedAt_.reset();
  point_.forget();
  return begun;
}

void OutlineTool::follow(Editor& editor, const PointerEvent& event) {
  last_ = event;
  DrawnPoint::Line line;
  line.wallFaces = manner_.area;
  line.ignored = ignored();
  if (!points_.empty()) line.from = points_.back();
  if (points_.size() > 1) {
    const Vec2 last = points_.back() - points_[points_.size() - 2];
    line.along = std::atan2(last.y, last.x);
    line.own = points_;
    line.own.pop_back();
  }
  point_.follow(editor, event, line);
  tellDrawn(editor);
}

void OutlineTool::tellDrawn(Editor& editor) {
  if (points_.empty()) return;
  std::vector<Vec2> points = points_;
  if (length(point_.at() - points.back()) >= kSamePlace) points.push_back(point_.at());
  drawn(editor, points);
}

Response OutlineTool::pointer(Editor& editor, const PointerEvent& event) {
  if (!manner_.anyPlane && event.plane != Plane::XY) return {.used = false};
  if (!points_.empty() && event.plane != plane()) return {};
  switch (event.kind) {
    case PointerEvent::Kind::Move:
      follow(editor, event);
      return {};
    case PointerEvent::Kind::Press:
      if (event.button == PointerEvent::Button::Right) {
        if (points_.empty()) return {.used = false};
        stop(editor);
        return {};
      }
      follow(editor, event);
      pressedAt_ = event.at;
      place(editor);
      return {};
    case PointerEvent::Kind::Release: {
      const std::optional<Vec2> from = std::exchange(pressedAt_, std::nullopt);
      if (!from || points_.empty() || length(event.at - *from) < kDragPixels * event.pixel) return {};
      follow(editor, event);
      place(editor);
      return {};
    }
    case PointerEvent::Kind::Leave:
      if (points_.empty()) point_ = DrawnPoint();
      return {};
    case PointerEvent::Kind::DoubleClick:
      if (event.button != PointerEvent::Button::Left) return {};
      // The first click of the two has put a point.
      if (points_.size() < 2) {
        cancel(editor);
        fill(editor, event.at);
      } else {
        stop(editor);
      }
      return {};
    default:
      return {};
  }
}

Response OutlineTool::key(Editor& editor, const KeyEvent& event) {
  if (points_.empty()) return {.used = false};
  switch (point_.key(event, editor.settings().unit)) {
    case TypedFields::Answer::Changed:
      tellDrawn(editor);
      return {};
    case TypedFields::Answer::Wrong:
      return {};
    case TypedFields::Answer::Apply:
      place(editor);
      if (!points_.empty()) follow(editor, last_);  // on from there to the pointer
      return {};
    case TypedFields::Answer::Unused:
      break;
  }
  if (event.key == Key::Enter) {
    stop(editor);
    return {};
  }
  if (event.key == Key::Backspace) {
    points_.pop_back();
    point_.fields().clear();
    if (points_.empty())
      cancel(editor);
    else
      follow(editor, last_);
    return {};
  }
  return {.used = false};
}

void OutlineTool::place(Editor& editor) {
  const Vec2 at = point_.at();
  if (points_.size() >= 3 && length(at - points_.front()) < kSamePlace) {
    std::vector<Vec2> points = points_;
    cancel(editor);
    finish(editor, std::move(points), true);
    return;
  }
  if (!points_.empty() && length(at - points_.back()) < kSamePlace) return;
  points_.push_back(at);
  point_.startFrom(at);
  tellDrawn(editor);
}

// Makes what is drawn so far; too little of it is dropped.
void OutlineTool::stop(Editor& editor) {
  std::vector<Vec2> points = points_;
  cancel(editor);
  if (points.size() >= fewest()) finish(editor, std::move(points), manner_.area);
}

Overlay OutlineTool::overlay(const Editor& editor, Plane plane, double pixel) const {
  Overlay overlay;
  if (manner_.anyPlane && plane != this->plane()) return overlay;
  if (!manner_.anyPlane && plane != Plane::XY) {
    if (editor.lastPointer().plane == plane) overlay.note = manner_.planOnly;
    return overlay;
  }
  point_.into(overlay, pixel);
  if (points_.empty()) {
    if (point_.known()) offer(editor, last_.at, overlay);
    return overlay;
  }
  PreviewShape shape;
  shape.points = points_;
  shape.points.push_back(point_.at());
  shape.closed = shape.filled = manner_.area && shape.points.size() >= 3;
  overlay.shapes.push_back(std::move(shape));
  if (points_.size() >= 3) overlay.handles.push_back({HandleKind::Point, points_.front(), 0, false});
  return overlay;
}

Cursor OutlineTool::cursor(const Editor&, Plane plane) const {
  return manner_.anyPlane || plane == Plane::XY ? Cursor::Cross : Cursor::Forbidden;
}

}  // namespace idap
