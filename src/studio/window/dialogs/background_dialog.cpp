#include "studio/window/dialogs/background_dialog.h"

#include <QBoxLayout>
#include <QBuffer>
#include <QCheckBox>
#include <QCryptographicHash>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QImageReader>
#include <QLabel>
#include <QPushButton>

#include "base/error.h"
#include "base/file.h"
#include "editor/tools/calibrate_tool.h"
#include "model/assets.h"
#include "studio/widgets/icons.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr std::size_t kMostBytes = std::size_t{40} << 20;
constexpr int kMostSide = 12000;  // pixels

const Background* background(const Editor& editor) {
  const auto found = editor.home().backgrounds.find(editor.level());
  return found == editor.home().backgrounds.end() ? nullptr : &found->second;
}

QImage decoded(const Bytes& bytes, QString* problem) {
  QByteArray data(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size()));
  QBuffer buffer(&data);
  QImageReader reader(&buffer);
  const QByteArray format = reader.format();
  if (format != "png" && format != "jpeg") {
    *problem = BackgroundDialog::tr("It is not a PNG or JPEG picture.");
    return {};
  }
  const QSize size = reader.size();
  if (size.width() > kMostSide || size.height() > kMostSide) {
    *problem = BackgroundDialog::tr("It is larger than %1 pixels. Make it smaller with a paint program.")
                   .arg(kMostSide);
    return {};
  }
  const QImage picture = reader.read();
  if (picture.isNull()) *problem = BackgroundDialog::tr("It is damaged: %1").arg(reader.errorString());
  return picture;
}

}  // namespace

BackgroundDialog::BackgroundDialog(Editor& editor, QWidget* parent)
    : QDialog(parent),
      editor_(editor),
      explanation_(new QLabel(this)),
      picture_(new QLabel(this)),
      problem_(new QLabel(this)),
      choose_(new QPushButton(this)),
      calibrate_(new QPushButton(this)),
      move_(new QPushButton(this)),
      remove_(new QPushButton(this)),
      close_(new QPushButton(this)),
      visible_(new QCheckBox(this)) {
  setObjectName(QStringLiteral("backgroundDialog"));
  choose_->setObjectName(QStringLiteral("choosePicture"));
  calibrate_->setObjectName(QStringLiteral("calibrate"));
  move_->setObjectName(QStringLiteral("movePicture"));
  remove_->setObjectName(QStringLiteral("removePicture"));
  visible_->setObjectName(QStringLiteral("pictureVisible"));
  problem_->setObjectName(QStringLiteral("problem"));
  for (QLabel* label : {explanation_, problem_}) label->setWordWrap(true);
  picture_->setAlignment(Qt::AlignCenter);
  picture_->setFrameShape(QFrame::StyledPanel);
  const int em = fontMetrics().height();
  picture_->setMinimumSize(22 * em, 13 * em);

  auto* steps = new QVBoxLayout;
  for (QPushButton* button : {choose_, calibrate_, move_, remove_}) steps->addWidget(button);
  steps->addWidget(visible_);
  steps->addStretch();
  auto* middle = new QHBoxLayout;
  middle->addWidget(picture_, 1);
  middle->addLayout(steps);
  auto* bottom = new QHBoxLayout;
  bottom->addStretch();
  bottom->addWidget(close_);
  auto* all = new QVBoxLayout(this);
  all->addWidget(explanation_);
  all->addLayout(middle, 1);
  all->addWidget(problem_);
  all->addLayout(bottom);
  problem_->hide();

  connect(choose_, &QPushButton::clicked, this, &BackgroundDialog::choose);
  connect(calibrate_, &QPushButton::clicked, this, [this] {
    accept();
    editor_.setTool(makeCalibrateTool(editor_.level()));
  });
  connect(move_, &QPushButton::clicked, this, [this] {
    accept();
    editor_.setTool(makeMoveBackgroundTool(editor_.level()));
  });
  connect(remove_, &QPushButton::clicked, this, [this] {
    editor_.apply(QT_TRANSLATE_NOOP("idap", "Remove background picture"),
                  [level = editor_.level()](const Home& home) {
                    Home changed = home;
                    changed.backgrounds.erase(level);
                    return changed;
                  });
    refresh();
  });
  connect(visible_, &QCheckBox::clicked, this, [this](bool on) {
    editor_.apply(QT_TRANSLATE_NOOP("idap", "Show background picture"), [level = editor_.level(),
                                                                         on](const Home& home) {
      Home changed = home;
      if (const auto found = changed.backgrounds.find(level); found != changed.backgrounds.end())
        found->second.visible = on;
      return changed;
    });
  });
  connect(close_, &QPushButton::clicked, this, &QDialog::reject);
  retranslate();
  refresh();
}

void BackgroundDialog::refresh() {
  const Background* now = background(editor_);
  for (QWidget* widget : std::initializer_list<QWidget*>{calibrate_, move_, remove_, visible_})
    widget->setEnabled(now);
  visible_->setChecked(now && now->visible);
  QPixmap small;
  if (now) {
    if (const auto asset = editor_.home().assets->find(now->asset); asset != editor_.home().assets->end()) {
      QString problem;
      const QImage picture = decoded(*asset->second, &problem);
      if (!picture.isNull()) {
        const qreal ratio = devicePixelRatioF();
        small = QPixmap::fromImage(
            picture.scaled(picture_->minimumSize() * ratio, Qt::KeepAspectRatio, Qt::SmoothTransformation));
        small.setDevicePixelRatio(ratio);
      }
    }
  }
  if (small.isNull())
    picture_->setText(tr("No picture yet"));
  else
    picture_->setPixmap(small);
  (now ? calibrate_ : choose_)->setDefault(true);
}

void BackgroundDialog::choose() {
  auto* dialog = new QFileDialog(this, tr("Choose a picture of the plan"), QString(),
                                 tr("Pictures") + QStringLiteral(" (*.png *.jpg *.jpeg)"));
  dialog->setObjectName(QStringLiteral("pictureDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &BackgroundDialog::usePicture);
  dialog->open();
}

bool BackgroundDialog::usePicture(const QString& file) {
  QString problem;
  SharedBytes bytes;
  QImage picture;
  try {
    bytes = std::make_shared<const Bytes>(readFile(fromQt(file), kMostBytes));
    picture = decoded(*bytes, &problem);
  } catch (const Error& error) {
    problem = toQt(error.what());
  }
  problem_->setVisible(!problem.isEmpty());
  if (!problem.isEmpty()) {
    problem_->setText(tr("“%1” cannot be used. %2").arg(QFileInfo(file).fileName(), problem));
    return false;
  }
  const QByteArray hash =
      QCryptographicHash::hash(
          QByteArray::fromRawData(reinterpret_cast<const char*>(bytes->data()), qsizetype(bytes->size())),
          QCryptographicHash::Sha1)
          .toHex()
          .left(12);
  const std::string asset =
      "pictures/plan-" + hash.toStdString() + "." + fromQt(QFileInfo(file).suffix().toLower());
  const bool done = editor_.apply(
      QT_TRANSLATE_NOOP("idap", "Background picture"), [&, level = editor_.level()](const Home& home) {
        Home changed = home;
        Background made;
        made.asset = asset;
        // As wide as the drawing, to be put right by two points of it.
        Box2 drawn;
        for (const auto& [id, wall] : home.walls)
          if (wall->level == level) drawn.add(wall->start), drawn.add(wall->end);
        const double width = drawn.empty() ? 10 : std::max(1.0, drawn.max.x - drawn.min.x);
        made.scale = width / std::max(1, picture.width());
        if (!drawn.empty()) made.origin = drawn.min;
        changed.backgrounds[level] = made;
        Assets assets = *home.assets;
        assets[asset] = bytes;
        changed.assets = std::make_shared<const Assets>(std::move(assets));
        return changed;
      });
  refresh();
  return done;
}

void BackgroundDialog::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
    refresh();
  }
  QDialog::changeEvent(event);
}

void BackgroundDialog::retranslate() {
  setWindowTitle(tr("Background picture"));
  explanation_->setText(
      tr("A scanned plan (PNG or JPEG) lies under the drawing of this level. Choose it, then click two "
         "points on it "
         "whose distance you know: it gets its true size."));
  choose_->setText(tr("1.  &Choose a picture…"));
  calibrate_->setText(tr("2.  &Set its size by two points"));
  move_->setText(tr("3.  &Move it into place"));
  remove_->setText(tr("&Remove it"));
  visible_->setText(tr("&Visible"));
  close_->setText(tr("Close"));
  calibrate_->setToolTip(tr("Click two points on the plan, then type the length between them"));
  move_->setToolTip(tr("Drag it where the drawing is, or the drawing will be"));
  remove_->setToolTip(tr("Takes it from this level; undo brings it back"));
}

}  // namespace idap
