#include "studio/window/theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyle>
#include <QStyleFactory>

namespace idap {

namespace {

struct Shades {
  const char *window, *base, *alternate, *text, *faint, *button, *bright, *mid, *dark, *accent, *onAccent,
      *tip, *link;
};
constexpr Shades kLight{"#f3f3f2", "#ffffff", "#f7f7f6", "#1e2124", "#6e7378", "#fafafa", "#ffffff",
                        "#c6c8ca", "#9a9da1", "#2a6fb0", "#ffffff", "#fffff0", "#1c5d9a"};
constexpr Shades kDark{"#2b2d30", "#1f2123", "#27292c", "#e6e7e8", "#9a9fa4", "#383b3f", "#4b4f54",
                       "#43464a", "#17181a", "#4c94d6", "#ffffff", "#3a3d41", "#7db8ee"};

QPalette paletteOf(const Shades& s) {
  QPalette palette;
  const auto set = [&palette](QPalette::ColorRole role, const char* colour) {
    palette.setColor(role, QColor(QLatin1String(colour)));
  };
  set(QPalette::Window, s.window);
  set(QPalette::Base, s.base);
  set(QPalette::AlternateBase, s.alternate);
  set(QPalette::WindowText, s.text);
  set(QPalette::Text, s.text);
  set(QPalette::ButtonText, s.text);
  set(QPalette::BrightText, s.onAccent);
  set(QPalette::PlaceholderText, s.faint);
  set(QPalette::Button, s.button);
  set(QPalette::Light, s.bright);
  set(QPalette::Midlight, s.button);
  set(QPalette::Mid, s.mid);
  set(QPalette::Dark, s.dark);
  set(QPalette::Shadow, "#000000");
  set(QPalette::Highlight, s.accent);
  set(QPalette::HighlightedText, s.onAccent);
  set(QPalette::ToolTipBase, s.tip);
  set(QPalette::ToolTipText, s.text);
  set(QPalette::Link, s.link);
  set(QPalette::LinkVisited, s.link);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, QColor(QLatin1String(s.faint)));
  palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(QLatin1String(s.mid)));
  return palette;
}

}  // namespace

void applyTheme(Preferences::Theme theme) {
  // One style on every desktop, so that the window looks as it was drawn and tested.
  if (QApplication::style()->name().compare(QLatin1String("fusion"), Qt::CaseInsensitive) != 0)
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  switch (theme) {
    case Preferences::Theme::Light:
      QApplication::setPalette(paletteOf(kLight));
      break;
    case Preferences::Theme::Dark:
      QApplication::setPalette(paletteOf(kDark));
      break;
    case Preferences::Theme::System: {
      // An unset palette is the desktop's; what it cannot say (no desktop at all) comes out light.
      QApplication::setPalette(QPalette());
      const QPalette desktop = QApplication::palette();
      const bool dark = desktop.color(QPalette::Window).lightness() < 128;
      QApplication::setPalette(paletteOf(dark ? kDark : kLight));
      break;
    }
  }
}

}  // namespace idap
