// The light of lamps.
#include <cmath>

#include "light/color_temperature.h"
#include "model/edits/piece_edits.h"
#include "studio/properties/sections.h"
#include "studio/widgets/color_button.h"
#include "studio/widgets/slider_field.h"

namespace idap {

namespace {

constexpr double kWarmest = 1800, kCoolest = 8000;  // K

QColor lightColor(double kelvin) {
  const Rgb light = rgbFromTemperature(kelvin);
  const float brightest = maxComponent(light);
  const auto channel = [&](float v) { return std::clamp(linearToSrgb(v / brightest), 0.0f, 1.0f); };
  return QColor::fromRgbF(channel(light.x), channel(light.y), channel(light.z));
}

// A strip of the colours that the slider above it runs through, with the chosen one marked.
class TemperatureStrip : public QWidget {
 public:
  explicit TemperatureStrip(QWidget* parent) : QWidget(parent) {
    setFixedHeight(fontMetrics().height());
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  }
  void setKelvin(std::optional<double> kelvin) {
    if (kelvin == kelvin_) return;
    kelvin_ = kelvin;
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    const int swatch = height() * 2;
    const QRectF strip(0, height() / 3.0, width() - swatch - height() / 2.0, height() / 3.0);
    QLinearGradient gradient(strip.topLeft(), strip.topRight());
    for (int i = 0; i <= 8; ++i)
      gradient.setColorAt(i / 8.0, lightColor(kWarmest + i / 8.0 * (kCoolest - kWarmest)));
    painter.fillRect(strip, gradient);
    const std::optional<QColor> chosen = kelvin_ ? std::optional(lightColor(*kelvin_)) : std::nullopt;
    paintSwatch(painter, QRectF(width() - swatch, 0, swatch, height()), chosen, palette());
    if (!kelvin_) return;
    const double share = std::clamp((*kelvin_ - kWarmest) / (kCoolest - kWarmest), 0.0, 1.0);
    painter.setPen(QPen(palette().color(QPalette::WindowText), 2));
    const double x = strip.left() + share * strip.width();
    painter.drawLine(QPointF(x, 1), QPointF(x, height() - 1));
  }

 private:
  std::optional<double> kelvin_;
};

class LampSection : public Section {
 public:
  LampSection(PanelLink& link, QWidget* parent)
      : Section(link, "lampSection", QT_TRANSLATE_NOOP("idap", "Light"), parent) {
    const auto change = [](const Home& home, const Elements& e, const std::function<void(Lamp&)>& f) {
      return changeFurniture(home, e, [&](Furniture& piece) {
        if (piece.lamp) f(*piece.lamp);
      });
    };
    addCheck(
        {"lampOn", QT_TRANSLATE_NOOP("idap", "Switched on"), QT_TRANSLATE_NOOP("idap", "Switch lamp"),
         QT_TRANSLATE_NOOP("idap", "Whether it shines in pictures.")},
        [](const Selected& s) { return s.ofLamps([](const Lamp& l) { return l.on; }); },
        [change](const Home& home, const Elements& e, bool on) {
          return change(home, e, [on](Lamp& l) { l.on = on; });
        });
    addNumber(
        {"lampLumens", QT_TRANSLATE_NOOP("idap", "Brightness"),
         QT_TRANSLATE_NOOP("idap", "Change brightness"),
         QT_TRANSLATE_NOOP("idap",
                           "Light of all its bulbs in lumens: an old 60 W bulb gives 800, a "
                           "reading lamp 450, a ceiling lamp 2000.")},
        QStringLiteral(" lm"), 0,
        [](const Selected& s) { return s.ofLamps([](const Lamp& l) { return l.lumens; }); },
        [change](const Home& home, const Elements& e, double lumens) {
          return change(home, e, [lumens](Lamp& l) { l.lumens = lumens; });
        },
        [](const Selected&) { return std::pair(0.0, 1e6); })
        ->setStep(50);
    addSlider(
        {"lampDimmer", QT_TRANSLATE_NOOP("idap", "Dimmer"), QT_TRANSLATE_NOOP("idap", "Dim lamp"),
         QT_TRANSLATE_NOOP("idap", "How much of its light is on.")},
        0, 100, 1, QStringLiteral(" %"),
        [](const Selected& s) {
          return s.ofLamps([](const Lamp& l) { return std::optional(100 * l.dimmer); });
        },
        [change](const Home& home, const Elements& e, double percent) {
          return change(home, e, [percent](Lamp& l) { l.dimmer = percent / 100; });
        });
    addSlider(
        {"lampTemperature", QT_TRANSLATE_NOOP("idap", "Colour"),
         QT_TRANSLATE_NOOP("idap", "Change colour of light"),
         QT_TRANSLATE_NOOP("idap",
                           "Colour temperature: 1800 K candle, 2700 K warm white, 4000 K "
                           "neutral, 6500 K daylight.")},
        kWarmest, kCoolest, 100, QStringLiteral(" K"),
        [](const Selected& s) {
          return s.ofLamps([](const Lamp& l) {
            return std::optional(std::clamp(l.colorTemperature, kWarmest, kCoolest));
          });
        },
        [change](const Home& home, const Elements& e, double kelvin) {
          return change(home, e, [kelvin](Lamp& l) {
            l.colorTemperature = kelvin;
            l.color.reset();
          });
        });
    auto* strip = new TemperatureStrip(body());
    form()->addRow(strip);
    onRefresh([strip](const Selected& s) {
      const auto kelvin = s.ofLamps([](const Lamp& l) { return l.colorTemperature; });
      strip->setKelvin(kelvin.any && !kelvin.mixed ? std::optional(kelvin.value) : std::nullopt);
    });
    addColor(
        {"lampColor", QT_TRANSLATE_NOOP("idap", "Tint"), QT_TRANSLATE_NOOP("idap", "Change tint of light"),
         QT_TRANSLATE_NOOP("idap", "A colour in place of the colour temperature, for coloured lamps.")},
        QT_TRANSLATE_NOOP("idap", "None: white light"),
        [](const Selected& s) { return s.ofLamps([](const Lamp& l) { return l.color; }); },
        [change](const Home& home, const Elements& e, const std::optional<Color>& color) {
          return change(home, e, [&color](Lamp& l) { l.color = color; });
        });
    addNumber(
        {"lampBeam", QT_TRANSLATE_NOOP("idap", "Beam"), QT_TRANSLATE_NOOP("idap", "Change beam"),
         QT_TRANSLATE_NOOP("idap", "Full angle of a spot that shines down; 0: it shines all around.")},
        QStringLiteral("°"), 1,
        [](const Selected& s) { return s.ofLamps([](const Lamp& l) { return degrees(l.beamAngle); }); },
        [change](const Home& home, const Elements& e, double angle) {
          return change(home, e, [angle](Lamp& l) { l.beamAngle = radians(angle); });
        },
        [](const Selected&) { return std::pair(0.0, 360.0); });
  }
};

}  // namespace

SectionEntry lampSection() {
  return {[](const Selected& s) {
            return (s.kind == ElementKind::Piece || s.kind == ElementKind::Group) &&
                   s.ofLamps([](const Lamp& l) { return l.on; }).any;
          },
          [](PanelLink& link, QWidget* parent) -> Section* { return new LampSection(link, parent); }};
}

}  // namespace idap
