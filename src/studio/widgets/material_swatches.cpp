#include "studio/widgets/material_swatches.h"

#include <QBuffer>
#include <QImageReader>
#include <QThreadPool>
#include <cmath>
#include <mutex>

#include "catalog/material.h"
#include "studio/widgets/color_button.h"

namespace idap {

namespace {

QImage readPicture(const Bytes& bytes, int side) {
  QByteArray data = QByteArray::fromRawData(reinterpret_cast<const char*>(bytes.data()),
                                            static_cast<qsizetype>(bytes.size()));
  QBuffer buffer(&data);
  QImageReader reader(&buffer);
  reader.setAutoTransform(true);
  const QSize size = reader.size();
  if (size.isValid()) reader.setScaledSize(size.scaled(side, side, Qt::KeepAspectRatioByExpanding));
  const QImage image = reader.read();
  if (image.isNull()) return image;
  const QImage fitted = image.scaled(side, side, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
  return fitted.copy((fitted.width() - side) / 2, (fitted.height() - side) / 2, side, side);
}

QImage unreadable(int side) {
  QImage image(side, side, QImage::Format_RGB32);
  image.fill(Qt::gray);
  return image;
}

}  // namespace

QImage drawSwatch(const Material& material, int side) {
  QImage image(side, side, QImage::Format_RGB32);
  const QColor colour = toQt(material.color);
  image.fill(colour);
  QPainter painter(&image);
  const QRect all(0, 0, side, side);
  if (material.texture && material.texture->bytes) {
    const QImage texture = readPicture(*material.texture->bytes, side);
    if (!texture.isNull()) {
      painter.drawImage(all, texture);
      painter.setCompositionMode(QPainter::CompositionMode_Multiply);
      painter.fillRect(all, colour);
      painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
    }
  }
  if (material.transmission > 0.3) {
    // Something to see through it.
    painter.setOpacity(0.35);
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x)
        painter.fillRect(x * side / 4, y * side / 4, side / 4, side / 4,
                         (x + y) % 2 ? QColor(90, 100, 105) : QColor(235, 240, 242));
    painter.setOpacity(1);
  }
  if (material.metalness > 0.5) {
    QLinearGradient shine(0, 0, side, side);
    shine.setColorAt(0, QColor(0, 0, 0, 70));
    shine.setColorAt(0.35, QColor(255, 255, 255, 130));
    shine.setColorAt(0.55, QColor(0, 0, 0, 40));
    shine.setColorAt(1, QColor(255, 255, 255, 60));
    painter.fillRect(all, shine);
  } else if (material.roughness < 0.35) {
    QLinearGradient shine(0, 0, side, side);
    shine.setColorAt(0, QColor(255, 255, 255, 110));
    shine.setColorAt(0.45, QColor(255, 255, 255, 0));
    painter.fillRect(all, shine);
  }
  return image;
}

// What the workers have made; outlives the application's object while one of them is still at it.
struct MaterialSwatches::Inbox {
  std::mutex mutex;
  MaterialSwatches* owner = nullptr;
  std::vector<std::pair<std::string, QImage>> materials;
  std::vector<std::pair<const Bytes*, QImage>> pictures;

  void call() {  // with the mutex held
    if (owner) QMetaObject::invokeMethod(owner, &MaterialSwatches::take, Qt::QueuedConnection);
  }
};

MaterialSwatches::MaterialSwatches(QObject* parent) : QObject(parent), inbox_(std::make_shared<Inbox>()) {
  inbox_->owner = this;
}

MaterialSwatches::~MaterialSwatches() {
  const std::lock_guard lock(inbox_->mutex);
  inbox_->owner = nullptr;
}

MaterialSwatches& MaterialSwatches::shared() {
  if (auto* found = qApp->findChild<MaterialSwatches*>(QString(), Qt::FindDirectChildrenOnly)) return *found;
  return *new MaterialSwatches(qApp);
}

QPixmap MaterialSwatches::material(const std::string& id) {
  if (const auto found = materials_.find(id); found != materials_.end()) return found->second;
  if (asked_.insert(id).second)
    QThreadPool::globalInstance()->start([inbox = inbox_, id] {
      const Material* made = findMaterial(id);
      QImage image = made ? drawSwatch(*made, kSide) : unreadable(kSide);
      const std::lock_guard lock(inbox->mutex);
      inbox->materials.emplace_back(id, std::move(image));
      inbox->call();
    });
  return {};
}

QPixmap MaterialSwatches::picture(const SharedBytes& file) {
  if (!file) return {};
  const auto [at, added] = pictures_.try_emplace(file.get(), file, QPixmap());
  if (added)
    QThreadPool::globalInstance()->start([inbox = inbox_, file] {
      QImage image = readPicture(*file, kSide);
      if (image.isNull()) image = unreadable(kSide);
      const std::lock_guard lock(inbox->mutex);
      inbox->pictures.emplace_back(file.get(), std::move(image));
      inbox->call();
    });
  return at->second.second;
}

void MaterialSwatches::take() {
  std::vector<std::pair<std::string, QImage>> materials;
  std::vector<std::pair<const Bytes*, QImage>> pictures;
  {
    const std::lock_guard lock(inbox_->mutex);
    materials.swap(inbox_->materials);
    pictures.swap(inbox_->pictures);
  }
  if (materials.empty() && pictures.empty()) return;  // an earlier call took them all
  for (const auto& [id, image] : materials) materials_[id] = QPixmap::fromImage(image);
  for (const auto& [file, image] : pictures)
    if (const auto at = pictures_.find(file); at != pictures_.end())
      at->second.second = QPixmap::fromImage(image);
  emit ready();
}

}  // namespace idap
