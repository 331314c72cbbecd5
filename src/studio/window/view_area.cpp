#include "studio/window/view_area.h"

#include <QApplication>
#include <QBoxLayout>
#include <QDataStream>
#include <QEvent>
#include <QSplitter>
#include <QStackedWidget>

#include "studio/picture/picture_panel.h"
#include "studio/plan/plan_view.h"
#include "studio/view3d/live_panel.h"
#include "studio/view3d/view3d.h"

namespace idap {

ViewArea::ViewArea(Editor& editor, QWidget* parent)
    : QWidget(parent),
      across_(new QSplitter(Qt::Horizontal, this)),
      column_(new QSplitter(Qt::Vertical)),
      seen_(new QStackedWidget),
      live_(new LivePanel(editor)),
      picture_(new PicturePanel(editor)) {
  setObjectName(QStringLiteral("viewArea"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(across_);
  const char* names[] = {"planXY", "planXZ", "planYZ"};
  for (const Plane plane : kPlanes) {
    const auto i = std::size_t(plane);
    plans_[i] = new PlanView(editor, plane, nullptr);
    plans_[i]->setObjectName(QLatin1String(names[i]));
    plans_[i]->setMinimumSize(80, 60);
  }
  live_->setObjectName(QStringLiteral("livePanel"));
  picture_->setObjectName(QStringLiteral("picturePanel"));
  seen_->addWidget(live_);
  seen_->addWidget(picture_);
  seen_->setMinimumSize(80, 60);
  across_->addWidget(plans_[0]);
  across_->addWidget(column_);
  column_->addWidget(plans_[1]);
  column_->addWidget(plans_[2]);
  column_->addWidget(seen_);
  across_->setStretchFactor(0, 3);
  across_->setStretchFactor(1, 2);
  across_->setSizes({600, 330});
  column_->setSizes({200, 200, 240});
  for (QSplitter* splitter : {across_, column_}) splitter->setChildrenCollapsible(false);

  for (int i = 0; i < kViews; ++i) view(i)->installEventFilter(this);
  for (const Plane plane : kPlanes) {
    PlanView* view = plans_[std::size_t(plane)];
    connect(view, &PlanView::pointerAt, this, [this, plane](double u, double v) {
      current_ = std::size_t(plane);
      emit pointerAt(plane, u, v);
    });
    connect(view, &PlanView::pointerLeft, this, &ViewArea::pointerLeft);
    connect(view, &PlanView::contextMenuRequested, this, &ViewArea::contextMenuRequested);
    connect(view, &PlanView::maximiseRequested, this, [this, plane] { toggle(int(plane)); });
  }
  connect(picture_, &PicturePanel::maximiseRequested, this, [this] { toggle(3); });
  connect(picture_, &PicturePanel::closed, this, [this] { showPicture(false); });
  connect(live_, &LivePanel::maximiseRequested, this, [this] { toggle(3); });
  connect(live_, &LivePanel::contextMenuRequested, this, &ViewArea::contextMenuRequested);
}

QWidget* ViewArea::view(int index) const {
  if (index == 3) return seen_;
  return plans_[std::size_t(index)];
}

int ViewArea::currentView() const {
  if (maximised_ != kAll) return maximised_;
  const QWidget* focus = QApplication::focusWidget();
  return focus && (focus == seen_ || seen_->isAncestorOf(focus)) ? 3 : int(current_);
}

void ViewArea::maximise(int index) {
  if (index == maximised_) return;
  maximised_ = index;
  for (int i = 0; i < kViews; ++i) view(i)->setVisible(index == kAll || index == i);
  column_->setVisible(index != 0);
  if (index != kAll) view(index)->setFocus(Qt::OtherFocusReason);
  emit maximisedChanged(index);
}

bool ViewArea::pictureShown() const { return seen_->currentIndex() == 1; }
void ViewArea::showPicture(bool picture) { seen_->setCurrentIndex(picture ? 1 : 0); }

void ViewArea::toggle(int index) { maximise(maximised_ == kAll ? index : kAll); }

QByteArray ViewArea::saveState() const {
  QByteArray state;
  QDataStream stream(&state, QIODevice::WriteOnly);
  stream << qint32(1) << across_->saveState() << column_->saveState();
  return state;
}

void ViewArea::restoreState(const QByteArray& state) {
  QDataStream stream(state);
  qint32 version = 0;
  QByteArray across, column;
  stream >> version >> across >> column;
  if (stream.status() != QDataStream::Ok || version != 1) return;
  across_->restoreState(across);
  column_->restoreState(column);
}

void ViewArea::zoomAllToFit() {
  for (PlanView* plan : plans_) plan->zoomToFit();
}

bool ViewArea::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusIn)
    for (std::size_t i = 0; i < plans_.size(); ++i)
      if (watched == plans_[i]) current_ = i;
  return QWidget::eventFilter(watched, event);
}

}  // namespace idap
