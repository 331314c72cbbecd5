// What runs in the background, in the status bar: how far it is, how long it will take, and a button to stop
// it. Short jobs come and go unseen.
#pragma once

#include <QPointer>
#include <QWidget>

class QLabel;
class QProgressBar;
class QToolButton;

namespace idap {

class BackgroundJob;

class JobIndicator : public QWidget {
  Q_OBJECT
 public:
  explicit JobIndicator(QWidget* parent = nullptr);

  void follow(BackgroundJob* job);  // the newest of several is shown

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void refresh();

  QLabel* what_;
  QProgressBar* bar_;
  QToolButton* stop_;
  std::vector<QPointer<BackgroundJob>> jobs_;
};

// "45 s", "2 min", for the user.
QString timeLeftText(double seconds);

}  // namespace idap
