// How soon the live view is clean after a change: at 640x400, a lamp or a chair of the home given is moved,
// and every frame that comes is compared with the finished one. Errors are root mean squares of what a screen
// shows, in per cent of white.
// Usage: bench_live_quality HOME [CAMERA NUMBER] [SAMPLES OF THE FINISHED FRAME]
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <vector>

#include "formats/registry.h"
#include "scene/live/live_render.h"

namespace {

using namespace idap;
using Clock = std::chrono::steady_clock;

struct Shown {
  double seconds;
  int samples;
  Image8 image;
};

double difference(const Image8& a, const Image8& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    const double d = double(a.rgb[i]) - double(b.rgb[i]);
    sum += d * d;
  }
  return 100 * std::sqrt(sum / double(a.rgb.size())) / 255;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: bench_live_quality HOME [CAMERA NUMBER] [SAMPLES]\n");
    return 2;
  }
  const Home home = readHome(argv[1]).home;
  const std::size_t number = argc > 2 ? std::stoul(argv[2]) : 1;
  LiveRequest request;
  request.catalog = std::make_shared<const Catalog>();
  request.samples = argc > 3 ? std::stoi(argv[3]) : 512;
  if (number >= 1 && number <= home.cameras.size())
    request.camera = *std::next(home.cameras.begin(), std::ptrdiff_t(number - 1))->second;
  else if (home.observer)
    request.camera = *home.observer;

  std::mutex mutex;
  std::condition_variable came;
  std::vector<Shown> frames;
  bool finished = false;
  Clock::time_point start;
  LiveRender live({.frame =
                       [&](LiveFrame frame) {
                         const std::lock_guard lock(mutex);
                         frames.push_back({std::chrono::duration<double>(Clock::now() - start).count(),
                                           frame.samples, std::move(frame.image)});
                         finished = frame.finished;
                         came.notify_all();
                       },
                   .failed = [](const std::string& why) { fmt::print("failed: {}\n", why); }});
  const auto measure = [&](const char* what, const Home& changed) {
    request.home = home;
    start = Clock::now();
    {
      std::unique_lock lock(mutex);
      frames.clear();
      live.submit(request);
      came.wait_for(lock, std::chrono::seconds(60),
                    [&] { return !frames.empty() && frames.back().samples >= 2; });
    }
    request.home = changed;
    std::unique_lock lock(mutex);
    frames.clear();
    finished = false;
    start = Clock::now();
    live.submit(request);
    came.wait_for(lock, std::chrono::seconds(1200), [&] { return finished; });
    fmt::print("{}\n", what);
    for (const Shown& f : frames) {
      if (f.image.width != frames.back().image.width) continue;
      fmt::print("  {:6.2f} s  {:4} samples  {:5.2f} %\n", f.seconds, f.samples,
                 difference(f.image, frames.back().image));
    }
  };
  FurnitureId chair, lamp;
  for (const auto& [id, piece] : home.furniture) {
    if (!chair && !piece->lamp && piece->staircaseCutOut.empty()) chair = id;
    if (!lamp && piece->lamp) lamp = id;
  }
  const auto moved = [&](FurnitureId id) {
    Home next = home;
    Furniture piece = *home.furniture.find(id);
    piece.position.x += 0.1;
    next.furniture.set(id, piece);
    return next;
  };
  if (lamp) measure("a lamp moved", moved(lamp));
  if (chair) measure("a chair moved", moved(chair));
  return 0;
}
