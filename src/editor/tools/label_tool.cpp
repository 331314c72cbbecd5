// Texts on the plan: a click, and what is typed stands there.
#include "editor/snap.h"
#include "editor/tools/drawn_point.h"
#include "editor/tools/tool_list.h"

namespace idap {

namespace {

const ToolInfo kInfo{"label",
                     QT_TRANSLATE_NOOP("idap", "Label"),
                     QT_TRANSLATE_NOOP("idap", "Write on the plan: names, notes, anything"),
                     QT_TRANSLATE_NOOP("idap", "Click where the text is to stand"),
                     "T",
                     {{"Enter", QT_TRANSLATE_NOOP("idap", "done")},
                      {"Shift+Enter", QT_TRANSLATE_NOOP("idap", "new line")},
                      {"Esc", QT_TRANSLATE_NOOP("idap", "drop it")}}};

class LabelTool : public Tool {
 public:
  const ToolInfo& info() const override { return kInfo; }

  Text hint() const override {
    return writing_ ? QT_TRANSLATE_NOOP("idap", "Type the text, then press Enter") : kInfo.hint;
  }

  bool cancel(Editor& editor) override {
    if (!writing_) return false;
    editor.document().cancel();
    writing_ = false;
    label_ = {};
    text_.clear();
    return true;
  }

  // What was typed stands, whatever is done next.
  void end(Editor& editor) override { finish(editor); }

  Response pointer(Editor& editor, const PointerEvent& event) override {
    if (event.plane != Plane::XY) return {.used = false};
    if (event.kind != PointerEvent::Kind::Press && event.kind != PointerEvent::Kind::Move) return {};
    if (event.kind == PointerEvent::Kind::Press) {
      const bool wrote = writing_;
      finish(editor);
      if (event.button == PointerEvent::Button::Right) return {.used = wrote};
    }
    if (writing_) return {};
    SnapRequest request;
    request.at = event.at;
    request.tolerance = kSnapPixels * event.pixel;
    // Texts stand in rows with each other; the ends of walls mean nothing to them.
    const SnappedPoint snapped = snapPoint(editor, request, event.modifiers.alt);
    const bool row = snapped.to == SnappedPoint::To::Alignment || snapped.to == SnappedPoint::To::Grid;
    at_ = row ? snapped.at : event.at;
    guides_ = row ? snapped.guides : std::vector<GuideLine>{};
    if (event.kind == PointerEvent::Kind::Press) {
      writing_ = true;
      text_.clear();
    }
    return {};
  }

  Response key(Editor& editor, const KeyEvent& event) override {
    if (!writing_) return {.used = false};
    if (event.key == Key::Enter && !event.modifiers.shift) {
      finish(editor);
      return {};
    }
    if (event.key == Key::Escape) return {.used = cancel(editor)};
    const bool used = text_.key(event, editor.settings().unit) != TypedFields::Answer::Unused;
    if (used) show(editor);
    // Letters are text here and no shortcuts, even those that do not fit.
    const bool letter = event.key == Key::Character && !event.modifiers.control && !event.modifiers.alt;
    return {.used = used || letter || event.key == Key::Backspace || event.key == Key::Delete};
  }

  Overlay overlay(const Editor& editor, Plane plane, double) const override {
    Overlay overlay;
    if (plane != Plane::XY) {
      if (editor.lastPointer().plane == plane)
        overlay.note = QT_TRANSLATE_NOOP("idap", "Texts are written on the plan X-Y");
      return overlay;
    }
    overlay.guides = guides_;
    if (writing_) text_.into(overlay, at_);
    return overlay;
  }

  Cursor cursor(const Editor&, Plane plane) const override {
    return plane == Plane::XY ? Cursor::Text : Cursor::Forbidden;
  }

 private:
  void show(Editor& editor) {
    Label label;
    label.level = editor.level();
    label.position = at_;
    label.text = text_.text(0);
    if (!editor.document().inTransaction()) editor.document().begin(QT_TRANSLATE_NOOP("idap", "Add text"));
    editor.preview([&](const Home& home) {
      if (label.text.find_first_not_of(" \n") == std::string::npos) return home;
      Home next = home;
      label_ = next.newId<LabelId>();
      next.labels.set(label_, label);
      return next;
    });
  }

  void finish(Editor& editor) {
    if (!writing_) return;
    writing_ = false;
    text_.clear();
    if (!editor.document().inTransaction()) return;
    const LabelId id = std::exchange(label_, LabelId{});
    editor.document().commit();
    if (editor.home().labels.contains(id)) editor.select(only(id));
  }

  TypedFields text_{{{QT_TRANSLATE_NOOP("idap", "Text"), Field::Kind::Text}}};
  bool writing_ = false;
  LabelId label_;
  Vec2 at_;
  std::vector<GuideLine> guides_;
};

}  // namespace

ToolEntry labelTool() {
  return {&kInfo, [] { return std::make_unique<LabelTool>(); }};
}

}  // namespace idap
