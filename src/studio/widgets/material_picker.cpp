#include "studio/widgets/material_picker.h"

#include <QColorDialog>
#include <QDragEnterEvent>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QImageReader>
#include <QLineEdit>
#include <QMimeData>
#include <QStyleOptionToolButton>
#include <QStylePainter>
#include <QToolTip>

#include "catalog/material.h"
#include "studio/widgets/color_button.h"
#include "studio/widgets/material_popup.h"
#include "studio/widgets/material_swatches.h"
#include "studio/widgets/popups.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr qint64 kMaxPicture = 64 * 1024 * 1024;  // bytes

QString fileName(const std::string& asset) { return QFileInfo(toQt(asset)).fileName(); }

// A name in the home's archive that no other file has, with plain letters only.
std::string freeName(const Assets* assets, const QFileInfo& file) {
  QString base;
  for (const QChar c : file.completeBaseName())
    base += c.unicode() < 128 && c.isLetterOrNumber() ? c : QLatin1Char('-');
  if (base.isEmpty()) base = QStringLiteral("picture");
  const QString suffix = file.suffix().toLower();
  for (int i = 1;; ++i) {
    const QString number = i == 1 ? QString() : QStringLiteral("-%1").arg(i);
    std::string name = fromQt(QStringLiteral("textures/") + base + number + QLatin1Char('.') + suffix);
    if (!assets || !assets->contains(name)) return name;
  }
}

}  // namespace

Home withAsset(const Home& home, const FinishChoice& choice) {
  if (!choice.asset) return home;
  Home next = home;
  auto assets = std::make_shared<Assets>(*home.assets);
  (*assets)[choice.assetName] = choice.asset;
  next.assets = std::move(assets);
  return next;
}

MaterialPicker::MaterialPicker(QWidget* parent) : QToolButton(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setFocusPolicy(Qt::StrongFocus);
  setAcceptDrops(true);
  plainWords_ = tr("As it comes");
  connect(this, &QToolButton::clicked, this, [this] { openPopup(); });
  connect(&MaterialSwatches::shared(), &MaterialSwatches::ready, this, [this] { update(); });
}

MaterialPicker::~MaterialPicker() = default;

void MaterialPicker::setFinish(const Finish& finish, std::shared_ptr<const Assets> assets) {
  const bool same = !mixed_ && finish == finish_;
  assets_ = std::move(assets);
  if (same) return;
  mixed_ = false;
  finish_ = finish;
  setAccessibleDescription(words());
  update();
}

void MaterialPicker::setMixed() {
  if (mixed_) return;
  mixed_ = true;
  finish_ = {};
  setAccessibleDescription(words());
  update();
}

void MaterialPicker::setPlain(const QString& words, std::optional<Color> color, const std::string& material) {
  if (words == plainWords_ && color == plainColor_ && material == plainMaterial_) return;
  plainMaterial_ = material;
  plainWords_ = words;
  plainColor_ = color;
  update();
}

void MaterialPicker::setLanguage(const std::string& language) {
  language_ = language;
  update();
}

void MaterialPicker::setUnit(LengthUnit unit) { unit_ = unit; }

QString MaterialPicker::words() const {
  if (mixed_) return tr("Several finishes");
  const Finish& f = finish_;
  if (f.texture) return fileName(f.texture->asset);
  if (!f.material.empty()) {
    QString name = toQt(materialName(f.material, language_));
    if (name.isEmpty()) name = toQt(f.material);
    return f.color ? tr("%1, tinted").arg(name) : name;
  }
  if (f.color) return toQt(*f.color).name();
  return plainWords_;
}

void MaterialPicker::choose(const Finish& finish) {
  mixed_ = false;
  finish_ = finish;
  update();
  emit finishChosen({finish, {}, nullptr});
}

void MaterialPicker::openPopup() {
  popup_ = new MaterialPopup(finish_, language_, unit_, plainWords_, this);
  connect(popup_, &MaterialPopup::chosen, this, [this](const Finish& finish) { choose(finish); });
  connect(popup_, &MaterialPopup::pictureRequested, this, [this] {
    popup_->close();
    askPicture();
  });
  connect(popup_, &MaterialPopup::colorRequested, this, [this] {
    popup_->close();
    askColor();
  });
  popup_->adjustSize();
  showBeside(*popup_, *this);
}

void MaterialPicker::askColor() {
  auto* dialog = new QColorDialog(finish_.color ? toQt(*finish_.color) : QColor(Qt::white), window());
  dialog->setOption(QColorDialog::DontUseNativeDialog);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QColorDialog::colorSelected, this, [this](const QColor& colour) {
    rememberColor(colour);
    Finish next = finish_;
    next.color = fromQt(colour);
    choose(next);
  });
  dialog->open();
}

void MaterialPicker::askPicture() {
  auto* dialog = new QFileDialog(window(), tr("Picture for this face"));
  dialog->setObjectName(QStringLiteral("texturePicture"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  QStringList patterns;
  for (const QByteArray& format : QImageReader::supportedImageFormats())
    patterns << QStringLiteral("*.") + QString::fromLatin1(format);
  dialog->setNameFilters({tr("Pictures (%1)").arg(patterns.join(QLatin1Char(' '))), tr("All files (*)")});
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    // Its size is asked for right away.
    if (takePicture(file)) openPopup();
  });
  dialog->open();
}

bool MaterialPicker::takePicture(const QString& path) {
  problem_.clear();
  QFile file(path);
  QImageReader reader(path);
  const QSize pixels = reader.size();
  if (!file.open(QIODevice::ReadOnly)) {
    problem_ = tr("%1 cannot be opened: %2.").arg(path, file.errorString());
  } else if (file.size() > kMaxPicture) {
    problem_ = tr("%1 is too large: pictures may have up to 64 MB.").arg(path);
  } else if (!reader.canRead() || pixels.isEmpty()) {
    problem_ = tr("%1 is not a picture this program can read.").arg(path);
  }
  if (!problem_.isEmpty()) {
    QToolTip::showText(mapToGlobal(QPoint(0, height())), problem_, this);
    return false;
  }
  const QByteArray content = file.readAll();
  FinishChoice choice;
  const auto* first = reinterpret_cast<const Bytes::value_type*>(content.constData());
  choice.asset = std::make_shared<const Bytes>(first, first + content.size());
  choice.assetName = freeName(assets_.get(), QFileInfo(path));
  choice.finish = mixed_ ? Finish{} : finish_;
  choice.finish.color.reset();
  TextureRef texture;
  texture.asset = choice.assetName;
  texture.size = {1, static_cast<double>(pixels.height()) / pixels.width()};
  choice.finish.texture = texture;
  finish_ = choice.finish;
  mixed_ = false;
  update();
  emit finishChosen(choice);
  return true;
}

void MaterialPicker::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls() && event->mimeData()->urls().first().isLocalFile())
    event->acceptProposedAction();
}

void MaterialPicker::dropEvent(QDropEvent* event) {
  const QList<QUrl> files = event->mimeData()->urls();
  if (!files.isEmpty() && takePicture(files.first().toLocalFile())) event->acceptProposedAction();
}

void MaterialPicker::paintEvent(QPaintEvent*) {
  QStylePainter painter(this);
  QStyleOptionToolButton option;
  initStyleOption(&option);
  option.toolButtonStyle = Qt::ToolButtonTextOnly;
  option.text.clear();
  painter.drawComplexControl(QStyle::CC_ToolButton, option);

  const int inset = height() / 6;
  const QRect box(inset, inset, (height() - 2 * inset) * 3 / 2, height() - 2 * inset);
  QPixmap picture;
  std::optional<QColor> colour;
  if (!mixed_) {
    const Finish& f = finish_;
    const std::string kCatalog = "catalog:";
    if (f.texture && f.texture->asset.starts_with(kCatalog))
      picture = MaterialSwatches::shared().material(f.texture->asset.substr(kCatalog.size()));
    else if (f.texture && assets_ && assets_->contains(f.texture->asset))
      picture = MaterialSwatches::shared().picture(assets_->at(f.texture->asset));
    else if (!f.material.empty())
      picture = MaterialSwatches::shared().material(f.material);
    if (f.color) colour = toQt(*f.color);
    const bool bare = !f.texture && f.material.empty() && !f.color;
    if (bare && !plainMaterial_.empty()) picture = MaterialSwatches::shared().material(plainMaterial_);
    if (bare && plainColor_) colour = toQt(*plainColor_);
  }
  if (picture.isNull()) {
    paintSwatch(painter, box, colour, palette());
  } else {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const double share = static_cast<double>(box.height()) / box.width();
    painter.drawPixmap(
        QRectF(box), picture,
        QRectF(0, picture.height() * (1 - share) / 2, picture.width(), picture.height() * share));
    if (colour) {
      // The colour counts; the picture's grain shows through.
      painter.setOpacity(0.75);
      painter.fillRect(box, *colour);
      painter.setOpacity(1);
    }
    QColor frame = palette().color(QPalette::WindowText);
    frame.setAlphaF(0.45f);
    painter.setPen(frame);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(box.adjusted(0, 0, -1, -1));
  }
  const int left = box.right() + inset + 2;
  painter.setPen(palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled,
                                 mixed_ ? QPalette::PlaceholderText : QPalette::ButtonText));
  const QRect rest(left, 0, width() - left - inset, height());
  painter.drawText(rest, Qt::AlignVCenter | Qt::AlignLeft,
                   fontMetrics().elidedText(words(), Qt::ElideRight, rest.width()));
}

void MaterialPicker::changeEvent(QEvent* event) {
  QToolButton::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) update();
}

QSize MaterialPicker::sizeHint() const {
  return {fontMetrics().averageCharWidth() * 18, QLineEdit().sizeHint().height()};
}
QSize MaterialPicker::minimumSizeHint() const {
  return {fontMetrics().averageCharWidth() * 8, sizeHint().height()};
}

}  // namespace idap
