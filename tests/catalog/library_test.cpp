#include "catalog/library/library.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>

#include "base/error.h"
#include "base/file.h"
#include "base/zip.h"
#include "catalog/library/library_cache.h"
#include "catalog/library/properties.h"

namespace idap {
namespace {

namespace fs = std::filesystem;

SharedBytes bytesOf(const std::string& text) {
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return std::make_shared<const Bytes>(begin, begin + text.size());
}

constexpr const char* kTable = R"(# a comment
id=test#library
name=Test library
license=CC-BY 3.0

id#1=test#chair
name#1=Chair
category#1=Living room
tags#1=seat, wood ,
icon#1=/icons/chair.png
model#1=/models/chair/chair.obj
width#1=45.5
depth#1=50
height#1=90
dropOnTopElevation#1=45
movable#1=true
doorOrWindow#1=false
creator#1=V\u00e9ronique
price#1=99.5
modelRotation#1=0 0 -1 0 1 0 1 0 0

name#2=Ceiling lamp
category#2=Lights
model#2=models/lamp.obj
width#2=40
depth#2=20
height#2=50
elevation#2=200
lightSourceX#2=10 30
lightSourceY#2=5 5
lightSourceZ#2=25 25
lightSourceColor#2=#777777 #777777
lightSourceDiameter#2=4 4
license#2=Public domain

id#4=test#window
name#4=Window
category#4=Doors and windows
model#4=missing.obj
width#4=100
depth#4=40
height#4=120
elevation#4=90
doorOrWindow#4=true
doorOrWindowWallThickness#4=20
doorOrWindowWallDistance#4=10
doorOrWindowSashXAxis#4=5
doorOrWindowSashYAxis#4=30
doorOrWindowSashWidth#4=90
doorOrWindowSashStartAngle#4=0
doorOrWindowSashEndAngle#4=-90

name#5=No size
model#5=models/lamp.obj
)";
constexpr const char* kFrench = "name#1=Chaise\ncategory#1=S\xE9jour\nname#9=Rien\n";

class Library : public ::testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("idap-library-test-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    file = folder / "test.sh3f";
    writeFileAtomically(
        file, writeZip({{"PluginFurnitureCatalog.properties", bytesOf(kTable)},
                        {"PluginFurnitureCatalog_fr.properties", bytesOf(kFrench)},
                        {"icons/chair.png", bytesOf("PNG")},
                        {"models/chair/chair.mtl", bytesOf("newmtl a\nmap_Kd wood.png\n")},
                        {"models/chair/wood.png", bytesOf("WOOD")},
                        {"models/chair/chair.obj",
                         bytesOf("mtllib chair.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n")},
                        {"models/lamp.obj", bytesOf("v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n")}}));
  }
  void TearDown() override { fs::remove_all(folder); }
  std::shared_ptr<FurnitureLibrary> open() { return FurnitureLibrary::open(file, folder / "cache"); }

  fs::path folder, file;
};

TEST_F(Library, PiecesHaveTheirSizeInMetresTheirMakerAndTheirLicence) {
  const auto library = open();
  EXPECT_EQ(library->name(), "Test library");
  ASSERT_EQ(library->pieces().size(), 3u) << "the one without a size is left out";
  const CatalogPiece& chair = *library->pieces()[0];
  EXPECT_EQ(chair.id, "test#chair");
  EXPECT_DOUBLE_EQ(chair.size.x, 0.455);
  EXPECT_EQ(chair.tags, (std::vector<std::string>{"seat", "wood"}));
  EXPECT_EQ(chair.creator, "Véronique");
  EXPECT_EQ(chair.license, "CC-BY 3.0");
  EXPECT_EQ(chair.library, "test.sh3f");
  EXPECT_DOUBLE_EQ(chair.dropOnTopHeight.value(), 0.45);
  EXPECT_DOUBLE_EQ(chair.price.value(), 99.5);
  EXPECT_EQ(chair.modelRotation[0], (Vec3{0, -1, 0}));
  EXPECT_EQ(chair.translations.at("fr").at("name"), "Chaise");
  EXPECT_EQ(chair.translations.at("fr").at("category"), "Séjour");
}

TEST_F(Library, LampsAndWindowsKeepTheirParts) {
  const auto library = open();
  const CatalogPiece& lamp = *library->pieces()[1];
  EXPECT_EQ(lamp.id, "test#2");
  EXPECT_EQ(lamp.kind, PieceKind::Lamp);
  EXPECT_TRUE(lamp.ceilingMounted);
  EXPECT_EQ(lamp.license, "Public domain");
  ASSERT_TRUE(lamp.lamp);
  EXPECT_NEAR(lamp.lamp->lumens, 1400, 1);
  EXPECT_DOUBLE_EQ(lamp.lamp->sources.at(1).position.x, 0.75);
  EXPECT_DOUBLE_EQ(lamp.lamp->sources.at(1).diameter, 0.04);
  const CatalogPiece& window = *library->find("test#window");
  EXPECT_EQ(window.kind, PieceKind::Window);
  EXPECT_DOUBLE_EQ(window.wallThickness, 0.5);
  EXPECT_DOUBLE_EQ(window.wallDistance, 0.25);
  ASSERT_EQ(window.sashes.size(), 1u);
  EXPECT_DOUBLE_EQ(window.sashes[0].axis.y, 0.75);
  EXPECT_DOUBLE_EQ(window.sashes[0].endAngle, -kPi / 2);
}

TEST_F(Library, ModelsComeWhenAskedForAndAreSharedWhileHeld) {
  const auto library = open();
  const CatalogPiece& chair = *library->pieces()[0];
  const SurfaceModelPtr model = library->model(chair);
  ASSERT_TRUE(model);
  EXPECT_TRUE(model->unitBox);
  EXPECT_EQ(library->model(chair), model);
  ASSERT_TRUE(model->slots.at(0).material.texture);
  EXPECT_EQ(asText(*model->slots.at(0).material.texture->bytes), "WOOD");
  EXPECT_EQ(asText(*library->icon(chair)), "PNG");
  const SurfaceModelPtr lamp = library->model(*library->pieces()[1]);
  ASSERT_EQ(lamp->lightPositions.size(), 2u);
  EXPECT_NEAR(lamp->lightPositions[0].y, -0.25, 1e-12) << "5 of 20 cm from the front";
  EXPECT_THROW(library->model(*library->find("test#window")), ParseError);
  EXPECT_FALSE(library->icon(*library->find("test#window")));
  EXPECT_FALSE(library->find("nothing"));
}

TEST_F(Library, TheSecondTimeItComesFromTheCacheUnchanged) {
  const auto first = open();
  EXPECT_FALSE(first->cameFromCache());
  const auto second = open();
  EXPECT_TRUE(second->cameFromCache());
  ASSERT_EQ(second->pieces().size(), first->pieces().size());
  for (std::size_t i = 0; i < first->pieces().size(); ++i) {
    const CatalogPiece &a = *first->pieces()[i], &b = *second->pieces()[i];
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.tags, b.tags);
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.size, b.size);
    EXPECT_EQ(a.translations, b.translations);
    EXPECT_EQ(a.lamp, b.lamp);
    EXPECT_EQ(a.sashes, b.sashes);
    EXPECT_EQ(a.modelRotation, b.modelRotation);
    EXPECT_EQ(a.license, b.license);
    EXPECT_EQ(a.price, b.price);
  }
  EXPECT_TRUE(second->model(*second->pieces()[0])) << "models still come from the archive";
}

TEST_F(Library, AChangedLibraryOrADamagedCacheIsReadAnew) {
  open();
  const LibraryStamp stamp = stampOf(file);
  fs::path cached;
  for (const auto& entry : fs::directory_iterator(folder / "cache")) cached = entry.path();
  Bytes content = readFile(cached);
  for (std::size_t at : {std::size_t{0}, std::size_t{30}, content.size() / 2, content.size() - 1}) {
    Bytes damaged = content;
    damaged[at] ^= std::byte{0x55};
    writeFileAtomically(cached, damaged);
    EXPECT_FALSE(loadLibraryIndex(folder / "cache", stamp)) << at;
    damaged.resize(at);
    writeFileAtomically(cached, damaged);
    EXPECT_FALSE(loadLibraryIndex(folder / "cache", stamp)) << at;
  }
  EXPECT_FALSE(open()->cameFromCache());
  EXPECT_TRUE(open()->cameFromCache());
  fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(5));
  EXPECT_FALSE(open()->cameFromCache());
}

TEST_F(Library, WhatIsNoLibraryIsRefused) {
  EXPECT_THROW(FurnitureLibrary::open(folder / "absent.sh3f", folder), IoError);
  writeFileAtomically(file, *bytesOf("not an archive"));
  EXPECT_THROW(open(), ParseError);
  writeFileAtomically(file, writeZip({{"readme.txt", bytesOf("hello")}}));
  EXPECT_THROW(open(), ParseError);
}

TEST(LibraryProperties, EscapesContinuedLinesAndSeparators) {
  std::vector<std::pair<std::string, std::string>> all;
  readProperties("a=1\n  b : two words \r\n! no\nc\\ d=x\\\n   y\ne\nf=\\u65E5\\uD83D\\uDE00\\t\xE9\ng\\u",
                 [&](std::string_view key, std::string_view value) { all.emplace_back(key, value); });
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"a", "1"}, {"b", "two words "}, {"c d", "xy"}, {"e", ""}, {"f", "日😀\té"}, {"g", ""}};
  EXPECT_EQ(all, expected);
}

TEST(LibraryProperties, DebianLibrariesHaveAllTheirPieces) {
  const fs::path folder = "/usr/share/sweethome3d/furniture";
  if (!fs::exists(folder)) GTEST_SKIP() << "Debian's sweethome3d-furniture is not installed";
  const fs::path cache = fs::temp_directory_path() / ("idap-library-cache-" + std::to_string(::getpid()));
  std::size_t pieces = 0, lamps = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const auto library = FurnitureLibrary::open(entry.path(), cache);
    pieces += library->pieces().size();
    for (const CatalogPiecePtr& piece : library->pieces()) {
      lamps += piece->lamp ? 1 : 0;
      EXPECT_FALSE(piece->license.empty()) << piece->id;
      EXPECT_FALSE(piece->creator.empty()) << piece->id;
    }
  }
  fs::remove_all(cache);
  EXPECT_EQ(pieces, 820u);
  EXPECT_EQ(lamps, 34u);
}

}  // namespace
}  // namespace idap
