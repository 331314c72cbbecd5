// What goes on between a press and the release: one class for each thing that can be dragged. A drag previews
// its change in a transaction of the document, so that it is one undo step and Escape takes it back.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "editor/editor.h"
#include "editor/snap.h"
#include "editor/tools/typed_fields.h"

namespace idap {

inline constexpr double kSnapReach = 10;  // pixels

class Drag {
 public:
  virtual ~Drag() = default;
  virtual void move(Editor& editor, const PointerEvent& event) = 0;
  virtual void finish(Editor& editor) = 0;  // the button is released
  virtual void cancel(Editor& editor) = 0;
  enum class Answer { Unused, Used, Done };
  virtual Answer key(Editor&, const KeyEvent&) { return Answer::Unused; }
  virtual Overlay overlay(const Editor& editor, Plane plane, double pixel) const = 0;
  virtual Text hint() const = 0;
  virtual Cursor cursor() const { return Cursor::Move; }
};

// A drag that changes the home. What the pointer and the typed values mean is found out in aim(); change()
// makes of the home as it was the home as it would be.
class EditDrag : public Drag {
 public:
  EditDrag(Editor& editor, std::string name, const PointerEvent& press, Cursor cursor);
  void move(Editor& editor, const PointerEvent& event) override;
  void finish(Editor& editor) override;
  void cancel(Editor& editor) override;
  Answer key(Editor& editor, const KeyEvent& event) override;
  Overlay overlay(const Editor& editor, Plane plane, double pixel) const override;
  Cursor cursor() const override { return cursor_; }

 protected:
  virtual void aim(const Editor& editor, const PointerEvent& event) = 0;
  virtual Home change(const Home& before) = 0;
  // What follows the change, beside dimensions: all along in a small home, at the end in a large one.
  virtual Home settle(const Editor&, const Home&, Home after) { return after; }
  // What is seen in the plane of the drag.
  virtual void show(const Editor&, Overlay&, double pixel) const { (void)pixel; }

  const Home& before() const { return before_; }
  const PointerEvent& press() const { return press_; }
  Plane plane() const { return press_.plane; }
  const PointerEvent& last() const { return last_; }
  double tolerance(const PointerEvent& event) const { return kSnapReach * event.pixel; }
  // A point of the plane that the pointer means, snapped.
  SnappedPoint snapped(const Editor& editor, Vec2 at, const Elements& ignored, bool faces = true,
                       std::optional<Vec2> from = {}, std::optional<double> along = {},
                       std::vector<Vec2> marks = {});

  TypedFields fields_;
  std::vector<GuideLine> guides_;
  std::string name_;

 private:
  void update(Editor& editor);

  Home before_;
  PointerEvent press_, last_;
  Cursor cursor_;
  bool settlesAlong_;
};

// Rooms follow walls that changed, where the settings want it.
Home withRooms(const Editor& editor, const Home& before, Home after);

// The multiple of 15 degrees nearest to an angle, or the angle itself when free.
double stepped(double angle, bool free);

}  // namespace idap
