// The ray tracer that keeps a view of a home up to date while it is worked on: every change shows within a
// frame, coarse, and becomes finer for as long as nothing else changes. A thread of its own does the work;
// the caller never waits for it, nor it for the caller.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/image8.h"
#include "render/film/tone_map.h"
#include "render/integrator/features.h"
#include "scene/cut_away.h"

namespace idap {

// All that the view depends on, as one value: what differs from the last one is found out by comparing.
struct LiveRequest {
  Home home;
  std::shared_ptr<const Catalog> catalog;
  Camera camera;
  int width = 640, height = 400;  // pixels of the finished frame
  CutAway cut = CutAway::ByView;
  LampPolicy lamps = LampPolicy::Auto;
  float compensation = 0;  // stops; positive is brighter
  render::ToneMap toneMap = render::ToneMap::PbrNeutral;
  int samples = 256;  // a pixel, when the view is as good as it gets
};

// What the pixels of a frame are. Shared: frames of one request that differ in noise only have the same.
struct LiveView {
  Camera camera;
  bool outside = false;  // seen from outside, with what is in the way cut away
  render::Features features;
  std::vector<ElementId> objects;  // by Features::objectId
  // The names of its parts, by Features::slot: see model/edits/finish_edits.h.
  std::shared_ptr<const std::vector<std::vector<std::string>>> parts;  // by Features::objectId
};

struct LiveFrame {
  std::uint64_t generation = 0;  // of the request that it answers
  Image8 image;
  int samples = 0;        // a pixel; 0: coarse
  bool finished = false;  // no finer one will follow
  float ev = 0;           // EV100 it is exposed for, compensation included
  std::shared_ptr<const LiveView> view;
};

class LiveRender {
 public:
  struct Sink {
    std::function<void(LiveFrame)> frame;            // on the render thread
    std::function<void(const std::string&)> failed;  // likewise, with the reason
  };
  // threads: to trace with; 0: all. They give way to the caller's.
  explicit LiveRender(Sink sink, int threads = 0);
  ~LiveRender();  // waits for what cannot be broken off: at most one coarse frame
  LiveRender(const LiveRender&) = delete;
  LiveRender& operator=(const LiveRender&) = delete;

  // The view to show from now on; returns its generation. Requests that come faster than coarse frames can be
  // made are passed over, but for the newest.
  std::uint64_t submit(LiveRequest request);
  // While true nothing is traced; what is submitted waits.
  void pause(bool paused);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
