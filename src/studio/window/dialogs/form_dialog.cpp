#include "studio/window/dialogs/form_dialog.h"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>

#include "studio/widgets/value_field.h"

namespace idap {

FormDialog::FormDialog(const char* name, QWidget* parent)
    : QDialog(parent),
      all_(new QVBoxLayout(this)),
      form_(new QFormLayout),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
  setObjectName(QLatin1String(name));
  form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  all_->addLayout(form_);
  all_->addStretch();
  all_->addWidget(buttons_);
  connect(buttons_, &QDialogButtonBox::accepted, this, &FormDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &FormDialog::reject);
}

QLabel* FormDialog::addRow(QWidget* field) {
  auto* label = new QLabel(this);
  label->setBuddy(field);
  form_->addRow(label, field);
  return label;
}

void FormDialog::addWide(QWidget* field, int stretch) { all_->insertWidget(++wide_, field, stretch); }

void FormDialog::accept() {
  // What is typed and not applied yet counts; what cannot be understood is shown instead of lost.
  const auto fields = findChildren<ValueField*>();
  for (ValueField* field : fields)
    if (field->isEnabled() && !field->commit()) return field->setFocus(Qt::OtherFocusReason);
  if (apply()) QDialog::accept();
}

void FormDialog::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QDialog::changeEvent(event);
}

}  // namespace idap
