// The middle of the window: the plan X-Y, the elevations X-Z and Y-Z and the live view, beside each other or
// one of them alone. A traced picture takes the live view's place until one goes back.
#pragma once

#include <QWidget>
#include <array>

#include "editor/editor.h"

class QSplitter;
class QStackedWidget;

namespace idap {

class LivePanel;
class PicturePanel;
class PlanView;

class ViewArea : public QWidget {
  Q_OBJECT
 public:
  explicit ViewArea(Editor& editor, QWidget* parent = nullptr);

  static constexpr int kViews = 4;  // the planes in the order of kPlanes, then the live view

  PlanView& plan(Plane plane) const { return *plans_[std::size_t(plane)]; }
  LivePanel& live() const { return *live_; }
  PicturePanel& picture() const { return *picture_; }
  bool pictureShown() const;
  void showPicture(bool picture);  // in the live view's place, or the live view again
  QWidget* view(int index) const;

  // The plane that the keyboard or the pointer was in last: zoom commands are meant for it.
  PlanView& current() const { return *plans_[current_]; }
  int currentView() const;  // its index; that of the picture where this has the focus

  // One view alone, or (none) all of them.
  static constexpr int kAll = -1;
  void maximise(int index);
  void toggle(int index);
  int maximised() const { return maximised_; }

  QByteArray saveState() const;
  void restoreState(const QByteArray& state);
  void zoomAllToFit();

 signals:
  void pointerAt(idap::Plane plane, double u, double v);
  void pointerLeft();
  void contextMenuRequested(QPoint global);
  void maximisedChanged(int index);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QSplitter *across_, *column_;
  std::array<PlanView*, 3> plans_{};
  QStackedWidget* seen_;
  LivePanel* live_;
  PicturePanel* picture_;
  std::size_t current_ = 0;
  int maximised_ = kAll;
};

}  // namespace idap
