#include "studio/lists/piece_table.h"

#include "model/diff.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr std::size_t kOneByOne = 64;  // more rows that come and go at once: all anew is quicker

GroupId groupAbove(const Home& home, RowId id) {
  if (const auto* group = std::get_if<GroupId>(&id)) {
    const Group* found = home.groups.find(*group);
    return found ? found->parent : GroupId{};
  }
  const Piece* piece = pieceOf(home, id);
  return piece ? piece->group : GroupId{};
}

template <class IdType>
void add(const std::vector<IdType>& ids, std::vector<RowId>& to) {
  to.insert(to.end(), ids.begin(), ids.end());
}

}  // namespace

PieceTable::PieceTable(Editor& editor, QObject* parent) : QAbstractItemModel(parent), editor_(editor) {
  fill();
}
PieceTable::~PieceTable() = default;

void PieceTable::fill() {
  nodes_.clear();
  root_.children.clear();
  shown_ = editor_.home();
  const auto make = [&](RowId id) {
    auto node = std::make_unique<Node>();
    node->id = id;
    nodes_.emplace(valueOf(id), std::move(node));
  };
  for (const auto& [id, group] : shown_.groups) make(id);
  for (const auto& [id, piece] : shown_.furniture) make(id);
  for (const auto& [id, opening] : shown_.openings) make(id);
  const auto hang = [&](RowId id) {
    Node* node = nodes_.at(valueOf(id)).get();
    node->parent = parentFor(shown_, id);
    node->place = static_cast<int>(node->parent->children.size());
    node->parent->children.push_back(node);
  };
  for (const auto& [id, group] : shown_.groups) hang(id);
  for (const auto& [id, piece] : shown_.furniture) hang(id);
  for (const auto& [id, opening] : shown_.openings) hang(id);
}

void PieceTable::rebuild() {
  beginResetModel();
  fill();
  endResetModel();
}

PieceTable::Node* PieceTable::parentFor(const Home& home, RowId id) {
  const GroupId group = groupAbove(home, id);
  const auto found = nodes_.find(group.value);
  return group && found != nodes_.end() ? found->second.get() : &root_;
}

void PieceTable::insert(RowId id) {
  auto made = std::make_unique<Node>();
  Node* node = made.get();
  node->id = id;
  node->parent = parentFor(shown_, id);
  node->place = static_cast<int>(node->parent->children.size());
  beginInsertRows(indexFor(node->parent, 0), node->place, node->place);
  nodes_.emplace(valueOf(id), std::move(made));
  node->parent->children.push_back(node);
  endInsertRows();
}

void PieceTable::remove(std::uint64_t id) {
  const auto found = nodes_.find(id);
  if (found == nodes_.end()) return;
  Node* node = found->second.get();
  while (!node->children.empty()) remove(valueOf(node->children.back()->id));
  std::vector<Node*>& siblings = node->parent->children;
  beginRemoveRows(indexFor(node->parent, 0), node->place, node->place);
  siblings.erase(siblings.begin() + node->place);
  for (std::size_t i = static_cast<std::size_t>(node->place); i < siblings.size(); ++i)
    siblings[i]->place = static_cast<int>(i);
  nodes_.erase(found);
  endRemoveRows();
}

void PieceTable::refresh() {
  const Home& now = editor_.home();
  const HomeDiff changes = diff(shown_, now);
  std::vector<RowId> added, removed, changed;
  add(changes.groups.added, added), add(changes.furniture.added, added), add(changes.openings.added, added);
  add(changes.openings.removed, removed), add(changes.furniture.removed, removed),
      add(changes.groups.removed, removed);
  add(changes.groups.changed, changed), add(changes.furniture.changed, changed),
      add(changes.openings.changed, changed);
  bool regrouped = !changes.groups.removed.empty() || !changes.groups.added.empty();
  for (const RowId id : changed) regrouped = regrouped || !(groupAbove(shown_, id) == groupAbove(now, id));
  if (regrouped || added.size() + removed.size() > kOneByOne) {
    rebuild();
    return;
  }
  const bool levels = !changes.levels.empty();
  for (const RowId id : removed) remove(valueOf(id));
  shown_ = now;
  for (const RowId id : added) insert(id);
  for (const RowId id : changed)
    if (const auto found = nodes_.find(valueOf(id)); found != nodes_.end())
      emit dataChanged(indexFor(found->second.get(), 0), indexFor(found->second.get(), kPieceColumns - 1));
  if (levels && !root_.children.empty())
    emit dataChanged(index(0, 0), index(rowCount() - 1, kPieceColumns - 1));
}

QModelIndex PieceTable::indexOf(std::uint64_t id) const {
  const auto found = nodes_.find(id);
  return found == nodes_.end() ? QModelIndex() : indexFor(found->second.get(), 0);
}

std::optional<RowId> PieceTable::rowAt(const QModelIndex& index) const {
  const Node* node = nodeOf(index);
  return node ? std::optional(node->id) : std::nullopt;
}

PieceTable::Totals PieceTable::totals() const {
  Totals totals;
  const auto count = [&](const Piece& piece) {
    ++totals.pieces;
    if (!piece.price) return;
    totals.price += *piece.price;
    totals.priced = true;
  };
  for (const auto& [id, piece] : shown_.furniture) count(*piece);
  for (const auto& [id, opening] : shown_.openings) count(*opening);
  return totals;
}

PieceTable::Node* PieceTable::nodeOf(const QModelIndex& index) const {
  return index.isValid() ? static_cast<Node*>(index.internalPointer()) : nullptr;
}

QModelIndex PieceTable::indexFor(const Node* node, int column) const {
  return node == &root_ ? QModelIndex() : createIndex(node->place, column, const_cast<Node*>(node));
}

QModelIndex PieceTable::index(int row, int column, const QModelIndex& parent) const {
  const Node* node = parent.isValid() ? nodeOf(parent) : &root_;
  if (row < 0 || column < 0 || column >= kPieceColumns || row >= static_cast<int>(node->children.size()))
    return {};
  return createIndex(row, column, node->children[static_cast<std::size_t>(row)]);
}

QModelIndex PieceTable::parent(const QModelIndex& index) const {
  const Node* node = nodeOf(index);
  return node ? indexFor(node->parent, 0) : QModelIndex();
}

int PieceTable::rowCount(const QModelIndex& parent) const {
  if (parent.column() > 0) return 0;
  return static_cast<int>((parent.isValid() ? nodeOf(parent) : &root_)->children.size());
}

int PieceTable::columnCount(const QModelIndex&) const { return kPieceColumns; }

QVariant PieceTable::data(const QModelIndex& index, int role) const {
  const Node* node = nodeOf(index);
  if (!node) return {};
  const auto column = static_cast<PieceColumn>(index.column());
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
    case Qt::ToolTipRole:
      if (isSwitch(column)) return {};
      return cellText(editor_, node->id, column);
    case Qt::CheckStateRole:
      if (!isSwitch(column)) return {};
      if (std::holds_alternative<GroupId>(node->id) && column != PieceColumn::Visible) return {};
      return isOn(editor_.home(), node->id, column) ? Qt::Checked : Qt::Unchecked;
    case Qt::TextAlignmentRole:
      return isNumber(column) ? int(Qt::AlignRight | Qt::AlignVCenter)
                              : int(Qt::AlignLeft | Qt::AlignVCenter);
    case SortRole:
      return sortValue(editor_, node->id, column);
    default:
      return {};
  }
}

bool PieceTable::setData(const QModelIndex& index, const QVariant& value, int role) {
  const Node* node = nodeOf(index);
  const auto column = static_cast<PieceColumn>(index.column());
  if (!node || role != (isSwitch(column) ? Qt::CheckStateRole : Qt::EditRole)) return false;
  const RowId id = node->id;
  const bool done = isSwitch(column) ? setCell(editor_, id, column, value.toInt() == Qt::Checked)
                                     : setCell(editor_, id, column, value);
  if (done) refresh();
  return done;
}

QVariant PieceTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  const auto column = static_cast<PieceColumn>(section);
  if (role == Qt::DisplayRole) return columnTitle(column);
  if (role == Qt::ToolTipRole) return columnTip(column);
  return {};
}

Qt::ItemFlags PieceTable::flags(const QModelIndex& index) const {
  const Node* node = nodeOf(index);
  if (!node) return Qt::NoItemFlags;
  Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  const auto column = static_cast<PieceColumn>(index.column());
  if (isEditable(column, node->id)) flags |= isSwitch(column) ? Qt::ItemIsUserCheckable : Qt::ItemIsEditable;
  return flags;
}

}  // namespace idap
