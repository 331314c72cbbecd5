#include "studio/widgets/section_box.h"

#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>

namespace idap {

SectionBox::SectionBox(const QString& title, const QString& name, QWidget* parent)
    : QWidget(parent), head_(new QToolButton(this)), body_(new QWidget(this)), name_(name) {
  head_->setObjectName(QStringLiteral("sectionTitle"));
  head_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  head_->setAutoRaise(true);
  head_->setCheckable(true);
  head_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  QFont bold = head_->font();
  bold.setBold(true);
  head_->setFont(bold);
  head_->setText(title);
  body_->setObjectName(QStringLiteral("sectionBody"));

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(head_);
  column->addWidget(body_);

  const QString key = QStringLiteral("sections/") + name_;
  const bool open = name_.isEmpty() || QSettings().value(key, true).toBool();
  connect(head_, &QToolButton::toggled, this, [this, key](bool on) {
    head_->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
    body_->setVisible(on);
    if (!name_.isEmpty()) QSettings().setValue(key, on);
    emit openChanged(on);
  });
  head_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
  body_->setVisible(open);
  const QSignalBlocker quiet(head_);
  head_->setChecked(open);
}

QString SectionBox::title() const { return head_->text(); }
void SectionBox::setTitle(const QString& title) { head_->setText(title); }
bool SectionBox::isOpen() const { return head_->isChecked(); }
void SectionBox::setOpen(bool open) { head_->setChecked(open); }

}  // namespace idap
