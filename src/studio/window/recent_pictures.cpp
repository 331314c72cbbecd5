#include "studio/window/recent_pictures.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QPainter>

#include "base/file.h"
#include "studio/plan/plan_view.h"
#include "studio/widgets/texts.h"

namespace idap {

QString recentPicture(const QString& file) {
  const QByteArray name =
      QCryptographicHash::hash(QFileInfo(file).absoluteFilePath().toUtf8(), QCryptographicHash::Sha1).toHex();
  return toQt((userCacheFolder() / "recent").string()) + QLatin1Char('/') + QString::fromLatin1(name) +
         QStringLiteral(".png");
}

QImage planPicture(const PlanView& view, int width, int height) {
  QImage picture(width, height, QImage::Format_RGB32);
  picture.fill(Qt::white);
  Box2 box = view.drawnBox();
  if (box.empty()) return picture;
  // The whole of it, in the middle, with a little room around.
  const double scale =
      std::max((box.max.x - box.min.x) / (width - 16), (box.max.y - box.min.y) / (height - 16));
  if (!(scale > 0)) return picture;
  const Vec2 middle = (box.min + box.max) * 0.5, half = Vec2{double(width), double(height)} * (scale / 2);
  box.min = middle - half;
  box.max = middle + half;
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  view.drawTo(painter, QRectF(0, 0, width, height), box);
  return picture;
}

void keepRecentPicture(const QString& file, const PlanView& view) {
  const QString kept = recentPicture(file);
  QDir().mkpath(QFileInfo(kept).path());
  planPicture(view, kRecentWidth, kRecentHeight).save(kept);
}

}  // namespace idap
