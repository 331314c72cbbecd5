// Everything a user does with files, and what is asked on the way: new, open, save, close, restore after a
// crash. Nothing blocks: questions are window-modal and go on where they were answered.
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <functional>

#include "model/import_report.h"
#include "studio/window/home_file.h"
#include "studio/window/preferences.h"
#include "studio/window/recovery.h"

class QMessageBox;

namespace idap {

class FileFlow : public QObject {
  Q_OBJECT
 public:
  FileFlow(Editor& editor, Preferences& preferences, QWidget* window);

  void newRoom(double x, double y, double z);  // m; asks about unsaved work first
  void startFromTemplate(const QString& file);
  void openDialog();
  void open(const QString& file);
  void save();
  void saveAs();
  void saveCompact();  // a copy without the files that nothing uses
  void closeHome();    // back to the welcome page
  // Calls then when nothing would be lost: at once, or after the user has saved or thrown it away. Waits for
  // a save that is under way.
  void whenSafe(std::function<void()> then);
  bool safe() const;    // nothing would be lost now
  void offerRestore();  // what was left by a program that stopped

  bool isOpen() const { return open_; }
  bool busy() const { return file_.busy(); }
  HomeFile& file() { return file_; }
  Recovery& recovery() { return recovery_; }
  QString title() const;  // "bedroom", "New home"

 signals:
  void jobStarted(idap::BackgroundJob* job);
  void openChanged();   // a home came or went
  void newHome();       // that has no furniture yet: time to furnish it
  void titleChanged();  // the name of the file
  void savedTo(const QString& file);

 private:
  void setOpen(bool open);
  void report(const QString& file, const ImportReport& report);
  void saveTo(const QString& file, bool evenIfChanged = false);
  void saveAsDialog(const QString& why);
  void ask(QMessageBox* box, std::function<void(int button)> answered);
  void afterSave(bool saved);

  Editor& editor_;
  Preferences& preferences_;
  QWidget* window_;
  HomeFile file_;
  Recovery recovery_;
  bool open_ = false;
  std::function<void()> afterSave_;  // waits for the save to end well
  QPointer<QMessageBox> question_;   // one at a time
  std::vector<Recovery::Found> left_;
  bool looked_ = false;
};

}  // namespace idap
