#include "studio/window/preferences.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QSettings>
#include <QStandardPaths>

#include "studio/window/language.h"

namespace idap {

struct Preferences::Impl {
  QSettings store{QSettings::IniFormat, QSettings::UserScope, QStringLiteral("idap"),
                  QStringLiteral("studio")};
};

namespace {

struct UnitName {
  LengthUnit unit;
  const char* name;
};
constexpr UnitName kUnits[] = {{LengthUnit::Metre, "m"},
                               {LengthUnit::Centimetre, "cm"},
                               {LengthUnit::Millimetre, "mm"},
                               {LengthUnit::FeetInches, "ft-in"}};

// One place says under which key each setting is kept: f(key, member).
template <class Settings, class F>
void forEachSwitch(Settings& s, F&& f) {
  f("snapping", s.snapping);
  f("grid-snapping", s.gridSnapping);
  f("grid-shown", s.gridShown);
  f("rulers-shown", s.rulersShown);
  f("base-locked", s.baseLocked);
  f("level-below-shown", s.levelBelowShown);
  f("room-areas", s.roomAreas);
}
template <class Settings, class F>
void forEachLength(Settings& s, F&& f) {
  f("wall-thickness", s.wallThickness, 0.01, 2.0);
  f("wall-height", s.wallHeight, 0.0, 50.0);
}

QString key(const char* name) { return QStringLiteral("editor/") + QLatin1String(name); }

}  // namespace

Preferences::Preferences() : impl_(std::make_unique<Impl>()) {
  const QSettings& store = impl_->store;
  forEachSwitch(editor_,
                [&](const char* name, bool& value) { value = store.value(key(name), value).toBool(); });
  forEachLength(editor_, [&](const char* name, double& value, double least, double most) {
    const double kept = store.value(key(name), value).toDouble();
    if (kept >= least && kept <= most) value = kept;  // false for what is not a number
  });
  editor_.wallPattern = store.value(key("wall-pattern")).toString().toStdString();
  const QString unit = store.value(key("unit")).toString();
  for (const UnitName& known : kUnits)
    if (unit == QLatin1String(known.name)) editor_.unit = known.unit;
  const bool imperial = QLocale::system().measurementSystem() == QLocale::ImperialUSSystem;
  // "C" is what a machine without a language says: no reason for feet.
  if (unit.isEmpty() && imperial && QLocale::system().language() != QLocale::C)
    editor_.unit = LengthUnit::FeetInches;
  QString language = store.value(QStringLiteral("language")).toString();
  if (language.isEmpty()) language = QLocale::system().name().section(QLatin1Char('_'), 0, 0);
  editor_.language = languageOrEnglish(language).toStdString();
}

Preferences::~Preferences() = default;

void Preferences::setEditor(const EditorSettings& settings) {
  if (settings == editor_) return;
  const bool newLanguage = settings.language != editor_.language;
  editor_ = settings;
  QSettings& store = impl_->store;
  forEachSwitch(editor_, [&](const char* name, bool value) { store.setValue(key(name), value); });
  forEachLength(editor_,
                [&](const char* name, double value, double, double) { store.setValue(key(name), value); });
  store.setValue(key("wall-pattern"), QString::fromStdString(editor_.wallPattern));
  for (const UnitName& known : kUnits)
    if (editor_.unit == known.unit) store.setValue(key("unit"), QLatin1String(known.name));
  store.setValue(QStringLiteral("language"), language());
  if (newLanguage) emit languageChanged();
  emit editorChanged();
}

Preferences::Theme Preferences::theme() const {
  const QString name = impl_->store.value(QStringLiteral("theme")).toString();
  return name == QLatin1String("light")  ? Theme::Light
         : name == QLatin1String("dark") ? Theme::Dark
                                         : Theme::System;
}

void Preferences::setTheme(Theme chosen) {
  if (chosen == theme()) return;
  const char* names[] = {"system", "light", "dark"};
  impl_->store.setValue(QStringLiteral("theme"), QLatin1String(names[int(chosen)]));
  emit themeChanged();
}

QStringList Preferences::recentFiles() const {
  QStringList files = impl_->store.value(QStringLiteral("recent")).toStringList();
  files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
  return files;
}

void Preferences::addRecent(const QString& file) {
  QStringList files = recentFiles();
  const QString absolute = QFileInfo(file).absoluteFilePath();
  files.removeAll(absolute);
  files.prepend(absolute);
  while (files.size() > kRecent) files.removeLast();
  impl_->store.setValue(QStringLiteral("recent"), files);
  emit recentChanged();
}

void Preferences::removeRecent(const QString& file) {
  QStringList files = recentFiles();
  if (files.removeAll(file) == 0) return;
  impl_->store.setValue(QStringLiteral("recent"), files);
  emit recentChanged();
}

QByteArray Preferences::layout(const char* name) const {
  return impl_->store.value(QStringLiteral("layout/") + QLatin1String(name)).toByteArray();
}

void Preferences::setLayout(const char* name, const QByteArray& state) {
  impl_->store.setValue(QStringLiteral("layout/") + QLatin1String(name), state);
}

QString Preferences::lastFolder() const {
  const QString folder = impl_->store.value(QStringLiteral("folder")).toString();
  if (!folder.isEmpty() && QDir(folder).exists()) return folder;
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return QDir(documents).exists() ? documents : QDir::homePath();
}

void Preferences::setLastFolder(const QString& folder) {
  impl_->store.setValue(QStringLiteral("folder"), folder);
}

}  // namespace idap
