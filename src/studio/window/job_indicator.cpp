#include "studio/window/job_indicator.h"

#include <QBoxLayout>
#include <QEvent>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <cmath>

#include "studio/widgets/background_job.h"

namespace idap {

QString timeLeftText(double seconds) {
  if (seconds < 90)
    return QCoreApplication::translate("idap::JobIndicator", "%1 s").arg(int(std::ceil(seconds)));
  return QCoreApplication::translate("idap::JobIndicator", "%1 min").arg(int(std::ceil(seconds / 60)));
}

JobIndicator::JobIndicator(QWidget* parent)
    : QWidget(parent), what_(new QLabel(this)), bar_(new QProgressBar(this)), stop_(new QToolButton(this)) {
  setObjectName(QStringLiteral("jobIndicator"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(what_);
  layout->addWidget(bar_);
  layout->addWidget(stop_);
  bar_->setTextVisible(false);
  bar_->setRange(0, 1000);
  bar_->setFixedWidth(8 * fontMetrics().height());
  bar_->setMaximumHeight(fontMetrics().height());
  stop_->setObjectName(QStringLiteral("cancelJob"));
  stop_->setAutoRaise(true);
  stop_->setText(QStringLiteral("✕"));
  connect(stop_, &QToolButton::clicked, this, [this] {
    if (!jobs_.empty() && jobs_.back()) jobs_.back()->cancel();
  });
  changeEvent(nullptr);
  hide();
}

void JobIndicator::follow(BackgroundJob* job) {
  jobs_.emplace_back(job);
  connect(job, &BackgroundJob::progressed, this, &JobIndicator::refresh);
  connect(job, &QObject::destroyed, this, &JobIndicator::refresh);
}

void JobIndicator::refresh() {
  std::erase_if(jobs_, [](const QPointer<BackgroundJob>& job) { return job.isNull(); });
  setVisible(!jobs_.empty());
  if (jobs_.empty()) return;
  const BackgroundJob& job = *jobs_.back();
  const auto left = job.secondsLeft();
  what_->setText(left ? job.what() + QStringLiteral(" · ") + tr("%1 left").arg(timeLeftText(*left))
                      : job.what());
  // Until something is known about the pace it only says that something goes on.
  bar_->setRange(0, job.fraction() > 0 ? 1000 : 0);
  bar_->setValue(int(job.fraction() * 1000));
  stop_->setVisible(job.cancellable());
}

void JobIndicator::changeEvent(QEvent* event) {
  if (!event || event->type() == QEvent::LanguageChange) {
    stop_->setToolTip(tr("Stop this"));
    stop_->setAccessibleName(tr("Stop"));
  }
  if (event) QWidget::changeEvent(event);
}

}  // namespace idap
