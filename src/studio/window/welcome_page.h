// What is seen when nothing is open: a new room, templates, recent homes, opening a file.
#pragma once

#include <QWidget>

#include "studio/window/preferences.h"

class QLabel;
class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace idap {

class NewRoomForm;

// A home to start from, of share/templates/index.json.
struct HomeTemplate {
  QString file, picture;  // absolute
  QString name;           // in a language
};
std::vector<HomeTemplate> homeTemplates(const QString& language);

class WelcomePage : public QWidget {
  Q_OBJECT
 public:
  explicit WelcomePage(Preferences& preferences, QWidget* parent = nullptr);

  void focusFirst();

 signals:
  void roomRequested(double x, double y, double z);  // m
  void templateChosen(const QString& file);
  void fileChosen(const QString& file);
  void openRequested();

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void retranslate();
  void fillTemplates();
  void fillRecent();

  Preferences& preferences_;
  QLabel *title_, *motto_, *roomTitle_, *templatesTitle_, *recentTitle_, *noRecent_;
  NewRoomForm* room_;
  QListWidget *templates_, *recent_;
  QPushButton* open_;
};

}  // namespace idap
