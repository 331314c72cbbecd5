#include "studio/widgets/icons.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>
#include <QToolButton>

#include "base/data_path.h"

namespace idap {

namespace {

class LineArtEngine : public QIconEngine {
 public:
  explicit LineArtEngine(QByteArray svg) : svg_(std::move(svg)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    QByteArray drawing = svg_;
    drawing.replace("currentColor",
                    QApplication::palette().color(group, QPalette::WindowText).name().toLatin1());
    QSvgRenderer renderer(drawing);
    renderer.render(painter, QRectF(rect));
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap picture(size);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return picture;
  }
  QIconEngine* clone() const override { return new LineArtEngine(svg_); }

 private:
  QByteArray svg_;
};

}  // namespace

QIcon icon(const char* name) {
  QFile file(QString::fromStdString((dataFolder() / "icons" / (std::string(name) + ".svg")).string()));
  if (!file.open(QIODevice::ReadOnly)) return {};
  return QIcon(new LineArtEngine(file.readAll()));
}

QToolButton* toolButton(const char* iconName, const char* objectName, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setObjectName(QLatin1String(objectName));
  button->setIcon(icon(iconName));
  button->setAutoRaise(true);
  return button;
}

}  // namespace idap
