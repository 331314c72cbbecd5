// The columns of the furniture list: what each says of a piece, sorts by, and whether it can be edited there.
#pragma once

#include <QString>
#include <QVariant>
#include <variant>
#include <vector>

#include "editor/editor.h"

namespace idap {

// One row: a piece, a door or window, or a group.
using RowId = std::variant<FurnitureId, OpeningId, GroupId>;
std::uint64_t valueOf(RowId id);  // unique in its home

enum class PieceColumn {
  Name,
  Width,
  Depth,
  Height,
  X,
  Y,
  Elevation,
  Angle,
  Pitch,
  Roll,
  Level,
  Kind,
  Category,
  Price,
  Visible,
  Locked,
  Mirrored,
  Light,
  Creator,
  Licence,
  CatalogPieceId,
  Description,
  Count_
};
inline constexpr int kPieceColumns = static_cast<int>(PieceColumn::Count_);

QString columnTitle(PieceColumn column);
QString columnTip(PieceColumn column);
bool shownAtFirst(PieceColumn column);
bool isNumber(PieceColumn column);  // stands at the right
bool isSwitch(PieceColumn column);  // a box to tick
bool isEditable(PieceColumn column, RowId row);

// The home's element of a row; null when it is gone. Groups have no piece.
const Piece* pieceOf(const Home& home, RowId row);

QString cellText(const Editor& editor, RowId row, PieceColumn column);
QVariant sortValue(const Editor& editor, RowId row, PieceColumn column);  // a number or folded text
bool isOn(const Home& home, RowId row, PieceColumn column);               // of a switch
// As tables in files want it: numbers without unit and with a point.
QString exportText(const Editor& editor, RowId row, PieceColumn column);
QString exportTitle(const Editor& editor, PieceColumn column);  // with the unit of its numbers

// One undo step. False, and nothing done, for what cannot be understood.
bool setCell(Editor& editor, RowId row, PieceColumn column, const QVariant& value);

}  // namespace idap
