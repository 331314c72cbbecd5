// Asks for the size of a new room along X, Y and Z, and shows it drawn while the numbers are typed.
#pragma once

#include <QWidget>
#include <array>

#include "base/units.h"

class QLabel;
class QPushButton;

namespace idap {

class LengthField;
class RoomSketch;

class NewRoomForm : public QWidget {
  Q_OBJECT
 public:
  explicit NewRoomForm(LengthUnit unit, QWidget* parent = nullptr);

  void setUnit(LengthUnit unit);
  void focusFirst();

 signals:
  void started(double x, double y, double z);  // m, clear sizes

 protected:
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void retranslate();
  void draw();
  void start();

  LengthUnit unit_;
  std::array<LengthField*, 3> fields_{};
  std::array<QLabel*, 3> labels_{};
  RoomSketch* sketch_;
  QPushButton* start_ = nullptr;
};

}  // namespace idap
