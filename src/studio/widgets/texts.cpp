#include "studio/widgets/texts.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <cmath>
#include <numbers>

namespace idap {

QString translated(const char* english) { return QCoreApplication::translate("idap", english); }

QString translated(const Text& text) {
  QString words = translated(text.source.c_str());
  for (const std::string& argument : text.arguments) words = words.arg(toQt(argument));
  return words;
}

QString withoutKey(QString text) {
  static const QRegularExpression inBrackets(QStringLiteral("\\(&.\\)"));
  return text.remove(inBrackets).remove(QLatin1Char('&'));
}

QString lengthText(double metres, LengthUnit unit, int decimals) {
  return toQt(formatLength(metres, unit, decimals));
}

QString areaText(double squareMetres, LengthUnit unit) {
  if (unit != LengthUnit::FeetInches) return QString::number(squareMetres, 'f', 2) + QStringLiteral(" m²");
  return QString::number(squareMetres / (0.3048 * 0.3048), 'f', 1) + QStringLiteral(" sq ft");
}

QString angleText(double radians) {
  QString number = QString::number(radians * 180 / std::numbers::pi, 'f', 1);
  if (number.endsWith(QStringLiteral(".0"))) number.chop(2);
  if (number == QStringLiteral("-0")) number = QStringLiteral("0");
  return number + QStringLiteral("°");
}

}  // namespace idap
