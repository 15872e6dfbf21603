// SPDX-License-Identifier: BSD-3-Clause
// Runs that are gone on with, or refused.
#include <filesystem>

#include "tests/eval/batch/eval_runner.h"

namespace {

namespace fs = std::filesystem;
using epcc::test::EvalToolTest;

class EvalResume : public EvalToolTest {
 protected:
  void writeFrames(const std::string& folder, unsigned count) const {
    for (unsigned i = 0; i < count; ++i) writeFrame(folder, "f" + std::to_string(i), i);
  }
};

TEST_F(EvalResume, WhatIsDoneIsNotDoneAgain) {
  writeFrames("rooms", 3);
  ASSERT_EQ(run({"rooms", "--methods", "omps", "--out", "o"}).exit_code, 0);
  const auto before = report("o");
  const std::string times = read("o/frames.csv");
  fs::remove(path("rooms/f1_depth.png"));
  write("rooms/f1_depth.png", "broken");
  fs::remove(path("o/results/rooms/000000/002.json"));
  const auto result = run({"rooms", "--methods", "omps", "--out", "o", "--resume"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(report("o"), before);
  const std::string again = read("o/frames.csv");
  EXPECT_EQ(again.substr(0, again.find("rooms,f2")), times.substr(0, times.find("rooms,f2")));
}

TEST_F(EvalResume, DamagedResultsAreDoneAgain) {
  writeFrames("rooms", 4);
  ASSERT_EQ(run({"rooms", "--methods", "omps", "--out", "o"}).exit_code, 0);
  const auto before = report("o");
  const std::string folder = "o/results/rooms/000000/";
  const std::string whole = read(folder + "000.json");
  write(folder + "000.json", "");
  write(folder + "001.json", whole.substr(0, whole.size() / 2));
  write(folder + "002.json", "{\"version\": 1, \"index\": 2, \"records\": []}");
  write(folder + ".epcc-1-2-3-4.tmp", "half");
  EXPECT_EQ(run({"rooms", "--methods", "omps", "--out", "o", "--resume"}).exit_code, 0);
  EXPECT_EQ(report("o"), before);
  EXPECT_FALSE(exists(folder + ".epcc-1-2-3-4.tmp"));
}

TEST_F(EvalResume, ResultsAreNotOverwritten) {
  writeFrames("rooms", 1);
  ASSERT_EQ(run({"rooms", "--methods", "omps", "--out", "o"}).exit_code, 0);
  expectFailure({"rooms", "--methods", "omps", "--out", "o"}, 2, "o has results already; go on with --resume");
  fs::remove(path("o/run.json"));
  expectFailure({"rooms", "--methods", "omps", "--out", "o"}, 2, "o has results already");
  expectFailure({"rooms", "--methods", "omps", "--out", "o", "--resume"}, 2, "no run.json");
  write("o/run.json", "{}");
  expectFailure({"rooms", "--methods", "omps", "--out", "o", "--resume"}, 3, "run.json: file: ");
}

TEST_F(EvalResume, AnotherRunIsRefusedAndTheDifferenceNamed) {
  writeFrames("rooms", 2);
  ASSERT_EQ(run({"rooms", "--methods", "omps", "--out", "o"}).exit_code, 0);
  const auto refused = [&](std::vector<std::string> arguments, const std::string& words) {
    arguments.insert(arguments.end(), {"--out", "o", "--resume"});
    expectFailure(arguments, 2, words);
  };
  refused({"rooms", "--methods", "omps,epcc"}, "--methods was omps, is omps,epcc");
  refused({"rooms", "--methods", "omps", "--noise", "kinect-v1"}, "--noise was the frames' own, is kinect-v1");
  refused({"rooms", "--methods", "omps", "--max-depth", "4"},
          "the input was read without options, is read with --max-depth 4");
  refused({"rooms", "--methods", "omps", "--overlays"}, "--overlays was off, is on");
  refused({"rooms", "--methods", "omps", "--shard", "1/2"}, "--shard was 1/1, is 1/2");
  refused({"rooms", "--methods", "omps", "--predictions", "a=b"}, "--predictions was none, is a=b");
  writeFrame("halls", "f");
  refused({"rooms", "halls", "--methods", "omps"}, "DATASET was rooms, is rooms,halls");
  writeFrame("rooms", "f2");
  refused({"rooms", "--methods", "omps"}, "data set rooms had 2 frames, has 3");
  for (const char* file : {"f2_depth.png", "f2_labels.png", "f2.json"})
    fs::rename(path(std::string("rooms/") + file), path(std::string("halls/") + file));
  for (const char* file : {"_depth.png", "_labels.png", ".json"})
    fs::rename(path(std::string("rooms/f1") + file), path(std::string("rooms/g1") + file));
  refused({"rooms", "--methods", "omps"}, "the frames of data set rooms have other names");
}

// The name of a file says nothing of the model that is in it.
TEST_F(EvalResume, AnotherModelInTheSameFileIsAnotherRun) {
  writeFrames("rooms", 1);
  write("s.json", R"({"noise": "0.001,0.003,2"})");
  const std::vector<std::string> again = {"rooms", "--methods", "omps", "--noise", "s.json", "--out", "o", "--resume"};
  ASSERT_EQ(run(again).exit_code, 0);
  ASSERT_EQ(run(again).exit_code, 0);
  write("s.json", R"({"noise": "0.002,0.003,2"})");
  expectFailure(again, 2, "--noise was s.json (0.001,0.003,2), is s.json (0.002,0.003,2)");
}

TEST_F(EvalResume, ResultsOfAnotherMethodAreDoneAgain) {
  writeFrames("rooms", 2);
  const std::vector<std::string> again = {"rooms", "--methods", "omps", "--out", "o", "--no-times", "--resume"};
  ASSERT_EQ(run(again).exit_code, 0);
  const std::string file = "o/results/rooms/000000/000.json", before = read(file);
  std::string foreign = before;
  write(file, foreign.replace(foreign.find("omps"), 4, "omqs"));
  expectFailure({"merge", "o", "--out", "m"}, 3, file + ": result: is missing");
  ASSERT_EQ(run(again).exit_code, 0);
  EXPECT_EQ(read(file), before);
}

TEST_F(EvalResume, NeedsOut) {
  writeFrames("rooms", 1);
  expectFailure({"rooms", "--resume"}, 2, "--resume needs --out");
}

TEST_F(EvalResume, TwoAtATimeInOneFolderAreRefused) {
  writeFrames("rooms", 1);
  fs::create_directory(path("o"));
  const std::string hold = "flock o/.epcc-lock ";
  const auto result = runShell(hold, {"rooms", "--methods", "omps", "--out", "o"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_NE(result.err.find("another process is at work in it"), std::string::npos) << result.err;
}

}  // namespace
