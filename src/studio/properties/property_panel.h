// The right side of the window: what is selected, in numbers, finishes and words, to be changed there; of
// nothing selected, the home and the level.
#pragma once

#include <QWidget>
#include <memory>

#include "editor/editor.h"

namespace idap {

class PropertyPanel : public QWidget {
  Q_OBJECT
 public:
  explicit PropertyPanel(Editor& editor, QWidget* parent = nullptr);
  ~PropertyPanel() override;

  void focusFirst();  // the Property command: the keyboard goes to its first field

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
