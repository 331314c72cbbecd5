// What pictures to make: points of view (as many as are ticked), size, quality or time, look, light and hour.
#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "editor/editor.h"

namespace idap {

class PictureForm : public QWidget {
  Q_OBJECT
 public:
  PictureForm(Editor& editor, QWidget* parent = nullptr);
  ~PictureForm() override;

  // Where the live view stands, while there is one.
  void setLiveCamera(std::function<Camera()> camera);

  struct Wanted {
    std::string name;
    PictureSettings settings;
  };
  std::vector<Wanted> wanted() const;
  QString problem() const;  // why these cannot be made; empty: they can

 signals:
  void requested();  // the button
  void changed();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
