#include "studio/catalog/catalog_model.h"

#include "studio/catalog/piece_tags.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

bool fits(Vec3 size, Vec3 most) {
  constexpr double kTolerance = 0.0005;  // what is shown as 60 cm passes for 60 cm
  // Furniture can stand either way round.
  const auto within = [&](double x, double y) {
    return (most.x <= 0 || x <= most.x + kTolerance) && (most.y <= 0 || y <= most.y + kTolerance);
  };
  return within(size.x, size.y) && (most.z <= 0 || size.z <= most.z + kTolerance);
}

}  // namespace

CatalogModel::Contents CatalogModel::contentsOf(const Catalog& catalog, bool libraries) {
  Contents contents;
  contents.complete = libraries;
  contents.pieces = libraries ? catalog.pieces() : catalog.builtinPieces();
  contents.fields.reserve(contents.pieces.size());
  for (const CatalogPiecePtr& piece : contents.pieces) contents.fields.push_back(searchFields(*piece));
  if (libraries) {
    contents.categories = catalog.categories();
  } else {
    contents.categories = Catalog(std::vector<std::filesystem::path>{}).categories();
  }
  return contents;
}

void CatalogModel::setContents(Contents contents) {
  contents_ = std::move(contents);
  filter();
}

void CatalogModel::setQuery(PieceQuery query) {
  if (query == query_) return;
  query_ = std::move(query);
  filter();
}

void CatalogModel::setLanguage(std::string language) {
  if (language == language_) return;
  language_ = std::move(language);
  if (!shown_.empty()) emit dataChanged(index(0), index(rowCount() - 1));
  emit filtered();
}

void CatalogModel::setLiked(std::set<std::string> ids) {
  if (ids == liked_) return;
  liked_ = std::move(ids);
  if (!shown_.empty()) emit dataChanged(index(0), index(rowCount() - 1), {LikedRole});
}

void CatalogModel::filter() {
  const std::vector<std::string> words = searchWords(query_.words);
  std::vector<std::pair<int, CatalogPiecePtr>> found;
  counts_.clear();
  passing_ = 0;
  std::map<std::string, std::size_t> places;
  if (query_.only)
    for (std::size_t i = 0; i < query_.only->size(); ++i) places.emplace((*query_.only)[i], i);
  for (std::size_t i = 0; i < contents_.pieces.size(); ++i) {
    const CatalogPiecePtr& piece = contents_.pieces[i];
    if (!fits(piece->size, query_.maxSize)) continue;
    int score = words.empty() ? 1 : searchScore(contents_.fields[i], words);
    if (score == 0) continue;
    const bool tagged = std::all_of(query_.tags.begin(), query_.tags.end(),
                                    [&](const std::string& tag) { return hasTag(*piece, tag); });
    if (tagged) ++counts_[piece->category], ++passing_;
    if (query_.only) {
      const auto place = places.find(piece->id);
      if (place == places.end()) continue;
      score = static_cast<int>(places.size() - place->second);
    } else if (!query_.category.empty() && piece->category != query_.category) {
      continue;
    }
    found.emplace_back(score, piece);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  beginResetModel();
  shown_.clear();
  beforeTags_.clear();
  for (auto& [score, piece] : found) {
    beforeTags_.push_back(piece);
    if (std::all_of(query_.tags.begin(), query_.tags.end(),
                    [&](const std::string& tag) { return hasTag(*piece, tag); }))
      shown_.push_back(piece);
  }
  endResetModel();
  emit filtered();
}

CatalogPiecePtr CatalogModel::piece(const QModelIndex& index) const {
  return index.isValid() && index.row() < rowCount() ? shown_[static_cast<std::size_t>(index.row())]
                                                     : nullptr;
}

CatalogPiecePtr CatalogModel::find(const std::string& id) const {
  const auto found = std::find_if(contents_.pieces.begin(), contents_.pieces.end(),
                                  [&](const CatalogPiecePtr& piece) { return piece->id == id; });
  return found == contents_.pieces.end() ? nullptr : *found;
}

QModelIndex CatalogModel::indexOf(const std::string& id) const {
  const auto found = std::find_if(shown_.begin(), shown_.end(),
                                  [&](const CatalogPiecePtr& piece) { return piece->id == id; });
  return found == shown_.end() ? QModelIndex() : index(static_cast<int>(found - shown_.begin()));
}

std::vector<CatalogModel::CategoryCount> CatalogModel::categories() const {
  // A category is named by its pieces, which know it in every language.
  std::map<std::string, const CatalogPiece*> samples;
  for (const CatalogPiecePtr& piece : contents_.pieces) samples.emplace(piece->category, piece.get());
  std::vector<CategoryCount> all;
  for (const Catalog::Category& category : contents_.categories) {
    CategoryCount entry{category.id, toQt(category.name), 0, true};
    if (const auto sample = samples.find(category.id); sample != samples.end()) {
      entry.builtin = sample->second->library.empty();
      const auto texts = sample->second->translations.find(language_);
      if (texts != sample->second->translations.end())
        if (const auto name = texts->second.find("category"); name != texts->second.end())
          entry.name = toQt(name->second);
    }
    if (const auto count = counts_.find(category.id); count != counts_.end()) entry.count = count->second;
    all.push_back(std::move(entry));
  }
  return all;
}

int CatalogModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(shown_.size());
}

QVariant CatalogModel::data(const QModelIndex& index, int role) const {
  const CatalogPiecePtr piece = this->piece(index);
  if (!piece) return {};
  switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole:
      return toQt(piece->nameIn(language_));
    case PieceRole:
      return QVariant::fromValue(piece);
    case LikedRole:
      return liked_.contains(piece->id);
    default:
      return {};
  }
}

Qt::ItemFlags CatalogModel::flags(const QModelIndex& index) const {
  return index.isValid() ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled : Qt::NoItemFlags;
}

}  // namespace idap
