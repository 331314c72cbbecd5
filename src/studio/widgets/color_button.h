// A button that shows a colour and opens a palette: colours of paints and cloths, the ones used last, a field
// for #rrggbb, and any other colour.
#pragma once

#include <QToolButton>
#include <optional>
#include <vector>

#include "model/finish.h"

namespace idap {

class ColorButton : public QToolButton {
  Q_OBJECT
 public:
  explicit ColorButton(QWidget* parent = nullptr);

  std::optional<Color> color() const { return color_; }
  void setColor(std::optional<Color> color);  // none shows as a struck field
  void setMixed();
  bool mixed() const { return mixed_; }
  // Whether "no colour of its own" can be chosen, and how that is called.
  void setOptional(bool optional, const QString& words = {});
  // In a popup, which would close over the dialog for any colour: dialogRequested() asks the owner for it.
  void setDialogElsewhere(bool elsewhere) { dialogElsewhere_ = elsewhere; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void colorChanged(std::optional<idap::Color> color);  // by the user, when it is chosen
  void colorChanging(idap::Color color);                // while it is looked for; colorChanged() or
                                                        // colorAbandoned() follows
  void colorAbandoned();
  void dialogRequested();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void openPalette();
  void openDialog();
  void choose(std::optional<Color> color);

  std::optional<Color> color_;
  bool mixed_ = false, optional_ = false, dialogElsewhere_ = false;
  QString noneWords_;
};

QColor toQt(const Color& color);
Color fromQt(const QColor& color);

// Newest first, kept between sessions.
std::vector<QColor> recentColors();
void rememberColor(const QColor& color);

// A colour in a frame that stands out from light and dark; none: struck through.
void paintSwatch(QPainter& painter, const QRectF& rect, const std::optional<QColor>& color,
                 const QPalette& palette);

}  // namespace idap
