#include "studio/picture/job_list.h"

#include <QProgressBar>
#include <QTime>
#include <QToolButton>
#include <cmath>

#include "studio/widgets/icons.h"
#include "studio/widgets/texts.h"

namespace idap {

struct JobList::Row : public QWidget {
  using QWidget::QWidget;
  QPushButton* name = nullptr;
  QProgressBar* bar = nullptr;
  QLabel* left = nullptr;
  QToolButton *pause = nullptr, *keep = nullptr, *remove = nullptr;
};

JobList::JobList(PictureQueue& queue, QWidget* parent)
    : QWidget(parent), queue_(queue), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(2);
  connect(&queue, &PictureQueue::changed, this, [this] { refresh(); });
  refresh();
}

JobList::Row* JobList::makeRow(int id) {
  auto* row = new Row(this);
  auto* across = new QHBoxLayout(row);
  across->setContentsMargins(0, 0, 0, 0);
  row->name = new QPushButton(row);
  row->name->setFlat(true);
  row->name->setStyleSheet(QStringLiteral("text-align: left; padding: 2px 4px;"));
  row->name->setMinimumWidth(10 * fontMetrics().averageCharWidth());
  row->bar = new QProgressBar(row);
  row->bar->setObjectName(QStringLiteral("jobProgress"));
  row->bar->setTextVisible(false);
  row->bar->setMaximumHeight(fontMetrics().height() / 2 + 3);
  row->left = new QLabel(row);
  row->left->setObjectName(QStringLiteral("jobLeft"));
  row->left->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("00:00:00 xxxxx")));
  row->pause = toolButton("pause", "jobPause", row);
  row->pause->setCheckable(true);
  row->keep = toolButton("stop", "jobKeep", row);
  row->remove = toolButton("close", "jobRemove", row);
  row->name->setToolTip(tr("Look at it while it is made"));
  row->pause->setToolTip(tr("Pause, and go on"));
  row->keep->setToolTip(tr("Stop here and keep the picture as it is"));
  row->remove->setToolTip(tr("Give this picture up"));
  across->addWidget(row->name, 2);
  across->addWidget(row->bar, 3);
  across->addWidget(row->left);
  for (QToolButton* button : {row->pause, row->keep, row->remove}) across->addWidget(button);
  connect(row->name, &QPushButton::clicked, this, [this, id] { emit looked(id); });
  connect(row->pause, &QToolButton::clicked, this, [this, id](bool on) { queue_.pause(id, on); });
  connect(row->keep, &QToolButton::clicked, this, [this, id] { queue_.stopAndKeep(id); });
  connect(row->remove, &QToolButton::clicked, this, [this, id] { queue_.remove(id); });
  column_->addWidget(row);
  return row;
}

void JobList::refresh() {
  std::erase_if(rows_, [this](const auto& entry) {
    if (queue_.find(entry.first)) return false;
    entry.second->hide();
    entry.second->deleteLater();  // its button may be what asked for this
    return true;
  });
  for (const PictureQueue::Job& job : queue_.jobs()) {
    Row*& row = rows_[job.id];
    if (!row) row = makeRow(job.id);
    using State = PictureQueue::Job::State;
    row->name->setText(fontMetrics().elidedText(toQt(job.name), Qt::ElideRight, 160));
    const bool unknown = job.state == State::Tracing && job.secondsLeft < 0;
    row->bar->setRange(0, unknown ? 0 : 1000);
    row->bar->setValue(job.state == State::Waiting ? 0 : int(job.fraction * 1000));
    const int left = int(std::ceil(job.secondsLeft));
    const QString clock = left >= 3600
                              ? QTime(0, 0).addSecs(left).toString(QStringLiteral("h:mm:ss"))
                              : QTime(0, 0).addSecs(std::max(0, left)).toString(QStringLiteral("m:ss"));
    row->left->setText(job.state == State::Waiting   ? tr("waiting")
                       : job.state == State::Paused  ? tr("paused")
                       : job.state == State::Keeping ? tr("keeping…")
                       : unknown                     ? tr("preparing…")
                                                     : tr("%1 left").arg(clock));
    const bool running = job.state == State::Tracing || job.state == State::Paused;
    row->pause->setEnabled(running);
    row->pause->setChecked(job.state == State::Paused);
    row->keep->setEnabled(running && !job.preview.isNull());
    row->remove->setEnabled(job.state != State::Keeping);
  }
  setVisible(!rows_.empty());
}

}  // namespace idap
