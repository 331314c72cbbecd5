// A piece that is not in the home yet, traced live on a ground in the sun: dragging turns it, the wheel comes
// nearer.
#pragma once

#include <QLabel>
#include <memory>

#include "editor/editor.h"

namespace idap {

class LiveLink;

class ModelPreview : public QLabel {
  Q_OBJECT
 public:
  explicit ModelPreview(Editor& editor, QWidget* parent = nullptr);
  ~ModelPreview() override;

  void show(const Furniture& piece, std::shared_ptr<const Assets> assets);
  // Around the piece, radians; for tests and pictures.
  double turn() const { return turn_; }
  double tilt() const { return tilt_; }

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void look(double left, double down);
  void submit();

  Editor& editor_;
  std::unique_ptr<LiveLink> link_;
  Home home_;
  Vec3 size_{1, 1, 1};
  double turn_ = 0.55, tilt_ = 0.35, near_ = 1;
  QPointF at_;
};

}  // namespace idap
