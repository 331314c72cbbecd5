// `idap print`: a plan on paper without a display.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/program.h"

namespace idap {
namespace {

using test::Outcome;
using testing::HasSubstr;
using testing::StartsWith;

class Print : public test::ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (!std::filesystem::exists(std::filesystem::path(IDAP_PROGRAM).parent_path() / "idap-studio"))
      GTEST_SKIP() << "needs the studio";
  }
  // As on a machine without a desktop.
  static void bare() {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    unsetenv("XDG_RUNTIME_DIR");
  }
};

TEST_F(Print, APlanBecomesAPdfAndASvg) {
  const Outcome pdf = run("print " + sample() + " -o plan.pdf --scale 1:100", bare);
  EXPECT_EQ(pdf.status, 0) << pdf.err;
  EXPECT_EQ(pdf.err, "");
  EXPECT_THAT(contents("plan.pdf"), StartsWith("%PDF"));
  EXPECT_EQ(run("print " + sample() + " -o plan.svg --language th", bare).status, 0);
  EXPECT_THAT(contents("plan.svg"), HasSubstr("width=\"297mm\""));
}

TEST_F(Print, WrongUsageIsStatusTwoAndWhatIsMissingStatusOne) {
  for (const char* wrong : {"--scale tiny", "--paper A99", "--sheets roof", "--scale 1:0"}) {
    const Outcome outcome = run("print " + sample() + " -o plan.pdf " + wrong, bare);
    EXPECT_EQ(outcome.status, 2) << wrong;
    EXPECT_THAT(outcome.err, StartsWith("idap: ")) << wrong;
  }
  EXPECT_EQ(run("print " + sample() + " -o plan.doc", bare).status, 2);
  const Outcome room = run("print " + sample() + " -o plan.pdf --sheets walls --room Attic", bare);
  EXPECT_EQ(room.status, 1);
  EXPECT_THAT(room.err, HasSubstr("Attic"));
  EXPECT_EQ(run("print gone.idap -o plan.pdf", bare).status, 1);
  EXPECT_EQ(run("print " + sample() + " -o no/plan.pdf", bare).status, 1);
  EXPECT_EQ(filesInFolder(), 0u);
}

}  // namespace
}  // namespace idap
