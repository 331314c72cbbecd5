// Rooms: drawn point by point, or found inside walls by a double click.
#include <cmath>

#include "editor/tools/outline_tool.h"
#include "editor/tools/tool_list.h"
#include "model/edits/element_edits.h"
#include "model/room_geometry.h"

namespace idap {

namespace {

const ToolInfo kInfo{
    "room",
    QT_TRANSLATE_NOOP("idap", "Room"),
    QT_TRANSLATE_NOOP("idap", "Draw the floor of a room, or fill the space between walls with one"),
    QT_TRANSLATE_NOOP("idap", "Double-click inside walls to fill them, or click the corners of the room"),
    "O",
    {{"0-9", QT_TRANSLATE_NOOP("idap", "type the length")},
     {"Tab", QT_TRANSLATE_NOOP("idap", "angle")},
     {"Enter", QT_TRANSLATE_NOOP("idap", "place the corner, or close")},
     {"Backspace", QT_TRANSLATE_NOOP("idap", "take the last corner back")},
     {"Alt", QT_TRANSLATE_NOOP("idap", "no snapping")}}};

class RoomTool : public OutlineTool {
 public:
  RoomTool()
      : OutlineTool(
            {true,
             QT_TRANSLATE_NOOP("idap", "Click the next corner; on the first one, or double-click, to close"),
             QT_TRANSLATE_NOOP("idap", "Rooms are drawn on the plan X-Y")}) {}
  const ToolInfo& info() const override { return kInfo; }

 protected:
  void finish(Editor& editor, std::vector<Vec2> points, bool) override {
    Room room;
    room.level = editor.level();
    room.points = std::move(points);
    add(editor, std::move(room));
  }

  void offer(const Editor& editor, Vec2 at, Overlay& overlay) const override {
    const std::optional<Polygon> area = closedAreaAt(editor.home(), editor.level(), at);
    if (!area || roomIn(editor, *area, at)) return;
    overlay.shapes.push_back({*area, true, true});
    overlay.note = QT_TRANSLATE_NOOP("idap", "Double-click makes this a room");
  }

  void fill(Editor& editor, Vec2 at) override {
    const std::optional<Polygon> area = closedAreaAt(editor.home(), editor.level(), at);
    if (!area) {
      editor.say(
          QT_TRANSLATE_NOOP("idap", "No walls close around this point: draw the room corner by corner"),
          Editor::Severity::Warning);
      return;
    }
    // The same room twice would only hide the first.
    if (const auto there = roomIn(editor, *area, at)) {
      editor.select(only(*there));
      editor.say(QT_TRANSLATE_NOOP("idap", "There is a room already"));
      return;
    }
    Room room;
    room.level = editor.level();
    room.points = *area;
    add(editor, std::move(room));
  }

 private:
  static std::optional<RoomId> roomIn(const Editor& editor, const Polygon& area, Vec2 at) {
    const double size = std::abs(signedArea(area));
    for (const auto& [id, room] : editor.home().rooms)
      if (room->level == editor.level() && contains(room->points, at) &&
          std::abs(floorArea(*room) - size) < 0.05 * size)
        return id;
    return std::nullopt;
  }

  static void add(Editor& editor, Room room) {
    RoomId id;
    if (editor.apply(QT_TRANSLATE_NOOP("idap", "Add room"), [&](const Home& home) {
          RoomEdit edit = addRoom(home, std::move(room));
          id = edit.room;
          return std::move(edit.home);
        }))
      editor.select(only(id));
  }
};

}  // namespace

ToolEntry roomTool() {
  return {&kInfo, [] { return std::make_unique<RoomTool>(); }};
}

}  // namespace idap
