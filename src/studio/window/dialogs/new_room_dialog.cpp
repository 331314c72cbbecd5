#include "studio/window/dialogs/new_room_dialog.h"

#include <QBoxLayout>
#include <QEvent>

#include "studio/window/new_room_form.h"

namespace idap {

NewRoomDialog::NewRoomDialog(LengthUnit unit, QWidget* parent)
    : QDialog(parent), form_(new NewRoomForm(unit, this)) {
  setObjectName(QStringLiteral("newRoomDialog"));
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(form_);
  connect(form_, &NewRoomForm::started, this, [this](double x, double y, double z) {
    accept();
    emit started(x, y, z);
  });
  setWindowTitle(tr("New room"));
  form_->focusFirst();
}

void NewRoomDialog::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) setWindowTitle(tr("New room"));
  QDialog::changeEvent(event);
}

}  // namespace idap
