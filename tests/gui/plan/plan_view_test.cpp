// The plane as a user meets it: real mouse, wheel and key events.
#include "studio/plan/plan_view.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <ostream>

#include "editor/tools/place_tool.h"
#include "gui/support/gui_support.h"
#include "studio/plan/plan_caption.h"
#include "studio/widgets/mime_types.h"
#include "support/sample_home.h"

void PrintTo(const QRect& rect, std::ostream* out) {
  *out << rect.width() << "x" << rect.height() << " at " << rect.x() << "," << rect.y();
}

namespace idap {
namespace {

using test::smallFlat;
using test::waitFor;

// Where two pictures differ; empty where they do not.
QRect difference(const QImage& a, const QImage& b) {
  QRect where;
  if (a.size() != b.size()) return a.rect();
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (a.pixel(x, y) != b.pixel(x, y)) where |= QRect(x, y, 1, 1);
  return where;
}

class PlanViewTest : public testing::Test {
 protected:
  PlanViewTest() {
    EditorSettings settings = editor.settings();
    settings.gridShown = false;
    settings.snapping = false;
    editor.setSettings(settings);
    open(smallFlat());
    view.resize(800, 600);
    view.show();
    view.zoomToFit();
    settle();
  }
  void open(Home home) { editor.open(std::make_unique<Document>(std::move(home))); }
  void settle() {
    view.grab();
    ASSERT_TRUE(waitFor([&] {
      view.repaint();
      return view.settled();
    }));
  }
  QImage picture() {
    settle();
    return view.grab().toImage();
  }
  QPoint pixel(Vec2 at) const { return view.toView(at).toPoint(); }
  int lightness(const QImage& image, Vec2 at) const { return qGray(image.pixel(pixel(at))); }
  const Furniture& table() const { return *editor.home().furniture.begin()->second; }
  void wheel(QPoint at, int notches, Qt::KeyboardModifiers modifiers = {}) {
    QWheelEvent event(at, view.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &event);
  }

  Editor editor{std::make_shared<Catalog>(std::vector<std::filesystem::path>{})};
  PlanView view{editor, Plane::XY};
};

TEST_F(PlanViewTest, AWallIsDarkAndARoomIsLight) {
  const QImage image = picture();
  EXPECT_LT(lightness(image, {1, 0}), 120);
  EXPECT_GT(lightness(image, {0.6, 3.2}), 200);
  EXPECT_GT(lightness(image, {-0.8, 2.3}), 240);
}

TEST_F(PlanViewTest, ADoorOpensTheWall) {
  EXPECT_GT(lightness(picture(), {3.02, 1.1}), 180);
  EXPECT_LT(lightness(picture(), {3, 3}), 120);
}

TEST_F(PlanViewTest, ZoomKeepsThePointUnderThePointer) {
  const QPoint at(250, 180);
  const Vec2 before = view.toPlane(at);
  const double pixel = view.pixel();
  wheel(at, 3);
  EXPECT_LT(view.pixel(), pixel);
  EXPECT_NEAR(length(view.toPlane(at) - before), 0, view.pixel());
  wheel(at, -7);
  EXPECT_GT(view.pixel(), pixel);
  EXPECT_NEAR(length(view.toPlane(at) - before), 0, 2 * view.pixel());
}

TEST_F(PlanViewTest, FitShowsAllThatIsDrawn) {
  view.centreOn({100, 100});
  view.zoomToFit();
  const Box2 drawn = view.drawnBox();
  EXPECT_LE(drawn.min.x, -0.1);
  EXPECT_GE(drawn.max.y, 4.1);
  for (const Vec2 corner : {drawn.min, drawn.max})
    EXPECT_TRUE(QRectF(view.rect()).contains(view.toView(corner)));
}

TEST_F(PlanViewTest, FitGoesOnFittingWhenTheViewGrows) {
  const double pixel = view.pixel();
  view.resize(400, 300);
  EXPECT_GT(view.pixel(), pixel);
}

TEST_F(PlanViewTest, TheMiddleButtonMovesThePaper) {
  const Vec2 at = view.toPlane({300, 200});
  QTest::mousePress(&view, Qt::MiddleButton, {}, {300, 200});
  QMouseEvent move(QEvent::MouseMove, QPointF(380, 260), view.mapToGlobal(QPointF(380, 260)), Qt::NoButton,
                   Qt::MiddleButton, {});
  QApplication::sendEvent(&view, &move);
  QTest::mouseRelease(&view, Qt::MiddleButton, {}, {380, 260});
  EXPECT_NEAR(length(view.toPlane({380, 260}) - at), 0, 1e-9);
}

TEST_F(PlanViewTest, AMovedPaperShowsTheSameAsOnePaintedAnew) {
  settle();
  const Vec2 at = view.toPlane({300, 200});
  QTest::mousePress(&view, Qt::MiddleButton, {}, {300, 200});
  QMouseEvent move(QEvent::MouseMove, QPointF(347, 161), view.mapToGlobal(QPointF(347, 161)), Qt::NoButton,
                   Qt::MiddleButton, {});
  QApplication::sendEvent(&view, &move);
  QTest::mouseRelease(&view, Qt::MiddleButton, {}, {347, 161});
  const QImage moved = picture();
  EditorSettings settings = editor.settings();
  settings.gridShown = true;
  editor.setSettings(settings);
  settings.gridShown = false;
  editor.setSettings(settings);
  ASSERT_NEAR(length(view.toPlane({347, 161}) - at), 0, 1e-9);
  EXPECT_EQ(difference(moved, picture()), QRect());
}

TEST_F(PlanViewTest, ADragMovesAPieceAndUndoPutsItBack) {
  const Vec3 before = table().position;
  const QPoint from = pixel({1.5, 2}), to = from + QPoint(60, 30);
  QTest::mouseMove(&view, from);
  QTest::mousePress(&view, Qt::LeftButton, {}, from);
  for (int i = 1; i <= 6; ++i) {
    const QPointF at = QPointF(from) + QPointF(to - from) * i / 6;
    QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&view, &move);
  }
  QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
  EXPECT_NEAR(table().position.x - before.x, 60 * view.pixel(), 0.02);
  EXPECT_NEAR(table().position.y - before.y, -30 * view.pixel(), 0.02);
  editor.undo();
  EXPECT_EQ(table().position, before);
  EXPECT_FALSE(editor.document().canUndo());
}

TEST_F(PlanViewTest, WhatChangedIsPaintedAnewAsIfAllWere) {
  settle();
  const auto [id, piece] = *editor.home().furniture.begin();
  editor.apply("Move", [id = id](const Home& home) {
    Home next = home;
    Furniture moved = *home.furniture.find(id);
    moved.position = {4.5, 3.3, 0};
    moved.angle = 0.3;
    next.furniture.set(id, std::move(moved));
    return next;
  });
  const QImage patched = picture();
  EXPECT_LT(lightness(patched, {4.5, 3.3}), 252);
  open(editor.home());
  EXPECT_EQ(difference(patched, picture()), QRect());
}

TEST_F(PlanViewTest, EveryKindOfChangeIsPaintedAnew) {
  settle();
  const Home before = editor.home();
  const auto check = [&](const char* what, const std::function<void(Home&)>& change) {
    open(before);
    view.zoomBy(0.8);  // from here on it does not follow what is drawn
    settle();
    editor.apply(what, [&](const Home& home) {
      Home next = home;
      change(next);
      return next;
    });
    const QImage patched = picture();
    EditorSettings settings = editor.settings();  // another setting and back: all is painted anew
    settings.gridShown = true;
    editor.setSettings(settings);
    settings.gridShown = false;
    editor.setSettings(settings);
    EXPECT_EQ(difference(patched, picture()), QRect()) << what;
  };
  check("Wall", [](Home& home) {
    const auto [id, wall] = *home.walls.begin();
    Wall thicker = *wall;
    thicker.thickness = 0.4;
    home.walls.set(id, thicker);
  });
  check("Window", [](Home& home) { home.openings.erase(home.openings.begin()->first); });
  check("Room", [](Home& home) {
    Room room;
    room.name = "Kitchen";
    room.points = {{0.1, 0.1}, {2.9, 0.1}, {2.9, 3.9}, {0.1, 3.9}};
    home.rooms.set(home.newId<RoomId>(), room);
  });
  check("Dimension", [](Home& home) {
    home.dimensions.set(home.newId<DimensionId>(),
                        Dimension{.start = {0, 0.5}, .end = {6, 0.5}, .offset = 0.4});
  });
  check("Label", [](Home& home) {
    home.labels.set(home.newId<LabelId>(), Label{.text = "ห้องนอน", .position = {1, 1}});
  });
  check("Line", [](Home& home) {
    Polyline line;
    line.points = {{0.5, 0.5}, {2, 1}, {2, 3}};
    line.endArrow = LineArrow::Delta;
    home.polylines.set(home.newId<PolylineId>(), line);
  });
  check("Camera", [](Home& home) {
    home.cameras.set(home.newId<CameraId>(), Camera{.name = "From the door", .eye = {2, 2, 1.6}});
  });
}

TEST_F(PlanViewTest, APieceIsDroppedFromTheCatalog) {
  const std::size_t before = editor.home().furniture.size();
  QMimeData mime;
  mime.setData(QString::fromLatin1(kPieceMime), "idap/chair-windsor");
  const QPointF at = view.toView({4.5, 2});
  QDragEnterEvent enter(at.toPoint(), Qt::CopyAction, &mime, Qt::LeftButton, {});
  QApplication::sendEvent(&view, &enter);
  ASSERT_TRUE(enter.isAccepted());
  EXPECT_FALSE(editor.selecting());
  QDragMoveEvent move(at.toPoint(), Qt::CopyAction, &mime, Qt::LeftButton, {});
  QApplication::sendEvent(&view, &move);
  EXPECT_EQ(editor.home().furniture.size(), before + 1) << "a ghost follows";
  QDragLeaveEvent leave;
  QApplication::sendEvent(&view, &leave);
  EXPECT_EQ(editor.home().furniture.size(), before) << "and goes when the pointer leaves";
  EXPECT_TRUE(editor.selecting());

  QApplication::sendEvent(&view, &enter);
  QApplication::sendEvent(&view, &move);
  QDropEvent drop(at, Qt::CopyAction, &mime, Qt::LeftButton, {});
  QApplication::sendEvent(&view, &drop);
  EXPECT_EQ(editor.home().furniture.size(), before + 1);
  EXPECT_TRUE(editor.selecting());
  editor.undo();
  EXPECT_EQ(editor.home().furniture.size(), before);
}

TEST_F(PlanViewTest, OtherDragsAreNotTaken) {
  QMimeData mime;
  mime.setText(QStringLiteral("idap/chair-windsor"));
  QDragEnterEvent enter(QPoint(100, 100), Qt::CopyAction, &mime, Qt::LeftButton, {});
  enter.ignore();
  QApplication::sendEvent(&view, &enter);
  EXPECT_FALSE(enter.isAccepted());
}

TEST_F(PlanViewTest, DigitsReachTheToolThatIsDrawing) {
  open({});
  editor.takeTool("wall");
  view.setFocus();
  const QPoint from = pixel({0, 0});
  QTest::mouseClick(&view, Qt::LeftButton, {}, from);
  QTest::mouseMove(&view, from + QPoint(80, 0));
  QMouseEvent move(QEvent::MouseMove, QPointF(from + QPoint(80, 0)),
                   view.mapToGlobal(QPointF(from + QPoint(80, 0))), Qt::NoButton, Qt::NoButton, {});
  QApplication::sendEvent(&view, &move);
  QTest::keyClicks(&view, QStringLiteral("325"));
  const Overlay overlay = editor.tool().overlay(editor, Plane::XY, view.pixel());
  ASSERT_FALSE(overlay.fields.empty());
  EXPECT_EQ(overlay.fields.front().typed, "325");
  test::shoot(view, "typing");
  QTest::keyClick(&view, Qt::Key_Return);
  ASSERT_GE(editor.home().walls.size(), 1u);
  const Wall& wall = *editor.home().walls.begin()->second;
  EXPECT_NEAR(length(wall.end - wall.start), 3.25, 1e-6);
}

TEST_F(PlanViewTest, LettersGoOnToShortcutsWhileNothingIsInHand) {
  view.setFocus();
  QKeyEvent key(QEvent::KeyPress, Qt::Key_Q, {}, QStringLiteral("q"));
  QApplication::sendEvent(&view, &key);
  EXPECT_FALSE(key.isAccepted());
}

TEST_F(PlanViewTest, SpaceAndDragMovesThePaper) {
  view.setFocus();
  const Vec2 at = view.toPlane({300, 200});
  QTest::keyPress(&view, Qt::Key_Space);
  QTest::mousePress(&view, Qt::LeftButton, {}, {300, 200});
  QMouseEvent move(QEvent::MouseMove, QPointF(340, 220), view.mapToGlobal(QPointF(340, 220)), Qt::NoButton,
                   Qt::LeftButton, {});
  QApplication::sendEvent(&view, &move);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, {340, 220});
  QTest::keyRelease(&view, Qt::Key_Space);
  EXPECT_NEAR(length(view.toPlane({340, 220}) - at), 0, 1e-9);
  EXPECT_TRUE(empty(editor.selection()));
}

TEST_F(PlanViewTest, TheRightButtonSelectsAndAsksForTheMenu) {
  QSignalSpy menu(&view, &PlanView::contextMenuRequested);
  QTest::mouseClick(&view, Qt::RightButton, {}, pixel({1.5, 2}));
  EXPECT_EQ(menu.count(), 1);
  EXPECT_EQ(count(editor.selection()), 1u);
}

TEST_F(PlanViewTest, TellsWhereThePointerIs) {
  QSignalSpy at(&view, &PlanView::pointerAt);
  QTest::mouseMove(&view, {200, 200});
  QMouseEvent move(QEvent::MouseMove, QPointF(210, 220), view.mapToGlobal(QPointF(210, 220)), Qt::NoButton,
                   Qt::NoButton, {});
  QApplication::sendEvent(&view, &move);
  ASSERT_GE(at.count(), 1);
  EXPECT_NEAR(at.last()[0].toDouble(), view.toPlane({210, 220}).x, 1e-9);
}

TEST_F(PlanViewTest, ADoubleClickOnTheCaptionAsksForTheWholeWindow) {
  QSignalSpy asked(&view, &PlanView::maximiseRequested);
  auto* caption = view.findChild<PlanCaption*>(QStringLiteral("planCaption"));
  ASSERT_NE(caption, nullptr);
  QTest::mouseDClick(caption, Qt::LeftButton);
  EXPECT_EQ(asked.count(), 1);
  QTest::mouseClick(view.findChild<QToolButton*>(QStringLiteral("maximise")), Qt::LeftButton);
  EXPECT_EQ(asked.count(), 2);
}

TEST_F(PlanViewTest, LightAndDarkPaper) {
  EXPECT_GT(lightness(picture(), {-0.8, 2.3}), 240);
  QPalette dark;
  dark.setColor(QPalette::Base, QColor(30, 32, 36));
  dark.setColor(QPalette::Text, QColor(230, 230, 230));
  view.setPalette(dark);
  const QImage image = picture();
  EXPECT_LT(lightness(image, {-0.8, 2.3}), 60);
  EXPECT_GT(lightness(image, {1, 0}), 130) << "walls are light on dark paper";
}

TEST_F(PlanViewTest, ElevationsHaveTheWorldsHeightOnTheirSecondAxis) {
  PlanView front(editor, Plane::XZ);
  front.resize(600, 300);
  front.zoomToFit();
  const Box2 drawn = front.drawnBox();
  EXPECT_NEAR(drawn.min.x, -0.1, 1e-6);
  EXPECT_NEAR(drawn.max.x, 6.1, 1e-6);
  EXPECT_NEAR(drawn.min.y, 0, 1e-6);
  EXPECT_NEAR(drawn.max.y, 2.5, 1e-6);
  EXPECT_GT(front.toView({0, 0}).y(), front.toView({0, 2}).y());
}

}  // namespace
}  // namespace idap
