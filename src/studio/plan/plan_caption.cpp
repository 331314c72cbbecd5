#include "studio/plan/plan_caption.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QToolButton>

#include "studio/widgets/icons.h"

namespace idap {

PlanCaption::PlanCaption(Plane plane, QWidget* parent)
    : QFrame(parent), plane_(plane), label_(new QLabel(this)), button_(new QToolButton(this)) {
  setObjectName(QStringLiteral("planCaption"));
  setAutoFillBackground(true);
  setFrameShape(QFrame::StyledPanel);
  setCursor(Qt::ArrowCursor);
  auto* row = new QHBoxLayout(this);
  const int pad = fontMetrics().height() / 4;
  row->setContentsMargins(pad * 2, 0, pad, 0);
  row->setSpacing(pad);
  row->addWidget(label_);
  button_->setObjectName(QStringLiteral("maximise"));
  button_->setAutoRaise(true);
  button_->setFocusPolicy(Qt::NoFocus);
  const QIcon picture = icon("maximise");
  if (picture.isNull()) {
    button_->setText(QStringLiteral("⤢"));
  } else {
    button_->setIcon(picture);
  }
  const int side = fontMetrics().height();
  button_->setIconSize(QSize(side, side));
  row->addWidget(button_);
  connect(button_, &QToolButton::clicked, this, &PlanCaption::maximiseRequested);
  retranslate();
}

void PlanCaption::setLevelName(const QString& name) {
  if (name == levelName_) return;
  levelName_ = name;
  retranslate();
}

void PlanCaption::mousePressEvent(QMouseEvent* event) { event->accept(); }

void PlanCaption::mouseDoubleClickEvent(QMouseEvent* event) {
  event->accept();
  emit maximiseRequested();
}

void PlanCaption::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QFrame::changeEvent(event);
}

void PlanCaption::retranslate() {
  QString words = plane_ == Plane::XY   ? tr("Plan X-Y")
                  : plane_ == Plane::XZ ? tr("Front X-Z")
                                        : tr("Side Y-Z");
  if (!levelName_.isEmpty()) words += QStringLiteral(" · ") + levelName_;
  label_->setText(words);
  const QString what =
      plane_ == Plane::XY ? tr("Seen from above. Double click to fill the window with it, or to go back.")
      : plane_ == Plane::XZ
          ? tr("Seen from the front. Double click to fill the window with it, or to go back.")
          : tr("Seen from the right. Double click to fill the window with it, or to go back.");
  setToolTip(what);
  button_->setToolTip(tr("Fill the window with this view, or go back"));
  adjustSize();
}

}  // namespace idap
