// The lights of a picture that is made, each with a switch, a strength and a colour: a mix is seen while a
// slider is dragged, without tracing again.
#pragma once

#include <QImage>
#include <QWidget>
#include <memory>

#include "model/edits/lamp_edits.h"
#include "render/film/light_mix.h"
#include "studio/picture/picture_worker.h"

namespace idap {

class LightMixer : public QWidget {
  Q_OBJECT
 public:
  explicit LightMixer(QWidget* parent = nullptr);
  ~LightMixer() override;

  // The picture to mix; null: none. Its lights are got ready in the background, then previewed() follows.
  void setFilm(std::shared_ptr<const PictureFilm> film);
  std::shared_ptr<const PictureFilm> film() const;
  bool ready() const;
  bool changed() const;  // whether the mix differs from the picture

  std::vector<render::LightChange> changes() const;  // by light group
  std::vector<LampChange> lampChanges() const;       // of the home's lamps, those that differ
  void reset();

 signals:
  void previewed(const QImage& picture);
  void keepAsked();      // the mix as a picture of its own
  void takeOverAsked();  // the home's lamps as they are in the mix
  void failed(const QString& why);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
