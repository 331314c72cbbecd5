#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include "editor/selection.h"
#include "gui/support/gui_support.h"
#include "model/edits/piece_edits.h"
#include "studio/lists/camera_list.h"
#include "studio/lists/furniture_list.h"
#include "studio/lists/message_list.h"
#include "studio/lists/piece_columns.h"

namespace idap {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::shared_ptr<const Catalog> builtinOnly() {
  static const auto catalog = std::make_shared<const Catalog>(std::vector<std::filesystem::path>{});
  return catalog;
}

Furniture piece(const char* name, double width, std::optional<double> price = {}) {
  Furniture f;
  f.name = name;
  f.model.catalogId = "idap/chair-windsor";
  f.size = {width, 0.5, 0.9};
  f.price = price;
  return f;
}

class FurnitureListTest : public testing::Test {
 protected:
  FurnitureListTest() : editor(builtinOnly()) {
    QSettings().clear();
    Home home;
    bed = add(home, piece("Bed", 1.6, 640));
    chair = add(home, piece("Chair", 0.45, 79.5));
    wardrobe = add(home, piece("Wardrobe \"Oslo\", white", 2));
    editor.open(std::make_unique<Document>(home));
    list = std::make_unique<FurnitureList>(editor);
    list->resize(720, 240);
    list->show();
    view = list->findChild<QTreeView*>("furnitureTable");
  }

  static FurnitureId add(Home& home, Furniture f) {
    const FurnitureId id = home.newId<FurnitureId>();
    home.furniture.set(id, std::move(f));
    return id;
  }
  QStringList names() const {
    QStringList all;
    for (int i = 0; i < view->model()->rowCount(); ++i) all << view->model()->index(i, 0).data().toString();
    return all;
  }
  QModelIndex cell(int row, PieceColumn column) const { return view->model()->index(row, int(column)); }
  QPoint middle(const QModelIndex& index) const { return view->visualRect(index).center(); }
  void clickHeader(PieceColumn column) {
    QHeaderView* header = view->header();
    const QPoint at(header->sectionViewportPosition(int(column)) + 10, header->height() / 2);
    QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, at);
  }
  void edit(const QModelIndex& index, const QString& text) {
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, middle(index));
    QTest::mouseDClick(view->viewport(), Qt::LeftButton, {}, middle(index));
    auto* field = view->viewport()->findChild<QLineEdit*>();
    ASSERT_TRUE(field);
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
    QTest::qWait(5);  // the view takes it after the key
  }

  Editor editor;
  FurnitureId bed, chair, wardrobe;
  std::unique_ptr<FurnitureList> list;
  QTreeView* view = nullptr;
};

TEST_F(FurnitureListTest, SortsByWidthWhenItsHeaderIsClicked) {
  EXPECT_THAT(names(), ElementsAre("Bed", "Chair", "Wardrobe \"Oslo\", white"));
  clickHeader(PieceColumn::Width);
  EXPECT_THAT(names(), ElementsAre("Chair", "Bed", "Wardrobe \"Oslo\", white"));
  clickHeader(PieceColumn::Width);
  EXPECT_THAT(names(), ElementsAre("Wardrobe \"Oslo\", white", "Bed", "Chair"));
  test::shoot(*list, "furniture-list");
}

TEST_F(FurnitureListTest, SelectingARowSelectsThePieceAndTheOtherWayRound) {
  QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, middle(cell(1, PieceColumn::Name)));
  EXPECT_EQ(editor.selection().furniture, std::vector{chair});
  QTest::mouseClick(view->viewport(), Qt::LeftButton, Qt::ControlModifier,
                    middle(cell(0, PieceColumn::Name)));
  EXPECT_EQ(editor.selection().furniture, (std::vector{bed, chair}));
  editor.select(only(wardrobe));
  ASSERT_TRUE(test::waitFor([&] { return view->selectionModel()->selectedRows().size() == 1; }));
  EXPECT_EQ(view->selectionModel()->selectedRows().front().row(), 2);
  EXPECT_EQ(editor.selection().furniture, std::vector{wardrobe});
}

TEST_F(FurnitureListTest, ShowsCountAndTotalPrice) {
  EXPECT_EQ(list->findChild<QLabel*>("furnitureCount")->text(), "Pieces: 3");
  EXPECT_EQ(list->findChild<QLabel*>("furnitureTotal")->text(),
            QStringLiteral("Total %1 EUR").arg(QLocale().toString(719.5, 'f', 2)));
}

TEST_F(FurnitureListTest, FollowsEditsUndoAndRedo) {
  editor.apply("Add", [](const Home& home) { return addFurniture(home, piece("Lamp", 0.3)).home; });
  ASSERT_TRUE(test::waitFor([&] { return view->model()->rowCount() == 4; }));
  editor.undo();
  ASSERT_TRUE(test::waitFor([&] { return view->model()->rowCount() == 3; }));
  editor.apply("Rename", [this](const Home& home) {
    return changePieces(home, only(bed), [](Piece& p) { p.name = "Cot"; });
  });
  EXPECT_TRUE(test::waitFor([&] { return names().contains("Cot"); }));
}

TEST_F(FurnitureListTest, RenamesInPlaceAsOneUndoStep) {
  edit(cell(0, PieceColumn::Name), "Guest bed");
  EXPECT_EQ(editor.home().furniture.find(bed)->name, "Guest bed");
  editor.undo();
  EXPECT_EQ(editor.home().furniture.find(bed)->name, "Bed");
}

TEST_F(FurnitureListTest, TakesAPriceAndRefusesWords) {
  edit(cell(2, PieceColumn::Price), "1200.50");
  EXPECT_EQ(editor.home().furniture.find(wardrobe)->price, 1200.5);
  edit(cell(2, PieceColumn::Price), "cheap");
  EXPECT_EQ(editor.home().furniture.find(wardrobe)->price, 1200.5);
  editor.undo();
  EXPECT_FALSE(editor.home().furniture.find(wardrobe)->price);
}

TEST_F(FurnitureListTest, TicksHideAPiece) {
  const QModelIndex visible = cell(0, PieceColumn::Visible);
  ASSERT_EQ(visible.data(Qt::CheckStateRole).toInt(), Qt::Checked);
  const QRect rect = view->visualRect(visible);
  QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, QPoint(rect.left() + 10, rect.center().y()));
  EXPECT_FALSE(editor.home().furniture.find(bed)->visible);
  editor.undo();
  EXPECT_TRUE(editor.home().furniture.find(bed)->visible);
}

TEST_F(FurnitureListTest, GroupsFold) {
  Elements both;
  both.furniture = {bed, chair};
  editor.apply("Group", [&](const Home& home) { return groupElements(home, both, "Corner").home; });
  ASSERT_TRUE(test::waitFor([&] { return view->model()->rowCount() == 2; }));
  EXPECT_EQ(names().front(), "Corner");
  EXPECT_EQ(view->model()->rowCount(view->model()->index(0, 0)), 2);
}

TEST_F(FurnitureListTest, FilterLeavesWhatHoldsTheWords) {
  QTest::keyClicks(list->findChild<QLineEdit*>("furnitureFilter"), "oslo");
  EXPECT_EQ(names().size(), 1);
}

TEST_F(FurnitureListTest, CsvQuotesAsRfc4180) {
  QStringList lines = QString::fromStdString(list->csv()).split("\r\n");
  ASSERT_EQ(lines.size(), 5);
  EXPECT_TRUE(lines[0].startsWith("Name,Width (cm),Depth (cm),Height (cm)")) << lines[0].toStdString();
  EXPECT_TRUE(lines[1].startsWith("Bed,160,50,90")) << lines[1].toStdString();
  EXPECT_TRUE(lines[3].startsWith("\"Wardrobe \"\"Oslo\"\", white\",200,50,90")) << lines[3].toStdString();
  EXPECT_THAT(lines[1].toStdString(), HasSubstr("640.00"));
  EXPECT_TRUE(lines[4].isEmpty());
}

TEST_F(FurnitureListTest, KeepsTheColumnsChosen) {
  view->header()->setSectionHidden(int(PieceColumn::Price), true);
  view->header()->moveSection(view->header()->visualIndex(int(PieceColumn::Height)), 1);
  list.reset();
  list = std::make_unique<FurnitureList>(editor);
  view = list->findChild<QTreeView*>("furnitureTable");
  EXPECT_TRUE(view->isColumnHidden(int(PieceColumn::Price)));
  EXPECT_EQ(view->header()->visualIndex(int(PieceColumn::Height)), 1);
  EXPECT_TRUE(QString::fromStdString(list->csv()).startsWith("Name,Height (cm),Width (cm)"));
}

TEST_F(FurnitureListTest, ADragAmongTwoThousandPiecesLeavesTheOtherRowsAlone) {
  Home home;
  for (int i = 0; i < 2000; ++i) add(home, piece("Piece", 0.3 + 0.001 * i, 10));
  editor.open(std::make_unique<Document>(home));
  const FurnitureId moved = home.furniture.begin()->first;
  editor.select(only(moved));
  QTest::qWait(50);
  editor.document().begin("Move");
  const QAbstractItemModel* rows = view->model();
  const QSignalSpy reset(rows, &QAbstractItemModel::modelReset),
      added(rows, &QAbstractItemModel::rowsInserted), removed(rows, &QAbstractItemModel::rowsRemoved);
  for (int step = 1; step <= 60; ++step) {
    editor.preview([&](const Home& before) {
      return moveElements(before, only(moved), {0.01 * step, 0, 0});
    });
    QApplication::processEvents();
    QTest::qWait(2);
  }
  editor.document().commit();
  QTest::qWait(200);
  EXPECT_EQ(reset.count() + added.count() + removed.count(), 0);
  EXPECT_EQ(rows->rowCount(), 2000);
}

class MessageListTest : public testing::Test {
 protected:
  Editor editor{builtinOnly()};
  MessageList list{editor};
  QListWidget* view = list.findChild<QListWidget*>("messages");
};

TEST_F(MessageListTest, CountsWarningsUntilItIsLookedAt) {
  QSignalSpy unseen(&list, &MessageList::unseen);
  editor.say("Saved");
  editor.say("No wall here", Editor::Severity::Warning);
  editor.say({"Cannot read %1", {"a.obj"}}, Editor::Severity::Error);
  ASSERT_EQ(unseen.size(), 2);
  EXPECT_EQ(unseen.back().front().toInt(), 2);
  list.resize(420, 160);
  list.show();
  EXPECT_EQ(unseen.back().front().toInt(), 0);
  EXPECT_EQ(view->count(), 3);
  EXPECT_TRUE(view->item(2)->text().contains("Cannot read a.obj"));
  editor.say("While it is seen", Editor::Severity::Warning);
  EXPECT_EQ(unseen.back().front().toInt(), 0);
  test::shoot(list, "messages");
}

TEST_F(MessageListTest, PutsRepeatsOnOneLineAndCopiesAll) {
  for (int i = 0; i < 3; ++i) editor.say("No wall here", Editor::Severity::Warning);
  EXPECT_EQ(view->count(), 1);
  EXPECT_TRUE(view->item(0)->text().endsWith(QStringLiteral("(×3)")));
  list.show();
  QTest::mouseClick(list.findChild<QToolButton*>("messagesCopy"), Qt::LeftButton);
  EXPECT_TRUE(QGuiApplication::clipboard()->text().contains("No wall here"));
}

class CameraListTest : public testing::Test {
 protected:
  CameraListTest() {
    Home home;
    for (const char* name : {"Door", "Window"}) {
      Camera camera;
      camera.name = name;
      cameras.push_back(home.newId<CameraId>());
      home.cameras.set(cameras.back(), camera);
    }
    editor.open(std::make_unique<Document>(home));
    list.resize(280, 200);
    list.show();
  }
  QStringList names() const {
    QStringList all;
    for (int i = 0; i < view->model()->rowCount(); ++i) all << view->model()->index(i, 0).data().toString();
    return all;
  }
  void click(int row) {
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {},
                      view->visualRect(view->model()->index(row, 0)).center());
  }
  void press(const char* button) { QTest::mouseClick(list.findChild<QToolButton*>(button), Qt::LeftButton); }

  Editor editor{builtinOnly()};
  CameraList list{editor};
  QListView* view = list.findChild<QListView*>("cameras");
  std::vector<CameraId> cameras;
};

TEST_F(CameraListTest, BeginsWithTheViewFromAbove) {
  EXPECT_THAT(names(), ElementsAre("From above", "Door", "Window"));
  EXPECT_EQ(list.current(), CameraId{});
  test::shoot(list, "cameras");
}

TEST_F(CameraListTest, RenamesInPlaceAndUndoes) {
  click(1);
  EXPECT_EQ(list.current(), cameras[0]);
  QTest::keyClick(view, Qt::Key_F2);
  auto* field = view->viewport()->findChild<QLineEdit*>();
  ASSERT_TRUE(field);
  field->selectAll();
  QTest::keyClicks(field, "From the door");
  QTest::keyClick(field, Qt::Key_Return);
  QTest::qWait(5);
  EXPECT_EQ(editor.home().cameras.find(cameras[0])->name, "From the door");
  editor.undo();
  EXPECT_THAT(names(), ElementsAre("From above", "Door", "Window"));
}

TEST_F(CameraListTest, DuplicatesOrdersAndDeletes) {
  click(2);
  press("cameraUpButton");
  EXPECT_THAT(names(), ElementsAre("From above", "Window", "Door"));
  EXPECT_EQ(view->currentIndex().row(), 1);
  press("cameraDuplicateButton");
  EXPECT_THAT(names(), ElementsAre("From above", "Window", "Door", "Window"));
  QTest::keyClick(view, Qt::Key_Delete);
  EXPECT_THAT(names(), ElementsAre("From above", "Window", "Door"));
  editor.undo();
  editor.undo();
  editor.undo();
  EXPECT_THAT(names(), ElementsAre("From above", "Door", "Window"));
}

TEST_F(CameraListTest, ChoosingOneSelectsItOnThePlanAndTheOtherWayRound) {
  QSignalSpy changed(&list, &CameraList::currentChanged);
  click(1);
  EXPECT_EQ(editor.selection().cameras, std::vector{cameras[0]});
  EXPECT_EQ(changed.size(), 1);
  editor.select(only(cameras[1]));
  EXPECT_EQ(list.current(), cameras[1]);
  EXPECT_EQ(changed.size(), 2);
}

TEST_F(CameraListTest, ADoubleClickAsksForThePicture) {
  QSignalSpy wanted(&list, &CameraList::pictureRequested);
  click(2);
  QTest::mouseDClick(view->viewport(), Qt::LeftButton, {},
                     view->visualRect(view->model()->index(2, 0)).center());
  EXPECT_EQ(wanted.size(), 1);
  EXPECT_EQ(list.current(), cameras[1]);
}

}  // namespace
}  // namespace idap
