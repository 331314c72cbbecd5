// Symbols of pieces, made in the background and kept. One for all views of the program; belongs to the GUI
// thread.
#pragma once

#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <memory>
#include <unordered_map>

#include "catalog/catalog.h"
#include "editor/symbol/symbol.h"
#include "model/home.h"

namespace idap {

class SymbolStore : public QObject {
  Q_OBJECT
 public:
  static std::shared_ptr<SymbolStore> shared();
  ~SymbolStore() override;

  // The symbol, or null when it has still to be made: then it is asked for, and ready() tells when it has
  // come. Pieces whose model cannot be had get an empty symbol: they stay a box.
  SymbolPtr get(const SymbolKey& key, const Home& home, const std::shared_ptr<const Catalog>& catalog,
                const Piece& piece, Plane plane);
  // At once, in this thread.
  SymbolPtr make(const SymbolKey& key, const Home& home, const std::shared_ptr<const Catalog>& catalog,
                 const Piece& piece, Plane plane);
  bool idle() const { return pending_ == 0; }

 signals:
  void ready();  // some have come; told at most every few frames

 private:
  SymbolStore();
  struct Entry {
    SymbolPtr symbol;  // null while it is being made
    SharedBytes asset;
    std::shared_ptr<const Catalog> catalog;  // both held, for the key goes by their address
  };
  std::unordered_map<SymbolKey, Entry> entries_;
  std::size_t pending_ = 0;
  QTimer tell_;
  QThreadPool pool_;
};

}  // namespace idap
