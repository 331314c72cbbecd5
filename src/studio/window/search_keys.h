// Undo and redo mean the home, also while the keyboard is in a search field: who types "bed", presses Enter
// and then Ctrl+Z wants the bed gone, not the word.
#pragma once

#include <QObject>

class QWidget;

namespace idap {

class SearchKeys : public QObject {
  Q_OBJECT
 public:
  explicit SearchKeys(QObject* parent = nullptr) : QObject(parent) {}

  void watch(QWidget* panel);  // the search fields in it

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace idap
