// The light of the live view in one place: date, weather, exposure, and every lamp with its switch and
// dimmer.
#pragma once

#include <QFrame>

#include "editor/editor.h"

class QVBoxLayout;

namespace idap {

class View3d;

class LightPopup : public QFrame {
  Q_OBJECT
 public:
  LightPopup(Editor& editor, View3d& view, QWidget* parent);
  ~LightPopup() override;
  void showBelow(QWidget* button);

 private:
  void addLamps(QVBoxLayout* layout);
  void changeSite(const char* name, const std::function<void(Home&)>& change);
  void changeLamp(const char* name, FurnitureId id, const std::function<void(Lamp&)>& change, bool goesOn);
  void switchAll(bool on);
  void refresh();

  Editor& editor_;
  View3d& view_;
  int subscription_ = 0;
  bool dimming_ = false;  // a dimmer is held: one undo step
  std::vector<std::function<void()>> refreshers_;
};

}  // namespace idap
