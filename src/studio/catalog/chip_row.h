// Small buttons side by side that are switched on and off, on as many lines as they need, up to a limit:
// those that do not fit are left out.
#pragma once

#include <QWidget>
#include <set>
#include <string>
#include <vector>

class QToolButton;

namespace idap {

class ChipRow : public QWidget {
  Q_OBJECT
 public:
  explicit ChipRow(QWidget* parent = nullptr);

  struct Chip {
    std::string id;
    QString text;
    friend bool operator==(const Chip&, const Chip&) = default;
  };
  void setChips(std::vector<Chip> chips, const std::set<std::string>& on);
  const std::set<std::string>& on() const { return on_; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

 signals:
  void changed();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  int layOut(int width, bool place) const;  // the height needed

  std::vector<Chip> chips_;
  std::vector<QToolButton*> buttons_;
  std::set<std::string> on_;
};

}  // namespace idap
