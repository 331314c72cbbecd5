// The categories of the catalog with how many pieces each has; all pieces, favourites and recent ones first.
#pragma once

#include <QListWidget>

#include "studio/catalog/catalog_model.h"

namespace idap {

class CategoryList : public QListWidget {
  Q_OBJECT
 public:
  explicit CategoryList(QWidget* parent = nullptr);

  struct Counts {
    std::size_t all = 0, liked = 0, recent = 0;
    std::vector<CatalogModel::CategoryCount> categories;
  };
  // Keeps what is chosen; where that is gone, all pieces are.
  void show(const Counts& counts);

  static constexpr const char* kAll = "";
  static constexpr const char* kLiked = "*liked";
  static constexpr const char* kRecent = "*recent";
  std::string chosen() const;  // a category, or one of these
  void choose(const std::string& id);

 signals:
  void chosenChanged();
};

}  // namespace idap
