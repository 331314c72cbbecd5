#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QDrag>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QMimeData>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "gui/support/gui_support.h"
#include "model/edits/piece_edits.h"
#include "studio/catalog/catalog_model.h"
#include "studio/catalog/catalog_panel.h"
#include "studio/catalog/thumbnail_store.h"
#include "studio/widgets/length_field.h"
#include "studio/widgets/mime_types.h"

namespace idap {
namespace {

using testing::Each;
using testing::HasSubstr;

class CatalogPanelTest : public testing::Test {
 protected:
  CatalogPanelTest() { QSettings().clear(); }

  void open(std::vector<std::filesystem::path> folders = {}) {
    catalog = std::make_shared<const Catalog>(std::move(folders));
    editor = std::make_unique<Editor>(catalog);
    store = std::make_unique<ThumbnailStore>(catalog, nullptr, cache.path().toStdString());
    panel = std::make_unique<CatalogPanel>(*editor, *store);
    panel->resize(300, 640);
    panel->show();
    grid = panel->findChild<QListView*>("catalogGrid");
    search = panel->findChild<QLineEdit*>("catalogSearch");
    categories = panel->findChild<QListWidget*>("catalogCategories");
    ASSERT_TRUE(grid && search && categories);
    ASSERT_TRUE(test::waitFor([&] { return model().complete(); }));
  }

  CatalogModel& model() { return *qobject_cast<CatalogModel*>(grid->model()); }
  QStringList shown() {
    QStringList names;
    for (int i = 0; i < model().rowCount(); ++i) names << model().index(i).data().toString();
    return names;
  }
  void chooseCategory(const QString& name) {
    const auto found = categories->findItems(name, Qt::MatchExactly);
    ASSERT_EQ(found.size(), 1) << name.toStdString();
    categories->scrollToItem(found.front());
    QTest::mouseClick(categories->viewport(), Qt::LeftButton, {},
                      categories->visualItemRect(found.front()).center());
  }

  QTemporaryDir cache;
  std::shared_ptr<const Catalog> catalog;
  std::unique_ptr<Editor> editor;
  std::unique_ptr<ThumbnailStore> store;
  std::unique_ptr<CatalogPanel> panel;
  QListView* grid = nullptr;
  QLineEdit* search = nullptr;
  QListWidget* categories = nullptr;
};

TEST_F(CatalogPanelTest, ShowsAllPiecesAndTheSeventeenCategoriesWithTheirCounts) {
  open();
  EXPECT_EQ(model().rowCount(), int(catalog->builtinPieces().size()));
  EXPECT_EQ(categories->count(), 3 + 17);
  EXPECT_EQ(categories->item(3)->text(), "Chairs");
  chooseCategory("Beds");
  EXPECT_GT(model().rowCount(), 3);
  EXPECT_LT(model().rowCount(), 30);
}

TEST_F(CatalogPanelTest, EnterInTheSearchPutsTheFirstBedIntoTheHome) {
  open();
  editor->document().apply({"room", [](const Home&) { return makeRoomHome(4, 5, 2.5, 0.1, "Bedroom"); }});
  panel->focusSearch();
  QTest::keyClicks(search, "bed");
  ASSERT_GT(model().rowCount(), 0);
  EXPECT_TRUE(shown().front().contains("bed", Qt::CaseInsensitive)) << shown().front().toStdString();
  QTest::keyClick(search, Qt::Key_Return);
  ASSERT_EQ(editor->home().furniture.size(), 1u);
  EXPECT_EQ(editor->home().furniture.begin()->second->model.catalogId, model().piece(model().index(0))->id);
  editor->undo();
  EXPECT_TRUE(editor->home().furniture.empty());
}

TEST_F(CatalogPanelTest, SearchesInThaiAndShowsNamesInTheUsersLanguage) {
  open();
  EditorSettings settings = editor->settings();
  settings.language = "th";
  editor->setSettings(settings);
  search->setText(QStringLiteral("เตียง"));
  ASSERT_GT(model().rowCount(), 2);
  EXPECT_TRUE(shown().front().contains(QStringLiteral("เตียง")));
  EXPECT_EQ(categories->item(3)->text(), QStringLiteral("เก้าอี้"));
  test::shoot(*panel, "catalog-thai");
}

TEST_F(CatalogPanelTest, SearchLooksEverywhereThoughACategoryIsChosen) {
  open();
  chooseCategory("Chairs");
  QTest::keyClicks(search, "washing");
  EXPECT_THAT(model().rowCount(), testing::Gt(0));
  QTest::keyClick(search, Qt::Key_Escape);
  EXPECT_TRUE(search->text().isEmpty());
  EXPECT_EQ(model().rowCount(), int(catalog->builtinPieces().size()));
}

TEST_F(CatalogPanelTest, DownGoesFromTheSearchToTheGridAndArrowsMoveThere) {
  open();
  panel->activateWindow();
  panel->focusSearch();
  QTest::keyClicks(search, "chair");
  QTest::keyClick(search, Qt::Key_Down);
  EXPECT_EQ(grid->currentIndex().row(), 0);
  QTest::keyClick(grid, Qt::Key_Right);
  EXPECT_EQ(grid->currentIndex().row(), 1);
  QTest::keyClick(grid, Qt::Key_Return);
  EXPECT_EQ(editor->home().furniture.size(), 1u);
}

TEST_F(CatalogPanelTest, FiltersBySize) {
  open();
  QTest::mouseClick(panel->findChild<QToolButton*>("catalogSizeFilter"), Qt::LeftButton);
  auto* width = panel->findChild<LengthField*>("catalogMaxWidth");
  ASSERT_TRUE(width->isVisible());
  QTest::keyClicks(width, "60");
  QTest::keyClick(width, Qt::Key_Return);
  ASSERT_GT(model().rowCount(), 0);
  EXPECT_LT(model().rowCount(), int(catalog->builtinPieces().size()));
  for (int i = 0; i < model().rowCount(); ++i) EXPECT_LE(model().piece(model().index(i))->size.x, 0.601);
  test::shoot(*panel, "catalog-size");
  QTest::mouseClick(panel->findChild<QToolButton*>("catalogAnySize"), Qt::LeftButton);
  EXPECT_EQ(model().rowCount(), int(catalog->builtinPieces().size()));
}

TEST_F(CatalogPanelTest, TagsNarrowDownACategory) {
  open();
  chooseCategory("Chairs");
  const int all = model().rowCount();
  const auto chips = panel->findChild<QWidget*>("catalogTags")->findChildren<QToolButton*>();
  ASSERT_FALSE(chips.isEmpty());
  QTest::mouseClick(chips.front(), Qt::LeftButton);
  EXPECT_LT(model().rowCount(), all);
  EXPECT_GT(model().rowCount(), 0);
  const std::string tag = chips.front()->objectName().mid(4).toStdString();
  for (int i = 0; i < model().rowCount(); ++i)
    EXPECT_THAT(model().piece(model().index(i))->tags, testing::Contains(tag));
}

TEST_F(CatalogPanelTest, ADragCarriesThePiece) {
  open();
  chooseCategory("Sofas and armchairs");
  const QModelIndex first = model().index(0);
  QByteArray carried;
  // The drag runs its own loop where the platform has drags: it is given up from inside.
  const auto look = [&] {
    if (const auto* drag = grid->findChild<QDrag*>())
      carried = drag->mimeData()->data(QString::fromLatin1(kPieceMime));
    QDrag::cancel();
  };
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, look);
  timer.start(20);
  const QPoint from = grid->visualRect(first).center();
  QTest::mousePress(grid->viewport(), Qt::LeftButton, {}, from);
  for (int step = 1; step <= 4; ++step) {
    QMouseEvent move(QEvent::MouseMove, from + QPoint(6 * step, 0),
                     grid->viewport()->mapToGlobal(from + QPoint(6 * step, 0)), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QApplication::sendEvent(grid->viewport(), &move);
    look();
    if (!carried.isEmpty()) break;
  }
  QTest::mouseRelease(grid->viewport(), Qt::LeftButton, {}, from);
  EXPECT_EQ(carried.toStdString(), model().piece(first)->id);
}

TEST_F(CatalogPanelTest, RemembersWhatWasUsed) {
  open();
  QTest::keyClicks(search, "sofa");
  QTest::keyClick(search, Qt::Key_Return);
  const std::string used = model().piece(model().index(0))->id;
  search->clear();
  chooseCategory("Recently used");
  ASSERT_EQ(model().rowCount(), 1);
  EXPECT_EQ(model().piece(model().index(0))->id, used);
}

TEST_F(CatalogPanelTest, SaysWhenNothingIsFound) {
  open();
  QTest::keyClicks(search, "zzzz");
  EXPECT_EQ(model().rowCount(), 0);
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_TRUE(editor->home().furniture.empty());
  test::shoot(*panel, "catalog-nothing");
}

TEST_F(CatalogPanelTest, ThumbnailsComeOneAfterAnotherAndAreKeptOnDisk) {
  open();
  store->setDelay(0);
  const CatalogPiecePtr piece = catalog->find("idap/chair-windsor");
  ASSERT_TRUE(piece);
  EXPECT_TRUE(store->thumbnail(piece).isNull());
  ASSERT_TRUE(test::waitFor([&] { return !store->thumbnail(piece).isNull(); }, 60'000));
  EXPECT_EQ(store->thumbnail(piece).width(), ThumbnailStore::kSide);

  ThumbnailStore again(catalog, nullptr, cache.path().toStdString());
  again.setDelay(1'000'000);  // no tracing: it must come from the disk
  EXPECT_TRUE(test::waitFor([&] { return !again.thumbnail(piece).isNull(); }));
}

TEST_F(CatalogPanelTest, StopsAtOnceThoughManyThumbnailsAreWanted) {
  open();
  store->setDelay(0);
  for (const CatalogPiecePtr& piece : catalog->builtinPieces()) store->thumbnail(piece);
  QTest::qWait(50);
  QElapsedTimer clock;
  clock.start();
  panel.reset();
  store.reset();
  EXPECT_LT(clock.elapsed(), 20'000);  // of some minutes
}

}  // namespace
}  // namespace idap
