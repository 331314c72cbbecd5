#include "studio/window/new_room_form.h"

#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>

#include "studio/widgets/length_field.h"
#include "studio/window/room_sketch.h"

namespace idap {

namespace {
constexpr std::array<double, 3> kUsual{5, 4, 2.5}, kLeast{0.5, 0.5, 1}, kMost{200, 200, 30};  // m
constexpr std::array<const char*, 3> kNames{"roomX", "roomY", "roomZ"};
}  // namespace

NewRoomForm::NewRoomForm(LengthUnit unit, QWidget* parent)
    : QWidget(parent), unit_(unit), sketch_(new RoomSketch(this)) {
  setObjectName(QStringLiteral("newRoomForm"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(sketch_, 0, 0, 1, 4);
  grid->setRowStretch(0, 1);
  for (std::size_t i = 0; i < 3; ++i) {
    labels_[i] = new QLabel(this);
    labels_[i]->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    fields_[i] = new LengthField(this, unit);
    fields_[i]->setObjectName(QLatin1String(kNames[i]));
    fields_[i]->setRange(kLeast[i], kMost[i]);
    fields_[i]->setValue(kUsual[i]);
    fields_[i]->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    labels_[i]->setBuddy(fields_[i]);
    grid->addWidget(labels_[i], 1, int(i));
    grid->addWidget(fields_[i], 2, int(i));
    grid->setColumnStretch(int(i), 1);
    // While a number is being typed or turned the drawing follows it.
    const auto follow = [this, i](double value) {
      std::array<double, 3> size{fields_[0]->value(), fields_[1]->value(), fields_[2]->value()};
      size[i] = value;
      sketch_->setRoom(size[0], size[1], size[2], unit_);
    };
    connect(fields_[i], &ValueField::valueTyped, this, follow);
    connect(fields_[i], &ValueField::valueStepping, this, follow);
    connect(fields_[i], &ValueField::valueChanged, this, follow);
  }
  // Made in the order of the keyboard's way through them.
  start_ = new QPushButton(this);
  start_->setObjectName(QStringLiteral("startRoom"));
  start_->setDefault(true);
  start_->setAutoDefault(true);
  grid->addWidget(start_, 2, 3);
  connect(start_, &QPushButton::clicked, this, &NewRoomForm::start);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  draw();
  retranslate();
}

void NewRoomForm::setUnit(LengthUnit unit) {
  unit_ = unit;
  for (LengthField* field : fields_) field->setUnit(unit);
  draw();
}

void NewRoomForm::focusFirst() {
  fields_[0]->setFocus(Qt::OtherFocusReason);
  fields_[0]->selectAll();
}

void NewRoomForm::draw() {
  sketch_->setRoom(fields_[0]->value(), fields_[1]->value(), fields_[2]->value(), unit_);
}

void NewRoomForm::start() {
  for (LengthField* field : fields_) {
    if (field->commit()) continue;
    field->setFocus(Qt::OtherFocusReason);  // it says what is wrong with it
    return;
  }
  emit started(fields_[0]->value(), fields_[1]->value(), fields_[2]->value());
}

void NewRoomForm::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
    start();
  else
    QWidget::keyPressEvent(event);
}

void NewRoomForm::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void NewRoomForm::retranslate() {
  labels_[0]->setText(tr("Width &X"));
  labels_[1]->setText(tr("Depth &Y"));
  labels_[2]->setText(tr("Height &Z"));
  const QString tip = tr("The clear size between the walls. Takes units and sums: 4.2m, 13'6\", 320+45.");
  for (LengthField* field : fields_) field->setToolTip(tip);
  start_->setText(tr("&Start"));
  start_->setToolTip(tr("Makes a room of this size with four walls, ready to be furnished"));
}

}  // namespace idap
