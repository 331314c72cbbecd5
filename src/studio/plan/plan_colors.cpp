#include "studio/plan/plan_colors.h"

#include <algorithm>

namespace idap {

namespace {

double lightness(const QColor& c) { return 0.2126 * c.redF() + 0.7152 * c.greenF() + 0.0722 * c.blueF(); }

}  // namespace

QColor mixed(const QColor& a, const QColor& b, double t) {
  const auto mix = [t](float x, float y) { return float(x + (y - x) * t); };
  return QColor::fromRgbF(mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()), mix(a.blueF(), b.blueF()));
}

PlanColors::PlanColors(const QPalette& palette)
    : paper(palette.color(QPalette::Base)),
      ink(palette.color(QPalette::Text)),
      accent(palette.color(QPalette::Highlight)),
      onAccent(palette.color(QPalette::HighlightedText)) {
  dark = lightness(paper) < lightness(ink);
  soft = mixed(paper, ink, 0.66);
  faint = mixed(paper, ink, dark ? 0.34 : 0.3);
  grid = mixed(paper, ink, dark ? 0.07 : 0.06);
  gridStrong = mixed(paper, ink, dark ? 0.15 : 0.14);
  wall = mixed(paper, ink, dark ? 0.72 : 0.74);
  wallPale = mixed(paper, ink, dark ? 0.16 : 0.1);
  floor = mixed(paper, dark ? QColor(190, 180, 160) : QColor(214, 200, 170), dark ? 0.12 : 0.28);
  guide = dark ? QColor(255, 140, 200) : QColor(205, 20, 120);
  wrong = dark ? QColor(255, 110, 100) : QColor(200, 30, 20);
  // A highlight that would drown in the paper (some themes select in grey) gives way to a blue.
  if (accent.saturationF() < 0.2f || std::abs(lightness(accent) - lightness(paper)) < 0.15) {
    accent = dark ? QColor(90, 170, 255) : QColor(20, 100, 210);
    onAccent = dark ? QColor(Qt::black) : QColor(Qt::white);
  }
}

PlanColors PlanColors::forPrint() {
  QPalette palette;
  palette.setColor(QPalette::Base, Qt::white);
  palette.setColor(QPalette::Text, Qt::black);
  palette.setColor(QPalette::Highlight, QColor(20, 100, 210));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  return PlanColors(palette);
}

QColor PlanColors::wash(const Color& color, double strength) const {
  const QColor own = QColor::fromRgbF(std::clamp(color.r, 0.f, 1.f), std::clamp(color.g, 0.f, 1.f),
                                      std::clamp(color.b, 0.f, 1.f));
  return mixed(paper, own, strength);
}

QColor PlanColors::readable(const Color& color) const {
  QColor own = QColor::fromRgbF(std::clamp(color.r, 0.f, 1.f), std::clamp(color.g, 0.f, 1.f),
                                std::clamp(color.b, 0.f, 1.f));
  const double distance = std::abs(lightness(own) - lightness(paper));
  constexpr double kEnough = 0.35;
  return distance >= kEnough ? own : mixed(own, ink, std::min(1.0, (kEnough - distance) / kEnough + 0.35));
}

}  // namespace idap
