// The bottom of the window: all furniture, doors and windows of the home as a table to sort, with sizes,
// prices and their total. Selecting here selects on the plans.
#pragma once

#include <QWidget>
#include <memory>
#include <string>

#include "editor/editor.h"

namespace idap {

class FurnitureList : public QWidget {
  Q_OBJECT
 public:
  explicit FurnitureList(Editor& editor, QWidget* parent = nullptr);
  ~FurnitureList() override;

  std::string csv() const;  // RFC 4180, as sorted and with the columns shown

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
