// The pictures kept with the home, as thumbnails; made from their files in the background.
#pragma once

#include <QListWidget>
#include <memory>

#include "editor/editor.h"

namespace idap {

class GalleryList : public QListWidget {
  Q_OBJECT
 public:
  explicit GalleryList(Editor& editor, QWidget* parent = nullptr);
  ~GalleryList() override;

  PictureId current() const;  // PictureId{}: none
  void setCurrent(PictureId picture);
  static QString nameOf(const Picture& picture);
  static QString describe(const Picture& picture);  // size, samples, when: a few lines

 signals:
  void chosen(idap::PictureId picture);
  void renamed(idap::PictureId picture, const QString& name);

 private:
  void refill();
  void makeThumbnails();

  Editor& editor_;
  int subscription_ = 0;
  std::map<SharedBytes, QPixmap> thumbnails_;  // by file; null: being made
};

}  // namespace idap
