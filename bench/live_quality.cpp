// How soon the live view is clean after a change: at 640x400, the lamp and the other piece that most of the
// view is of are moved, by 10 and by 50 cm, once the view of them as they were has so many samples a pixel.
// Every whole frame that comes is compared with the finished one. Errors are root mean squares of what a
// screen shows, in per cent of white. Usage: bench_live_quality HOME [CAMERA NUMBER] [SAMPLES OF THE FINISHED
// FRAME] [SAMPLES BEFORE THE CHANGE]
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <map>
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
    fmt::print(stderr, "usage: bench_live_quality HOME [CAMERA NUMBER] [SAMPLES] [SAMPLES BEFORE]\n");
    return 2;
  }
  const Home home = readHome(argv[1]).home;
  const int rest = argc > 4 ? std::stoi(argv[4]) : 8;
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
  std::shared_ptr<const LiveView> view;
  Clock::time_point start;
  LiveRender live({.frame =
                       [&](LiveFrame frame) {
                         const std::lock_guard lock(mutex);
                         frames.push_back({std::chrono::duration<double>(Clock::now() - start).count(),
                                           frame.samples, std::move(frame.image)});
                         finished = frame.finished;
                         view = frame.view;
                         came.notify_all();
                       },
                   .failed = [](const std::string& why) { fmt::print("failed: {}\n", why); }});
  // The view at rest.
  const auto restAt = [&](const Home& at) {
    request.home = at;
    std::unique_lock lock(mutex);
    frames.clear();
    live.submit(request);
    came.wait_for(lock, std::chrono::seconds(120),
                  [&] { return !frames.empty() && frames.back().samples >= rest; });
  };
  restAt(home);
  // The lamp and the other piece that most of the view is of.
  std::map<FurnitureId, int> pixels;
  {
    const std::lock_guard lock(mutex);
    for (const std::uint32_t object : view->features.objectId)
      if (const auto* id = std::get_if<FurnitureId>(&view->objects[object])) ++pixels[*id];
  }
  const auto largest = [&](bool lamp) {
    FurnitureId found;
    for (const auto& [id, count] : pixels)
      if (home.furniture.find(id)->lamp.has_value() == lamp && (!found || count > pixels[found])) found = id;
    return found;
  };
  const auto measure = [&](FurnitureId id, double metres) {
    if (!id) return;
    Home changed = home;
    Furniture piece = *home.furniture.find(id);
    piece.position.x += metres;
    changed.furniture.set(id, piece);
    restAt(home);
    request.home = changed;
    std::unique_lock lock(mutex);
    frames.clear();
    finished = false;
    start = Clock::now();
    live.submit(request);
    came.wait_for(lock, std::chrono::seconds(1200), [&] { return finished; });
    fmt::print("{} moved by {} m\n", piece.name, metres);
    for (const Shown& f : frames) {
      if (f.image.width != frames.back().image.width) continue;
      fmt::print("  {:6.2f} s  {:4} samples  {:5.2f} %\n", f.seconds, f.samples,
                 difference(f.image, frames.back().image));
    }
  };
  for (const double metres : {0.1, 0.5}) {
    measure(largest(true), metres);
    measure(largest(false), metres);
  }
  return 0;
}
