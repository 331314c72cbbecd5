#include "studio/plan/symbol_store.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThread>
#include <algorithm>

#include "editor/symbol/piece_model.h"
#include "studio/plan/pictures.h"

namespace idap {

namespace {

constexpr std::size_t kKept = 20'000;
constexpr int kTellEvery = 60;  // ms

// Never throws: a model that cannot be read leaves its piece a box.
SymbolPtr symbolOf(const Piece& piece, Plane plane, const Assets& assets, const Catalog& catalog) {
  auto symbol = std::make_shared<Symbol>();
  try {
    if (const SurfaceModelPtr model = pieceModel(piece, assets, catalog)) {
      *symbol = makeSymbol(*model, piece, plane);
      for (SymbolSlot& slot : symbol->slots)
        if (slot.picture)
          if (const auto mean = Pictures::meanColor(*slot.picture)) {
            slot.color = {slot.color.r * mean->r, slot.color.g * mean->g, slot.color.b * mean->b};
            slot.picture.reset();
          }
    }
  } catch (const std::exception&) {
    *symbol = {};
  }
  return symbol;
}

SharedBytes assetOf(const Home& home, const Piece& piece) {
  const auto found = home.assets->find(piece.model.asset);
  return found == home.assets->end() ? nullptr : found->second;
}

}  // namespace

SymbolStore::SymbolStore() {
  pool_.setMaxThreadCount(std::clamp(QThread::idealThreadCount() - 1, 1, 4));
  pool_.setThreadPriority(QThread::LowPriority);
  tell_.setSingleShot(true);
  tell_.setInterval(kTellEvery);
  connect(&tell_, &QTimer::timeout, this, &SymbolStore::ready);
}

SymbolStore::~SymbolStore() {
  pool_.clear();
  pool_.waitForDone();
}

std::shared_ptr<SymbolStore> SymbolStore::shared() {
  static std::weak_ptr<SymbolStore> one;
  auto store = one.lock();
  if (!store) one = store = std::shared_ptr<SymbolStore>(new SymbolStore);
  return store;
}

SymbolPtr SymbolStore::get(const SymbolKey& key, const Home& home,
                           const std::shared_ptr<const Catalog>& catalog, const Piece& piece, Plane plane) {
  const auto found = entries_.find(key);
  if (found != entries_.end()) return found->second.symbol;
  if (entries_.size() > kKept)
    std::erase_if(entries_, [](const auto& e) { return e.second.symbol.use_count() == 1; });
  entries_[key] = {nullptr, assetOf(home, piece), catalog};
  ++pending_;
  const QPointer<SymbolStore> self(this);
  pool_.start([self, key, piece, plane, assets = home.assets, catalog] {
    SymbolPtr symbol = symbolOf(piece, plane, *assets, *catalog);
    QMetaObject::invokeMethod(
        qApp,
        [self, key, symbol = std::move(symbol)] {
          if (!self) return;
          --self->pending_;
          if (const auto at = self->entries_.find(key); at != self->entries_.end())
            at->second.symbol = symbol;
          if (!self->tell_.isActive()) self->tell_.start();
        },
        Qt::QueuedConnection);
  });
  return nullptr;
}

SymbolPtr SymbolStore::make(const SymbolKey& key, const Home& home,
                            const std::shared_ptr<const Catalog>& catalog, const Piece& piece, Plane plane) {
  Entry& entry = entries_[key];
  if (!entry.symbol) entry = {symbolOf(piece, plane, *home.assets, *catalog), assetOf(home, piece), catalog};
  return entry.symbol;
}

}  // namespace idap
