// The live view: the home traced as it is worked on. Look around, walk, circle; click a piece to select it,
// drag what is selected over floors and walls, drop furniture from the catalog.
#pragma once

#include <QImage>
#include <QWidget>
#include <memory>

#include "editor/finish_drag.h"
#include "scene/cut_away.h"

namespace idap {

struct LiveFrame;

class View3d : public QWidget {
  Q_OBJECT
 public:
  explicit View3d(Editor& editor, QWidget* parent = nullptr);
  ~View3d() override;

  const Camera& camera() const;
  void setCamera(const Camera& camera);
  enum class Manner { Walk, Orbit };
  Manner manner() const;
  void setManner(Manner manner);
  CutAway cutAway() const;
  void setCutAway(CutAway cut);
  bool stopsAtWalls() const;
  void setStopsAtWalls(bool stops);
  double compensation() const;  // stops
  void setCompensation(double stops);
  void setSamples(int samples);  // a pixel, of the finished view
  void seeWholeHome();           // from above and the front

  QImage picture() const;                           // of the newest frame; null before the first
  int samples() const;                              // of the newest frame; 0: coarse
  bool upToDate() const;                            // the newest frame shows what was last asked for
  std::optional<AnyId> at(QPoint pixel) const;      // the element seen there
  std::optional<Vec3> pointAt(QPoint pixel) const;  // world, m
  std::optional<ElementPart> partAt(QPoint pixel) const;

  QSize sizeHint() const override { return {480, 320}; }

 signals:
  void cameraMoved();  // by the user
  void frameShown(int samples, bool finished);
  void contextMenuRequested(QPoint global);
  void maximiseRequested();
  void failed(const QString& why);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragMoveEvent(QDragMoveEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
