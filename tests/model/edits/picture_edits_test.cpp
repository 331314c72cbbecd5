#include "model/edits/picture_edits.h"

#include <gtest/gtest.h>

#include "model/document.h"
#include "support/sample_home.h"

namespace idap::test {
namespace {

Edit titled(const char* title) {
  return {"Title", [title](const Home& home) {
            Home next = home;
            next.title = title;
            return next;
          }};
}

TEST(PictureEdits, APictureComesAndGoesWithItsFile) {
  const Home home = addPicture(Home{}, PictureId{7}, Picture{.name = "Day"}, bytesOf("png"));
  ASSERT_EQ(home.pictures.size(), 1u);
  const std::string asset = home.pictures.find(PictureId{7})->asset;
  EXPECT_TRUE(home.assets->contains(asset));
  EXPECT_GT(home.nextId, 7u);
  const Home without = removePicture(home, PictureId{7});
  EXPECT_TRUE(without.pictures.empty());
  EXPECT_FALSE(without.assets->contains(asset));
}

TEST(PictureEdits, TheGalleryIsNoPartOfTheDesign) {
  const Home home = addPicture(Home{}, PictureId{7}, Picture{}, bytesOf("png"));
  EXPECT_TRUE(sameDesign(home, Home{}));
  EXPECT_FALSE(sameDesign(titled("x").change(home), Home{}));
}

TEST(PictureEdits, APictureStaysThroughUndoAndRedoAndMakesNoStep) {
  Document document;
  document.apply(titled("one"));
  document.apply(titled("two"));
  document.undo();
  document.markSaved("home.idap");
  const PictureId id{document.freeId()};
  document.amend([&](const Home& home) { return addPicture(home, id, Picture{}, bytesOf("png")); });
  EXPECT_TRUE(document.modified());
  document.undo();
  EXPECT_EQ(document.home().title, "");
  EXPECT_TRUE(document.home().pictures.contains(id));
  document.redo();
  document.redo();
  EXPECT_EQ(document.home().title, "two");
  EXPECT_TRUE(document.home().pictures.contains(id));
}

TEST(PictureEdits, APictureThatComesDuringADragStaysWhenTheDragIsCancelled) {
  Document document;
  document.begin("Move");
  document.preview(titled("dragged").change);
  const PictureId id{document.freeId()};
  document.amend([&](const Home& home) { return addPicture(home, id, Picture{}, bytesOf("png")); });
  EXPECT_EQ(document.home().title, "dragged");
  document.cancel();
  EXPECT_EQ(document.home().title, "");
  EXPECT_TRUE(document.home().pictures.contains(id));
}

}  // namespace
}  // namespace idap::test
