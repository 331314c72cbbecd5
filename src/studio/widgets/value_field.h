// What all fields for one number share: a line that takes what people type, marks what it cannot understand
// and applies only what it can. LengthField, AngleField and NumberField are made of it.
#pragma once

#include <QLineEdit>

class QTimer;

namespace idap {

class ValueField : public QLineEdit {
  Q_OBJECT
 public:
  ~ValueField() override;

  double value() const { return value_; }
  // Shown, without a signal; what the user is just typing stays, and is measured against the new value.
  void setValue(double value);
  // Several values at once: empty, with words in place of a number. What is typed goes to all.
  void setMixed();
  bool mixed() const { return state_ == State::Mixed; }
  // No value at all; only of use with setOptional().
  void setNone();
  bool none() const { return state_ == State::None; }

  // Ends included; numbers outside are refused with words, steps stop there.
  void setRange(double min, double max);
  double minimum() const { return min_; }
  double maximum() const { return max_; }
  void setOptional(bool optional) { optional_ = optional; }  // an empty line means "none": cleared()
  void setStep(double step) { step_ = step; }  // 0: what suits the kind of value; Shift takes ten at once

  bool typing() const { return isModified() || stepping_; }
  QString problem() const { return problem_; }  // why the text cannot be applied; empty: it can
  // Applies what is typed, as Enter does; false where it cannot be.
  bool commit();
  void reset();  // forgets what is typed, as Escape does

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void valueChanged(double value);   // by the user: once a change, when it is applied
  void cleared();                    // by the user: none, where that is possible
  void valueTyped(double value);     // while typing, whenever it can be understood; not applied yet
  void valueStepping(double value);  // while the wheel or an arrow key turns it; valueChanged() follows

 protected:
  explicit ValueField(QWidget* parent);

  struct Reading {
    double value = 0;
    QString problem;  // in words; empty: understood
  };
  virtual Reading read(const QString& text) const = 0;
  virtual QString write(double value) const = 0;
  virtual double usualStep() const = 0;
  void showValue();  // again, after what write() depends on has changed

  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  enum class State { Value, Mixed, None };
  void onEdited();
  void stepBy(double steps);
  void mark(const QString& problem);
  Reading checked(const QString& text) const;
  void show(State state);

  double value_ = 0, min_, max_, step_ = 0;
  State state_ = State::Value;
  bool optional_ = false;
  bool held_ = false;      // the user is at it: from the first key to leaving the field
  bool stepping_ = false;  // turned, and not yet applied
  double stepped_ = 0;
  double wheel_ = 0;  // parts of a step that a fine wheel has gathered
  QString problem_;
  QTimer* rest_;  // a pause in stepping applies
};

}  // namespace idap
