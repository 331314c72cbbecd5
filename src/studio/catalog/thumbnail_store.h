// Small traced pictures of catalog pieces: made one after another in the background at low priority, kept on
// disk.
#pragma once

#include <QObject>
#include <QPixmap>
#include <filesystem>
#include <memory>

#include "base/file.h"
#include "catalog/catalog.h"

namespace idap {

class ThumbnailStore : public QObject {
  Q_OBJECT
 public:
  explicit ThumbnailStore(std::shared_ptr<const Catalog> catalog, QObject* parent = nullptr,
                          std::filesystem::path folder = userCacheFolder() / "thumbnails");
  ~ThumbnailStore() override;  // stops at once, waits for no picture

  static constexpr int kSide = 128;       // pixels
  static constexpr int kLargeSide = 320;  // of a closer look

  // The picture, or null where it is not made yet: it is asked for then, the last asked first, and ready()
  // follows. Those asked for so long ago that they must have scrolled away are forgotten.
  QPixmap thumbnail(const CatalogPiecePtr& piece);
  QPixmap large(const CatalogPiecePtr& piece);

  // How long after the first picture was asked for tracing begins: start-up goes first.
  void setDelay(int milliseconds);

 signals:
  void ready(QString pieceId);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
