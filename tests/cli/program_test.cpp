// The program as a user or a script runs it: exit status, what it says, what it writes.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "support/program.h"

namespace idap {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using testing::HasSubstr;
using testing::StartsWith;

class Program : public test::ProgramTest {};

TEST_F(Program, HelpAndVersionEverywhere) {
  for (const std::string command : {"", "info", "render", "film", "print", "convert", "catalog"}) {
    const Outcome help = run(command + " --help");
    EXPECT_EQ(help.status, 0) << command;
    EXPECT_THAT(help.out, HasSubstr("--help")) << command;
    const Outcome version = run(command + " --version");
    EXPECT_EQ(version.status, 0) << command;
    EXPECT_THAT(version.out, StartsWith("idap ")) << command;
  }
}

TEST_F(Program, WrongUsageIsStatusTwo) {
  for (const std::string wrong : {"frobnicate", "info", "convert a.idap", "catalog", "catalog show"})
    EXPECT_EQ(run(wrong).status, 2) << wrong;
  EXPECT_EQ(run("render " + sample()).status, 2);
  for (const std::string wrong :
       {"--size huge", "--size 0x10", "--size 10x", "--size 99999999999x9", "--spp -1", "--spp 1.5",
        "--integrator magic", "--at yesterday", "--at 2026-13-01T10:00", "--time 0", "--time nan",
        "--time 5 --spp 5", "--clouds nan", "--exposure inf", "--tone loud", "--lamps maybe", "--threads 0"})
    EXPECT_EQ(run("render " + sample() + " -o a.png " + wrong).status, 2) << wrong;
  EXPECT_EQ(run("render " + sample() + " -o a.tiff2").status, 2);
  EXPECT_EQ(filesInFolder(), 0u);
}

// Whatever the machine that runs the tests has.
void withoutDisplay() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) unsetenv(name);
}

TEST_F(Program, WithoutADisplayTheStudioSaysSoInOneLine) {
  for (const std::string& arguments : {std::string(), sample(), std::string("not-there.idap")}) {
    const Outcome outcome = run(arguments, withoutDisplay);
    EXPECT_EQ(outcome.status, 1) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr("display")) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr("idap render")) << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
}

// A studio that only tells how it was called.
TEST_F(Program, StartsTheStudioBesideItWithTheSameArguments) {
  fs::copy_file(IDAP_PROGRAM, path("idap"));
  write("idap-studio", "#!/bin/sh\nprintf '[%s]' \"$@\"; exit 7\n");
  fs::permissions(path("idap-studio"), fs::perms::owner_all);
  write("my plan.idap", "");
  const auto start = [this](const std::string& arguments) {
    const std::string command = "'" + path("idap").string() + "' " + arguments + " > out.txt";
    return std::system(("cd '" + path("").string() + "' && QT_QPA_PLATFORM=offscreen " + command).c_str());
  };
  EXPECT_EQ(WEXITSTATUS(start("'my plan.idap'")), 7);
  EXPECT_EQ(contents("out.txt"), "[my plan.idap]");
  EXPECT_EQ(WEXITSTATUS(start("")), 7);
  EXPECT_EQ(WEXITSTATUS(start("gone.sh3d --measure-start")), 7);
  EXPECT_EQ(contents("out.txt"), "[gone.sh3d][--measure-start]");
  EXPECT_EQ(WEXITSTATUS(start("--version")), 0);
  EXPECT_EQ(WEXITSTATUS(start("frobnicate 2> err.txt")), 2);
}

TEST_F(Program, WhereTheStudioIsNotInstalledItSaysSo) {
  fs::copy_file(IDAP_PROGRAM, path("idap"));
  const std::string command =
      "QT_QPA_PLATFORM=offscreen '" + path("idap").string() + "' 2> '" + path("err.txt").string() + "'";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1);
  EXPECT_THAT(contents("err.txt"), HasSubstr("not installed"));
}

TEST_F(Program, InfoCountsTheSample) {
  const Outcome outcome = run("info --json " + sample());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  for (const char* key : {"levels", "walls", "rooms", "pieces", "groups", "openings", "lamps", "cameras",
                          "dimensions", "labels", "polylines", "pictures", "triangles"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["cameras"], 3);
  EXPECT_GE(json["rooms"], 2);
  EXPECT_GT(json["triangles"], 10000);
}

TEST_F(Program, RendersEveryPictureFormat) {
  const std::array<std::pair<std::string, std::string>, 4> kinds{
      {{"png", "\x89PNG"},
       {"jpg", "\xff\xd8\xff"},
       {"exr", "\x76\x2f\x31\x01"},
       {"pcx", std::string("\x0a\x05\x01\x08", 4)}}};
  for (const auto& [extension, magic] : kinds) {
    const std::string file = "picture." + extension;
    const Outcome outcome = run("render " + sample() + " -o " + file + " --size 64x48 --spp 1 --json");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);  // throws where it is more than one object
    for (const char* key : {"read_ms", "build_ms", "bvh_ms", "render_ms", "width", "height", "spp", "paths",
                            "rays", "triangles", "instances", "lights", "peak_rss_mb", "output"})
      EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_EQ(json["width"], 64);
    EXPECT_EQ(json["height"], 48);
    EXPECT_EQ(json["spp"], 1);
    EXPECT_EQ(json["paths"], 64 * 48);
    EXPECT_GT(json["peak_rss_mb"], 1);
    EXPECT_EQ(json["output"], file);
    EXPECT_EQ(outcome.err, "") << "not quiet without a terminal";
    EXPECT_THAT(contents(file), StartsWith(magic));
  }
}

TEST_F(Program, ClassicAndTopAndCamerasByNameAndNumber) {
  const std::string render = "render " + sample() + " -o a.png --size 40x30 --spp 1 --no-denoise ";
  for (const std::string how : {"--integrator classic", "--camera top", "--camera 2", "--camera Bedroom"})
    EXPECT_EQ(run(render + how).status, 0) << how;
  const Outcome unknown = run(render + "--camera Attic");
  EXPECT_EQ(unknown.status, 1);
  EXPECT_THAT(unknown.err, HasSubstr("Bedroom")) << "an error names the cameras there are";
}

TEST_F(Program, ConvertKeepsTheHome) {
  ASSERT_EQ(run("convert " + sample() + " copy.idap").status, 0);
  EXPECT_EQ(run("info --json copy.idap").out, run("info --json " + sample()).out);
  ASSERT_EQ(run("convert copy.idap copy.idap").status, 0) << "onto itself";
  EXPECT_EQ(run("info copy.idap").status, 0);
  const Outcome unknown = run("convert copy.idap copy.dwg");
  EXPECT_EQ(unknown.status, 1);
  EXPECT_THAT(unknown.err, HasSubstr(".idap"));
}

TEST_F(Program, InterruptWhileReadingStopsWithStatusOne) {
  // The program opens the pipe after it is ready for interrupts, and waits for the home to come through it.
  ASSERT_EQ(mkfifo(path("slow.idap").c_str(), 0600), 0);
  const pid_t child = start("render slow.idap -o a.png --size 64x48 --spp 1");
  const int pipe = open(path("slow.idap").c_str(), O_WRONLY);
  ASSERT_GE(pipe, 0);
  kill(child, SIGINT);
  std::ifstream in(samplePath(), std::ios::binary);
  const std::string home(std::istreambuf_iterator<char>(in), {});
  for (std::size_t done = 0; done < home.size();) {
    const ssize_t put = ::write(pipe, home.data() + done, home.size() - done);
    if (put <= 0) break;
    done += static_cast<std::size_t>(put);
  }
  close(pipe);
  const Outcome outcome = finish(child);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, "idap: cancelled\n");
  EXPECT_FALSE(fs::exists(path("a.png")));
}

// A terminal for standard error; gives what was written to it so far.
class Terminal {
 public:
  Terminal() : master_(posix_openpt(O_RDWR | O_NOCTTY)) {
    if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0) return;
    slave_ = open(ptsname(master_), O_RDWR | O_NOCTTY);
  }
  ~Terminal() {
    close(slave_);
    close(master_);
  }
  bool works() const { return slave_ >= 0; }
  void becomeStandardError() const { dup2(slave_, STDERR_FILENO); }
  const std::string& text() {
    std::array<char, 4096> buffer;
    for (pollfd ready{master_, POLLIN, 0}; poll(&ready, 1, 20) > 0 && (ready.revents & POLLIN);) {
      const ssize_t got = read(master_, buffer.data(), buffer.size());
      if (got <= 0) break;
      text_.append(buffer.data(), static_cast<std::size_t>(got));
    }
    return text_;
  }

 private:
  int master_, slave_ = -1;
  std::string text_;
};

TEST_F(Program, InterruptWhileRenderingSavesWhatThereIs) {
  Terminal terminal;
  if (!terminal.works()) GTEST_SKIP() << "no terminals here";
  const pid_t child = start("render " + sample() + " -o a.png --size 64x48 --time 60 --no-denoise --json",
                            [&] { terminal.becomeStandardError(); });
  for (int waits = 0; terminal.text().find("rendering") == std::string::npos && waits < 1000; ++waits)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  kill(child, SIGINT);
  const Outcome outcome = finish(child);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(contents("a.png"), StartsWith("\x89PNG"));
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["interrupted"], true);
  EXPECT_THAT(terminal.text(), HasSubstr("idap: stopped; a.png holds"));
}

TEST_F(Program, TerminalShowsAProgressBarAndKeepsNoneOfIt) {
  Terminal terminal;
  if (!terminal.works()) GTEST_SKIP() << "no terminals here";
  const Outcome outcome = run("render " + sample() + " -o a.png --size 64x48 --spp 4 --no-denoise",
                              [&] { terminal.becomeStandardError(); });
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "");
  const std::string& text = terminal.text();
  EXPECT_THAT(text, HasSubstr("rendering"));
  EXPECT_THAT(text, HasSubstr(" %"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 0);
  EXPECT_THAT(text, testing::EndsWith("\r\x1b[K")) << "the line is wiped at the end";
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
  EXPECT_THAT(search.out, HasSubstr("idap/"));
  const std::string id = pieces[0]["id"];
  const Outcome show = run("catalog show '" + id + "'");
  EXPECT_EQ(show.status, 0);
  EXPECT_THAT(show.out, HasSubstr(id));
  EXPECT_EQ(run("catalog show no-such-piece").status, 1);
}

}  // namespace
}  // namespace idap
