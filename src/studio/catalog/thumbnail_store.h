// Small traced pictures of catalog pieces: made one after another in the background at low priority, kept on
// disk.
#pragma once

#include <QObject>
#include <QPixmap>
#include <memory>

#include "catalog/catalog.h"

namespace idap {

class ThumbnailStore : public QObject {
  Q_OBJECT
 public:
  explicit ThumbnailStore(std::shared_ptr<const Catalog> catalog, QObject* parent = nullptr);
  ~ThumbnailStore() override;  // stops at once, waits for no picture

  static constexpr int kSide = 128;  // pixels

  // The picture, or null where it is not made yet: it is asked for then, the last asked first, and ready()
  // follows.
  QPixmap thumbnail(const CatalogPiecePtr& piece);

 signals:
  void ready(QString pieceId);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
