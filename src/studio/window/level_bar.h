// The storeys of the home as tabs above the plan, from below, and a button that adds one.
#pragma once

#include <QWidget>
#include <vector>

#include "editor/editor.h"

class QTabBar;
class QToolButton;

namespace idap {

class LevelBar : public QWidget {
  Q_OBJECT
 public:
  explicit LevelBar(Editor& editor, QWidget* parent = nullptr);
  ~LevelBar() override;

 signals:
  void propertiesRequested();  // of the current level: a double click on its tab

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void fill();
  void retranslate();

  Editor& editor_;
  QTabBar* tabs_;
  QToolButton* add_;
  std::vector<LevelId> levels_;  // by tab
  std::vector<std::string> names_;
  bool filling_ = false;
  int subscription_;
};

}  // namespace idap
