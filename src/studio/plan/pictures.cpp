#include "studio/plan/pictures.h"

#include <QCoreApplication>
#include <QPointer>

#include "catalog/material.h"

namespace idap {

namespace {

constexpr int kLargest = 4096;  // pixels a side of a decoded scan: more than a screen shows

QImage decoded(const Bytes& bytes, int largest) {
  QImage image = QImage::fromData(reinterpret_cast<const uchar*>(bytes.data()), int(bytes.size()));
  const int width = image.width();
  if (width > largest || image.height() > largest)
    image = image.scaled(largest, largest, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  if (!image.isNull()) image.setText(QStringLiteral("width"), QString::number(width));
  return image;
}

Color multiplied(const Color& a, const Color& b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }

// Reading the material, its picture may have to be made first.
std::optional<Color> materialColor(const std::string& id) {
  const Material* material = findMaterial(id);
  if (!material) return std::nullopt;
  if (!material->texture || !material->texture->bytes) return material->color;
  const auto mean = Pictures::meanColor(*material->texture->bytes);
  return mean ? multiplied(material->color, *mean) : material->color;
}

}  // namespace

struct Pictures::Entry {
  SharedBytes bytes;  // held, so that no other picture takes their place in memory
  bool askedWhole = false, askedMean = false;
  QImage image;
  std::optional<Color> mean;
};

Pictures::Pictures() { pool_.setMaxThreadCount(1); }
Pictures::~Pictures() {
  pool_.clear();
  pool_.waitForDone();
}

std::shared_ptr<Pictures> Pictures::shared() {
  static std::weak_ptr<Pictures> one;
  auto pictures = one.lock();
  if (!pictures) one = pictures = std::shared_ptr<Pictures>(new Pictures);
  return pictures;
}

std::optional<Color> Pictures::meanColor(const Bytes& bytes) {
  const QImage image = decoded(bytes, 256).convertToFormat(QImage::Format_RGB32);
  if (image.isNull()) return std::nullopt;
  double sum[3]{};
  for (int y = 0; y < image.height(); ++y) {
    const auto* row = reinterpret_cast<const QRgb*>(image.constScanLine(y));
    for (int x = 0; x < image.width(); ++x)
      sum[0] += qRed(row[x]), sum[1] += qGreen(row[x]), sum[2] += qBlue(row[x]);
  }
  const double n = 255.0 * image.width() * image.height();
  return Color{float(sum[0] / n), float(sum[1] / n), float(sum[2] / n)};
}

Pictures::Entry& Pictures::entryOf(const SharedBytes& bytes, bool whole) {
  auto& entry = entries_[bytes.get()];
  if (!entry) entry = std::make_shared<Entry>(), entry->bytes = bytes;
  const bool asked = whole ? entry->askedWhole : entry->askedWhole || entry->askedMean;
  if (asked) return *entry;
  (whole ? entry->askedWhole : entry->askedMean) = true;
  const QPointer<Pictures> self(this);
  pool_.start([self, bytes, whole] {
    QImage image = whole ? decoded(*bytes, kLargest) : QImage();
    const std::optional<Color> mean = meanColor(*bytes);
    QMetaObject::invokeMethod(
        qApp,
        [self, bytes, image = std::move(image), mean] {
          if (!self) return;
          Entry& filled = *self->entries_[bytes.get()];
          if (!image.isNull()) filled.image = image;
          filled.mean = mean;
          emit self->changed();
        },
        Qt::QueuedConnection);
  });
  return *entry;
}

QImage Pictures::picture(const SharedBytes& bytes) { return bytes ? entryOf(bytes, true).image : QImage(); }

std::optional<Color> Pictures::colorOf(const Home& home, const Finish& finish) {
  std::optional<Color> color = finish.color;
  if (finish.texture) {
    constexpr std::string_view kCatalog = "catalog:";
    const std::string& asset = finish.texture->asset;
    if (asset.starts_with(kCatalog)) {
      Finish named;
      named.material = asset.substr(kCatalog.size());
      if (const auto mean = colorOf(home, named)) return color ? multiplied(*color, *mean) : *mean;
    } else if (const auto found = home.assets->find(asset); found != home.assets->end() && found->second) {
      if (const auto mean = entryOf(found->second, false).mean)
        return color ? multiplied(*color, *mean) : *mean;
    }
  }
  if (color || finish.material.empty()) return color;
  const auto [at, added] = materials_.try_emplace(finish.material);
  if (added) {
    const QPointer<Pictures> self(this);
    pool_.start([self, id = finish.material] {
      const auto known = materialColor(id);
      QMetaObject::invokeMethod(
          qApp,
          [self, id, known] {
            if (!self) return;
            self->materials_[id] = known;
            emit self->changed();
          },
          Qt::QueuedConnection);
    });
  }
  return at->second;
}

}  // namespace idap
