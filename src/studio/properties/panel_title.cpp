#include "studio/properties/panel_title.h"

#include <QStringList>

#include "studio/widgets/texts.h"

namespace idap {

namespace {

struct Kind {
  std::size_t count;
  const char* one;
  const char* several;  // with the number in place of %1
};

std::vector<Kind> kinds(const Selected& s) {
  std::size_t doors = 0, windows = 0, bare = 0;
  for (const OpeningId id : s.elements.openings)
    if (const Opening* opening = s.home.openings.find(id))
      ++(opening->kind == OpeningKind::Door ? doors : opening->kind == OpeningKind::Window ? windows : bare);
  std::vector<Kind> all{
      {s.elements.furniture.size(), QT_TRANSLATE_NOOP("idap", "1 piece of furniture"),
       QT_TRANSLATE_NOOP("idap", "%1 pieces of furniture")},
      {s.elements.groups.size(), QT_TRANSLATE_NOOP("idap", "1 group"),
       QT_TRANSLATE_NOOP("idap", "%1 groups")},
      {doors, QT_TRANSLATE_NOOP("idap", "1 door"), QT_TRANSLATE_NOOP("idap", "%1 doors")},
      {windows, QT_TRANSLATE_NOOP("idap", "1 window"), QT_TRANSLATE_NOOP("idap", "%1 windows")},
      {bare, QT_TRANSLATE_NOOP("idap", "1 opening"), QT_TRANSLATE_NOOP("idap", "%1 openings")},
      {s.elements.walls.size(), QT_TRANSLATE_NOOP("idap", "1 wall"), QT_TRANSLATE_NOOP("idap", "%1 walls")},
      {s.elements.rooms.size(), QT_TRANSLATE_NOOP("idap", "1 room"), QT_TRANSLATE_NOOP("idap", "%1 rooms")},
      {s.elements.cameras.size(), QT_TRANSLATE_NOOP("idap", "1 point of view"),
       QT_TRANSLATE_NOOP("idap", "%1 points of view")},
      {s.elements.dimensions.size(), QT_TRANSLATE_NOOP("idap", "1 dimension"),
       QT_TRANSLATE_NOOP("idap", "%1 dimensions")},
      {s.elements.labels.size(), QT_TRANSLATE_NOOP("idap", "1 text"), QT_TRANSLATE_NOOP("idap", "%1 texts")},
      {s.elements.polylines.size(), QT_TRANSLATE_NOOP("idap", "1 line"),
       QT_TRANSLATE_NOOP("idap", "%1 lines")}};
  std::erase_if(all, [](const Kind& kind) { return kind.count == 0; });
  return all;
}

QString counted(const Kind& kind) {
  return kind.count == 1 ? translated(kind.one) : translated(kind.several).arg(kind.count);
}

// What the one element that is selected is called; empty for none of its own.
std::string nameOf(const Selected& s) {
  const auto name = [](const auto& table, const auto& ids, auto get) -> std::string {
    const auto* found = ids.empty() ? nullptr : table.find(ids.front());
    return found ? get(*found) : std::string();
  };
  const auto named = [](const auto& element) { return element.name; };
  for (const std::string& found :
       {name(s.home.furniture, s.elements.furniture, named),
        name(s.home.openings, s.elements.openings, named), name(s.home.groups, s.elements.groups, named),
        name(s.home.rooms, s.elements.rooms, named), name(s.home.cameras, s.elements.cameras, named)})
    if (!found.empty()) return found;
  return {};
}

const char* kindName(const Selected& s) {
  if (!s.elements.furniture.empty()) return QT_TRANSLATE_NOOP("idap", "Piece of furniture");
  if (!s.elements.groups.empty()) return QT_TRANSLATE_NOOP("idap", "Group");
  if (!s.elements.openings.empty()) {
    const Opening* opening = s.home.openings.find(s.elements.openings.front());
    if (opening && opening->kind == OpeningKind::Door) return QT_TRANSLATE_NOOP("idap", "Door");
    if (opening && opening->kind == OpeningKind::Window) return QT_TRANSLATE_NOOP("idap", "Window");
    return QT_TRANSLATE_NOOP("idap", "Opening");
  }
  if (!s.elements.walls.empty()) return QT_TRANSLATE_NOOP("idap", "Wall");
  if (!s.elements.rooms.empty()) return QT_TRANSLATE_NOOP("idap", "Room");
  if (!s.elements.cameras.empty()) return QT_TRANSLATE_NOOP("idap", "Point of view");
  if (!s.elements.dimensions.empty()) return QT_TRANSLATE_NOOP("idap", "Dimension");
  if (!s.elements.labels.empty()) return QT_TRANSLATE_NOOP("idap", "Label");
  return QT_TRANSLATE_NOOP("idap", "Line");
}

}  // namespace

PanelTitle panelTitle(const Selected& s) {
  if (s.count == 0) return {translated(QT_TRANSLATE_NOOP("idap", "Home")), {}};
  if (s.count == 1) {
    const QString kind = translated(kindName(s)), name = toQt(nameOf(s));
    return name.isEmpty() || name == kind ? PanelTitle{kind, {}} : PanelTitle{name, kind};
  }
  const std::vector<Kind> found = kinds(s);
  if (found.size() == 1) return {counted(found.front()), {}};
  QStringList parts;
  for (const Kind& kind : found) parts << counted(kind);
  return {translated(QT_TRANSLATE_NOOP("idap", "%1 elements")).arg(s.count),
          parts.join(QStringLiteral(", "))};
}

}  // namespace idap
