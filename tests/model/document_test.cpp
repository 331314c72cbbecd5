#include "model/document.h"

#include <gtest/gtest.h>

#include <random>

#include "base/error.h"
#include "support/sample_home.h"

namespace idap {
namespace {

Edit rename(std::string name) {
  return {"Rename to " + name, [name](const Home& home) {
            Home next = home;
            next.name = name;
            return next;
          }};
}

std::function<Home(const Home&)> moveTo(FurnitureId id, double x) {
  return [id, x](const Home& home) {
    Home next = home;
    Furniture piece = *home.furniture.find(id);
    piece.position.x = x;
    next.furniture.set(id, std::move(piece));
    return next;
  };
}

TEST(Document, UndoesAndRedoesStepsByName) {
  Document document;
  EXPECT_FALSE(document.canUndo());
  EXPECT_EQ(document.undoName(), "");
  document.undo();
  document.apply(rename("A"));
  document.apply(rename("B"));
  EXPECT_EQ(document.undoName(), "Rename to B");
  document.undo();
  EXPECT_EQ(document.home().name, "A");
  EXPECT_EQ(document.redoName(), "Rename to B");
  document.redo();
  EXPECT_EQ(document.home().name, "B");
  document.undo();
  document.apply(rename("C"));
  EXPECT_FALSE(document.canRedo());
  document.undo();
  document.undo();
  EXPECT_EQ(document.home(), Home{});
}

TEST(Document, RefusesAnEditThatBreaksTheHomeAndKeepsTheOldOne) {
  Document document(test::smallFlat());
  const Home before = document.home();
  EXPECT_THROW(document.apply({"Break",
                               [](const Home& home) {
                                 Home next = home;
                                 Wall flat = *home.walls.begin()->second;
                                 flat.end = flat.start;
                                 next.walls.set(home.walls.begin()->first, flat);
                                 return next;
                               }}),
               InvalidHome);
  EXPECT_EQ(document.home(), before);
  EXPECT_FALSE(document.canUndo());
  EXPECT_FALSE(document.modified());
  Home broken;
  broken.wallHeight = -1;
  EXPECT_THROW(Document{broken}, InvalidHome);
}

TEST(Document, AnEditThatThrowsOrChangesNothingLeavesNoStep) {
  Document document(test::smallFlat());
  EXPECT_THROW(document.apply({"Throw", [](const Home&) -> Home { throw Error("no"); }}), Error);
  int calls = 0;
  document.subscribe([&](const Home&, const Home&) { ++calls; });
  document.apply({"Nothing", [](const Home& home) { return home; }});
  EXPECT_FALSE(document.canUndo());
  EXPECT_EQ(calls, 0);
}

TEST(Document, ADragIsOneStepAndEveryPreviewStartsFromTheBeginning) {
  Document document(test::manyPieces(10));
  const Home before = document.home();
  std::vector<double> seen;
  document.subscribe([&](const Home&, const Home& after) {
    seen.push_back(after.furniture.find(FurnitureId{1})->position.x);
  });
  document.begin("Move");
  EXPECT_THROW(document.apply(rename("X")), InvalidHome);
  EXPECT_THROW(document.begin("Again"), InvalidHome);
  document.preview(moveTo(FurnitureId{1}, 5));
  document.preview(moveTo(FurnitureId{2}, 7));
  EXPECT_EQ(document.home().furniture.find(FurnitureId{1})->position.x, 0);
  document.preview(moveTo(FurnitureId{1}, 6));
  EXPECT_FALSE(document.canUndo());
  document.undo();  // not during a drag
  EXPECT_THROW(document.preview(moveTo(FurnitureId{1}, std::nan(""))), InvalidHome);
  EXPECT_EQ(document.home().furniture.find(FurnitureId{1})->position.x, 6);
  document.commit();
  EXPECT_EQ(seen, (std::vector<double>{5, 0, 6}));
  EXPECT_EQ(document.undoName(), "Move");
  document.undo();
  EXPECT_EQ(document.home(), before);
  EXPECT_FALSE(document.canUndo());
}

TEST(Document, CancellingADragLeavesNothingBehind) {
  Document document(test::manyPieces(3));
  const Home before = document.home();
  document.begin("Move");
  document.preview(moveTo(FurnitureId{1}, 5));
  EXPECT_TRUE(document.modified());
  document.cancel();
  EXPECT_EQ(document.home(), before);
  EXPECT_FALSE(document.modified());
  EXPECT_FALSE(document.canUndo());
  document.cancel();
  EXPECT_THROW(document.commit(), InvalidHome);
  EXPECT_THROW(document.preview(moveTo(FurnitureId{1}, 5)), InvalidHome);
}

TEST(Document, ADragBackToTheStartIsNoStep) {
  Document document(test::manyPieces(3));
  document.begin("Move");
  document.preview(moveTo(FurnitureId{1}, 5));
  document.preview(moveTo(FurnitureId{1}, 0));
  document.commit();
  EXPECT_FALSE(document.canUndo());
  EXPECT_FALSE(document.modified());
}

TEST(Document, KnowsWhetherItDiffersFromTheFile) {
  Document document;
  document.apply(rename("A"));
  EXPECT_TRUE(document.modified());
  document.markSaved("home.idap");
  EXPECT_EQ(document.file(), "home.idap");
  EXPECT_FALSE(document.modified());
  document.apply(rename("B"));
  EXPECT_TRUE(document.modified());
  document.undo();
  EXPECT_FALSE(document.modified());
  document.undo();
  EXPECT_TRUE(document.modified());
  document.apply(rename("C"));
  EXPECT_TRUE(document.modified()) << "another branch of history is not what was saved";
}

TEST(Document, ListenersMayComeAndGoWhileBeingCalled) {
  Document document;
  int first = 0, second = 0, secondHandle = 0;
  int firstHandle = 0;
  firstHandle = document.subscribe([&](const Home& before, const Home& after) {
    EXPECT_NE(before.name, after.name);
    ++first;
    document.unsubscribe(firstHandle);
    document.unsubscribe(secondHandle);
  });
  secondHandle = document.subscribe([&](const Home&, const Home&) { ++second; });
  document.apply(rename("A"));
  document.apply(rename("B"));
  EXPECT_EQ(first, 1);
  EXPECT_EQ(second, 0);
}

TEST(Document, AThousandRandomEditsUndoneGiveTheSameHome) {
  std::mt19937 random(11);
  Document document(test::manyPieces(200));
  std::vector<Home> history{document.home()};
  for (int i = 0; i < 1000; ++i) {
    document.apply({"Edit", [&](const Home& home) {
                      Home next = home;
                      const FurnitureId id{1 + random() % (home.nextId - 1)};
                      const Furniture* found = home.furniture.find(id);
                      if (!found || random() % 4 == 0) {
                        next.furniture.set(next.newId<FurnitureId>(), Furniture{});
                      } else if (random() % 4 == 0) {
                        next.furniture.erase(id);
                      } else {
                        Furniture piece = *found;
                        piece.position.y += 0.1;
                        next.furniture.set(id, std::move(piece));
                      }
                      return next;
                    }});
    history.push_back(document.home());
  }
  for (std::size_t i = history.size(); i-- > 1;) {
    ASSERT_EQ(document.home(), history[i]);
    document.undo();
  }
  EXPECT_EQ(document.home(), history[0]);
  EXPECT_FALSE(document.canUndo());
  while (document.canRedo()) document.redo();
  EXPECT_EQ(document.home(), history.back());
}

}  // namespace
}  // namespace idap
