// What a user or an attacker may feed the program: one clear line and status 1, or a report of what was
// mended; never a crash, and never half a file in place of a good one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "base/file.h"
#include "base/zip.h"
#include "support/program.h"

namespace idap {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::Outcome;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* kQuick = " -o a.png --size 24x16 --spp 1 --no-denoise ";

class BadInput : public test::ProgramTest {
 protected:
  using Entries = std::map<std::string, std::string>;

  void archive(const std::string& name, const Entries& entries) const {
    std::map<std::string, SharedBytes> packed;
    for (const auto& [entry, text] : entries) {
      const auto* begin = reinterpret_cast<const std::byte*>(text.data());
      packed[entry] = std::make_shared<const Bytes>(begin, begin + text.size());
    }
    writeFileAtomically(path(name), writeZip(packed));
  }
  void idapHome(const std::string& name, json home, Entries files = {}) const {
    home["version"] = 2;
    files["home.json"] = home.dump();
    archive(name, files);
  }
  void sh3dHome(const std::string& name, const std::string& elements, Entries files = {}) const {
    files["Home.xml"] =
        "<?xml version='1.0'?><home version='7200' name='t' wallHeight='250'>" + elements + "</home>";
    archive(name, files);
  }

  // Refused by every command that reads homes, in one line that names the file.
  void expectRefused(const std::string& file, const std::string& reason = "") const {
    for (const std::string& command : {"render " + file + kQuick, "convert " + file + " b.idap"}) {
      const Outcome outcome = run(command);
      EXPECT_EQ(outcome.status, 1) << command;
      EXPECT_THAT(outcome.err, StartsWith("idap: "));
      EXPECT_THAT(outcome.err, HasSubstr(fs::path(file).filename().string() + ": "));
      EXPECT_EQ(lines(outcome.err), 1) << outcome.err;
      EXPECT_THAT(outcome.err, HasSubstr(reason));
      EXPECT_EQ(outcome.out, "");
      EXPECT_FALSE(fs::exists(path("a.png")) || fs::exists(path("b.idap"))) << command;
    }
  }
  // Read, mended and shown; gives what was said of it.
  std::string expectMended(const std::string& file, const std::string& mended = "") const {
    EXPECT_EQ(run("convert " + file + " b.idap").status, 0);
    const Outcome info = run("info --json b.idap");
    EXPECT_EQ(info.status, 0) << info.err;
    EXPECT_EQ(info.err, "") << "what was mended is saved as mended";
    EXPECT_TRUE(json::accept(info.out)) << info.out;
    const Outcome outcome = run("render " + file + kQuick);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(contents("a.png"), StartsWith("\x89PNG"));
    EXPECT_THAT(outcome.err, HasSubstr(mended));
    EXPECT_LE(lines(outcome.err), 11) << outcome.err;
    return outcome.err;
  }
  static std::ptrdiff_t lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

  static json wall(double x0, double y0, double x1, double y1) {
    return {{"start", {x0, y0}}, {"end", {x1, y1}}};
  }
  static json piece(const std::string& name, json more = json::object()) {
    json p{{"name", name}, {"position", {1, 1, 0}}, {"size", {0.5, 0.5, 0.5}}};
    p.update(more);
    return p;
  }
};

TEST_F(BadInput, ForeignFiles) {
  write("empty.idap", "");
  write("text.sh3d", "this is not a home");
  write("picture.idap", "\x89PNG\r\n\x1a\n and so on");
  write("half.idap", "PK\x03\x04 and then nothing");
  write("noise.sh3d", [] {
    std::string noise(5000, '\0');
    for (std::size_t i = 0; i < noise.size(); ++i) noise[i] = static_cast<char>(i * i * 2654435761u >> 13);
    return noise;
  }());
  archive("other.idap", {{"mimetype", "application/epub+zip"}, {"content.xml", "<a/>"}});
  archive("nothing.sh3d", {});
  archive("old.sh3d", {{"Home", "\xAC\xED\x00\x05"}});
  for (const std::string file : {"empty.idap", "text.sh3d", "picture.idap", "half.idap", "noise.sh3d",
                                 "other.idap", "nothing.sh3d", "old.sh3d"})
    expectRefused(file);
  fs::create_directory(path("folder.idap"));
  expectRefused("folder.idap", "irectory");
  expectRefused("missing.idap", "No such file");
  expectRefused("/dev/null", "not a file");
}

TEST_F(BadInput, TruncatedHomesAreRefusedWherever) {
  std::ifstream in(samplePath(), std::ios::binary);
  const std::string whole(std::istreambuf_iterator<char>(in), {});
  for (std::size_t part = 1; part < 6; ++part) {
    write("part.idap", whole.substr(0, whole.size() * part / 6));
    EXPECT_EQ(run("info part.idap").status, 1) << part;
  }
  sh3dHome("whole.sh3d", "<wall id='w' xStart='0' yStart='0' xEnd='400' yEnd='0' thickness='10'/>");
  std::string home = contents("whole.sh3d");
  write("part.sh3d", home.substr(0, home.size() / 2));
  expectRefused("part.sh3d");
  home[home.size() / 4] = static_cast<char>(home[home.size() / 4] ^ 0x55);  // the checksum tells
  write("flipped.sh3d", home);
  expectRefused("flipped.sh3d");
}

TEST_F(BadInput, WrongTextsNameThePlace) {
  archive("cut.idap", {{"home.json", R"({"version": 2, "walls": [)"}});
  expectRefused("cut.idap", "home.json byte ");
  archive("kind.idap", {{"home.json", R"({"version": 2, "walls": [{"start": "here"}]})"}});
  expectRefused("kind.idap", "home.json#/walls/0/start");
  archive("number.idap", {{"home.json", R"({"version": 2, "wallHeight": 1e999})"}});
  expectRefused("number.idap", "home.json");
  archive("deep.idap", {{"home.json", std::string(200'000, '[')}});
  expectRefused("deep.idap", "too deeply");
  archive("new.idap", {{"home.json", R"({"version": 999})"}});
  expectRefused("new.idap", "999");
  archive("xml.sh3d", {{"Home.xml", "<home><wall"}});
  expectRefused("xml.sh3d", "Home.xml, byte ");
  archive("root.sh3d", {{"Home.xml", "<house/>"}});
  expectRefused("root.sh3d", "Home.xml");
}

TEST_F(BadInput, HostileArchives) {
  archive("out.idap", {{"../../evil", "x"}, {"home.json", R"({"version": 2})"}});
  expectRefused("out.idap", "leaves the archive");
  archive("bomb.idap", {{"home.json", std::string(40u << 20, ' ')}});
  expectRefused("bomb.idap", "ratio");
  std::string groups;
  for (int i = 0; i < 5000; ++i) groups += "<furnitureGroup id='g'>";
  for (int i = 0; i < 5000; ++i) groups += "</furnitureGroup>";
  sh3dHome("nested.sh3d", groups);
  expectMended("nested.sh3d", "nested too deeply");
}

TEST_F(BadInput, EmptyHomesAreShownAllTheSame) {
  idapHome("empty.idap", json::object());
  EXPECT_EQ(expectMended("empty.idap"), "");
  sh3dHome("empty.sh3d", "");
  EXPECT_EQ(expectMended("empty.sh3d"), "");
}

TEST_F(BadInput, ImpossibleNumbers) {
  sh3dHome("nan.sh3d",
           "<wall id='a' xStart='NaN' yStart='0' xEnd='400' yEnd='0' thickness='10'/>"
           "<wall id='b' xStart='0' yStart='0' xEnd='400' yEnd='0' thickness='-10'/>"
           "<wall id='c' xStart='0' yStart='0' xEnd='1e300' yEnd='0' thickness='10'/>"
           "<pieceOfFurniture name='chair' x='10' y='10' width='NaN' depth='Infinity' height='50'/>"
           "<pieceOfFurniture name='table' x='10' y='10' width='-5' depth='0' height='50'/>"
           "<room><point x='0' y='0'/><point x='nan' y='0'/><point x='9' y='9'/></room>"
           "<observerCamera attribute='observerCamera' x='inf' y='0' z='1e999' yaw='NaN' pitch='0' "
           "fieldOfView='0'/>");
  expectMended("nan.sh3d", "not a usable number");
  idapHome("huge.idap",
           {{"walls", {wall(0, 0, 1e300, 0), wall(0, 0, 3, 1e-12), wall(-9e3, -9e3, 9e3, 9e3)}},
            {"furniture",
             {piece("endless", {{"size", {1e308, -1, 0}}}), piece("away", {{"position", {1e200, 0, -1e200}}}),
              piece("spun", {{"angle", 1e300}, {"pitch", -1e300}})}},
            {"rooms", {{{"points", {{0, 0}, {1, 0}}}}, {{"points", {{0, 0}, {1e30, 0}, {0, 1e30}}}}}},
            {"cameras", {{{"name", "c"}, {"eye", {0, 0, 1e300}}, {"fieldOfView", -4}}}},
            {"site", {{"latitude", 1e9}, {"time", 9223372036854775807}}}});
  expectMended("huge.idap");
}

TEST_F(BadInput, DegenerateAndOverlappingWalls) {
  idapHome("walls.idap",
           {{"walls",
             {wall(0, 0, 0, 0), wall(0, 0, 4, 0), wall(0, 0, 4, 0), wall(4, 0, 0, 0), wall(1, 0, 3, 0),
              wall(0.5, 0.01, 3.5, 0.01), wall(0, 0, 4, 3), wall(4, 0, 0, 3)}}});
  const std::string said = expectMended("walls.idap", "length");
  EXPECT_THAT(said, HasSubstr("another"));
}

TEST_F(BadInput, IdsThatPointNowhereOrInCircles) {
  json start = wall(0, 0, 4, 0);
  start.update({{"id", 7}, {"neighbourAtStart", 7}, {"neighbourAtEnd", 999}, {"level", 55}});
  json same = wall(0, 1, 4, 1);
  same["id"] = 7;
  idapHome("ids.idap",
           {{"walls", {start, same}},
            {"nextId", 3},
            {"groups", {{{"id", 20}, {"parent", 21}}, {{"id", 21}, {"parent", 20}}}},
            {"furniture", {piece("lost", {{"id", 18446744073709551615u}, {"group", 20}, {"level", 1}})}},
            {"openings", {piece("door", {{"id", 0}, {"wall", 12345}})}}});
  expectMended("ids.idap", "does not exist");
  sh3dHome(
      "ids.sh3d",
      "<wall id='a' level='none' wallAtStart='gone' wallAtEnd='a' xStart='0' yStart='0' xEnd='400' yEnd='0' "
      "thickness='10'/>"
      "<light name='lamp' level='nowhere' model='99' icon='98' x='1' y='1' width='9' depth='9' height='9'/>");
  expectMended("ids.sh3d", "does not exist");
}

TEST_F(BadInput, MissingAndDamagedModelsAndPictures) {
  json pieces = json::array();
  for (int i = 0; i < 300; ++i) {
    pieces.push_back(piece("chair " + std::to_string(i), {{"model", {{"asset", "models/none.obj"}}}}));
    pieces.push_back(
        piece("table", {{"model", {{"asset", "models/bad.obj"}}},
                        {"finish", {{"texture", {{"asset", "textures/bad.png"}, {"size", {1, 1}}}}}}}));
    pieces.push_back(piece("sofa", {{"model", {{"catalogId", "idap/no-such-sofa"}}}}));
  }
  idapHome("models.idap", {{"furniture", pieces}},
           {{"models/bad.obj", "v 0 0\nf 1 2 3 4 5\n"}, {"textures/bad.png", "\x89PNG\r\n\x1a\n...."}});
  const std::string said = expectMended("models.idap", "its model is missing");
  EXPECT_THAT(said, HasSubstr("and 297 more"));
  EXPECT_THAT(said, HasSubstr("models/bad.obj: line 1"));
  EXPECT_THAT(said, HasSubstr("idap/no-such-sofa"));
  const std::size_t first = said.find("bad.png");
  ASSERT_NE(first, std::string::npos) << said;
  EXPECT_EQ(said.find("bad.png", first + 7), std::string::npos) << "one picture, one line: " << said;
  EXPECT_LE(lines(said), 7) << said;
}

TEST_F(BadInput, NamesDoNotCommandTheTerminal) {
  idapHome("escape.idap",
           {{"name", "\x1b]0;owned\x07 \xC2\x9b home"},
            {"furniture", {piece("\x1b[2J\nfaked: line", {{"id", 1}, {"model", {{"catalogId", "none"}}}})}},
            {"cameras", {{{"id", 2}, {"name", "\x1b[31m red"}, {"eye", {0, -3, 1}}}}}});
  const std::string said = expectMended("escape.idap", "faked: line");
  const std::string told = run("info escape.idap").out;
  for (const char* control : {"\x1b", "\x07", "\xC2\x9b"}) {
    EXPECT_THAT(said, Not(HasSubstr(control)));
    EXPECT_THAT(told, Not(HasSubstr(control)));
  }
  EXPECT_EQ(lines(said), 1) << said;
}

TEST_F(BadInput, GiantPicturesAreRefusedBeforeAnybodyWaits) {
  const Outcome outcome = run("render missing.idap -o a.png --size 40000x40000");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("40000 x 40000"));
  EXPECT_THAT(outcome.err, HasSubstr("GB"));
  EXPECT_EQ(lines(outcome.err), 1);
  EXPECT_EQ(run("render missing.idap -o a.png --size 2147483647x2147483647").status, 1);
}

TEST_F(BadInput, TargetsThatCannotBeWritten) {
  write("file", "precious");
  fs::create_directory(path("folder.png"));
  for (const std::string target : {"no/such/a.png", "file/a.png", "folder.png", "/proc/a.png"}) {
    const Outcome outcome = run("render " + sample() + " --size 20x20 --spp 1 -o " + target);
    EXPECT_EQ(outcome.status, 1) << target;
    EXPECT_THAT(outcome.err, StartsWith("idap: " + target + ": cannot write: "));
    EXPECT_EQ(lines(outcome.err), 1);
  }
  for (const std::string target : {"no/such/a.idap", "file/a.idap", "/proc/a.idap"})
    EXPECT_EQ(run("convert " + sample() + " " + target).status, 1) << target;
  EXPECT_EQ(contents("file"), "precious");
  EXPECT_EQ(filesInFolder(), 2u);
}

TEST_F(BadInput, FullDiskKeepsTheOldFile) {
  const auto tinyFiles = [] {
    const rlimit limit{600, 600};
    setrlimit(RLIMIT_FSIZE, &limit);
  };
  for (const std::string name : {"a.png", "a.jpg", "a.exr", "a.pcx", "a.idap"}) {
    write(name, "precious");
    const std::string job = name == "a.idap"
                                ? "convert " + sample() + " a.idap"
                                : "render " + sample() + " --size 64x48 --spp 1 --no-denoise -o " + name;
    const Outcome outcome = run(job, tinyFiles);
    EXPECT_EQ(outcome.status, 1) << name;
    EXPECT_THAT(outcome.err, StartsWith("idap: " + name + ": cannot write: "));
    EXPECT_EQ(lines(outcome.err), 1);
    EXPECT_EQ(contents(name), "precious");
    fs::remove(path(name));
    EXPECT_EQ(filesInFolder(), 0u) << "a temporary file was left beside " << name;
  }
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  fs::create_symlink("/dev/full", path("full.png"));
  const Outcome full = run("render " + sample() + " --size 20x20 --spp 1 --no-denoise -o full.png");
  EXPECT_EQ(full.status, 1);
  EXPECT_THAT(full.err, HasSubstr("No space left"));
}

TEST_F(BadInput, OutputsThatAreFullOrClosed) {
  EXPECT_EQ(run("info " + sample() + " >/dev/full").status, 1);
  EXPECT_EQ(run("catalog list --json >/dev/full").status, 1);
  EXPECT_EQ(run("--help >/dev/full").status, 1);
  EXPECT_EQ(run("info missing.idap 2>/dev/full").status, 1);
  EXPECT_EQ(run("info " + sample() + " >&-").status, 1);
  // With standard error closed, nothing said may end up in the picture.
  EXPECT_EQ(run("render " + sample() + kQuick + "2>&- </dev/null").status, 0);
  EXPECT_THAT(contents("a.png"), StartsWith("\x89PNG"));
}

}  // namespace
}  // namespace idap
