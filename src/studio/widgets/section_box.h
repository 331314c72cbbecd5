// A titled part of a panel that folds away with a click on its title, and remembers that it did.
#pragma once

#include <QWidget>

class QToolButton;

namespace idap {

class SectionBox : public QWidget {
  Q_OBJECT
 public:
  // name: under which it is remembered whether the user folded it; empty: not remembered.
  explicit SectionBox(const QString& title = {}, const QString& name = {}, QWidget* parent = nullptr);

  QString title() const;
  void setTitle(const QString& title);
  bool isOpen() const;
  void setOpen(bool open);
  QWidget* body() const { return body_; }  // put a layout into it

 signals:
  void openChanged(bool open);

 private:
  QToolButton* head_;
  QWidget* body_;
  QString name_;
};

}  // namespace idap
