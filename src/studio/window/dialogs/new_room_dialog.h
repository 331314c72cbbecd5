// The New command: the size of the room, drawn while it is typed.
#pragma once

#include <QDialog>

#include "base/units.h"

namespace idap {

class NewRoomForm;

class NewRoomDialog : public QDialog {
  Q_OBJECT
 public:
  explicit NewRoomDialog(LengthUnit unit, QWidget* parent = nullptr);

 signals:
  void started(double x, double y, double z);  // m; the dialog is closed already

 protected:
  void changeEvent(QEvent* event) override;

 private:
  NewRoomForm* form_;
};

}  // namespace idap
