// SPDX-License-Identifier: BSD-3-Clause
// epcc_eval --repeatability: from a folder with poses to a table and a file.
#include "datasets/files/frame_pose.h"
#include "datasets/files/labelled_frame.h"
#include "tests/eval/batch/eval_runner.h"
#include "tests/support/tiny_frames.h"

namespace epcc::test {
namespace {

class EvalRepeatability : public EvalToolTest {
 protected:
  void writePosedFrame(const std::string& name, unsigned seed) const {
    std::filesystem::create_directories(path("walk"));
    LabelledFrame frame = tinyFrame(name, seed);
    setFramePose(Eigen::Isometry3d::Identity(), frame);
    frame.labels = LabelImage();
    writeLabelledFrame(path("walk"), frame);
  }
};

TEST_F(EvalRepeatability, PrintsATableAndLeavesItsCounts) {
  for (unsigned i = 0; i < 4; ++i) writePosedFrame("f" + std::to_string(i), i);
  const auto result = run({"walk", "--repeatability", "1,3", "--methods", "epcc,omps", "--out", "deep/out"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out.rfind("dataset  method  lag  pairs  pixels  labelled  regions repeated", 0), 0U) << result.out;
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 5) << "two methods at two lags";
  const std::string counts = read("deep/out/repeatability.csv");
  EXPECT_NE(counts.find("walk,epcc,1,3,14400,"), std::string::npos) << counts;
  EXPECT_NE(counts.find("walk,omps,3,1,4800,"), std::string::npos) << counts;
  EXPECT_EQ(names("deep/out"), std::vector<std::string>{"repeatability.csv"});
}

TEST_F(EvalRepeatability, FramesWithoutPoseAreNamed) {
  for (unsigned i = 0; i < 2; ++i) writePosedFrame("f" + std::to_string(i), i);
  writeFrame("walk", "f2");
  const std::vector<std::string> arguments = {"walk", "--repeatability", "1", "--methods", "omps"};
  const auto result = run(arguments);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "epcc_eval: f2.json: pose: is missing\n");
  auto strict = arguments;
  strict.push_back("--strict");
  EXPECT_EQ(run(strict).exit_code, 3);
  std::filesystem::remove(path("walk/f1.json"));
  EXPECT_EQ(run(arguments).exit_code, 3) << "there is no pair left";
}

TEST_F(EvalRepeatability, LagsThatNoSequenceIsLongEnoughForAreNamed) {
  for (unsigned i = 0; i < 3; ++i) writePosedFrame("f" + std::to_string(i), i);
  expectFailure({"walk", "--repeatability", "3", "--methods", "epcc", "--out", "o"}, 3,
                "--repeatability: 3 is not below the number of frames, 3");
  EXPECT_FALSE(exists("o"));
  const auto result = run({"walk", "--repeatability", "2,500", "--methods", "epcc"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "epcc_eval: --repeatability: 500 is not below the number of frames, 3\n");
  EXPECT_EQ(run({"walk", "--repeatability", "2,500", "--methods", "epcc", "--strict"}).exit_code, 3);
}

TEST_F(EvalRepeatability, TakesTheOptionsThatSayWhatTheNumbersOfAnInputAre) {
  for (unsigned i = 0; i < 2; ++i) writePosedFrame("f" + std::to_string(i), i);
  const auto table = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"walk", "--repeatability", "1", "--methods", "epcc"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments).out;
  };
  EXPECT_EQ(table({"--unit", "mm"}), table({}));
  EXPECT_NE(table({"--max-depth", "1.5"}), table({}));
}

TEST_F(EvalRepeatability, WhatBelongsToScoresIsRefused) {
  writePosedFrame("f0", 0);
  const auto refused = [&](const std::vector<std::string>& more, const std::string& words) {
    std::vector<std::string> arguments = {"walk", "--repeatability"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expectFailure(arguments, 2, words);
  };
  refused({"0"}, "'0' is no number of frames from 1 to 10000");
  refused({"5,x"}, "'x' is no number of frames");
  refused({"-1"}, "'-1' is no number of frames");
  refused({"5,,25"}, "'' is no number of frames");
  refused({"99999"}, "'99999' is no number of frames");
  refused({"5,25,5"}, "5 is named twice");
  refused({""}, "LAG is empty");
  refused({"5", "--shard", "1/2"}, "--shard does not go with --repeatability");
  refused({"5", "--jobs", "2"}, "--jobs does not go with --repeatability");
  refused({"5", "--out", "o", "--resume"}, "--resume does not go with --repeatability");
  refused({"5", "--out", "o", "--overlays"}, "--overlays does not go with --repeatability");
}

}  // namespace
}  // namespace epcc::test
