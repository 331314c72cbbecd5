// The pieces of the catalog that pass what the user asks for, in order; and how many each category has.
#pragma once

#include <QAbstractListModel>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "catalog/search_text.h"

namespace idap {

struct PieceQuery {
  std::string words;     // as typed
  std::string category;  // empty: all
  Vec3 maxSize;          // m; 0: any
  std::set<std::string> tags;
  // Only these pieces, in this order, whatever their category (favourites).
  std::optional<std::vector<std::string>> only;
  friend bool operator==(const PieceQuery&, const PieceQuery&) = default;
};

class CatalogModel : public QAbstractListModel {
  Q_OBJECT
 public:
  enum Role { PieceRole = Qt::UserRole, LikedRole };
  using QAbstractListModel::QAbstractListModel;

  // Everything there is, with what searching needs, which is made on another thread.
  struct Contents {
    std::vector<CatalogPiecePtr> pieces;
    std::vector<SearchFields> fields;
    std::vector<Catalog::Category> categories;
    bool complete = false;  // libraries too
  };
  static Contents contentsOf(const Catalog& catalog, bool libraries);

  void setContents(Contents contents);
  void setQuery(PieceQuery query);
  void setLanguage(std::string language);
  void setLiked(std::set<std::string> ids);

  const PieceQuery& query() const { return query_; }
  bool complete() const { return contents_.complete; }
  CatalogPiecePtr piece(const QModelIndex& index) const;
  CatalogPiecePtr find(const std::string& id) const;
  QModelIndex indexOf(const std::string& id) const;
  // What a chip may narrow down: the pieces shown, before tags are asked for.
  const std::vector<CatalogPiecePtr>& beforeTags() const { return beforeTags_; }

  struct CategoryCount {
    std::string id;
    QString name;           // in the user's language
    std::size_t count = 0;  // of pieces that pass all but the category
    bool builtin = true;
  };
  std::vector<CategoryCount> categories() const;
  std::size_t passing() const { return passing_; }  // of all categories

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 signals:
  void filtered();

 private:
  void filter();

  Contents contents_;
  PieceQuery query_;
  std::string language_ = "en";
  std::set<std::string> liked_;
  std::vector<CatalogPiecePtr> shown_, beforeTags_;
  std::map<std::string, std::size_t> counts_;
  std::size_t passing_ = 0;
};

}  // namespace idap

Q_DECLARE_METATYPE(idap::CatalogPiecePtr)
