#include "studio/catalog/chip_row.h"

#include <QToolButton>

namespace idap {

namespace {

constexpr int kLines = 2;
constexpr int kGap = 3;

}  // namespace

ChipRow::ChipRow(QWidget* parent) : QWidget(parent) {
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void ChipRow::setChips(std::vector<Chip> chips, const std::set<std::string>& on) {
  if (chips == chips_ && on == on_) return;
  on_ = on;
  if (chips != chips_) {
    chips_ = std::move(chips);
    for (QToolButton* button : buttons_) {
      button->hide();
      button->deleteLater();
    }
    buttons_.clear();
    for (const Chip& chip : chips_) {
      auto* button = new QToolButton(this);
      button->setObjectName(QStringLiteral("tag:") + QString::fromStdString(chip.id));
      button->setText(chip.text);
      button->setCheckable(true);
      button->setAutoRaise(false);
      button->setToolTip(tr("Show only pieces tagged “%1”").arg(chip.text));
      connect(button, &QToolButton::toggled, this, [this, id = chip.id](bool checked) {
        if (checked ? on_.insert(id).second : on_.erase(id) > 0) emit changed();
      });
      buttons_.push_back(button);
    }
  }
  for (std::size_t i = 0; i < chips_.size(); ++i) {
    const QSignalBlocker quiet(buttons_[i]);
    buttons_[i]->setChecked(on_.contains(chips_[i].id));
  }
  layOut(width(), true);
  updateGeometry();
}

int ChipRow::layOut(int width, bool place) const {
  int x = 0, y = 0, line = 0, height = 0;
  bool full = false;
  for (QToolButton* button : buttons_) {
    const QSize size = button->sizeHint();
    if (!full && x > 0 && x + size.width() > width) {
      x = 0;
      y += height + kGap;
      full = ++line == kLines;
    }
    if (!full) {
      height = size.height();
      if (place) button->setGeometry(x, y, std::min(size.width(), std::max(width, 1)), size.height());
      x += size.width() + kGap;
    }
    if (place) button->setVisible(!full);
  }
  if (buttons_.empty()) return 0;
  return full ? y - kGap : y + height;
}

QSize ChipRow::sizeHint() const { return {200, layOut(200, false)}; }
QSize ChipRow::minimumSizeHint() const { return {0, layOut(width(), false)}; }
int ChipRow::heightForWidth(int width) const { return layOut(width, false); }

void ChipRow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  layOut(width(), true);
}

}  // namespace idap
