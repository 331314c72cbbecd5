// Runs the program as a user or a script does, in a folder of its own that goes with the test.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

namespace idap::test {

struct Outcome {
  int status = -1;  // as a shell has it: 128 + the signal where one ended it
  std::string out, err;
};

class ProgramTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "idap-cli-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  std::string contents(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::size_t filesInFolder() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
  }

  // Arguments as a shell reads them. prepare is called in the child before the program starts.
  pid_t start(const std::string& arguments, const std::function<void()>& prepare = {}) const {
    const std::string command = "exec '" IDAP_PROGRAM "' " + arguments;
    const pid_t child = fork();
    if (child != 0) return child;
    if (chdir(folder_.c_str()) != 0) _exit(126);
    const auto redirect = [](int fd, const std::string& file, int flags) {
      const int opened = open(file.c_str(), flags, 0600);
      if (opened < 0 || dup2(opened, fd) < 0) _exit(126);
      close(opened);
    };
    redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
    redirect(STDOUT_FILENO, path("stdout.txt"), O_WRONLY | O_CREAT | O_TRUNC);
    redirect(STDERR_FILENO, path("stderr.txt"), O_WRONLY | O_CREAT | O_TRUNC);
    if (prepare) prepare();
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  Outcome finish(pid_t child) const {
    int raw = 0;
    while (waitpid(child, &raw, 0) < 0 && errno == EINTR) {
    }
    Outcome outcome;
    outcome.status = WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
    outcome.out = contents("stdout.txt");
    outcome.err = contents("stderr.txt");
    std::filesystem::remove(path("stdout.txt"));
    std::filesystem::remove(path("stderr.txt"));
    return outcome;
  }
  Outcome run(const std::string& arguments, const std::function<void()>& prepare = {}) const {
    return finish(start(arguments, prepare));
  }

  static std::filesystem::path samplePath() {
    return std::filesystem::path(IDAP_SOURCE_DIR) / "share/samples/apartment.idap";
  }
  static std::string sample() { return "'" + samplePath().string() + "'"; }

 private:
  std::filesystem::path folder_;
};

}  // namespace idap::test
