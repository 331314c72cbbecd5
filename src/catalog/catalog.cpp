#include "catalog/catalog.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <list>
#include <mutex>
#include <set>
#include <unordered_map>

#include "base/error.h"
#include "catalog/library/library.h"
#include "catalog/parametric/builtin.h"
#include "catalog/search_text.h"

namespace idap {
namespace {

// Models kept alive though nobody uses them at the moment: dragging a size back and forth builds nothing
// anew.
constexpr std::size_t kModelsKept = 96;

std::string modelKey(const std::string& id, Vec3 size, const std::map<std::string, double>& parameters) {
  std::string key = id;
  const auto put = [&key](double v) { key += '|' + std::to_string(std::llround(v * 1e5)); };
  for (int i = 0; i < 3; ++i) put(std::isfinite(size[i]) ? std::clamp(size[i], 0.0, 1e6) : 0.0);
  for (const auto& [name, value] : parameters) {
    key += '|' + name;
    put(std::isfinite(value) ? std::clamp(value, -1e9, 1e9) : 0.0);
  }
  return key;
}

class ModelCache {
 public:
  SurfaceModelPtr find(const std::string& key) {
    const std::lock_guard lock(mutex_);
    return findLocked(key);
  }
  // Returns the model that another thread may have put there first.
  SurfaceModelPtr put(const std::string& key, SurfaceModelPtr model) {
    const std::lock_guard lock(mutex_);
    if (auto other = findLocked(key)) return other;
    if (known_.size() > 64 * kModelsKept)
      std::erase_if(known_, [](const auto& e) { return e.second.expired(); });
    known_[key] = model;
    keep(model);
    return model;
  }

 private:
  SurfaceModelPtr findLocked(const std::string& key) {
    const auto it = known_.find(key);
    if (it == known_.end()) return nullptr;
    SurfaceModelPtr model = it->second.lock();
    if (model) keep(model);
    return model;
  }
  void keep(const SurfaceModelPtr& model) {
    const auto it = std::find(recent_.begin(), recent_.end(), model);
    if (it != recent_.end()) {
      recent_.splice(recent_.begin(), recent_, it);
    } else {
      recent_.push_front(model);
      if (recent_.size() > kModelsKept) recent_.pop_back();
    }
  }

  std::mutex mutex_;
  std::unordered_map<std::string, std::weak_ptr<const SurfaceModel>> known_;
  std::list<SurfaceModelPtr> recent_;  // latest first
};

}  // namespace

std::string CatalogPiece::nameIn(std::string_view language) const {
  const auto texts = translations.find(std::string(language));
  if (texts != translations.end())
    if (const auto it = texts->second.find("name"); it != texts->second.end()) return it->second;
  // "pt_BR" is served by "pt".
  if (const auto end = language.find_first_of("_-"); end != std::string_view::npos)
    return nameIn(language.substr(0, end));
  return name;
}

struct Catalog::Impl {
  struct Libraries {
    std::vector<std::shared_ptr<FurnitureLibrary>> all;
    std::vector<CatalogPiecePtr> pieces;
    std::unordered_map<std::string, std::pair<CatalogPiecePtr, const FurnitureLibrary*>> byId;
    std::vector<std::string> problems;
  };

  using LibrariesPtr = std::shared_ptr<const Libraries>;

  std::vector<std::filesystem::path> folders;
  std::mutex opening;           // held while files are read
  mutable std::mutex swapping;  // of opened
  LibrariesPtr opened;          // null: not read yet
  ModelCache models;

  LibrariesPtr known() const {
    const std::lock_guard lock(swapping);
    return opened;
  }
  LibrariesPtr libraries() {
    if (LibrariesPtr now = known()) return now;
    const std::lock_guard lock(opening);
    if (LibrariesPtr now = known()) return now;
    return read();
  }
  void reread() {
    const std::lock_guard lock(opening);
    read();
  }

 private:
  LibrariesPtr read() {
    auto fresh = std::make_shared<Libraries>();
    open(*fresh);
    const std::lock_guard lock(swapping);
    opened = fresh;
    return fresh;
  }

  void open(Libraries& into) const {
    std::vector<std::filesystem::path> files;
    for (const auto& folder : folders) {
      std::error_code none;
      std::vector<std::filesystem::path> here;
      for (const auto& entry : std::filesystem::directory_iterator(folder, none))
        if (entry.path().extension() == ".sh3f") here.push_back(entry.path());
      std::sort(here.begin(), here.end());
      files.insert(files.end(), here.begin(), here.end());
    }
    for (const auto& file : files) {
      try {
        into.all.push_back(FurnitureLibrary::open(file));
      } catch (const Error& e) {
        into.problems.push_back(e.what());
      }
    }
    // A later library's piece takes the place of an earlier one's with the same id.
    for (const auto& library : into.all)
      for (const CatalogPiecePtr& piece : library->pieces()) into.byId[piece->id] = {piece, library.get()};
    for (const auto& library : into.all)
      for (const CatalogPiecePtr& piece : library->pieces())
        if (into.byId.at(piece->id).first == piece) into.pieces.push_back(piece);
  }
};

Catalog::Catalog(std::vector<std::filesystem::path> libraryFolders) : impl_(std::make_unique<Impl>()) {
  impl_->folders = std::move(libraryFolders);
}
Catalog::~Catalog() = default;

std::vector<std::filesystem::path> Catalog::defaultLibraryFolders() {
  std::vector<std::filesystem::path> folders{"/usr/share/sweethome3d/furniture"};
  if (const char* data = std::getenv("XDG_DATA_HOME"); data && *data) {
    folders.push_back(std::filesystem::path(data) / "idap/furniture");
  } else if (const char* home = std::getenv("HOME"); home && *home) {
    folders.push_back(std::filesystem::path(home) / ".local/share/idap/furniture");
  }
  if (const char* more = std::getenv("IDAP_FURNITURE")) {
    std::string_view rest = more;
    while (!rest.empty()) {
      const auto end = std::min(rest.find(':'), rest.size());
      if (end > 0) folders.emplace_back(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  return folders;
}

std::vector<Catalog::Category> Catalog::categories() const {
  std::vector<Category> all = parametric::builtinCatalog().categories;
  std::map<std::string, std::size_t> index;
  for (std::size_t i = 0; i < all.size(); ++i) index[all[i].id] = i;
  const auto libraries = impl_->libraries();
  for (const CatalogPiecePtr& piece : libraries->pieces) {
    const auto [it, isNew] = index.emplace(piece->category, all.size());
    if (isNew) all.push_back({piece->category, piece->category, 0});
    ++all[it->second].pieces;
  }
  return all;
}

std::vector<CatalogPiecePtr> Catalog::builtinPieces() const {
  std::vector<CatalogPiecePtr> all;
  for (const auto& built : parametric::builtinCatalog().pieces) all.push_back(built.piece);
  return all;
}

std::vector<CatalogPiecePtr> Catalog::pieces() const {
  std::vector<CatalogPiecePtr> all = builtinPieces();
  const auto libraries = impl_->libraries();
  all.insert(all.end(), libraries->pieces.begin(), libraries->pieces.end());
  return all;
}

bool Catalog::librariesRead() const { return impl_->known() != nullptr; }
void Catalog::reread() const { impl_->reread(); }

CatalogPiecePtr Catalog::find(const std::string& id) const {
  if (const auto* built = parametric::builtinCatalog().find(id)) return built->piece;
  if (id.empty() || id.starts_with("idap/")) return nullptr;
  const auto libraries = impl_->libraries();
  const auto it = libraries->byId.find(id);
  return it == libraries->byId.end() ? nullptr : it->second.first;
}

std::vector<CatalogPiecePtr> Catalog::search(std::string_view query) const {
  const std::vector<std::string> words = searchWords(query);
  std::vector<CatalogPiecePtr> all = pieces();
  if (words.empty()) return all;
  std::vector<std::pair<int, CatalogPiecePtr>> found;
  for (const CatalogPiecePtr& piece : all)
    if (const int score = searchScore(*piece, words); score > 0) found.emplace_back(score, piece);
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<CatalogPiecePtr> result;
  for (auto& entry : found) result.push_back(std::move(entry.second));
  return result;
}

std::vector<std::string> Catalog::problems() const { return impl_->libraries()->problems; }

SurfaceModelPtr Catalog::model(const std::string& id, Vec3 size,
                               const std::map<std::string, double>& parameters) const {
  if (const auto* built = parametric::builtinCatalog().find(id)) {
    const std::string key = modelKey(id, size, parameters);
    if (auto model = impl_->models.find(key)) return model;
    return impl_->models.put(key, std::make_shared<const SurfaceModel>(buildModel(*built, size, parameters)));
  }
  if (id.empty() || id.starts_with("idap/")) return nullptr;
  const auto libraries = impl_->libraries();
  const auto it = libraries->byId.find(id);
  return it == libraries->byId.end() ? nullptr : it->second.second->model(*it->second.first);
}

}  // namespace idap
