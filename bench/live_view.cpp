// What a change costs until the live view shows it: the real widget at 640x400, driven by edits of the
// document and by real mouse events, in the home given. From the edit to the frame in the widget; and frames
// a second while looking around.
#include <fmt/format.h>

#include "editor/editor.h"
#include "formats/registry.h"
#include "scene/live/live_render.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QTimer>
#include <algorithm>
#include <functional>
#include <vector>

#include "studio/view3d/view3d.h"

namespace {

using namespace idap;

class Bench {
  // Sleeps until something happens, as an idle window does: a loop that spins would take a core from the
  // tracer.
  static void rest(int milliseconds) {
    QElapsedTimer timer;
    timer.start();
    do QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    while (timer.elapsed() < milliseconds);
  }

 public:
  Bench(Editor& editor, View3d& view) : editor_(editor), view_(view) {}

  bool await(const std::function<bool()>& done, int milliseconds = 20000) {
    QElapsedTimer timer;
    timer.start();
    while (!done() && timer.elapsed() < milliseconds) rest(0);
    return done();
  }

  void measure(const char* what, int times, int pause, const std::function<void(int)>& change) {
    std::vector<double> ms;
    for (int i = 0; i < times; ++i) {
      // At different moments of what goes on meanwhile.
      if (pause > 0) rest(pause * (1 + i % 5));
      QElapsedTimer timer;
      timer.start();
      change(i);
      if (!await([&] { return view_.upToDate(); })) fmt::print("{}: no frame came\n", what);
      ms.push_back(double(timer.nsecsElapsed()) / 1e6);
    }
    std::sort(ms.begin(), ms.end());
    const auto at = [&](double share) { return ms[std::size_t(share * double(ms.size() - 1))]; };
    fmt::print("{:34} p50 {:6.1f}  p95 {:6.1f}  max {:6.1f} ms\n", what, at(0.5), at(0.95), ms.back());
  }

  void lookAround(const char* what) {
    const auto send = [&](QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons buttons) {
      QMouseEvent event(type, at, view_.mapToGlobal(at), button, buttons, Qt::NoModifier);
      QApplication::sendEvent(&view_, &event);
    };
    const QPointF from(320, 60);
    int frames = 0;
    const auto counting = QObject::connect(&view_, &View3d::frameShown, [&](int, bool) { ++frames; });
    send(QEvent::MouseButtonPress, from, Qt::RightButton, Qt::RightButton);
    QElapsedTimer timer;
    timer.start();
    int moves = 0;
    while (timer.elapsed() < 3000) {
      ++moves;
      send(QEvent::MouseMove, from + QPointF(12 + moves, 0), Qt::NoButton, Qt::RightButton);
      rest(8);
    }
    const double seconds = double(timer.elapsed()) / 1000;
    send(QEvent::MouseButtonRelease, from, Qt::RightButton, Qt::NoButton);
    QObject::disconnect(counting);
    fmt::print("{:34} {:.1f} frames a second\n", what, frames / seconds);
  }

 private:
  Editor& editor_;
  View3d& view_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: bench_live_view HOME [CAMERA NUMBER]\n");
    return 2;
  }
  QApplication application(argc, argv);
  QTimer alarm;  // so that waiting ends
  alarm.start(1);
  Editor editor(std::make_shared<const Catalog>());
  Home home = readHome(argv[1]).home;
  editor.open(std::make_unique<Document>(home));
  View3d view(editor);
  view.resize(640, 400);
  view.show();
  Bench bench(editor, view);
  const std::size_t number = argc > 2 ? std::stoul(argv[2]) : 1;
  if (number >= 1 && number <= home.cameras.size())
    view.setCamera(*std::next(home.cameras.begin(), std::ptrdiff_t(number - 1))->second);
  bench.await([&] { return view.upToDate() && view.samples() >= 1; });

  FurnitureId chair, lamp;
  for (const auto& [id, piece] : home.furniture) {
    if (!chair && !piece->lamp && piece->staircaseCutOut.empty()) chair = id;
    if (!lamp && piece->lamp) lamp = id;
  }
  const auto shift = [&](FurnitureId id, double by) {
    editor.apply("move", [&](const Home& before) {
      Home next = before;
      Furniture piece = *before.furniture.find(id);
      piece.position.x += by;
      next.furniture.set(id, piece);
      return next;
    });
  };
  for (const int rest : {0, 40}) {
    fmt::print("resting {} to {} ms between changes\n", rest, 5 * rest);
    bench.measure("  a piece moved", 60, rest, [&](int i) { shift(chair, i % 2 ? 0.05 : -0.05); });
    if (lamp) bench.measure("  a lamp moved", 40, rest, [&](int i) { shift(lamp, i % 2 ? 0.05 : -0.05); });
    bench.measure("  the hour changed", 20, rest, [&](int i) {
      editor.apply("hour", [&](const Home& before) {
        Home next = before;
        next.site.time += (i % 2 ? 1 : -1) * 3'600'000LL;
        return next;
      });
    });
    bench.measure("  a wall's corner moved", 20, rest, [&](int i) {
      editor.apply("wall", [&](const Home& before) {
        Home next = before;
        const auto [id, wall] = *before.walls.begin();
        Wall moved = *wall;
        moved.end.x += 0.01 * (1 + i % 5);  // on and on, as in a drag
        next.walls.set(id, moved);
        return next;
      });
    });
  }
  bench.lookAround("looking around");
  return 0;
}
