#include "studio/lists/piece_columns.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>
#include <numbers>

#include "model/edits/piece_edits.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

QString wording(const char* text) { return QCoreApplication::translate("FurnitureList", text); }

struct ColumnInfo {
  const char* title;
  const char* tip;
  bool shown, number;
};

const ColumnInfo& infoOf(PieceColumn column) {
  static constexpr ColumnInfo kInfos[kPieceColumns] = {
      {QT_TRANSLATE_NOOP("FurnitureList", "Name"),
       QT_TRANSLATE_NOOP("FurnitureList", "What it is called; double click to rename"), true, false},
      {QT_TRANSLATE_NOOP("FurnitureList", "Width"),
       QT_TRANSLATE_NOOP("FurnitureList", "From its left to its right"), true, true},
      {QT_TRANSLATE_NOOP("FurnitureList", "Depth"),
       QT_TRANSLATE_NOOP("FurnitureList", "From its front to its back"), true, true},
      {QT_TRANSLATE_NOOP("FurnitureList", "Height"),
       QT_TRANSLATE_NOOP("FurnitureList", "From its base to its top"), true, true},
      {"X", QT_TRANSLATE_NOOP("FurnitureList", "Place of its middle to the right of the origin"), false,
       true},
      {"Y", QT_TRANSLATE_NOOP("FurnitureList", "Place of its middle up the page from the origin"), false,
       true},
      {QT_TRANSLATE_NOOP("FurnitureList", "Elevation"),
       QT_TRANSLATE_NOOP("FurnitureList", "Of its base above the floor"), false, true},
      {QT_TRANSLATE_NOOP("FurnitureList", "Angle"),
       QT_TRANSLATE_NOOP("FurnitureList", "Turned counter-clockwise on the plan"), false, true},
      {QT_TRANSLATE_NOOP("FurnitureList", "Pitch"), QT_TRANSLATE_NOOP("FurnitureList", "Leaning back"), false,
       true},
      {QT_TRANSLATE_NOOP("FurnitureList", "Roll"), QT_TRANSLATE_NOOP("FurnitureList", "Leaning sideways"),
       false, true},
      {QT_TRANSLATE_NOOP("FurnitureList", "Level"),
       QT_TRANSLATE_NOOP("FurnitureList", "The storey that it stands on"), true, false},
      {QT_TRANSLATE_NOOP("FurnitureList", "Kind"),
       QT_TRANSLATE_NOOP("FurnitureList", "Furniture, lamp, door, window, stairs or group"), true, false},
      {QT_TRANSLATE_NOOP("FurnitureList", "Category"),
       QT_TRANSLATE_NOOP("FurnitureList", "Where it is found in the catalog"), false, false},
      {QT_TRANSLATE_NOOP("FurnitureList", "Price"),
       QT_TRANSLATE_NOOP("FurnitureList", "In the home's currency; double click to change"), true, true},
      {QT_TRANSLATE_NOOP("FurnitureList", "Visible"),
       QT_TRANSLATE_NOOP("FurnitureList", "Shown on plans and in pictures"), true, false},
      {QT_TRANSLATE_NOOP("FurnitureList", "Locked"),
       QT_TRANSLATE_NOOP("FurnitureList", "Cannot be moved by the pointer"), false, false},
      {QT_TRANSLATE_NOOP("FurnitureList", "Mirrored"),
       QT_TRANSLATE_NOOP("FurnitureList", "Left and right exchanged"), false, false},
      {QT_TRANSLATE_NOOP("FurnitureList", "Light"),
       QT_TRANSLATE_NOOP("FurnitureList", "Luminous flux of a lamp, in lumens"), false, true},
      {QT_TRANSLATE_NOOP("FurnitureList", "Creator"),
       QT_TRANSLATE_NOOP("FurnitureList", "Who made the model"), false, false},
      {QT_TRANSLATE_NOOP("FurnitureList", "Licence"),
       QT_TRANSLATE_NOOP("FurnitureList", "How the model may be used"), false, false},
      {QT_TRANSLATE_NOOP("FurnitureList", "Catalog ID"),
       QT_TRANSLATE_NOOP("FurnitureList", "By which the catalog knows it"), false, false},
      {QT_TRANSLATE_NOOP("FurnitureList", "Description"),
       QT_TRANSLATE_NOOP("FurnitureList", "What the file says about it"), false, false},
  };
  return kInfos[static_cast<int>(column)];
}

const Furniture* furnitureOf(const Home& home, RowId row) {
  const auto* id = std::get_if<FurnitureId>(&row);
  return id ? home.furniture.find(*id) : nullptr;
}

const Opening* openingOf(const Home& home, RowId row) {
  const auto* id = std::get_if<OpeningId>(&row);
  return id ? home.openings.find(*id) : nullptr;
}

const Group* groupOf(const Home& home, RowId row) {
  const auto* id = std::get_if<GroupId>(&row);
  return id ? home.groups.find(*id) : nullptr;
}

// The catalog's piece, unless that would make the user wait for libraries to be read.
CatalogPiecePtr catalogPieceOf(const Editor& editor, const Piece& piece) {
  const std::string& id = piece.model.catalogId;
  if (!id.starts_with("idap/") && !editor.catalog().librariesRead()) return nullptr;
  return editor.catalog().find(id);
}

QString kindText(const Home& home, RowId row) {
  if (const Group* group = groupOf(home, row)) {
    (void)group;
    return translated(QT_TRANSLATE_NOOP("idap", "Group"));
  }
  if (const Opening* opening = openingOf(home, row)) {
    switch (opening->kind) {
      case OpeningKind::Door:
        return translated(QT_TRANSLATE_NOOP("idap", "Door"));
      case OpeningKind::Window:
        return translated(QT_TRANSLATE_NOOP("idap", "Window"));
      case OpeningKind::Bare:
        return translated(QT_TRANSLATE_NOOP("idap", "Opening"));
    }
  }
  const Furniture* furniture = furnitureOf(home, row);
  if (!furniture) return {};
  if (furniture->lamp) return translated(QT_TRANSLATE_NOOP("idap", "Lamp"));
  return furniture->staircaseCutOut.empty() ? translated(QT_TRANSLATE_NOOP("idap", "Furniture"))
                                            : translated(QT_TRANSLATE_NOOP("idap", "Stairs"));
}

QString categoryText(const Editor& editor, const Piece& piece) {
  static const std::vector<Catalog::Category> builtin =
      Catalog(std::vector<std::filesystem::path>{}).categories();
  const CatalogPiecePtr known = catalogPieceOf(editor, piece);
  if (!known) return {};
  if (const auto texts = known->translations.find(editor.settings().language);
      texts != known->translations.end())
    if (const auto name = texts->second.find("category"); name != texts->second.end())
      return toQt(name->second);
  for (const Catalog::Category& category : builtin)
    if (category.id == known->category) return toQt(category.name);
  return toQt(known->category);
}

QString propertyText(const Editor& editor, const Piece& piece, const char* key,
                     std::string CatalogPiece::*member) {
  if (const auto own = piece.properties.find(key); own != piece.properties.end()) return toQt(own->second);
  const CatalogPiecePtr known = catalogPieceOf(editor, piece);
  return known ? toQt((*known).*member) : QString();
}

// Metres, radians, money, lumens; nothing where the cell is empty or no number.
std::optional<double> numberOf(const Home& home, RowId row, PieceColumn column) {
  const Piece* piece = pieceOf(home, row);
  if (!piece) return std::nullopt;
  switch (column) {
    case PieceColumn::Width:
      return piece->size.x;
    case PieceColumn::Depth:
      return piece->size.y;
    case PieceColumn::Height:
      return piece->size.z;
    case PieceColumn::X:
      return piece->position.x;
    case PieceColumn::Y:
      return piece->position.y;
    case PieceColumn::Elevation:
      return piece->position.z;
    case PieceColumn::Angle: {
      const double turn = std::fmod(piece->angle, 2 * std::numbers::pi);
      return turn < -1e-9 ? turn + 2 * std::numbers::pi : turn;
    }
    case PieceColumn::Pitch:
      return piece->pitch;
    case PieceColumn::Roll:
      return piece->roll;
    case PieceColumn::Price:
      return piece->price;
    case PieceColumn::Light: {
      const Furniture* lamp = furnitureOf(home, row);
      return lamp && lamp->lamp ? std::optional(lamp->lamp->lumens) : std::nullopt;
    }
    default:
      return std::nullopt;
  }
}

bool isLength(PieceColumn column) { return column >= PieceColumn::Width && column <= PieceColumn::Elevation; }
bool isAngle(PieceColumn column) { return column >= PieceColumn::Angle && column <= PieceColumn::Roll; }

double perMetre(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::Centimetre:
      return 100;
    case LengthUnit::Millimetre:
      return 1000;
    case LengthUnit::FeetInches:
      return 1 / 0.0254;
    case LengthUnit::Metre:
      break;
  }
  return 1;
}

Elements elementsOf(RowId row) {
  Elements elements;
  if (const auto* id = std::get_if<FurnitureId>(&row)) elements.furniture = {*id};
  if (const auto* id = std::get_if<OpeningId>(&row)) elements.openings = {*id};
  if (const auto* id = std::get_if<GroupId>(&row)) elements.groups = {*id};
  return elements;
}

bool changePiece(Editor& editor, const char* name, RowId row, const std::function<void(Piece&)>& change) {
  return editor.apply(name, [&](const Home& home) { return changePieces(home, elementsOf(row), change); });
}

bool changeGroup(Editor& editor, const char* name, GroupId id, const std::function<void(Group&)>& change) {
  return editor.apply(name, [&](const Home& home) {
    Home after = home;
    if (const Group* before = home.groups.find(id)) {
      Group group = *before;
      change(group);
      after.groups.set(id, std::move(group));
    }
    return after;
  });
}

}  // namespace

std::uint64_t valueOf(RowId id) {
  return std::visit([](auto i) { return i.value; }, id);
}

QString columnTitle(PieceColumn column) { return wording(infoOf(column).title); }
QString columnTip(PieceColumn column) { return wording(infoOf(column).tip); }
bool shownAtFirst(PieceColumn column) { return infoOf(column).shown; }
bool isNumber(PieceColumn column) { return infoOf(column).number; }
bool isSwitch(PieceColumn column) {
  return column == PieceColumn::Visible || column == PieceColumn::Locked || column == PieceColumn::Mirrored;
}

bool isEditable(PieceColumn column, RowId row) {
  const bool group = std::holds_alternative<GroupId>(row);
  return column == PieceColumn::Name || column == PieceColumn::Visible ||
         (!group && (column == PieceColumn::Price || column == PieceColumn::Locked));
}

const Piece* pieceOf(const Home& home, RowId row) {
  if (const Furniture* furniture = furnitureOf(home, row)) return furniture;
  return openingOf(home, row);
}

QString cellText(const Editor& editor, RowId row, PieceColumn column) {
  const Home& home = editor.home();
  if (const auto number = numberOf(home, row, column)) {
    if (isLength(column)) return lengthText(*number, editor.settings().unit);
    if (isAngle(column)) return angleText(*number);
    if (column == PieceColumn::Light)
      return QCoreApplication::translate("FurnitureList", "%1 lm").arg(QLocale().toString(*number, 'f', 0));
    return QLocale().toString(*number, 'f', 2);
  }
  if (column == PieceColumn::Kind) return kindText(home, row);
  const Piece* piece = pieceOf(home, row);
  if (!piece) {
    const Group* group = groupOf(home, row);
    return group && column == PieceColumn::Name ? toQt(group->name) : QString();
  }
  switch (column) {
    case PieceColumn::Name:
      return toQt(piece->name);
    case PieceColumn::Level: {
      const Level* level = home.levels.find(piece->level);
      return level ? toQt(level->name) : QString();
    }
    case PieceColumn::Category:
      return categoryText(editor, *piece);
    case PieceColumn::Creator:
      return propertyText(editor, *piece, "creator", &CatalogPiece::creator);
    case PieceColumn::Licence:
      return propertyText(editor, *piece, "license", &CatalogPiece::license);
    case PieceColumn::CatalogPieceId:
      return toQt(piece->model.catalogId);
    case PieceColumn::Description:
      return toQt(piece->description);
    default:
      return {};
  }
}

bool isOn(const Home& home, RowId row, PieceColumn column) {
  if (const Group* group = groupOf(home, row)) return column == PieceColumn::Visible && group->visible;
  const Piece* piece = pieceOf(home, row);
  if (!piece) return false;
  if (column == PieceColumn::Visible) return piece->visible;
  return column == PieceColumn::Locked ? piece->locked : piece->mirrored;
}

QVariant sortValue(const Editor& editor, RowId row, PieceColumn column) {
  if (isSwitch(column)) return isOn(editor.home(), row, column) ? 1.0 : 0.0;
  if (isNumber(column)) return numberOf(editor.home(), row, column).value_or(-1e300);
  return cellText(editor, row, column);
}

QString exportText(const Editor& editor, RowId row, PieceColumn column) {
  if (isSwitch(column)) {
    if (std::holds_alternative<GroupId>(row) && column != PieceColumn::Visible) return {};
    return isOn(editor.home(), row, column) ? translated(QT_TRANSLATE_NOOP("idap", "yes"))
                                            : translated(QT_TRANSLATE_NOOP("idap", "no"));
  }
  if (!isNumber(column)) return cellText(editor, row, column);
  const auto number = numberOf(editor.home(), row, column);
  if (!number) return {};
  if (column == PieceColumn::Price) return QString::number(*number, 'f', 2);
  double value = *number;
  if (isLength(column)) value *= perMetre(editor.settings().unit);
  if (isAngle(column)) value *= 180 / std::numbers::pi;
  // Tenths of a millimetre are enough, and 0.1 + 0.2 should look like 0.3.
  value = std::round(value * 1e4) / 1e4;
  return QString::number(value == 0 ? 0.0 : value, 'g', 12);
}

QString exportTitle(const Editor& editor, PieceColumn column) {
  const QString title = columnTitle(column);
  if (isAngle(column)) return title + QStringLiteral(" (°)");
  if (column == PieceColumn::Light) return title + QStringLiteral(" (lm)");
  if (column == PieceColumn::Price) return QStringLiteral("%1 (%2)").arg(title, toQt(editor.home().currency));
  if (!isLength(column)) return title;
  static constexpr const char* kUnits[] = {"m", "cm", "mm", "in"};
  return QStringLiteral("%1 (%2)").arg(title,
                                       QString::fromLatin1(kUnits[static_cast<int>(editor.settings().unit)]));
}

bool setCell(Editor& editor, RowId row, PieceColumn column, const QVariant& value) {
  const auto* group = std::get_if<GroupId>(&row);
  if (!isEditable(column, row)) return false;
  switch (column) {
    case PieceColumn::Name: {
      const std::string name = fromQt(value.toString().trimmed());
      if (name == fromQt(cellText(editor, row, column))) return true;
      if (group)
        return changeGroup(editor, QT_TRANSLATE_NOOP("idap", "Rename"), *group,
                           [&](Group& g) { g.name = name; });
      return changePiece(editor, QT_TRANSLATE_NOOP("idap", "Rename"), row, [&](Piece& p) { p.name = name; });
    }
    case PieceColumn::Price: {
      const QString text = value.toString().trimmed();
      std::optional<double> price;
      if (!text.isEmpty()) {
        bool understood = false;
        price = QLocale().toDouble(text, &understood);
        if (!understood) price = QLocale::c().toDouble(QString(text).replace(u',', u'.'), &understood);
        if (!understood || !(*price >= 0) || *price > 1e12) return false;
      }
      return changePiece(editor, QT_TRANSLATE_NOOP("idap", "Change price"), row,
                         [&](Piece& p) { p.price = price; });
    }
    case PieceColumn::Visible: {
      const bool on = value.toBool();
      const char* name = on ? QT_TRANSLATE_NOOP("idap", "Show") : QT_TRANSLATE_NOOP("idap", "Hide");
      if (group) return changeGroup(editor, name, *group, [&](Group& g) { g.visible = on; });
      return changePiece(editor, name, row, [&](Piece& p) { p.visible = on; });
    }
    case PieceColumn::Locked: {
      const bool on = value.toBool();
      return changePiece(editor, on ? QT_TRANSLATE_NOOP("idap", "Lock") : QT_TRANSLATE_NOOP("idap", "Unlock"),
                         row, [&](Piece& p) { p.locked = on; });
    }
    default:
      return false;
  }
}

}  // namespace idap
