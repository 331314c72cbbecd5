// What a frame of the plan costs with 2 000 pieces on the screen: one dragged by the mouse through the select
// tool, the paper pushed, and zoomed. Edit and paint together, as the user waits for both. 1280 x 800, all
// layers.
#include "editor/editor.h"

#include <fmt/format.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <functional>
#include <vector>

#include "studio/plan/plan_view.h"

namespace {

using namespace idap;

constexpr int kColumns = 50, kRows = 40;
constexpr double kStep = 0.9;  // m between two pieces

// Beds, chairs, tables and the like in rooms of 10 by 10 pieces.
Home fullHouse(const Catalog& catalog) {
  std::vector<CatalogPiecePtr> kinds;
  for (const CatalogPiecePtr& piece : catalog.pieces())
    if (piece->kind == PieceKind::Furniture || piece->kind == PieceKind::Lamp) kinds.push_back(piece);
  Home home;
  Table<FurnitureId, Furniture>::Chunk entries;
  for (int i = 0; i < kColumns * kRows; ++i) {
    const CatalogPiece& kind = *kinds[std::size_t(i) % kinds.size()];
    Furniture piece =
        makeFurniture(kind, {(i % kColumns + 0.5) * kStep, (i / kColumns + 0.5) * kStep, 0}, i * 0.7);
    const double shrink = std::min(1.0, kStep / std::max(piece.size.x, piece.size.y));
    piece.size = {piece.size.x * shrink, piece.size.y * shrink, piece.size.z};
    entries.emplace_back(home.newId<FurnitureId>(), std::make_shared<const Furniture>(std::move(piece)));
  }
  home.furniture = Table<FurnitureId, Furniture>::of(std::move(entries));
  for (int column = 0; column < kColumns / 10; ++column)
    for (int row = 0; row < kRows / 10; ++row) {
      const Vec2 a{column * 10 * kStep, row * 10 * kStep}, b = a + Vec2{10 * kStep, 10 * kStep};
      Room room;
      room.name = "Room " + std::to_string(column) + std::to_string(row);
      room.points = {a, {b.x, a.y}, b, {a.x, b.y}};
      home.rooms.set(home.newId<RoomId>(), room);
      Wall wall;
      wall.start = a, wall.end = {b.x, a.y};
      home.walls.set(home.newId<WallId>(), wall);
      wall.start = a, wall.end = {a.x, b.y};
      home.walls.set(home.newId<WallId>(), wall);
      home.dimensions.set(home.newId<DimensionId>(), Dimension{.start = a, .end = {b.x, a.y}, .offset = 0.3});
    }
  return home;
}

struct Frames {
  std::vector<double> milliseconds;
  void add(const std::function<void()>& frame) {
    QElapsedTimer clock;
    clock.start();
    frame();
    milliseconds.push_back(double(clock.nsecsElapsed()) * 1e-6);
  }
  void print(const char* name) {
    std::sort(milliseconds.begin(), milliseconds.end());
    const auto at = [&](double share) {
      return milliseconds[std::min(milliseconds.size() - 1,
                                   std::size_t(share * double(milliseconds.size())))];
    };
    fmt::print("{:<28} p50 {:6.2f}  p95 {:6.2f}  max {:6.2f} ms  ({} frames)\n", name, at(0.5), at(0.95),
               milliseconds.back(), milliseconds.size());
  }
};

void mouse(QWidget& view, QEvent::Type type, QPointF at, Qt::MouseButton button) {
  const bool move = type == QEvent::MouseMove;
  QMouseEvent event(type, at, view.mapToGlobal(at), move ? Qt::NoButton : button,
                    type == QEvent::MouseButtonRelease ? Qt::NoButton : button, {});
  QApplication::sendEvent(&view, &event);
}

void settle(PlanView& view) {
  do {
    QApplication::processEvents(QEventLoop::AllEvents, 20);
    view.repaint();
  } while (!view.settled());
  // Symbols are told of a little after the last is made.
  QElapsedTimer clock;
  clock.start();
  while (clock.elapsed() < 200) QApplication::processEvents(QEventLoop::AllEvents, 20);
  view.repaint();
}

}  // namespace

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  const auto catalog = std::make_shared<Catalog>(std::vector<std::filesystem::path>{});
  Editor editor(catalog);
  editor.open(std::make_unique<Document>(fullHouse(*catalog)));
  PlanView view(editor, Plane::XY);
  view.resize(1280, 800);
  view.show();
  view.zoomToFit();
  QElapsedTimer clock;
  clock.start();
  settle(view);
  fmt::print("all symbols made              {:6.0f} ms\n", double(clock.elapsed()));

  Frames whole;
  for (int i = 0; i < 20; ++i) {
    EditorSettings settings = editor.settings();
    settings.gridShown = i % 2 == 0;
    editor.setSettings(settings);
    whole.add([&] {
      do view.repaint();
      while (!view.settled());
    });
  }
  whole.print("everything painted anew");

  Frames drag;
  const QPointF from = view.toView({(kColumns / 2 + 0.5) * kStep, (kRows / 2 + 0.5) * kStep});
  mouse(view, QEvent::MouseMove, from, Qt::NoButton);
  mouse(view, QEvent::MouseButtonPress, from, Qt::LeftButton);
  for (int i = 1; i <= 200; ++i)
    drag.add([&] {
      mouse(view, QEvent::MouseMove, from + QPointF(i * 1.3, (i % 60) * 2), Qt::LeftButton);
      view.repaint();
    });
  mouse(view, QEvent::MouseButtonRelease, from + QPointF(260, 40), Qt::LeftButton);
  drag.print("one piece dragged");
  editor.undo();

  Frames hover;
  for (int i = 1; i <= 200; ++i)
    hover.add([&] {
      mouse(view, QEvent::MouseMove, QPointF(100 + 5 * i, 300 + (i % 40)), Qt::NoButton);
      view.repaint();
    });
  hover.print("the pointer moved");

  Frames pan;
  mouse(view, QEvent::MouseButtonPress, {640, 400}, Qt::MiddleButton);
  for (int i = 1; i <= 200; ++i)
    pan.add([&] {
      mouse(view, QEvent::MouseMove, QPointF(640 + 3 * (i % 80), 400 + 2 * (i % 70)), Qt::MiddleButton);
      view.repaint();
    });
  mouse(view, QEvent::MouseButtonRelease, {640, 400}, Qt::MiddleButton);
  pan.print("the paper pushed");

  Frames zoom;
  for (int i = 1; i <= 120; ++i)
    zoom.add([&] {
      const QPointF at(500, 350);
      QWheelEvent event(at, view.mapToGlobal(at), {}, {0, (i / 10) % 2 == 0 ? 40 : -40}, Qt::NoButton, {},
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(&view, &event);
      view.repaint();
    });
  zoom.print("zoomed, to a first picture");
  return 0;
}
