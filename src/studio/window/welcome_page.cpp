#include "studio/window/welcome_page.h"

#include <QDir>
#include <QEvent>
#include <QFile>
#include <QFileInfo>
#include <QGridLayout>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QTimer>

#include "base/data_path.h"
#include "studio/widgets/icons.h"
#include "studio/widgets/texts.h"
#include "studio/window/new_room_form.h"
#include "studio/window/recent_pictures.h"

namespace idap {

namespace {

constexpr int kPictureWidth = 132, kPictureHeight = 83;  // logical pixels
constexpr int kFileRole = Qt::UserRole, kPictureRole = Qt::UserRole + 1;

QLabel* heading(QWidget* parent, double scale) {
  auto* label = new QLabel(parent);
  QFont font = label->font();
  font.setPointSizeF(font.pointSizeF() * scale);
  font.setBold(true);
  label->setFont(font);
  label->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  return label;
}

QListWidget* pictureList(QWidget* parent, const char* name) {
  auto* list = new QListWidget(parent);
  list->setObjectName(QLatin1String(name));
  list->setViewMode(QListView::IconMode);
  list->setMovement(QListView::Static);
  list->setResizeMode(QListView::Adjust);
  list->setIconSize({kPictureWidth, kPictureHeight});
  list->setSpacing(3);
  list->setWordWrap(true);
  list->setUniformItemSizes(true);
  list->setTextElideMode(Qt::ElideRight);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list->setMouseTracking(true);
  return list;
}

// The picture in the middle of its place, over the theme's colours where it leaves room.
QIcon framed(const QWidget& widget, const QString& file) {
  const qreal ratio = widget.devicePixelRatioF();
  QPixmap place(QSize(kPictureWidth, kPictureHeight) * ratio);
  place.setDevicePixelRatio(ratio);
  place.fill(widget.palette().color(QPalette::AlternateBase));
  QPainter painter(&place);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QImage picture(file);
  const QRect frame(0, 0, kPictureWidth, kPictureHeight);
  if (!picture.isNull()) {
    QRect fitted(QPoint(), picture.size().scaled(frame.size(), Qt::KeepAspectRatioByExpanding));
    fitted.moveCenter(frame.center());
    painter.drawImage(fitted, picture);
  } else {
    icon("room").paint(&painter, frame.adjusted(50, 24, -50, -24));
  }
  painter.setPen(widget.palette().color(QPalette::Mid));
  painter.drawRect(frame.adjusted(0, 0, -1, -1));
  return QIcon(place);
}

void setFile(QListWidgetItem* item, const QString& file, const QString& picture) {
  item->setData(kFileRole, file);
  item->setData(kPictureRole, picture);
}

// Read when the page is on the screen already.
void loadPictures(QListWidget* list) {
  for (int i = 0; i < list->count(); ++i)
    list->item(i)->setIcon(framed(*list, list->item(i)->data(kPictureRole).toString()));
}

}  // namespace

std::vector<HomeTemplate> homeTemplates(const QString& language) {
  std::vector<HomeTemplate> found;
  const QDir folder(toQt((dataFolder() / "templates").string()));
  QFile index(folder.filePath(QStringLiteral("index.json")));
  if (!index.open(QIODevice::ReadOnly)) return found;
  const QJsonArray entries = QJsonDocument::fromJson(index.readAll()).array();
  for (const QJsonValue& entry : entries) {
    HomeTemplate one;
    const QString file = entry[QStringLiteral("file")].toString();
    one.file = folder.filePath(file);
    one.picture = folder.filePath(entry[QStringLiteral("picture")].toString());
    const QJsonValue names = entry[QStringLiteral("name")];
    one.name = names[language].toString(names[QStringLiteral("en")].toString(file));
    if (!file.isEmpty() && QFileInfo::exists(one.file)) found.push_back(std::move(one));
  }
  return found;
}

WelcomePage::WelcomePage(Preferences& preferences, QWidget* parent)
    : QWidget(parent),
      preferences_(preferences),
      title_(heading(this, 2)),
      motto_(new QLabel(this)),
      roomTitle_(heading(this, 1.25)),
      templatesTitle_(heading(this, 1.25)),
      recentTitle_(heading(this, 1.25)),
      noRecent_(new QLabel(this)),
      room_(new NewRoomForm(preferences.editor().unit, this)),
      templates_(pictureList(this, "templates")),
      recent_(pictureList(this, "recentFiles")),
      open_(new QPushButton(this)) {
  setObjectName(QStringLiteral("welcomePage"));
  setAutoFillBackground(true);
  title_->setText(QStringLiteral("IDAP"));
  open_->setObjectName(QStringLiteral("openFile"));
  open_->setIcon(icon("open"));
  motto_->setWordWrap(true);
  motto_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  noRecent_->setWordWrap(true);
  noRecent_->setAlignment(Qt::AlignLeft | Qt::AlignTop);

  const int gap = fontMetrics().height() / 2;
  auto* left = new QVBoxLayout;
  left->setSpacing(gap);  // not that of the columns, which it would take over
  left->addWidget(roomTitle_);
  left->addWidget(room_);
  left->addSpacing(fontMetrics().height());
  auto* opening = new QHBoxLayout;
  opening->addWidget(open_);
  opening->addStretch();
  left->addLayout(opening);
  left->addStretch(1);
  auto* right = new QVBoxLayout;
  right->setSpacing(gap);
  right->addWidget(templatesTitle_);
  right->addWidget(templates_, 3);
  right->addSpacing(fontMetrics().height() / 2);
  right->addWidget(recentTitle_);
  right->addWidget(recent_, 2);
  right->addWidget(noRecent_, 2);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(2 * fontMetrics().height());
  columns->addLayout(left, 10);
  columns->addLayout(right, 13);
  auto* all = new QVBoxLayout(this);
  const int margin = fontMetrics().height() * 3 / 2;
  all->setContentsMargins(margin * 2, margin, margin * 2, margin);
  all->addWidget(title_);
  all->addWidget(motto_);
  all->addSpacing(fontMetrics().height() / 2);
  all->addLayout(columns, 1);

  connect(room_, &NewRoomForm::started, this, &WelcomePage::roomRequested);
  connect(open_, &QPushButton::clicked, this, &WelcomePage::openRequested);
  for (QListWidget* list : {templates_, recent_}) {
    const auto choose = [this, list](QListWidgetItem* item) {
      const QString file = item->data(kFileRole).toString();
      if (list == templates_)
        emit templateChosen(file);
      else
        emit fileChosen(file);
    };
    connect(list, &QListWidget::itemClicked, this, choose);
    // Enter; styles that activate by a click have said itemClicked already.
    connect(list, &QListWidget::itemActivated, this, [list, choose](QListWidgetItem* item) {
      if (!list->underMouse() || QGuiApplication::mouseButtons() == Qt::NoButton) choose(item);
    });
  }
  connect(&preferences_, &Preferences::recentChanged, this, &WelcomePage::fillRecent);
  connect(&preferences_, &Preferences::editorChanged, this,
          [this] { room_->setUnit(preferences_.editor().unit); });
  retranslate();
}

void WelcomePage::focusFirst() { room_->focusFirst(); }

void WelcomePage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  fillRecent();
  QTimer::singleShot(0, this, [this] {
    loadPictures(templates_);
    loadPictures(recent_);
  });
}

void WelcomePage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  if (event->type() == QEvent::PaletteChange && isVisible()) {
    loadPictures(templates_);
    loadPictures(recent_);
  }
  QWidget::changeEvent(event);
}

void WelcomePage::fillTemplates() {
  templates_->clear();
  for (const HomeTemplate& home : homeTemplates(preferences_.language())) {
    auto* item = new QListWidgetItem(home.name, templates_);
    item->setToolTip(tr("Starts a new home like this one"));
    item->setSizeHint({kPictureWidth + 12, kPictureHeight + fontMetrics().height() * 5 / 2});
    setFile(item, home.file, home.picture);
  }
  if (isVisible()) loadPictures(templates_);
}

void WelcomePage::fillRecent() {
  recent_->clear();
  for (const QString& file : preferences_.recentFiles()) {
    auto* item = new QListWidgetItem(QFileInfo(file).completeBaseName(), recent_);
    item->setToolTip(QDir::toNativeSeparators(file));
    item->setSizeHint({kPictureWidth + 12, kPictureHeight + fontMetrics().height() * 5 / 2});
    setFile(item, file, recentPicture(file));
  }
  recent_->setVisible(recent_->count() > 0);
  noRecent_->setVisible(recent_->count() == 0);
  if (isVisible()) loadPictures(recent_);
}

void WelcomePage::retranslate() {
  motto_->setText(tr(
      "Draw a home, furnish it, and see it as it would really look. Nothing can go wrong: everything can be "
      "undone."));
  roomTitle_->setText(tr("New room"));
  templatesTitle_->setText(tr("Start from a template"));
  recentTitle_->setText(tr("Recent homes"));
  noRecent_->setText(tr("Homes you open or save appear here."));
  open_->setText(tr("&Open a home…"));
  open_->setToolTip(tr("Reads a home of IDAP (.idap) or Sweet Home 3D (.sh3d)"));
  fillTemplates();
  fillRecent();
}

}  // namespace idap
