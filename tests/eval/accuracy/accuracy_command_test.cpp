// SPDX-License-Identifier: BSD-3-Clause
// epcc_accuracy's command line: wrong usage, pages and data sets that are not there.
#include "eval/accuracy/accuracy_command.h"

#include <gtest/gtest.h>

#include "tests/support/run_tool.h"

namespace epcc::test {
namespace {

ToolResult run(const std::vector<std::string>& arguments) {
  return callTool(accuracyMain, "epcc_accuracy", arguments);
}

void expectFailure(const std::vector<std::string>& arguments, int code, const std::string& words) {
  test::expectFailure(run(arguments), "epcc_accuracy", code, words);
}

class AccuracyCommand : public TempFolderTest {};

TEST_F(AccuracyCommand, UsageErrorsAreOneLine) {
  expectFailure({"--seeds", "0"}, 2, "--seeds");
  expectFailure({"--jobs", "-1"}, 2, "--jobs");
  expectFailure({"--data"}, 2, "--data");
  expectFailure({"--loud"}, 2, "--loud");
  expectFailure({"extra"}, 2, "extra");
}

TEST_F(AccuracyCommand, HelpAndVersionAreNoErrors) {
  EXPECT_NE(run({"--help"}).out.find("--page"), std::string::npos);
  EXPECT_EQ(run({"--version"}).out.rfind("epcc_accuracy ", 0), 0U);
}

TEST_F(AccuracyCommand, UnusablePagesAreSaidBeforeTheWork) {
  expectFailure({"--page", path("none.md"), "--out", path("out")}, 3, "none.md");
  expectFailure({"--page", write("bare.md", "no tables\n"), "--out", path("out")}, 3, "<!-- table sensors -->");
  EXPECT_EQ(names(), std::vector<std::string>{"bare.md"});
}

TEST_F(AccuracyCommand, AnOutputFolderThatCannotBeMadeIsSaid) {
  const std::string file = write("file", "x");
  expectFailure({"--out", file + "/out"}, 4, "file/out");
}

TEST_F(AccuracyCommand, MissingDataSetsAreNamedAndThePageStaysAsItIs) {
  std::string page;
  for (const char* name :
       {"sensors", "totals", "halves", "copies", "repeatability", "curve", "scenes", "steps", "frames"})
    page += std::string("<!-- table ") + name + " -->\n<!-- end of table -->\n";
  const std::string file = write("page.md", page);
  const ToolResult outcome =
      run({"--data", path("none"), "--out", path("out"), "--page", file, "--seeds", "1", "--jobs", "2"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 8) << outcome.err;
  EXPECT_NE(outcome.err.find("none/sequence"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("none/kinect"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.out.find("stereo"), std::string::npos) << "rendered scenes need no data";
  EXPECT_EQ(bytesOf(file), page);
  EXPECT_TRUE(std::filesystem::exists(path("out/overlays/d-white_0.png")));
  EXPECT_TRUE(std::filesystem::exists(path("out/frames.csv")));
  EXPECT_TRUE(std::filesystem::exists(path("out/curve.png")));
}

}  // namespace
}  // namespace epcc::test
