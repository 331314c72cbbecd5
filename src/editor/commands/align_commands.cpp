#include "editor/commands/command_list.h"
#include "model/edits/arrange_edits.h"

namespace idap {

namespace {

std::size_t pieces(const Elements& elements) {
  return elements.furniture.size() + elements.openings.size() + elements.groups.size();
}
// What is locked or held by its wall can lead, but something must be free to follow.
bool anyMovable(const Editor& editor) {
  const Elements chosen = changeable(editor);
  return pieces(chosen) > openingsInWalls(editor.home(), chosen).openings.size();
}
bool canAlign(const Editor& editor) { return pieces(editor.selection()) >= 2 && anyMovable(editor); }
bool canDistribute(const Editor& editor) { return pieces(editor.selection()) >= 3 && anyMovable(editor); }

template <Alignment alignment>
void align(Editor& editor) {
  editor.apply(QT_TRANSLATE_NOOP("idap", "Align"), [&](const Home& home) {
    return followed(editor, home, alignElements(home, editor.selection(), alignment));
  });
}
template <bool horizontally>
void distribute(Editor& editor) {
  editor.apply(QT_TRANSLATE_NOOP("idap", "Distribute"), [&](const Home& home) {
    return followed(editor, home, distributeElements(home, editor.selection(), horizontally));
  });
}

constexpr const char* kAlign = QT_TRANSLATE_NOOP("idap", "Align");
constexpr const char* kDistribute = QT_TRANSLATE_NOOP("idap", "Distribute");

Command alignment(const char* id, const char* name, const char* tip, void (*run)(Editor&)) {
  return {.id = id,
          .name = name,
          .tip = tip,
          .menu = Menu::Furniture,
          .submenu = kAlign,
          .enabled = canAlign,
          .run = run};
}

}  // namespace

std::vector<Command> alignCommands() {
  std::vector<Command> all{
      alignment("align-left", QT_TRANSLATE_NOOP("idap", "Left"),
                QT_TRANSLATE_NOOP("idap",
                                  "Puts the left edges of the selected pieces in line with the first one's"),
                align<Alignment::Left>),
      alignment(
          "align-centre-horizontal", QT_TRANSLATE_NOOP("idap", "Centre"),
          QT_TRANSLATE_NOOP(
              "idap", "Puts the middles of the selected pieces above each other, as the first one stands"),
          align<Alignment::CentreHorizontal>),
      alignment("align-right", QT_TRANSLATE_NOOP("idap", "Right"),
                QT_TRANSLATE_NOOP("idap",
                                  "Puts the right edges of the selected pieces in line with the first one's"),
                align<Alignment::Right>),
      alignment("align-top", QT_TRANSLATE_NOOP("idap", "Top"),
                QT_TRANSLATE_NOOP("idap", "Puts the upper edges on the plan in line with the first one's"),
                align<Alignment::Top>),
      alignment(
          "align-centre-vertical", QT_TRANSLATE_NOOP("idap", "Middle"),
          QT_TRANSLATE_NOOP(
              "idap", "Puts the middles of the selected pieces beside each other, as the first one stands"),
          align<Alignment::CentreVertical>),
      alignment("align-bottom", QT_TRANSLATE_NOOP("idap", "Bottom"),
                QT_TRANSLATE_NOOP("idap", "Puts the lower edges on the plan in line with the first one's"),
                align<Alignment::Bottom>),
      alignment("align-front-side", QT_TRANSLATE_NOOP("idap", "Front side"),
                QT_TRANSLATE_NOOP(
                    "idap", "Puts the pieces in line with the front of the first one, however it is turned"),
                align<Alignment::FrontSide>),
      alignment("align-back-side", QT_TRANSLATE_NOOP("idap", "Back side"),
                QT_TRANSLATE_NOOP(
                    "idap", "Puts the pieces in line with the back of the first one, however it is turned"),
                align<Alignment::BackSide>),
      alignment(
          "align-left-side", QT_TRANSLATE_NOOP("idap", "Left side"),
          QT_TRANSLATE_NOOP(
              "idap", "Puts the pieces in line with the left side of the first one, however it is turned"),
          align<Alignment::LeftSide>),
      alignment(
          "align-right-side", QT_TRANSLATE_NOOP("idap", "Right side"),
          QT_TRANSLATE_NOOP(
              "idap", "Puts the pieces in line with the right side of the first one, however it is turned"),
          align<Alignment::RightSide>),
      alignment(
          "align-side-by-side", QT_TRANSLATE_NOOP("idap", "Side by side"),
          QT_TRANSLATE_NOOP(
              "idap", "Puts the pieces in a row without gaps, their backs in line with the first one's"),
          align<Alignment::SideBySide>),
      {.id = "distribute-horizontally",
       .name = QT_TRANSLATE_NOOP("idap", "Horizontally"),
       .tip = QT_TRANSLATE_NOOP("idap", "Makes the gaps from left to right equal; the outermost pieces stay"),
       .menu = Menu::Furniture,
       .submenu = kDistribute,
       .enabled = canDistribute,
       .run = distribute<true>},
      {.id = "distribute-vertically",
       .name = QT_TRANSLATE_NOOP("idap", "Vertically"),
       .tip = QT_TRANSLATE_NOOP("idap", "Makes the gaps from bottom to top equal; the outermost pieces stay"),
       .menu = Menu::Furniture,
       .submenu = kDistribute,
       .enabled = canDistribute,
       .run = distribute<false>},
  };
  all[0].separatorBefore = all[6].separatorBefore = all[10].separatorBefore = true;
  return all;
}

}  // namespace idap
