#include "studio/properties/property_panel.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QStyleFactory>
#include <QTest>
#include <QTranslator>

#include "gui/support/gui_support.h"
#include "model/edits/element_edits.h"
#include "model/edits/piece_edits.h"
#include "model/room_geometry.h"
#include "model/wall_path.h"
#include "studio/widgets/color_button.h"
#include "studio/widgets/length_field.h"
#include "studio/widgets/material_picker.h"
#include "studio/widgets/slider_field.h"
#include "studio/widgets/text_field.h"

namespace idap {
namespace {

// A room with furniture, a door, a lamp, and one of everything else that can be selected.
class PropertyPanelTest : public testing::Test {
 protected:
  PropertyPanelTest() {
    Home home = makeRoomHome(4, 5, 2.5, 0.1, "Bedroom");
    bed = add(home, "idap/bed-double", {2, 3, 0});
    night = add(home, "idap/night-table", {0.5, 3, 0});
    lamp = addFirst(home, PieceKind::Lamp, {0.5, 3, 0.5});
    wall = home.walls.begin()->first;
    room = home.rooms.begin()->first;
    for (const CatalogPiecePtr& piece : catalog->pieces())
      if (piece->kind == PieceKind::Door && !piece->sashes.empty()) {
        const Wall& in = *home.walls.find(wall);
        const WallPath path(in);
        const Vec2 at = path.point(path.length() / 2), along = path.direction(0);
        Opening opening = makeOpening(*piece, {at.x, at.y, 0}, std::atan2(along.y, along.x));
        opening.wall = wall;
        OpeningEdit edit = addOpening(home, opening);
        home = edit.home;
        door = edit.opening;
        break;
      }
    const auto set = [&home](auto& table, auto element) {
      using Id = std::decay_t<decltype(table.begin()->first)>;
      const auto id = home.newId<Id>();
      table.set(id, element);
      return id;
    };
    camera = set(home.cameras, Camera{.name = "From the door", .eye = {1, 1, 1.6}});
    dimension = set(home.dimensions, Dimension{.start = {0, 0}, .end = {4, 0}, .offset = 0.5});
    label = set(home.labels, Label{.text = "Facing\nthe garden", .position = {2, 2}});
    line = set(home.polylines, Polyline{.points = {{0, 0}, {1, 1}, {2, 0}}});
    editor.open(std::make_unique<Document>(home));
    panel.resize(300, 900);
    panel.show();
    panel.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&panel));
  }

  FurnitureId add(Home& home, const std::string& id, Vec3 at) {
    CatalogPiecePtr piece = catalog->find(id);
    if (!piece) piece = catalog->pieces().front();
    FurnitureEdit edit = addFurniture(home, makeFurniture(*piece, at));
    home = edit.home;
    return edit.furniture;
  }
  FurnitureId addFirst(Home& home, PieceKind kind, Vec3 at) {
    for (const CatalogPiecePtr& piece : catalog->pieces())
      if (piece->kind == kind) return add(home, piece->id, at);
    return {};
  }

  template <class... Ids>
  void select(Ids... ids) {
    Elements chosen;
    (idap::add(chosen, ids), ...);
    editor.select(chosen);
    settle();
  }
  // The panel takes up to a twentieth of a second to show what changed.
  void settle() {
    QTest::qWait(60);
    QCoreApplication::processEvents();  // on a busy machine the wait may be over before its events are seen
    QTest::qWait(10);
  }
  template <class T>
  T* field(const char* name) {
    for (T* found : panel.findChildren<T*>(QString::fromLatin1(name)))
      if (found->isVisible()) return found;
    return nullptr;
  }
  void type(QWidget* into, const char* text) {
    ASSERT_NE(into, nullptr);
    into->setFocus(Qt::TabFocusReason);
    QTest::qWait(1);
    QTest::keyClicks(into, QString::fromUtf8(text));
    QTest::keyClick(into, Qt::Key_Return);
    settle();
  }
  const Furniture& piece(FurnitureId id) { return *editor.home().furniture.find(id); }
  QString title() { return panel.findChild<QLabel*>("propertyTitle")->text(); }

  std::shared_ptr<const Catalog> catalog = std::make_shared<Catalog>(std::vector<std::filesystem::path>{});
  Editor editor{catalog};
  PropertyPanel panel{editor};
  FurnitureId bed, night, lamp;
  OpeningId door;
  WallId wall;
  RoomId room;
  CameraId camera;
  DimensionId dimension;
  LabelId label;
  PolylineId line;
};

TEST_F(PropertyPanelTest, ASumInCentimetresSetsTheWidthInOneUndoStep) {
  select(bed);
  const Home before = editor.home();
  type(field<LengthField>("pieceWidth"), "120+35");
  EXPECT_DOUBLE_EQ(piece(bed).size.x, 1.55);
  EXPECT_EQ(editor.document().undoName(), "Change width");
  editor.undo();
  EXPECT_EQ(editor.home(), before);
  EXPECT_FALSE(editor.document().canUndo());
}

TEST_F(PropertyPanelTest, OtherSizesFollowWhenProportionsAreKept) {
  select(night);
  const Vec3 before = piece(night).size;
  auto* keep = field<QCheckBox>("keepProportions");
  ASSERT_NE(keep, nullptr);
  keep->setChecked(true);
  type(field<LengthField>("pieceWidth"), std::to_string(before.x * 105).c_str());
  keep->setChecked(false);
  const Vec3 after = piece(night).size;
  EXPECT_NEAR(after.x / before.x, 1.05, 1e-4);
  EXPECT_NEAR(after.y / before.y, 1.05, 1e-4);
  EXPECT_NEAR(after.z / before.z, 1.05, 1e-4);
}

TEST_F(PropertyPanelTest, TheCatalogsLimitsAreKept) {
  select(bed);
  ASSERT_TRUE(test::waitFor([&] {
    settle();
    return field<LengthField>("pieceWidth")->maximum() < 100;
  }));
  const double width = piece(bed).size.x;
  auto* box = field<LengthField>("pieceWidth");
  type(box, "90 m");
  EXPECT_FALSE(box->problem().isEmpty());
  EXPECT_DOUBLE_EQ(piece(bed).size.x, width);
}

TEST_F(PropertyPanelTest, SeveralPiecesShowWhatTheyShareAndChangeTogether) {
  select(bed, night);
  EXPECT_EQ(title(), "2 pieces of furniture");
  auto* x = field<LengthField>("pieceX");
  auto* y = field<LengthField>("pieceY");
  ASSERT_NE(x, nullptr);
  EXPECT_TRUE(x->mixed());
  EXPECT_FALSE(y->mixed());
  EXPECT_EQ(y->text(), "300 cm");
  type(x, "1m");
  EXPECT_DOUBLE_EQ(piece(bed).position.x, 1);
  EXPECT_DOUBLE_EQ(piece(night).position.x, 1);
  EXPECT_FALSE(x->mixed());
  editor.undo();
  EXPECT_DOUBLE_EQ(piece(bed).position.x, 2);
  EXPECT_DOUBLE_EQ(piece(night).position.x, 0.5);
}

TEST_F(PropertyPanelTest, WrongWordsChangeNothing) {
  select(bed);
  auto* depth = field<LengthField>("pieceDepth");
  const Home before = editor.home();
  type(depth, "two metres");
  EXPECT_EQ(editor.home(), before);
  EXPECT_FALSE(depth->problem().isEmpty());
  EXPECT_FALSE(editor.document().canUndo());
}

TEST_F(PropertyPanelTest, ADragUpdatesNumbersAndLeavesTypingAlone) {
  select(bed);
  auto* width = field<LengthField>("pieceWidth");
  auto* x = field<LengthField>("pieceX");
  width->setFocus();
  QTest::qWait(1);
  QTest::keyClicks(width, "15");
  editor.document().begin("Move");
  for (int i = 1; i <= 20; ++i) {
    Elements moved;
    idap::add(moved, bed);
    editor.preview([&](const Home& home) { return moveElements(home, moved, {i * 0.01, 0, 0}); });
  }
  editor.document().commit();
  settle();
  EXPECT_EQ(x->text(), "220 cm");
  EXPECT_EQ(width->text(), "15");
  QTest::keyClicks(width, "0");
  QTest::keyClick(width, Qt::Key_Return);
  EXPECT_DOUBLE_EQ(piece(bed).size.x, 1.5);
  EXPECT_DOUBLE_EQ(piece(bed).position.x, 2.2);
}

TEST_F(PropertyPanelTest, HalfTypedNumbersGoToWhatWasSelectedThen) {
  select(bed);
  auto* x = field<LengthField>("pieceX");
  x->setFocus();
  QTest::qWait(1);
  QTest::keyClicks(x, "150");
  select(night);
  EXPECT_DOUBLE_EQ(piece(bed).position.x, 1.5);
  EXPECT_DOUBLE_EQ(piece(night).position.x, 0.5);
  EXPECT_EQ(x->text(), "50 cm");
}

// All of a large home at once: well within the pause between two updates.
TEST_F(PropertyPanelTest, ManyPiecesAreShownAtOnce) {
  editor.apply("Many", [&](const Home& home) {
    Home next = home;
    for (int i = 0; i < 2000; ++i) {
      Furniture copy = *home.furniture.find(bed);
      copy.position.x = i * 0.01;
      next.furniture.set(next.newId<FurnitureId>(), copy);
    }
    return next;
  });
  Elements all;
  for (const auto& [id, each] : editor.home().furniture) all.furniture.push_back(id);
  editor.select(all);
  settle();
  EXPECT_EQ(title(), "2003 pieces of furniture");
  panel.hide();
  editor.apply("Rename", [&](const Home& home) {
    return changePieces(home, all, [](Piece& each) { each.name = "Thing"; });
  });
  panel.show();
  EXPECT_EQ(field<TextField>("pieceName")->value(), "Thing");
}

TEST_F(PropertyPanelTest, HiddenPanelsDoNothingUntilShown) {
  select(bed);
  panel.hide();
  select(night);
  EXPECT_NE(title(), "2 pieces of furniture");
  select(bed, night);
  EXPECT_NE(title(), "2 pieces of furniture");
  panel.show();
  EXPECT_EQ(title(), "2 pieces of furniture");
}

TEST_F(PropertyPanelTest, UnitsFollowTheSettings) {
  select(bed);
  EditorSettings settings = editor.settings();
  settings.unit = LengthUnit::FeetInches;
  editor.setSettings(settings);
  settle();
  EXPECT_TRUE(field<LengthField>("pieceX")->text().contains("'"));
}

TEST_F(PropertyPanelTest, FocusFirstGoesToTheFirstField) {
  select(bed);
  panel.focusFirst();
  auto* name = field<TextField>("pieceName");
  EXPECT_TRUE(name->hasFocus());
  QTest::keyClick(name, Qt::Key_Tab);
  EXPECT_TRUE(field<QCheckBox>("pieceNameVisible")->hasFocus());
}

TEST_F(PropertyPanelTest, NamesAndSwitches) {
  select(bed);
  type(field<TextField>("pieceName"), "Big bed");
  EXPECT_EQ(piece(bed).name, "Big bed");
  EXPECT_EQ(title(), "Big bed");
  QTest::mouseClick(field<QCheckBox>("pieceVisible"), Qt::LeftButton, {}, {8, 8});
  EXPECT_FALSE(piece(bed).visible);
}

TEST_F(PropertyPanelTest, AnglesAreDegrees) {
  select(bed);
  type(field<NumberField>("pieceAngle"), "90-15");
  EXPECT_NEAR(piece(bed).angle, 75 * kPi / 180, 1e-12);
}

TEST_F(PropertyPanelTest, FinishByPartOfTheModel) {
  select(bed);
  ASSERT_TRUE(test::waitFor([&] {
    settle();
    for (const auto* picker : panel.findChildren<MaterialPicker*>())
      if (picker->objectName().startsWith("slot-") && picker->isVisible()) return true;
    return false;
  }));
  for (auto* picker : panel.findChildren<MaterialPicker*>()) {
    if (!picker->objectName().startsWith("slot-")) continue;
    FinishChoice choice;
    choice.finish.material = "walnut";
    emit picker->finishChosen(choice);
    settle();
    const std::string part = picker->objectName().mid(5).toStdString();
    EXPECT_EQ(piece(bed).slotFinishes.at(part).material, "walnut");
    EXPECT_EQ(picker->words(), "Walnut");
    choice.finish = {};
    emit picker->finishChosen(choice);
    EXPECT_FALSE(piece(bed).slotFinishes.contains(part));
    break;
  }
}

TEST_F(PropertyPanelTest, LampsAreDimmedInOneStepADrag) {
  select(lamp);
  auto* dimmer = field<SliderField>("lampDimmer");
  ASSERT_NE(dimmer, nullptr);
  QSlider* slider = dimmer->slider();
  slider->setSliderDown(true);
  for (int percent = 90; percent >= 40; percent -= 10) slider->setValue(percent);
  EXPECT_NEAR(piece(lamp).lamp->dimmer, 0.4, 1e-9);  // seen while dragged
  EXPECT_FALSE(editor.document().canUndo());
  slider->setSliderDown(false);
  EXPECT_EQ(editor.document().undoName(), "Dim lamp");
  editor.undo();
  EXPECT_DOUBLE_EQ(piece(lamp).lamp->dimmer, 1);
  EXPECT_FALSE(editor.document().canUndo());
  type(field<NumberField>("lampLumens"), "400*2");
  EXPECT_DOUBLE_EQ(piece(lamp).lamp->lumens, 800);
}

TEST_F(PropertyPanelTest, WallsTakeTheirNeighboursAlong) {
  select(wall);
  const Wall before = *editor.home().walls.find(wall);
  const double length = WallPath(before).length();
  const double area = floorArea(*editor.home().rooms.find(room));
  const std::string wish = std::to_string(length * 100 + 50);
  type(field<LengthField>("wallLength"), wish.c_str());
  const Wall after = *editor.home().walls.find(wall);
  EXPECT_NEAR(WallPath(after).length(), length + 0.5, 1e-6);
  const Wall* joined = editor.home().walls.find(after.neighbourAtEnd);
  ASSERT_NE(joined, nullptr);
  EXPECT_GT(floorArea(*editor.home().rooms.find(room)), area + 0.5);  // and the room
  EXPECT_TRUE(idap::length(joined->start - after.end) < 1e-9 || idap::length(joined->end - after.end) < 1e-9);
  editor.undo();
  EXPECT_EQ(*editor.home().walls.find(wall), before);
}

TEST_F(PropertyPanelTest, SkirtingBoardsBySide) {
  select(wall);
  auto* left = panel.findChild<QWidget*>("wallLeftSection");
  ASSERT_NE(left, nullptr);
  auto* board = left->findChild<QCheckBox*>("sideBaseboard");
  QTest::mouseClick(board, Qt::LeftButton, {}, {8, 8});
  settle();
  EXPECT_TRUE(editor.home().walls.find(wall)->left.baseboard.has_value());
  EXPECT_FALSE(editor.home().walls.find(wall)->right.baseboard.has_value());
  type(left->findChild<LengthField*>("boardHeight"), "9");
  EXPECT_DOUBLE_EQ(editor.home().walls.find(wall)->left.baseboard->height, 0.09);
}

TEST_F(PropertyPanelTest, DoorsMoveAlongTheirWallAndSwing) {
  ASSERT_TRUE(door);
  select(door);
  EXPECT_EQ(field<LengthField>("pieceX"), nullptr);
  type(field<LengthField>("openingFromStart"), "20");
  const Opening moved = *editor.home().openings.find(door);
  const Wall& in = *editor.home().walls.find(wall);
  EXPECT_NEAR(WallPath(in).nearest({moved.position.x, moved.position.y}) - moved.size.x / 2, 0.2, 1e-9);
  QTest::mouseClick(field<QPushButton>("openingHand"), Qt::LeftButton);
  EXPECT_TRUE(editor.home().openings.find(door)->mirrored);
  QTest::mouseClick(field<QPushButton>("openingDirection"), Qt::LeftButton);
  const Opening turned = *editor.home().openings.find(door);
  EXPECT_FALSE(turned.mirrored);
  EXPECT_NEAR(std::abs(std::remainder(turned.angle - moved.angle, 2 * kPi)), kPi, 1e-9);
}

TEST_F(PropertyPanelTest, CamerasHaveFocalLengths) {
  select(camera);
  type(field<NumberField>("cameraFocalLength"), "18");
  EXPECT_NEAR(editor.home().cameras.find(camera)->fieldOfView, kPi / 2, 1e-9);
  EXPECT_EQ(field<NumberField>("cameraFieldOfView")->text(), QString::fromUtf8("90°"));
  type(field<LengthField>("cameraHeight"), "120");
  EXPECT_DOUBLE_EQ(editor.home().cameras.find(camera)->eye.z, 1.2);
}

TEST_F(PropertyPanelTest, TextsTakeSeveralLines) {
  select(label);
  auto* text = field<TextArea>("labelText");
  ASSERT_NE(text, nullptr);
  text->setFocus();
  text->selectAll();
  QTest::keyClicks(text, "North");
  QTest::keyClick(text, Qt::Key_Return, Qt::ControlModifier);
  EXPECT_EQ(editor.home().labels.find(label)->text, "North");
}

TEST_F(PropertyPanelTest, GroupsMoveAndDissolve) {
  Elements both;
  idap::add(both, bed);
  idap::add(both, night);
  GroupId group;
  editor.apply("Group", [&](const Home& home) {
    GroupEdit edit = groupElements(home, both, "Sleeping");
    group = edit.group;
    return edit.home;
  });
  select(group);
  EXPECT_EQ(title(), "Sleeping");
  const double gap = piece(bed).position.x - piece(night).position.x;
  type(field<LengthField>("groupX"), "300");
  EXPECT_NEAR(piece(bed).position.x - piece(night).position.x, gap, 1e-9);
  EXPECT_EQ(field<LengthField>("groupX")->text(), "300 cm");
  QTest::mouseClick(field<QPushButton>("ungroup"), Qt::LeftButton);
  EXPECT_TRUE(editor.home().groups.empty());
  EXPECT_EQ(editor.selection().furniture.size(), 2u);
}

TEST_F(PropertyPanelTest, MixedKindsAreCountedAndDeletedTogether) {
  select(wall, bed, label);
  EXPECT_EQ(title(), "3 elements");
  EXPECT_EQ(panel.findChild<QLabel*>("propertySubtitle")->text(), "1 piece of furniture, 1 wall, 1 text");
  EXPECT_EQ(field<LengthField>("pieceWidth"), nullptr);
  QTest::mouseClick(field<QPushButton>("commonDelete"), Qt::LeftButton);
  EXPECT_FALSE(editor.home().walls.contains(wall));
  EXPECT_FALSE(editor.home().labels.contains(label));
  editor.undo();
  EXPECT_TRUE(editor.home().furniture.contains(bed));
}

TEST_F(PropertyPanelTest, NothingSelectedShowsTheHome) {
  settle();
  EXPECT_EQ(title(), "Home");
  type(field<TextField>("homeTitle"), "House by the lake");
  EXPECT_EQ(editor.home().title, "House by the lake");
  type(field<LengthField>("homeWallHeight"), "2.8m");
  EXPECT_DOUBLE_EQ(editor.home().wallHeight, 2.8);
  type(field<NumberField>("siteLatitude"), "52.5");
  EXPECT_NEAR(editor.home().site.latitude, 52.5 * kPi / 180, 1e-12);
}

// Every text three times as long, as other languages may have it.
class LongTranslator : public QTranslator {
 public:
  bool isEmpty() const override { return false; }
  QString translate(const char*, const char* source, const char*, int) const override {
    return QString::fromUtf8(source) + QStringLiteral(" or quite the same");
  }
};

TEST_F(PropertyPanelTest, LanguageIsSwitchedAtRunTime) {
  select(bed);
  LongTranslator translator;
  qApp->installTranslator(&translator);
  settle();
  const auto labels = panel.findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(),
                          [](const QLabel* l) { return l->text() == "Width or quite the same"; }));
  qApp->removeTranslator(&translator);
  settle();
  EXPECT_TRUE(
      std::any_of(labels.begin(), labels.end(), [](const QLabel* l) { return l->text() == "Width"; }));
}

// Nothing sticks out of the panel, whatever is selected, however narrow it is and however long the words are.
TEST_F(PropertyPanelTest, FitsNarrowPanelsInAllLanguages) {
  const auto look = [&](const std::string& name) {
    for (const int width : {260, 340}) {
      panel.resize(width, 1000);
      settle();
      const auto* scroll = panel.findChild<QScrollArea*>("propertyScroll");
      EXPECT_LE(scroll->widget()->minimumSizeHint().width(), scroll->viewport()->width())
          << name << " " << width;
      for (const QWidget* child : scroll->widget()->findChildren<QWidget*>()) {
        if (!child->isVisible() || child->parentWidget()->objectName() == "qt_spinbox_lineedit") continue;
        const int right = child->mapTo(scroll->widget(), QPoint(child->width(), 0)).x();
        EXPECT_LE(right, scroll->widget()->width()) << name << " " << child->objectName().toStdString();
      }
      test::shoot(panel, (name + "-" + std::to_string(width)).c_str());
    }
  };
  const auto lookAtAll = [&](const std::string& theme) {
    select();
    look(theme + "-home");
    select(bed);
    test::waitFor([&] {
      for (const auto* picker : panel.findChildren<MaterialPicker*>())
        if (picker->objectName().startsWith("slot-") && picker->isVisible()) return true;
      return false;
    });
    look(theme + "-bed");
    select(bed, night);
    look(theme + "-two");
    select(lamp);
    look(theme + "-lamp");
    select(door);
    look(theme + "-door");
    select(wall);
    look(theme + "-wall");
    select(room);
    look(theme + "-room");
    select(camera);
    look(theme + "-camera");
    select(dimension);
    look(theme + "-dimension");
    select(label);
    look(theme + "-label");
    select(line);
    look(theme + "-line");
    select(wall, bed, label);
    look(theme + "-mixed");
  };
  lookAtAll("light");
  LongTranslator translator;
  qApp->installTranslator(&translator);
  lookAtAll("long");
  qApp->removeTranslator(&translator);
  if (qEnvironmentVariableIsEmpty("IDAP_SHOTS")) return;
  const QPalette usual = QApplication::palette();
  QPalette dark;
  dark.setColor(QPalette::Window, QColor(45, 47, 50));
  dark.setColor(QPalette::WindowText, QColor(230, 230, 230));
  dark.setColor(QPalette::Base, QColor(30, 31, 33));
  dark.setColor(QPalette::Text, QColor(230, 230, 230));
  dark.setColor(QPalette::Button, QColor(60, 62, 66));
  dark.setColor(QPalette::ButtonText, QColor(230, 230, 230));
  dark.setColor(QPalette::PlaceholderText, QColor(150, 150, 150));
  dark.setColor(QPalette::Highlight, QColor(60, 110, 180));
  QApplication::setPalette(dark);
  lookAtAll("dark");
  QApplication::setPalette(usual);
}

}  // namespace
}  // namespace idap
