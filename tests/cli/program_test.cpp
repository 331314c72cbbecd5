// The program as a user or a script runs it: exit status, what it says, what it writes.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace {

namespace fs = std::filesystem;

const fs::path kSample = fs::path(IDAP_SOURCE_DIR) / "share/samples/apartment.idap";

struct Outcome {
  int status = -1;
  std::string out, err;
};

class Program : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "idap-cli-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  void TearDown() override {
    std::error_code ignored;
    fs::permissions(folder_, fs::perms::owner_all, ignored);
    fs::remove_all(folder_, ignored);
  }

  fs::path path(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }

  Outcome run(const std::string& arguments) const {
    const fs::path err = path("stderr.txt");
    const std::string command = std::string("cd '") + folder_.string() + "' && '" IDAP_PROGRAM "' " + arguments + " 2>'" +
                                err.string() + "' </dev/null";
    Outcome outcome;
    FILE* pipe = popen(command.c_str(), "r");
    std::array<char, 4096> buffer;
    while (const std::size_t got = fread(buffer.data(), 1, buffer.size(), pipe)) outcome.out.append(buffer.data(), got);
    outcome.status = WEXITSTATUS(pclose(pipe));
    std::ifstream errors(err);
    outcome.err.assign(std::istreambuf_iterator<char>(errors), {});
    return outcome;
  }

  static std::string sample() { return "'" + kSample.string() + "'"; }

 private:
  fs::path folder_;
};

TEST_F(Program, HelpAndVersionEverywhere) {
  for (const char* command : {"", "info", "render", "convert", "catalog"}) {
    const Outcome help = run(std::string(command) + " --help");
    EXPECT_EQ(help.status, 0) << command;
    EXPECT_NE(help.out.find("--help"), std::string::npos) << command;
    const Outcome version = run(std::string(command) + " --version");
    EXPECT_EQ(version.status, 0) << command;
    EXPECT_EQ(version.out.rfind("idap ", 0), 0u) << command;
  }
}

TEST_F(Program, WrongUsageIsStatusTwo) {
  EXPECT_EQ(run("frobnicate").status, 2);
  EXPECT_EQ(run("info").status, 2);
  EXPECT_EQ(run("render " + sample()).status, 2);
  EXPECT_EQ(run("render " + sample() + " -o a.png --size huge").status, 2);
  EXPECT_EQ(run("render " + sample() + " -o a.png --size 0x10").status, 2);
  EXPECT_EQ(run("render " + sample() + " -o a.png --spp -1").status, 2);
  EXPECT_EQ(run("render " + sample() + " -o a.tiff2").status, 2);
  EXPECT_EQ(run("render " + sample() + " -o a.png --integrator magic").status, 2);
  EXPECT_EQ(run("render " + sample() + " -o a.png --at yesterday").status, 2);
}

TEST_F(Program, InfoCountsTheSample) {
  const Outcome outcome = run("info --json " + sample());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  for (const char* key : {"levels", "walls", "rooms", "pieces", "groups", "openings", "lamps", "cameras", "dimensions",
                          "labels", "polylines", "triangles"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["cameras"], 3);
  EXPECT_GE(json["rooms"], 2);
  EXPECT_GT(json["triangles"], 10000);
}

TEST_F(Program, RendersEveryPictureFormat) {
  const std::array<std::pair<const char*, std::string>, 4> kinds{{{"png", "\x89PNG"},
                                                                  {"jpg", "\xff\xd8\xff"},
                                                                  {"exr", "\x76\x2f\x31\x01"},
                                                                  {"pcx", std::string("\x0a\x05\x01\x08", 4)}}};
  for (const auto& [extension, magic] : kinds) {
    const std::string file = std::string("picture.") + extension;
    const Outcome outcome = run("render " + sample() + " -o " + file + " --size 64x48 --spp 1 --json");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    for (const char* key : {"read_ms", "build_ms", "bvh_ms", "render_ms", "width", "height", "spp", "paths", "rays",
                            "triangles", "instances", "lights", "peak_rss_mb", "output"})
      EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_EQ(json["width"], 64);
    EXPECT_EQ(json["spp"], 1);
    EXPECT_EQ(outcome.err, "");  // quiet when piped
    std::ifstream picture(path(file), std::ios::binary);
    std::string start(magic.size(), '\0');
    picture.read(start.data(), static_cast<std::streamsize>(start.size()));
    EXPECT_EQ(start, magic) << extension;
  }
}

TEST_F(Program, ClassicAndTopAndCamerasByNameAndNumber) {
  EXPECT_EQ(run("render " + sample() + " -o a.png --size 40x30 --integrator classic").status, 0);
  EXPECT_EQ(run("render " + sample() + " -o a.png --size 40x30 --spp 1 --camera top").status, 0);
  EXPECT_EQ(run("render " + sample() + " -o a.png --size 40x30 --spp 1 --camera 2").status, 0);
  EXPECT_EQ(run("render " + sample() + " -o a.png --size 40x30 --spp 1 --camera Bedroom").status, 0);
  const Outcome unknown = run("render " + sample() + " -o a.png --camera Attic");
  EXPECT_EQ(unknown.status, 1);
  EXPECT_NE(unknown.err.find("Bedroom"), std::string::npos) << "an error names the cameras there are";
}

TEST_F(Program, ConvertKeepsTheHome) {
  ASSERT_EQ(run("convert " + sample() + " copy.idap").status, 0);
  EXPECT_EQ(run("info --json copy.idap").out, run("info --json " + sample()).out);
}

TEST_F(Program, BadFilesAreOneLineAndStatusOne) {
  write("empty.idap", "");
  write("text.sh3d", "this is not a home");
  write("half.idap", "PK\x03\x04 and then nothing");
  fs::create_directory(path("folder.idap"));
  for (const char* file : {"empty.idap", "text.sh3d", "half.idap", "folder.idap", "missing.idap"}) {
    for (const char* command : {"info ", "render -o x.png "}) {
      const Outcome outcome = run(command + std::string(file));
      EXPECT_EQ(outcome.status, 1) << file;
      EXPECT_NE(outcome.err.find(file), std::string::npos) << outcome.err;
      EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
  }
}

TEST_F(Program, TruncatedHomesNeverCrash) {
  std::ifstream in(kSample, std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(in)), {});
  for (std::size_t part = 1; part < 12; ++part) {
    write("part.idap", whole.substr(0, whole.size() * part / 12));
    EXPECT_EQ(run("info part.idap").status, 1) << part;
  }
}

TEST_F(Program, GiantPictureIsRefusedWithAReason) {
  const Outcome outcome = run("render " + sample() + " -o a.png --size 40000x40000");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("GB"), std::string::npos) << outcome.err;
}

TEST_F(Program, UnwritableTargetsLeaveNothingBehind) {
  const Outcome missing = run("render " + sample() + " -o no/such/folder/a.png --size 20x20 --spp 1");
  EXPECT_EQ(missing.status, 1);
  const Outcome full = run("render " + sample() + " -o /dev/full --size 20x20 --spp 1");
  EXPECT_NE(full.status, 0);
  write("good.idap", "precious");
  const Outcome bad = run("convert missing.idap good.idap");
  EXPECT_EQ(bad.status, 1);
  std::ifstream in(path("good.idap"));
  std::string text;
  in >> text;
  EXPECT_EQ(text, "precious");
}

TEST_F(Program, InterruptSavesWhatThereIs) {
  const Outcome outcome = run("render " + sample() + " -o a.png --size 320x240 --time 60 --no-denoise & child=$!; sleep 3; kill -INT $child; wait $child");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(fs::exists(path("a.png")));
}

TEST_F(Program, CatalogFindsAndShowsPieces) {
  const Outcome list = run("catalog list --json");
  ASSERT_EQ(list.status, 0) << list.err;
  const auto pieces = nlohmann::json::parse(list.out);
  std::size_t builtIn = 0;
  for (const auto& piece : pieces) builtIn += piece["library"].get<std::string>().empty() ? 1 : 0;
  EXPECT_GE(builtIn, 60u);
  const Outcome search = run("catalog search 'table'");
  EXPECT_EQ(search.status, 0);
  EXPECT_NE(search.out.find("idap/"), std::string::npos);
  const std::string id = pieces[0]["id"];
  const Outcome show = run("catalog show '" + id + "'");
  EXPECT_EQ(show.status, 0);
  EXPECT_NE(show.out.find(id), std::string::npos);
  EXPECT_EQ(run("catalog show no-such-piece").status, 1);
}

}  // namespace
