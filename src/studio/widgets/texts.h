// Texts of the Qt-free parts put into the user's language, and strings across the border to Qt.
#pragma once

#include <QString>
#include <string>
#include <string_view>

#include "base/translatable.h"
#include "base/units.h"

namespace idap {

// A text marked with QT_TRANSLATE_NOOP("idap", …), translated now. Widgets call it again on LanguageChange.
QString translated(const char* english);
QString translated(const Text& text);

// "Open…" of "&Open…" and "เปิด…" of "เปิด(&O)…": a menu's words without the key that takes it.
QString withoutKey(QString text);

inline QString toQt(std::string_view text) { return QString::fromUtf8(text.data(), qsizetype(text.size())); }
inline std::string fromQt(const QString& text) { return text.toStdString(); }

// "3.25 m", "12.40 m²" in the user's unit.
QString lengthText(double metres, LengthUnit unit, int decimals = -1);
QString areaText(double squareMetres, LengthUnit unit);
QString angleText(double radians);

}  // namespace idap
