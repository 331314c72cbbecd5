// Polylines: lines of any shape on the plan, open or closed.
#include "editor/tools/outline_tool.h"
#include "editor/tools/tool_list.h"

namespace idap {

namespace {

const ToolInfo kInfo{"polyline",
                     QT_TRANSLATE_NOOP("idap", "Polyline"),
                     QT_TRANSLATE_NOOP("idap", "Draw lines on the plan: arrows, paths, outlines"),
                     QT_TRANSLATE_NOOP("idap", "Click where the line starts"),
                     "L",
                     {{"0-9", QT_TRANSLATE_NOOP("idap", "type the length")},
                      {"Tab", QT_TRANSLATE_NOOP("idap", "angle")},
                      {"Enter", QT_TRANSLATE_NOOP("idap", "place the point, or end")},
                      {"Backspace", QT_TRANSLATE_NOOP("idap", "take the last point back")},
                      {"Alt", QT_TRANSLATE_NOOP("idap", "no snapping")}}};

class PolylineTool : public OutlineTool {
 public:
  PolylineTool()
      : OutlineTool(
            {false,
             QT_TRANSLATE_NOOP("idap",
                               "Click the next point; double-click to end, or click the first one to close"),
             QT_TRANSLATE_NOOP("idap", "Polylines are drawn on the plan X-Y")}) {}
  const ToolInfo& info() const override { return kInfo; }

 protected:
  void finish(Editor& editor, std::vector<Vec2> points, bool closed) override {
    Polyline line;
    line.level = editor.level();
    line.points = std::move(points);
    line.closed = closed;
    PolylineId id;
    if (editor.apply(QT_TRANSLATE_NOOP("idap", "Add polyline"), [&](const Home& home) {
          Home next = home;
          id = next.newId<PolylineId>();
          next.polylines.set(id, line);
          return next;
        }))
      editor.select(only(id));
  }
};

}  // namespace

ToolEntry polylineTool() {
  return {&kInfo, [] { return std::make_unique<PolylineTool>(); }};
}

}  // namespace idap
