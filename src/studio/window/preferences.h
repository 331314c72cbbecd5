// What the user has chosen and what the program remembers between starts: how the editor works, language,
// theme, recent files, the window's layout. One object for all windows; kept in the user's configuration
// folder as soon as it changes.
#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>

#include "editor/settings.h"

namespace idap {

class Preferences : public QObject {
  Q_OBJECT
 public:
  Preferences();
  ~Preferences() override;

  const EditorSettings& editor() const { return editor_; }
  void setEditor(const EditorSettings& settings);

  enum class Theme { System, Light, Dark };
  Theme theme() const;
  void setTheme(Theme theme);

  // "en", "th"; at the first start that of the system, where the program speaks it.
  QString language() const { return QString::fromStdString(editor_.language); }

  // Absolute paths, the last used first, at most kRecent; those that are gone are left out.
  static constexpr int kRecent = 12;
  QStringList recentFiles() const;
  void addRecent(const QString& file);
  void removeRecent(const QString& file);

  // The window's state by name ("geometry", "docks", "planes").
  QByteArray layout(const char* name) const;
  void setLayout(const char* name, const QByteArray& state);

  QString lastFolder() const;  // of file dialogs
  void setLastFolder(const QString& folder);

 signals:
  void editorChanged();
  void themeChanged();
  void languageChanged();
  void recentChanged();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  EditorSettings editor_;
};

}  // namespace idap
