#include "studio/picture/gallery_list.h"

#include <QDateTime>
#include <QLocale>

#include "studio/widgets/background_job.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr QSize kThumbnail{144, 96};

// In the middle of a frame of one size, so that the row is even.
QPixmap framed(const QImage& picture, qreal ratio) {
  const QSize whole = kThumbnail * ratio;
  QPixmap frame(whole);
  frame.fill(Qt::transparent);
  QPainter painter(&frame);
  const QImage fitted = picture.scaled(whole, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  painter.drawImage((whole.width() - fitted.width()) / 2, (whole.height() - fitted.height()) / 2, fitted);
  painter.end();
  frame.setDevicePixelRatio(ratio);
  return frame;
}

}  // namespace

GalleryList::GalleryList(Editor& editor, QWidget* parent) : QListWidget(parent), editor_(editor) {
  setViewMode(QListView::IconMode);
  setFlow(QListView::LeftToRight);
  setWrapping(false);
  setMovement(QListView::Static);
  setResizeMode(QListView::Adjust);
  setIconSize(kThumbnail);
  setUniformItemSizes(true);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFixedHeight(kThumbnail.height() + 2 * fontMetrics().height() + 24);
  setEditTriggers(QAbstractItemView::EditKeyPressed);
  connect(this, &QListWidget::currentItemChanged, this, [this] {
    if (const PictureId id = current()) emit chosen(id);
  });
  // A click shows it again, after something else was looked at.
  connect(this, &QListWidget::itemClicked, this, [this] {
    if (const PictureId id = current()) emit chosen(id);
  });
  connect(this, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    const PictureId id{item->data(Qt::UserRole).toULongLong()};
    const Picture* picture = editor_.home().pictures.find(id);
    if (picture && item->text() != nameOf(*picture)) emit renamed(id, item->text());
  });
  Editor::Listener listener;
  listener.homeChanged = [this](const Home& before, const Home& after) {
    if (!(before.pictures == after.pictures)) refill();
  };
  listener.changed = [this](Editor::Change change) {
    if (change == Editor::Change::Document) refill();
  };
  subscription_ = editor.subscribe(std::move(listener));
  refill();
}

GalleryList::~GalleryList() { editor_.unsubscribe(subscription_); }

QString GalleryList::nameOf(const Picture& picture) {
  return picture.name.empty() ? tr("Picture") : toQt(picture.name);
}

QString GalleryList::describe(const Picture& picture) {
  const PictureSettings& s = picture.settings;
  QStringList lines{nameOf(picture), QStringLiteral("%1 × %2").arg(s.width).arg(s.height)};
  if (s.classic)
    lines << tr("Classic, as in 1993");
  else
    lines << tr("Samples a pixel: %1").arg(picture.samples);
  lines << tr("Made %1").arg(
      QLocale().toString(QDateTime::fromMSecsSinceEpoch(picture.made), QLocale::ShortFormat));
  return lines.join(QLatin1Char('\n'));
}

PictureId GalleryList::current() const {
  return currentItem() ? PictureId{currentItem()->data(Qt::UserRole).toULongLong()} : PictureId{};
}

void GalleryList::setCurrent(PictureId picture) {
  for (int i = 0; i < count(); ++i)
    if (item(i)->data(Qt::UserRole).toULongLong() == picture.value) {
      setCurrentRow(i);
      scrollToItem(item(i));
    }
}

void GalleryList::refill() {
  const PictureId was = current();
  {
    const QSignalBlocker quiet(this);
    clear();
    QPixmap blank(kThumbnail);
    blank.fill(Qt::transparent);
    for (const auto& [id, picture] : editor_.home().pictures) {
      auto* item = new QListWidgetItem(QIcon(blank), nameOf(*picture), this);
      item->setData(Qt::UserRole, qulonglong(id.value));
      item->setToolTip(describe(*picture));
      item->setFlags(item->flags() | Qt::ItemIsEditable);
      item->setSizeHint({kThumbnail.width() + 12, kThumbnail.height() + fontMetrics().height() + 14});
      if (id == was) setCurrentItem(item);
    }
  }
  makeThumbnails();
}

void GalleryList::makeThumbnails() {
  const qreal ratio = devicePixelRatioF();
  const Home& home = editor_.home();
  std::map<SharedBytes, QPixmap> kept;
  for (int i = 0; i < count(); ++i) {
    const Picture* picture = home.pictures.find(PictureId{item(i)->data(Qt::UserRole).toULongLong()});
    const auto file = picture ? home.assets->find(picture->asset) : home.assets->end();
    if (file == home.assets->end()) continue;
    const SharedBytes bytes = file->second;
    const auto known = thumbnails_.find(bytes);
    if (known != thumbnails_.end()) {
      kept[bytes] = known->second;
      const QSignalBlocker quiet(this);
      if (!known->second.isNull()) item(i)->setIcon(QIcon(known->second));
      continue;
    }
    kept[bytes] = QPixmap();
    runInBackground<QImage>(
        this, tr("Reading a picture"),
        [bytes, ratio](const Progress&) {
          const QImage whole = QImage::fromData(reinterpret_cast<const uchar*>(bytes->data()),
                                                int(std::min<std::size_t>(bytes->size(), INT_MAX)));
          return whole.isNull()
                     ? whole
                     : whole.scaled(kThumbnail * ratio, Qt::KeepAspectRatio, Qt::SmoothTransformation);
        },
        [this, bytes, ratio](const QImage& small) {
          if (small.isNull() || !thumbnails_.contains(bytes)) return;
          thumbnails_[bytes] = framed(small, ratio);
          makeThumbnails();
        },
        [](std::exception_ptr) {});
  }
  thumbnails_ = std::move(kept);
}

}  // namespace idap
