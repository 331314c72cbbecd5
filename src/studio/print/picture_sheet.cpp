// The pictures of the home's gallery, one a page, as large as it allows.
#include <QFontMetricsF>
#include <QImage>

#include "studio/print/sheets.h"
#include "studio/widgets/texts.h"

namespace idap {

std::vector<PrintPage> pictureSheets(const SheetContext& context) {
  const Home& home = context.source.home;
  std::vector<PrintPage> pages;
  for (const auto& [id, picture] : home.pictures) {
    const auto file = home.assets->find(picture->asset);
    if (file == home.assets->end()) continue;
    PrintPage page;
    page.title = picture->name.empty() ? printed(QT_TRANSLATE_NOOP("idap", "Picture")) : toQt(picture->name);
    page.paint = [bytes = file->second, room = context.room](QPainter& p, const QRectF& area) {
      const QImage image =
          QImage::fromData(reinterpret_cast<const uchar*>(bytes->data()), int(bytes->size()));
      if (image.isNull()) return;
      const double dots = p.device()->logicalDpiX() / 25.4;
      const QSizeF free(room.width() * dots, (room.height() - 4) * dots);
      const QSizeF size = QSizeF(image.size()).scaled(free, Qt::KeepAspectRatio);
      p.save();
      p.setRenderHint(QPainter::SmoothPixmapTransform);
      p.drawImage(QRectF(area.topLeft() +
                             QPointF((free.width() - size.width()) / 2, (free.height() - size.height()) / 2),
                         size),
                  image);
      p.restore();
    };
    pages.push_back(std::move(page));
  }
  return pages;
}

}  // namespace idap
