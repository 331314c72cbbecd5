// What a MaterialPicker opens.
#pragma once

#include <QFrame>
#include <string>

#include "base/units.h"
#include "model/finish.h"

class QLineEdit;

namespace idap {

class MaterialList;

class MaterialPopup : public QFrame {
  Q_OBJECT
 public:
  MaterialPopup(const Finish& finish, const std::string& language, LengthUnit unit, const QString& plainWords,
                QWidget* parent);

 signals:
  void chosen(const idap::Finish& finish);
  void pictureRequested();
  void colorRequested();  // any colour, in a dialog

 private:
  void choose(const Finish& finish);
  QWidget* makeOptions();

  Finish finish_;
  LengthUnit unit_;
  QLineEdit* search_;
  MaterialList* list_;
};

}  // namespace idap
