// What the program had to say, with the time, newest last.
#pragma once

#include <QWidget>

#include "editor/editor.h"

namespace idap {

class MessageList : public QWidget {
  Q_OBJECT
 public:
  explicit MessageList(Editor& editor, QWidget* parent = nullptr);
  ~MessageList() override;

 signals:
  void unseen(int warnings);  // how many warnings and errors came since it was last looked at

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
