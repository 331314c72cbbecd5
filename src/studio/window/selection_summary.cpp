#include "studio/window/selection_summary.h"

#include <QCoreApplication>

#include "model/room_geometry.h"
#include "model/wall_path.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

QString words(const char* english) { return QCoreApplication::translate("idap::MainWindow", english); }

QString sizeText(Vec3 size, LengthUnit unit) {
  return lengthText(size.x, unit, 1) + QStringLiteral(" × ") + lengthText(size.y, unit, 1) +
         QStringLiteral(" × ") + lengthText(size.z, unit, 1);
}

QString joined(const QString& name, const QString& rest) {
  return name.isEmpty() ? rest : name + QStringLiteral(" · ") + rest;
}

}  // namespace

QString selectionSummary(const Editor& editor) {
  const Elements& selection = editor.selection();
  const Home& home = editor.home();
  const LengthUnit unit = editor.settings().unit;
  const std::size_t count = idap::count(selection);
  if (count == 0) return {};
  if (count == 1) {
    if (!selection.furniture.empty()) {
      const Furniture& piece = *home.furniture.find(selection.furniture[0]);
      return joined(toQt(piece.name), sizeText(piece.size, unit));
    }
    if (!selection.openings.empty()) {
      const Opening& opening = *home.openings.find(selection.openings[0]);
      return joined(toQt(opening.name), sizeText(opening.size, unit));
    }
    if (!selection.walls.empty())
      return joined(words(QT_TRANSLATE_NOOP("idap::MainWindow", "Wall")),
                    lengthText(WallPath(*home.walls.find(selection.walls[0])).length(), unit, 1));
    if (!selection.rooms.empty()) {
      const Room& room = *home.rooms.find(selection.rooms[0]);
      return joined(
          room.name.empty() ? words(QT_TRANSLATE_NOOP("idap::MainWindow", "Room")) : toQt(room.name),
          areaText(std::abs(signedArea(room.points)), unit));
    }
    if (!selection.groups.empty()) return toQt(home.groups.find(selection.groups[0])->name);
    if (!selection.cameras.empty()) return toQt(home.cameras.find(selection.cameras[0])->name);
  }
  return words(QT_TRANSLATE_NOOP("idap::MainWindow", "%1 selected")).arg(count);
}

}  // namespace idap
