// The traced picture on the screen: as large as fits, in its own proportions.
#pragma once

#include <QImage>
#include <QWidget>

namespace idap {

class PictureCanvas : public QWidget {
  Q_OBJECT
 public:
  explicit PictureCanvas(QWidget* parent = nullptr);

  void setPicture(const QImage& picture);  // a null one clears
  const QImage& picture() const { return picture_; }
  QSize pixels() const;  // of the screen, that a picture made for this canvas has; never empty

  QSize sizeHint() const override { return {480, 320}; }

 signals:
  void doubleClicked();
  void resized();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QImage picture_;
};

}  // namespace idap
