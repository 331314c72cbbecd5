// One picture, or two in the same place with a divider between them: drag it, or move it with the arrow keys.
#pragma once

#include <QImage>
#include <QWidget>

namespace idap {

class CompareView : public QWidget {
  Q_OBJECT
 public:
  explicit CompareView(QWidget* parent = nullptr);

  void show(const QImage& picture, const QString& name);
  // left is seen left of the divider, right on its other side.
  void compare(const QImage& left, const QString& leftName, const QImage& right, const QString& rightName);
  bool comparing() const { return !other_.isNull(); }
  const QImage& picture() const { return picture_; }
  double divider() const { return divider_; }  // 0 at the left edge of the pictures, 1 at their right
  void setDivider(double at);

  QSize sizeHint() const override { return {640, 420}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QRectF place(const QImage& picture) const;

  QImage picture_, other_;
  QString name_, otherName_;
  double divider_ = 0.5;
};

}  // namespace idap
