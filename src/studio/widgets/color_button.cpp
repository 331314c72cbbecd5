#include "studio/widgets/color_button.h"

#include <QColorDialog>
#include <QEvent>
#include <QGridLayout>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSettings>
#include <QStyleOptionToolButton>
#include <QStylePainter>
#include <array>

#include "studio/widgets/popups.h"

namespace idap {

namespace {

constexpr int kColumns = 8;
constexpr std::size_t kRecent = 8;

// Rows of eight: whites and greys, warm neutrals, woods, reds to yellows, greens, blues and violets.
constexpr std::array<QRgb, 48> kPalette{
    0xffffff, 0xf4f2ee, 0xe4e2dd, 0xc9c9c8, 0x9c9d9e, 0x6c6e70, 0x3d4043, 0x141414,  //
    0xf6efdf, 0xebe0c8, 0xd9c8a9, 0xc2ab88, 0xa58c6b, 0x84694b, 0x5f4934, 0x3b2c20,  //
    0xf5d9cf, 0xe7b3a2, 0xd98872, 0xc45a45, 0xa23a2f, 0x7d2424, 0xb5495b, 0xe7a5b1,  //
    0xfbe8b0, 0xf3cf6b, 0xe3ac36, 0xd98a2b, 0xc46c24, 0x99501f, 0xd8c24a, 0x9a8a3c,  //
    0xdbe6d2, 0xb5c8a7, 0x8ba67e, 0x62845b, 0x40633f, 0x274330, 0x7fb3a0, 0x3c7f72,  //
    0xd7e4ee, 0xa8c3d9, 0x7299bd, 0x426f9b, 0x28496f, 0x1b2c46, 0x8f86b5, 0x5c4a7a,
};

class Swatch : public QAbstractButton {
 public:
  Swatch(const QColor& colour, QWidget* parent) : QAbstractButton(parent), colour_(colour) {
    setToolTip(colour.name());
    setAccessibleName(colour.name());
    setFocusPolicy(Qt::TabFocus);
  }
  QSize sizeHint() const override {
    const int side = fontMetrics().height() * 5 / 4;
    return {side, side};
  }
  void setColour(const QColor& colour) {
    colour_ = colour;
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintSwatch(painter, QRectF(rect()).adjusted(1, 1, -1, -1), colour_, palette());
    if (hasFocus() || underMouse()) {
      painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
      painter.setBrush(Qt::NoBrush);
      painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
    }
  }
  void enterEvent(QEnterEvent*) override { update(); }
  void leaveEvent(QEvent*) override { update(); }

 private:
  QColor colour_;
};

}  // namespace

QColor toQt(const Color& color) { return QColor::fromRgbF(color.r, color.g, color.b); }
Color fromQt(const QColor& color) {
  const QColor rgb = color.toRgb();
  return {static_cast<float>(rgb.redF()), static_cast<float>(rgb.greenF()), static_cast<float>(rgb.blueF())};
}

std::vector<QColor> recentColors() {
  std::vector<QColor> colours;
  for (const QString& name : QSettings().value(QStringLiteral("colors/recent")).toStringList())
    if (const QColor colour(name); colour.isValid()) colours.push_back(colour);
  return colours;
}

void rememberColor(const QColor& color) {
  std::vector<QColor> colours = recentColors();
  std::erase_if(colours, [&](const QColor& c) { return c.name() == color.name(); });
  colours.insert(colours.begin(), color);
  if (colours.size() > kRecent) colours.resize(kRecent);
  QStringList names;
  for (const QColor& c : colours) names << c.name();
  QSettings().setValue(QStringLiteral("colors/recent"), names);
}

void paintSwatch(QPainter& painter, const QRectF& rect, const std::optional<QColor>& color,
                 const QPalette& palette) {
  QColor frame = palette.color(QPalette::WindowText);
  frame.setAlphaF(0.45f);
  const QRectF box = rect.adjusted(0.5, 0.5, -0.5, -0.5);
  painter.setPen(QPen(frame, 1));
  painter.setBrush(color ? *color : palette.color(QPalette::Base));
  painter.drawRect(box);
  if (!color) painter.drawLine(box.bottomLeft(), box.topRight());
}

ColorButton::ColorButton(QWidget* parent) : QToolButton(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setFocusPolicy(Qt::StrongFocus);
  connect(this, &QToolButton::clicked, this, [this] { openPalette(); });
}

void ColorButton::setColor(std::optional<Color> color) {
  if (!mixed_ && color == color_) return;
  color_ = color;
  mixed_ = false;
  update();
}

void ColorButton::setMixed() {
  mixed_ = true;
  color_.reset();
  update();
}

void ColorButton::setOptional(bool optional, const QString& words) {
  optional_ = optional;
  noneWords_ = words;
  update();
}

void ColorButton::choose(std::optional<Color> color) {
  if (color) rememberColor(toQt(*color));
  if (!mixed_ && color == color_) {
    emit colorAbandoned();
    return;
  }
  mixed_ = false;
  color_ = color;
  update();
  emit colorChanged(color);
}

void ColorButton::openPalette() {
  auto* popup = new QFrame(this, Qt::Popup);
  popup->setObjectName(QStringLiteral("colorPalette"));
  popup->setAttribute(Qt::WA_DeleteOnClose);
  popup->setFrameShape(QFrame::StyledPanel);
  auto* column = new QVBoxLayout(popup);
  const auto addRow = [&](QGridLayout* grid, int index, const QColor& colour) {
    auto* swatch = new Swatch(colour, popup);
    grid->addWidget(swatch, index / kColumns, index % kColumns);
    connect(swatch, &QAbstractButton::clicked, this, [this, popup, colour] {
      popup->close();
      choose(fromQt(colour));
    });
  };
  auto* grid = new QGridLayout;
  grid->setSpacing(2);
  for (std::size_t i = 0; i < kPalette.size(); ++i) addRow(grid, static_cast<int>(i), QColor(kPalette[i]));
  column->addLayout(grid);
  if (const std::vector<QColor> recent = recentColors(); !recent.empty()) {
    auto* title = new QLabel(tr("Used last"), popup);
    column->addWidget(title);
    auto* row = new QGridLayout;
    row->setSpacing(2);
    for (std::size_t i = 0; i < recent.size(); ++i) addRow(row, static_cast<int>(i), recent[i]);
    row->setColumnStretch(kColumns, 1);
    column->addLayout(row);
  }
  auto* code = new QLineEdit(popup);
  code->setObjectName(QStringLiteral("colorCode"));
  code->setToolTip(tr("The colour as #rrggbb, from a paint chart for example. Enter takes it."));
  code->setPlaceholderText(QStringLiteral("#rrggbb"));
  if (color_) code->setText(toQt(*color_).name());
  connect(code, &QLineEdit::returnPressed, this, [this, popup, code] {
    QString name = code->text().trimmed();
    static const QRegularExpression kDigits(QStringLiteral("^([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$"));
    if (kDigits.match(name).hasMatch()) name.prepend(QLatin1Char('#'));
    const QColor colour(name);
    if (!colour.isValid()) {
      code->selectAll();
      return;
    }
    popup->close();
    choose(fromQt(colour));
  });
  column->addWidget(code);
  auto* more = new QPushButton(tr("More colours…"), popup);
  more->setObjectName(QStringLiteral("moreColors"));
  more->setAutoDefault(false);
  connect(more, &QPushButton::clicked, this, [this, popup] {
    popup->close();
    openDialog();
  });
  column->addWidget(more);
  if (optional_) {
    auto* none = new QPushButton(noneWords_.isEmpty() ? tr("No colour of its own") : noneWords_, popup);
    none->setObjectName(QStringLiteral("noColor"));
    none->setAutoDefault(false);
    connect(none, &QPushButton::clicked, this, [this, popup] {
      popup->close();
      choose(std::nullopt);
    });
    column->addWidget(none);
  }
  popup->adjustSize();
  showBeside(*popup, *this);
  code->setFocus();
}

void ColorButton::openDialog() {
  if (dialogElsewhere_) {
    emit dialogRequested();
    return;
  }
  auto* dialog = new QColorDialog(color_ ? toQt(*color_) : QColor(Qt::white), window());
  dialog->setOption(QColorDialog::DontUseNativeDialog);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QColorDialog::currentColorChanged, this,
          [this](const QColor& colour) { emit colorChanging(fromQt(colour)); });
  connect(dialog, &QColorDialog::colorSelected, this,
          [this](const QColor& colour) { choose(fromQt(colour)); });
  connect(dialog, &QDialog::rejected, this, [this] { emit colorAbandoned(); });
  dialog->open();
}

void ColorButton::paintEvent(QPaintEvent*) {
  QStylePainter painter(this);
  QStyleOptionToolButton option;
  initStyleOption(&option);
  option.toolButtonStyle = Qt::ToolButtonTextOnly;
  option.text.clear();
  painter.drawComplexControl(QStyle::CC_ToolButton, option);
  const int inset = height() / 5;
  QRect inner = rect().adjusted(inset, inset, -inset, -inset);
  QString words;
  if (mixed_)
    words = tr("Several values");
  else if (!color_)
    words = noneWords_;
  if (words.isEmpty()) {
    paintSwatch(painter, inner, color_ ? std::optional(toQt(*color_)) : std::nullopt, palette());
    return;
  }
  painter.setPen(palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled,
                                 mixed_ ? QPalette::PlaceholderText : QPalette::ButtonText));
  painter.drawText(rect().adjusted(inset, 0, -inset, 0), Qt::AlignVCenter | Qt::AlignLeft,
                   fontMetrics().elidedText(words, Qt::ElideRight, width() - 2 * inset));
}

void ColorButton::changeEvent(QEvent* event) {
  QToolButton::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) update();
}

QSize ColorButton::sizeHint() const {
  const int height = QLineEdit().sizeHint().height();
  return {fontMetrics().averageCharWidth() * 12, height};
}
QSize ColorButton::minimumSizeHint() const {
  return {fontMetrics().averageCharWidth() * 6, sizeHint().height()};
}

}  // namespace idap
