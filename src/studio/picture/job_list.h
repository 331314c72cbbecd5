// The pictures being made: each with its progress, the time left, and pause, keep and remove.
#pragma once

#include <QWidget>

#include "studio/picture/picture_queue.h"

class QVBoxLayout;

namespace idap {

class JobList : public QWidget {
  Q_OBJECT
 public:
  explicit JobList(PictureQueue& queue, QWidget* parent = nullptr);

 signals:
  void looked(int id);  // its preview is asked for

 private:
  struct Row;
  void refresh();
  Row* makeRow(int id);

  PictureQueue& queue_;
  QVBoxLayout* column_;
  std::map<int, Row*> rows_;
};

}  // namespace idap
