// SPDX-License-Identifier: BSD-3-Clause
// Frames and folders that cannot be used: counted, named, and never the end of the run.
#include <algorithm>

#include "datasets/files/png_io.h"
#include "tests/eval/batch/eval_runner.h"

namespace {

namespace fs = std::filesystem;
using epcc::test::EvalToolTest;

class EvalBadInput : public EvalToolTest {
 protected:
  static long lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }
};

TEST_F(EvalBadInput, BadFramesCostARowEach) {
  for (const char* name : {"a", "b", "c", "d"}) writeFrame("rooms", name);
  write("rooms/a_depth.png", "broken");
  write("rooms/b.json", "{");
  fs::remove(path("rooms/c_labels.png"));
  const auto result = run({"rooms", "--methods", "epcc-paper,omps", "--out", "o"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(lines(result.err), 4) << "one line a frame and the count\n" << result.err;
  EXPECT_NE(result.err.find("a_depth.png"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("b.json"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("rooms/c: "), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("6 errors, 2 results scored"), std::string::npos) << result.err;
  for (const std::string method : {"epcc-paper", "omps"}) {
    const auto entry = row("o", "rooms", method);
    EXPECT_EQ(entry.at("frames"), 4);
    EXPECT_EQ(entry.at("errors"), 3);
    EXPECT_EQ(entry.at("N"), 3);
    EXPECT_FALSE(exists("o/labels/" + method + "/a_labels.png"));
    EXPECT_TRUE(exists("o/labels/" + method + "/d_labels.png"));
  }
  EXPECT_NE(read("o/summary.md").find("b.json"), std::string::npos);
}

TEST_F(EvalBadInput, OptionsThatNoFrameHasAUseForAreRefused) {
  writeFrame("rooms", "a");
  std::filesystem::create_directory(path("scans"));
  write("scans/s.pcd", "broken");
  write("scans/s.json", "{}");
  expectFailure({"rooms", "--methods", "omps", "--projection", "camera"}, 2,
                "--projection is for clouds, and there are depth images only");
  expectFailure({"scans", "--methods", "omps", "--distance"}, 2,
                "--distance is for depth images, and there are clouds only");
  for (const std::vector<std::string>& option : {std::vector<std::string>{"--distance"}, {"--projection", "scanner"}}) {
    std::vector<std::string> arguments = {"rooms", "scans", "--methods", "omps"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    EXPECT_EQ(run(arguments).exit_code, 0) << "some frames have";
  }
}

TEST_F(EvalBadInput, StrictMakesErrorsCountInTheExitCode) {
  writeFrame("rooms", "a");
  EXPECT_EQ(run({"rooms", "--methods", "omps", "--strict"}).exit_code, 0);
  writeFrame("rooms", "b");
  write("rooms/b_labels.png", "broken");
  EXPECT_EQ(run({"rooms", "--methods", "omps"}).exit_code, 0);
  EXPECT_EQ(run({"rooms", "--methods", "omps", "--strict", "--out", "o"}).exit_code, 3);
  EXPECT_EQ(row("o", "rooms", "omps").at("N"), 3) << "the rest is done all the same";
}

TEST_F(EvalBadInput, MissingOrEmptyFolder) {
  writeFrame("rooms", "a");
  fs::create_directory(path("empty"));
  write("file", "x");
  for (const char* bad : {"nowhere", "empty", "file"}) {
    const auto mixed = run({bad, "rooms", "--methods", "omps"});
    EXPECT_EQ(mixed.exit_code, 0) << mixed.err;
    EXPECT_NE(mixed.err.find(std::string("epcc_eval: ") + bad + ": "), std::string::npos) << mixed.err;
    EXPECT_NE(mixed.err.find("1 error, 1 result scored"), std::string::npos) << mixed.err;
    EXPECT_EQ(run({bad, "rooms", "--methods", "omps", "--strict"}).exit_code, 3);
    EXPECT_EQ(run({bad, "--methods", "omps"}).exit_code, 3);
  }
}

TEST_F(EvalBadInput, NoFrameScoredAtAll) {
  writeFrame("rooms", "a");
  fs::remove(path("rooms/a_labels.png"));
  const auto result = run({"rooms", "--methods", "omps", "--out", "o"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(row("o", "rooms", "omps").at("errors"), 1);
  EXPECT_TRUE(row("o", "rooms", "omps").at("median_ms").is_null());
}

TEST_F(EvalBadInput, ADataSetThatIsNotThereLeavesNothingBehind) {
  writeFrame("rooms", "a");
  const auto mistyped = run({"romos", "--methods", "omps", "--out", "o"});
  EXPECT_EQ(mistyped.exit_code, 3);
  EXPECT_EQ(mistyped.out, "");
  EXPECT_FALSE(exists("o"));
  EXPECT_EQ(run({"rooms", "--methods", "omps", "--out", "o"}).exit_code, 0);
}

TEST_F(EvalBadInput, PredictionsWithoutAName) {
  writeFrame("rooms", "a");
  expectFailure({"rooms", "--methods", "omps", "--predictions", "o/labels/omps"}, 2,
                "--predictions: 'o/labels/omps' is not NAME=DIR");
}

TEST_F(EvalBadInput, MissingPredictionsAreErrorsOfTheirMethodAlone) {
  writeFrame("rooms", "a");
  const auto result = run({"rooms", "--methods", "omps", "--predictions", "theirs=nowhere", "--out", "o"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.err.find("rooms/a: theirs: "), std::string::npos) << result.err;
  EXPECT_EQ(row("o", "rooms", "theirs").at("errors"), 1);
  EXPECT_EQ(row("o", "rooms", "theirs").at("N"), 0);
  EXPECT_EQ(row("o", "rooms", "omps").at("errors"), 0);
}

TEST_F(EvalBadInput, PredictionOfAnotherSize) {
  writeFrame("rooms", "a");
  fs::create_directory(path("theirs"));
  epcc::writeGray16(path("theirs/a_labels.png"), epcc::LabelImage(8, 6, 1));
  const auto result = run({"rooms", "--methods", "none", "--predictions", "theirs=theirs"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.err.find("8x6"), std::string::npos) << result.err;
}

TEST_F(EvalBadInput, OutputsThatCannotBeWritten) {
  writeFrame("rooms", "a");
  write("file", "x");
  expectFailure({"rooms", "--methods", "omps", "--out", "file"}, 4, "file: folder: ");
  write("o/labels", "a file where a folder is needed");
  expectFailure({"rooms", "--methods", "omps", "--out", "o", "--jobs", "2"}, 4, "o/labels/omps: folder: ");
  EXPECT_FALSE(exists("o/summary.json"));
}

}  // namespace
