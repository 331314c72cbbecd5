#include "catalog/library/library.h"

#include <mutex>
#include <unordered_map>

#include "base/error.h"
#include "base/file.h"
#include "base/zip.h"
#include "catalog/library/library_cache.h"
#include "catalog/library/library_index.h"
#include "catalog/model_file.h"

namespace idap {

namespace {

// Shares what is alive under a key; what nobody holds any more is made anew.
template <class T>
class SharedByName {
 public:
  std::shared_ptr<const T> find(const std::string& name) const {
    const auto found = values_.find(name);
    return found == values_.end() ? nullptr : found->second.lock();
  }
  void set(const std::string& name, const std::shared_ptr<const T>& value) { values_[name] = value; }

 private:
  std::unordered_map<std::string, std::weak_ptr<const T>> values_;
};

// Where a lamp's bulbs sit in its unit box.
std::vector<Vec3> lightPositions(const CatalogPiece& piece) {
  std::vector<Vec3> positions;
  if (piece.lamp)
    for (const LightSource& source : piece.lamp->sources)
      positions.push_back({source.position.x - 0.5, source.position.y - 0.5, source.position.z});
  return positions;
}

}  // namespace

struct FurnitureLibrary::Impl {
  std::filesystem::path file;
  LibraryIndex about;  // its entries have moved to the members below
  bool fromCache = false;
  std::vector<CatalogPiecePtr> pieces;
  struct Place {
    std::size_t piece;
    std::string model, icon;
  };
  std::unordered_map<std::string, Place> places;  // by the piece's id

  mutable std::mutex mutex;
  mutable std::shared_ptr<const ZipReader> archive;  // opened when first needed
  mutable SharedByName<Bytes> files;
  mutable SharedByName<SurfaceModel> models;

  std::shared_ptr<const ZipReader> opened() const {
    const std::lock_guard lock(mutex);
    if (!archive) archive = std::make_shared<const ZipReader>(file);
    return archive;
  }

  // Null when the archive has no such entry. Equal entries are one block of bytes while anybody holds it.
  SharedBytes read(const std::string& entry) const {
    const auto zip = opened();
    if (!zip->contains(entry)) return nullptr;
    {
      const std::lock_guard lock(mutex);
      if (SharedBytes known = files.find(entry)) return known;
    }
    SharedBytes bytes = std::make_shared<const Bytes>(zip->read(entry));
    const std::lock_guard lock(mutex);
    if (SharedBytes known = files.find(entry)) return known;
    files.set(entry, bytes);
    return bytes;
  }
};

std::filesystem::path FurnitureLibrary::defaultCacheFolder() { return userCacheFolder() / "libraries"; }

std::shared_ptr<FurnitureLibrary> FurnitureLibrary::open(const std::filesystem::path& file,
                                                         const std::filesystem::path& cacheFolder) {
  auto impl = std::make_unique<Impl>();
  impl->file = file;
  const LibraryStamp stamp = stampOf(file);
  auto index = loadLibraryIndex(cacheFolder, stamp);
  impl->fromCache = index.has_value();
  if (!index) {
    impl->archive = std::make_shared<const ZipReader>(file);
    index = readLibraryIndex(*impl->archive, file.filename().string());
    storeLibraryIndex(cacheFolder, stamp, *index);
  }
  std::vector<LibraryIndex::Entry> entries = std::move(index->entries);
  impl->about = std::move(*index);
  impl->pieces.reserve(entries.size());
  for (LibraryIndex::Entry& entry : entries) {
    const auto [place, isNew] = impl->places.try_emplace(
        entry.piece.id, Impl::Place{impl->pieces.size(), std::move(entry.model), std::move(entry.icon)});
    if (isNew) impl->pieces.push_back(std::make_shared<const CatalogPiece>(std::move(entry.piece)));
  }
  return std::shared_ptr<FurnitureLibrary>(new FurnitureLibrary(std::move(impl)));
}

FurnitureLibrary::FurnitureLibrary(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
FurnitureLibrary::~FurnitureLibrary() = default;

const std::filesystem::path& FurnitureLibrary::file() const { return impl_->file; }
const std::string& FurnitureLibrary::name() const { return impl_->about.name; }
const std::string& FurnitureLibrary::description() const { return impl_->about.description; }
const std::string& FurnitureLibrary::license() const { return impl_->about.license; }
bool FurnitureLibrary::cameFromCache() const { return impl_->fromCache; }
const std::vector<CatalogPiecePtr>& FurnitureLibrary::pieces() const { return impl_->pieces; }

CatalogPiecePtr FurnitureLibrary::find(const std::string& id) const {
  const auto found = impl_->places.find(id);
  return found == impl_->places.end() ? nullptr : impl_->pieces[found->second.piece];
}

SurfaceModelPtr FurnitureLibrary::model(const CatalogPiece& piece) const {
  const auto found = impl_->places.find(piece.id);
  if (found == impl_->places.end()) return nullptr;
  {
    const std::lock_guard lock(impl_->mutex);
    if (SurfaceModelPtr known = impl_->models.find(piece.id)) return known;
  }
  const std::string& entry = found->second.model;
  const SharedBytes bytes = impl_->read(entry);
  if (!bytes) throw ParseError(impl_->file.string(), entry, "the model of " + piece.id + " is missing");
  const std::string folder = entry.substr(0, entry.rfind('/') + 1);
  const auto beside = [&](const std::string& path) { return impl_->read(folder + path); };
  const CatalogPiece& own = *impl_->pieces[found->second.piece];
  auto model = std::make_shared<SurfaceModel>(
      readModelFile(*bytes, impl_->file.string() + ": " + entry, beside, {.rotation = own.modelRotation}));
  model->lightPositions = lightPositions(own);
  const std::lock_guard lock(impl_->mutex);
  if (SurfaceModelPtr known = impl_->models.find(piece.id)) return known;
  impl_->models.set(piece.id, model);
  return model;
}

SharedBytes FurnitureLibrary::icon(const CatalogPiece& piece) const {
  const auto found = impl_->places.find(piece.id);
  return found == impl_->places.end() || found->second.icon.empty() ? nullptr
                                                                    : impl_->read(found->second.icon);
}

}  // namespace idap
