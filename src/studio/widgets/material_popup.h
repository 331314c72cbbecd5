// What a MaterialPicker opens.
#pragma once

#include <QFrame>
#include <string>

#include "base/units.h"
#include "model/finish.h"

class QListView;
class QLineEdit;

namespace idap {

class MaterialPopup : public QFrame {
  Q_OBJECT
 public:
  MaterialPopup(const Finish& finish, const std::string& language, LengthUnit unit, const QString& plainWords,
                QWidget* parent);

  static QString groupName(const std::string& group);

 signals:
  void chosen(const idap::Finish& finish);
  void pictureRequested();
  void colorRequested();  // any colour, in a dialog

 private:
  void fill(const QString& query);
  void choose(const Finish& finish);
  QWidget* makeOptions();

  Finish finish_;
  std::string language_;
  LengthUnit unit_;
  QLineEdit* search_;
  QListView* list_;
};

}  // namespace idap
