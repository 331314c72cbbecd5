// One of the three planes on the screen: draws the home, takes the pointer and keys to the tool in hand, pans
// and zooms.
#pragma once

#include <QWidget>
#include <memory>

#include "editor/editor.h"

namespace idap {

class PlanView : public QWidget {
  Q_OBJECT
 public:
  PlanView(Editor& editor, Plane plane, QWidget* parent = nullptr);
  ~PlanView() override;

  Plane plane() const;
  double pixel() const;  // m that one logical pixel covers
  Vec2 toPlane(QPointF view) const;
  QPointF toView(Vec2 plane) const;

  void zoomToFit();  // all that is drawn; an empty home shows 10 m
  void zoomToSelection();
  void zoomBy(double factor);  // about the middle; > 1 nearer
  void centreOn(Vec2 at);

  // The drawing without selection, handles, grid and rulers, of an area of the plane at a scale: for
  // printing. dpi of the device.
  void drawTo(QPainter& painter, const QRectF& target, const Box2& area) const;
  Box2 drawnBox() const;  // what zoomToFit shows

  // Nothing is left to be painted, and no symbol is still being made: for pictures and tests.
  bool settled() const;

 signals:
  void pointerAt(double u, double v);  // m; for the status bar
  void pointerLeft();
  void maximiseRequested();  // a double click on its caption
  void contextMenuRequested(QPoint global);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragMoveEvent(QDragMoveEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
