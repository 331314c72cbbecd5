// Makes a picture of a home on a thread of its own: coarse within about a second, then finer until it is good
// enough. The window goes on meanwhile.
#pragma once

#include <QImage>
#include <QObject>
#include <memory>
#include <optional>

#include "catalog/catalog.h"
#include "model/home.h"
#include "render/film/develop.h"
#include "render/film/film.h"
#include "render/light_group.h"
#include "scene/scene_builder.h"

namespace idap {

struct PictureRequest {
  Home home;  // a snapshot
  std::shared_ptr<const Catalog> catalog;
  std::optional<Camera> camera;      // none: from above, without ceilings
  std::optional<std::int64_t> time;  // of a picture from above; none: the home's
  int width = 640, height = 480;
  int samples = 64;     // a pixel; 0: by time only
  double seconds = 20;  // of tracing; 0: by samples only. Whichever comes first
  LampPolicy lamps = LampPolicy::Auto;
  PictureTone tone = PictureTone::Neutral;
  double brightness = 0, aperture = 0;  // see PictureSettings
  bool upright = false;
  bool classic = false;     // the shading of 1993
  bool keepLights = false;  // each lamp's light by itself, where there is memory for it
  // All processors, for pictures that somebody waits for; else one is left to the window.
  bool allProcessors = false;
};

// What a picture was made of, for files that keep its light and for mixing it.
struct PictureFilm {
  render::Film film;
  std::vector<render::LightGroup> lightGroups;
  std::vector<FurnitureId> lamps;  // by light group, as BuiltScene::lamps
  render::DevelopSettings look;    // how the picture was developed from it
};

// Belongs to the GUI thread; so do its signals.
class PictureWorker : public QObject {
  Q_OBJECT
 public:
  explicit PictureWorker(QObject* parent = nullptr);
  ~PictureWorker() override;  // cancels; waits until the thread notices, at most for one denoising

  void start(PictureRequest request);  // in place of the picture being made, of which no more is heard
  void stop();                         // what there is stays, and is shown at its best
  void pause(bool paused);             // holds still; what was traced so far stays
  bool paused() const;
  // Of the picture that was finished last; null before, and for classic ones.
  std::shared_ptr<const PictureFilm> film() const;
  int samples() const;  // a pixel, of the picture that was finished last
  bool busy() const;

 signals:
  void pictured(const QImage& picture);
  void progressed(double fraction, double secondsLeft);  // secondsLeft < 0: not known yet
  void finished();                                       // after the last picture, stopped or not
  void failed(const QString& why);                       // before finished()

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
