// The furniture list's rows as a tree, groups with what is in them; kept in step with the home by what
// changed, not more often than a few times a second.
#pragma once

#include <QAbstractItemModel>
#include <memory>
#include <unordered_map>

#include "studio/lists/piece_columns.h"

namespace idap {

class PieceTable : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Role { SortRole = Qt::UserRole, RowRole };

  explicit PieceTable(Editor& editor, QObject* parent = nullptr);
  ~PieceTable() override;

  void refresh();  // what has changed since the last time
  void rebuild();  // everything: another home, another language or unit
  QModelIndex indexOf(std::uint64_t id) const;
  std::optional<RowId> rowAt(const QModelIndex& index) const;

  struct Totals {
    std::size_t pieces = 0;  // groups not counted
    double price = 0;
    bool priced = false;  // some piece has a price
  };
  Totals totals() const;

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& index) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 private:
  struct Node {
    RowId id;
    Node* parent = nullptr;
    std::vector<Node*> children;
    int place = 0;  // among its parent's children
  };
  Node* nodeOf(const QModelIndex& index) const;
  QModelIndex indexFor(const Node* node, int column) const;
  Node* parentFor(const Home& home, RowId id);
  void insert(RowId id);
  void remove(std::uint64_t id);
  void fill();

  Editor& editor_;
  Home shown_;  // what the rows are of
  Node root_;
  std::unordered_map<std::uint64_t, std::unique_ptr<Node>> nodes_;
};

}  // namespace idap
