// Drives a tool the way a view does: pointer and keys at places in metres, on an editor with the built-in
// catalog only.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "editor/editor.h"

namespace idap {

class ToolDriver : public testing::Test {
 protected:
  ToolDriver() {
    editor.subscribe({.said = [this](const Text& text, Editor::Severity) { said.push_back(text.source); }});
  }

  static std::shared_ptr<const Catalog> builtIn() {
    static const auto catalog = std::make_shared<const Catalog>(std::vector<std::filesystem::path>{});
    return catalog;
  }

  void pointer(PointerEvent::Kind kind, Vec2 at, PointerEvent::Button button = PointerEvent::Button::Left) {
    PointerEvent event;
    event.kind = kind;
    event.plane = plane;
    event.at = at;
    event.pixel = 0.01;
    event.button = button;
    event.modifiers = modifiers;
    editor.pointer(event);
  }
  void move(Vec2 at) { pointer(PointerEvent::Kind::Move, at, PointerEvent::Button::None); }
  void press(Vec2 at) { pointer(PointerEvent::Kind::Press, at); }
  void release(Vec2 at) { pointer(PointerEvent::Kind::Release, at); }
  void leave() { pointer(PointerEvent::Kind::Leave, {}, PointerEvent::Button::None); }
  void click(Vec2 at) {
    move(at);
    press(at);
    release(at);
  }
  void rightClick(Vec2 at) { pointer(PointerEvent::Kind::Press, at, PointerEvent::Button::Right); }
  void doubleClick(Vec2 at) {
    click(at);
    pointer(PointerEvent::Kind::DoubleClick, at);
    release(at);
  }
  void drag(Vec2 from, Vec2 to) {
    move(from);
    press(from);
    for (int i = 1; i <= 4; ++i)
      pointer(PointerEvent::Kind::Move, from + (to - from) * (i / 4.0), PointerEvent::Button::Left);
    release(to);
  }

  bool key(Key key) { return editor.key({key, {}, modifiers}); }
  bool type(const std::string& ascii) {
    bool used = true;
    for (const char c : ascii) used = editor.key({Key::Character, std::string(1, c), modifiers}) && used;
    return used;
  }

  const Home& home() const { return editor.home(); }
  Overlay overlay() const { return editor.tool().overlay(editor, plane, 0.01); }
  const Document& document() const { return editor.document(); }
  int undoSteps() {
    int steps = 0;
    while (editor.document().canUndo()) {
      editor.document().undo();
      ++steps;
    }
    for (int i = 0; i < steps; ++i) editor.document().redo();
    return steps;
  }

  // Four walls, 0.1 m thick, around a clear rectangle from the origin; no steps to undo.
  void openRoom(double x, double y) {
    Home walls;
    const Vec2 corners[] = {{-0.05, -0.05}, {x + 0.05, -0.05}, {x + 0.05, y + 0.05}, {-0.05, y + 0.05}};
    WallId ids[4];
    for (WallId& id : ids) id = walls.newId<WallId>();
    for (int i = 0; i < 4; ++i) {
      Wall wall;
      wall.start = corners[i];
      wall.end = corners[(i + 1) % 4];
      wall.neighbourAtStart = ids[(i + 3) % 4];
      wall.neighbourAtEnd = ids[(i + 1) % 4];
      walls.walls.set(ids[i], wall);
    }
    editor.open(std::make_unique<Document>(walls));
  }

  Editor editor{builtIn()};
  Plane plane = Plane::XY;
  Modifiers modifiers;
  std::vector<std::string> said;
};

// The last element that was added.
template <class IdType, class T>
const T& newest(const Table<IdType, T>& table) {
  static const T none{};
  const T* last = &none;
  for (const auto& [id, element] : table) last = element.get();
  EXPECT_FALSE(table.empty());
  return *last;
}

inline void expectNear(Vec2 a, Vec2 b, double tolerance = 1e-6) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
}

}  // namespace idap
