// Fields for words that are applied when they are finished: Enter (Control+Enter where a line break is
// possible) or leaving the field applies, Escape takes back.
#pragma once

#include <QLineEdit>
#include <QPlainTextEdit>

namespace idap {

class TextField : public QLineEdit {
  Q_OBJECT
 public:
  explicit TextField(QWidget* parent = nullptr);

  QString value() const { return value_; }
  void setValue(const QString& value);  // what the user is just typing stays
  void setMixed();
  bool mixed() const { return mixed_; }
  bool typing() const { return isModified(); }
  bool commit();
  void reset();

  QSize minimumSizeHint() const override;

 signals:
  void valueChanged(QString value);  // by the user, when it is applied

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QString value_;
  bool mixed_ = false;
};

class TextArea : public QPlainTextEdit {
  Q_OBJECT
 public:
  explicit TextArea(QWidget* parent = nullptr);

  QString value() const { return value_; }
  void setValue(const QString& value);
  void setMixed();
  bool mixed() const { return mixed_; }
  bool typing() const;
  void commit();
  void reset();
  void setLines(int lines) { lines_ = lines; }  // how high it wants to be

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void valueChanged(QString value);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QString value_;
  bool mixed_ = false;
  int lines_ = 3;
};

}  // namespace idap
