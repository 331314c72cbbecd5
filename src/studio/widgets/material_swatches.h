// Small pictures of the catalog's materials and of texture files, made in the background, each once.
#pragma once

#include <QObject>
#include <QPixmap>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "base/bytes.h"
#include "model/finish.h"

namespace idap {

class MaterialSwatches : public QObject {
  Q_OBJECT
 public:
  static MaterialSwatches& shared();  // lives as long as the application
  ~MaterialSwatches() override;

  static constexpr int kSide = 96;  // pixels

  // Null until it is made: ready() follows.
  QPixmap material(const std::string& id);
  QPixmap picture(const SharedBytes& file);

 signals:
  void ready();

 private:
  explicit MaterialSwatches(QObject* parent);
  struct Inbox;
  void take();

  std::map<std::string, QPixmap> materials_;
  std::map<const Bytes*, std::pair<SharedBytes, QPixmap>> pictures_;
  std::set<std::string> asked_;
  std::shared_ptr<Inbox> inbox_;
};

// The look of a material in a square: its texture in its colour, metals and glass hinted at.
QImage drawSwatch(const struct Material& material, int side);

}  // namespace idap
