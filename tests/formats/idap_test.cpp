#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "base/error.h"
#include "base/file.h"
#include "base/zip.h"
#include "formats/idap/idap_format.h"
#include "formats/idap/json_reader.h"
#include "support/sample_home.h"

namespace idap {
namespace {

using nlohmann::json;
using testing::HasSubstr;

SharedBytes bytesOf(std::string_view text) {
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return std::make_shared<const Bytes>(begin, begin + text.size());
}

SharedBytes archiveOf(const std::string& homeJson, std::map<std::string, SharedBytes> others = {}) {
  others["home.json"] = bytesOf(homeJson);
  return std::make_shared<const Bytes>(writeZip(others));
}

ReadResult readJson(const std::string& homeJson) { return readIdap(archiveOf(homeJson), "test.idap", {}); }

std::string homeJsonOf(const Home& home) {
  const auto bytes = std::make_shared<const Bytes>(writeIdap(home, {}));
  return std::string(asText(ZipReader(bytes, "x").read("home.json")));
}

Home withPiece(Furniture piece, Assets assets = {}) {
  Home home;
  home.assets = std::make_shared<const Assets>(std::move(assets));
  home.furniture.set(home.newId<FurnitureId>(), std::move(piece));
  return home;
}

Home throughFile(const Home& home) {
  const ReadResult result = readIdap(std::make_shared<const Bytes>(writeIdap(home, {})), "test.idap", {});
  EXPECT_TRUE(result.report.empty()) << result.report.entries[0].place << ": "
                                     << result.report.entries[0].what;
  return result.home;
}

TEST(Idap, AnEmptyHomeIsAFewLinesAndComesBack) {
  EXPECT_EQ(throughFile(Home{}), Home{});
  EXPECT_EQ(homeJsonOf(Home{}), "{\n \"version\": 2\n}\n");
}

TEST(Idap, EveryFieldComesBackExactly) {
  const Home home = test::fullHome();
  EXPECT_EQ(throughFile(home), home);
  EXPECT_EQ(throughFile(test::smallFlat()), test::smallFlat());
}

// Guards the list of fields: each member left at its default would hide that it is not stored.
TEST(Idap, EveryFieldOfAFullHomeIsWritten) {
  const json full = json::parse(homeJsonOf(test::fullHome()));
  const std::pair<const char*, std::size_t> members[] = {{"/walls/0", 14},
                                                         {"/rooms/0", 16},
                                                         {"/openings/0", 27},
                                                         {"/furniture/0", 22},
                                                         {"/levels/0", 8},
                                                         {"/groups/1", 4},
                                                         {"/cameras/0", 8},
                                                         {"/dimensions/0", 10},
                                                         {"/labels/0", 8},
                                                         {"/polylines/0", 11},
                                                         {"/site", 8},
                                                         {"/environment", 4},
                                                         {"/pictures/0", 6},
                                                         {"/pictures/0/settings", 8},
                                                         {"", 22}};
  for (const auto& [place, count] : members)
    EXPECT_EQ(full.at(json::json_pointer(place)).size(), count) << place;
}

TEST(Idap, NumbersComeBackExactly) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    Furniture piece;
    const auto number = [&] { return std::ldexp(double(random()), -int(random() % 60) - 52); };
    piece.position = {number(), -number(), number()};
    piece.size = {number() + 1e-5, 1.0 / 3, 0.1 + 0.2};
    piece.finish = plain(Color{float(random() % 1000) / 999.0f, std::nextafter(0.7f, 1.0f), 1e-30f});
    piece.price = number();
    const Home home = withPiece(piece);
    ASSERT_EQ(throughFile(home), home);
  }
}

TEST(Idap, DefaultsThatAreNotEmptyCanBeEmptied) {
  Home home;
  home.environment.ground = Finish{};  // by default a grey
  home.currency = "";
  Opening bare;
  bare.cutOut = "";
  home.openings.set(home.newId<OpeningId>(), bare);
  EXPECT_EQ(throughFile(home), home);
}

TEST(Idap, IsDiffable) {
  Furniture piece;
  piece.name = "Chair";
  Home home = withPiece(piece);
  Wall wall;
  wall.end = {2.5, 0};
  wall.left.finish = plain(Color{0.7f, 0.1f, 0.25f});
  home.walls.set(home.newId<WallId>(), wall);
  const std::string before = homeJsonOf(home);
  EXPECT_EQ(before, homeJsonOf(home));
  EXPECT_THAT(before, HasSubstr("\"end\": [2.5, 0.0]"));
  EXPECT_THAT(before, HasSubstr("\"color\": [0.7, 0.1, 0.25]")) << "as people pick it";
  piece.position.x = 1.5;
  home.furniture.set(FurnitureId{1}, piece);
  const std::string after = homeJsonOf(home);
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  EXPECT_EQ(lines(after), lines(before) + 1) << "a move of a piece is one line";
  const auto position = [](const std::string& text, const char* key) { return text.find(key); };
  EXPECT_LT(position(after, "\"furniture\""), position(after, "\"version\"")) << "keys are sorted";
}

TEST(Idap, StoresTheFilesInUseAndThoseBesideModelsOnly) {
  Furniture piece;
  piece.model.asset = "models/chair/chair.obj";
  Finish wood;
  wood.texture = TextureRef{"textures/wood.jpg", {1, 1}, {}, 0, false};
  piece.slotFinishes["seat"] = wood;
  const Home home = withPiece(piece, {{"models/chair/chair.obj", bytesOf("o")},
                                      {"models/chair/chair.mtl", bytesOf("m")},
                                      {"models/chair/maps/red.png", bytesOf("r")},
                                      {"models/old/old.obj", bytesOf("x")},
                                      {"textures/wood.jpg", bytesOf("w")},
                                      {"textures/unused.jpg", bytesOf("u")}});
  const auto bytes = std::make_shared<const Bytes>(writeIdap(home, {}));
  EXPECT_EQ(ZipReader(bytes, "x").entries(),
            (std::vector<std::string>{"home.json", "models/chair/chair.mtl", "models/chair/chair.obj",
                                      "models/chair/maps/red.png", "textures/wood.jpg"}));
  const Home back = readIdap(bytes, "x", {}).home;
  EXPECT_EQ(asText(*back.assets->at("textures/wood.jpg")), "w");
  EXPECT_EQ(back.furniture, home.furniture);
}

TEST(Idap, RefusesToWriteAHomeItCouldNotReadAgain) {
  Furniture piece;
  piece.angle = std::nan("");
  EXPECT_THROW(writeIdap(withPiece(piece), {}), InvalidHome);
}

TEST(Idap, IgnoresWhatItDoesNotKnowAndSaysSo) {
  const ReadResult result = readJson(R"({"version": 2, "mood": "warm", "furniture": [
      {"id": 1, "name": "A", "smell": 1}, {"id": 2, "smell": {"deep": [1]}}]})");
  EXPECT_EQ(result.home.furniture.size(), 2u);
  ASSERT_EQ(result.report.entries.size(), 2u);
  EXPECT_EQ(result.report.entries[0].place, "home.json#/furniture/*/smell");
  EXPECT_EQ(result.report.entries[0].count, 2u);
  EXPECT_EQ(result.report.entries[1].place, "home.json#/mood");
}

TEST(Idap, SaysWhereTheFileIsWrong) {
  const std::pair<const char*, const char*> cases[] = {
      {R"({"version": 2, "walls": [{"id": 1, "start": [0, "x"]}]})", "home.json#/walls/0/start/1"},
      {R"({"version": 2, "walls": {"id": 1}})", "home.json#/walls"},
      {R"({"version": 2, "furniture": [{"id": 1, "lamp": 5}]})", "home.json#/furniture/0/lamp"},
      {R"({"version": 2, "furniture": [{"id": -1}]})", "home.json#/furniture/0/id"},
      {R"({"version": 2, "openings": [{"id": 1, "kind": "gate"}]})", "home.json#/openings/0/kind"},
      {R"({"version": 2, "levels": [{"id": 1, "order": 1e3}]})", "home.json#/levels/0/order"},
      {R"({"version": 2, "levels": [{"id": 1, "order": 3000000000}]})", "home.json#/levels/0/order"},
      {R"({"version": 2, "properties": {"a/b~c": 1}})", "home.json#/properties/a~1b~0c"},
      {R"({"version": 2, "site": null})", "home.json#/site"},
      {R"({"version": "2"})", "home.json#/version"},
      {R"({})", "home.json#/version"},
      {R"([])", "home.json#"},
      {R"({"version": 2, )", "home.json byte 16"},
  };
  for (const auto& [text, place] : cases) {
    try {
      readJson(text);
      ADD_FAILURE() << text << " was read";
    } catch (const ParseError& error) {
      EXPECT_EQ(error.file(), "test.idap");
      EXPECT_EQ(error.place(), place) << error.what();
    }
  }
  EXPECT_THROW(readJson(""), ParseError);
  EXPECT_THROW(readJson("{\"version\": 2, \"wallHeight\": 1e999}"), ParseError);
  EXPECT_THROW(readJson("{\"version\": 2, \"name\": \"\xFF\"}"), ParseError);
  EXPECT_THROW(readIdap(std::make_shared<const Bytes>(writeZip({{"other", bytesOf("x")}})), "x", {}),
               ParseError);
}

TEST(Idap, MendsWhatBreaksTheRules) {
  const ReadResult result = readJson(R"({"version": 2, "walls": [{"id": 1, "start": [0, 0], "end": [0, 0]}],
      "furniture": [{"id": 2, "size": [1, 0, 1]}, {"id": 2, "group": 9, "name": "second"}, {"name": "third"}]})");
  EXPECT_TRUE(result.home.walls.empty());
  EXPECT_EQ(result.home.furniture.size(), 3u) << "a number used twice hides nothing";
  EXPECT_GT(result.home.nextId, 4u);
  EXPECT_GE(result.report.entries.size(), 4u);
}

TEST(Idap, RefusesNewerVersionsByName) {
  try {
    readJson(R"({"version": 7, "walls": "something new"})");
    FAIL();
  } catch (const UnsupportedVersion& error) {
    EXPECT_THAT(error.what(), HasSubstr("test.idap"));
    EXPECT_THAT(error.what(), HasSubstr("version 7"));
    EXPECT_THAT(error.what(), HasSubstr("up to version 2"));
    EXPECT_THAT(error.what(), HasSubstr("newer IDAP"));
  }
  EXPECT_THROW(readJson(R"({"version": 0})"), UnsupportedVersion);
  EXPECT_THROW(readJson(R"({"version": -3})"), UnsupportedVersion);
  EXPECT_THROW(readJson(R"({"version": 18446744073709551615})"), UnsupportedVersion);
}

TEST(Idap, ReadsVersion1) {
  const ReadResult result = readJson(R"({
    "version": 1,
    "walls": [{"id": 1, "start": [0, 0], "end": [3, 0], "height": 2.2}, {"id": 2, "start": [3, 0], "end": [3, 3]}],
    "furniture": [{"id": 3, "name": "Lamp", "lamp": {"watts": 60, "colorTemperature": 3000}}]
  })");
  EXPECT_TRUE(result.report.empty());
  const Wall& wall = *result.home.walls.find(WallId{1});
  EXPECT_EQ(wall.heightAtStart, 2.2);
  EXPECT_EQ(wall.heightAtEnd, 2.2);
  EXPECT_EQ(result.home.walls.find(WallId{2})->heightAtEnd, 2.5);
  const Furniture& lamp = *result.home.furniture.find(FurnitureId{3});
  EXPECT_DOUBLE_EQ(lamp.lamp->lumens, 806);
  EXPECT_EQ(lamp.lamp->colorTemperature, 3000);
  EXPECT_THAT(homeJsonOf(result.home), HasSubstr("\"version\": 2"));
  // Nonsense in an old file is an error with its place, as in a new one.
  EXPECT_THROW(readJson(R"({"version": 1, "walls": [{"id": 1, "height": "high"}]})"), ParseError);
  EXPECT_THROW(readJson(R"({"version": 1, "walls": 3, "furniture": [[], {"lamp": []}]})"), ParseError);
}

TEST(Idap, DeepNestingIsRefusedWithoutOverflow) {
  for (const char* opening : {"[", "{\"a\":"}) {
    std::string hostile;
    for (int i = 0; i < 3'000'000; ++i) hostile += opening;
    try {
      idap_format::parseJson(hostile, "hostile.idap");
      FAIL();
    } catch (const ParseError& error) {
      EXPECT_THAT(error.what(), HasSubstr("nested"));
    }
  }
  EXPECT_NO_THROW(readJson("{\"version\": 2, \"name\": \"" + std::string(1000, '[') + "\\\"[\"}"));
}

TEST(Idap, SurvivesDamage) {
  Furniture piece;
  piece.name = "Chair";
  piece.lamp = Lamp{};
  Home home = withPiece(piece);
  Wall wall;
  wall.end = {3, 0};
  home.walls.set(home.newId<WallId>(), wall);
  home.levels.set(home.newId<LevelId>(), Level{});
  const std::string good = homeJsonOf(home);
  std::mt19937 random(4);
  int read = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string bad = good;
    for (int i = 0; i <= round % 3; ++i) bad[random() % bad.size()] = "0123456789{}[],:\"-e.x"[random() % 21];
    try {
      readJson(bad);
      ++read;
    } catch (const ParseError&) {
    } catch (const UnsupportedVersion&) {
    }
  }
  EXPECT_GT(read, 100);
}

TEST(Idap, IsRecognisedByContent) {
  EXPECT_TRUE(sniffIdap(archiveOf("{}"), "anything"));
  EXPECT_FALSE(sniffIdap(bytesOf("PK\x03\x04 damaged"), "a.idap"));
  EXPECT_FALSE(sniffIdap(bytesOf(""), "a.idap"));
  EXPECT_FALSE(sniffIdap(std::make_shared<const Bytes>(writeZip({{"Home.xml", bytesOf("x")}})), "a"));
}

TEST(Idap, StopsWhenAsked) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(writeIdap(Home{}, progress), Cancelled);
  EXPECT_THROW(readIdap(archiveOf("{\"version\": 2}"), "x", progress), Cancelled);
}

TEST(Idap, APictureWithoutItsFileIsDroppedWithAWord) {
  const ReadResult result = readJson(R"({"version": 2, "nextId": 5, "pictures": [
      {"id": 3, "name": "Lost", "asset": "pictures/3.png", "settings": {"width": 640, "height": 400}}]})");
  EXPECT_TRUE(result.home.pictures.empty());
  ASSERT_EQ(result.report.entries.size(), 1u);
  EXPECT_THAT(result.report.entries[0].what, HasSubstr("missing"));
}

TEST(Idap, APictureOfImpossibleSizeIsMended) {
  const ReadResult result =
      readIdap(archiveOf(R"({"version": 2, "nextId": 5, "pictures": [{"id": 3, "asset": "pictures/3.png",
          "settings": {"width": -4, "height": 2000000000, "samples": -1}}]})",
                         {{"pictures/3.png", bytesOf("png")}}),
               "test.idap", {});
  ASSERT_EQ(result.home.pictures.size(), 1u);
  const PictureSettings& settings = result.home.pictures.begin()->second->settings;
  EXPECT_EQ(settings.width, PictureSettings{}.width);
  EXPECT_EQ(settings.height, PictureSettings{}.height);
  EXPECT_EQ(settings.samples, PictureSettings{}.samples);
}

}  // namespace
}  // namespace idap
