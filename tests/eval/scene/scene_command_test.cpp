// SPDX-License-Identifier: BSD-3-Clause
// epcc_scene: frames written and read back, the same bytes for the same seed, and every wrong command line.
#include "eval/scene/scene_command.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "datasets/files/frame_pose.h"
#include "datasets/files/trajectory_file.h"
#include "datasets/rendered/scene.h"
#include "tests/support/real_frames.h"
#include "tests/support/run_tool.h"
#include "tests/support/sanitized.h"

namespace epcc::test {
namespace {

namespace fs = std::filesystem;

ToolResult run(const std::vector<std::string>& arguments) {
  return callTool(sceneMain, "epcc_scene", arguments);
}

void expectFailure(const std::vector<std::string>& arguments, int code, const std::string& words) {
  test::expectFailure(run(arguments), "epcc_scene", code, words);
}

/// Runs it to its end, without an error; what it prints.
std::string outputOf(const std::vector<std::string>& arguments) {
  const ToolResult result = run(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return result.out;
}

class SceneCommand : public TempFolderTest {};

TEST_F(SceneCommand, WritesFramesThatReadBack) {
  outputOf({"a", "--seed", "7", "--out", path("f")});
  ASSERT_EQ(listLabelledFrames(path("f")), std::vector<std::string>{"a_007"});
  const LabelledFrame read = readLabelledFrame(path("f"), "a_007"), made = renderScene("a", 7);
  EXPECT_EQ(read.labels.data, made.labels.data);
  EXPECT_EQ(*read.camera.noise, "rendered");
  EXPECT_EQ(read.camera.extra["planes"], made.camera.extra["planes"]);
  EXPECT_DOUBLE_EQ(read.camera.camera.fx, made.camera.camera.fx);
  for (std::size_t i = 0; i < read.depth.data.size(); ++i)
    ASSERT_NEAR(read.depth.data[i], made.depth.data[i], 0.00011F);
}

TEST_F(SceneCommand, GivesTheSameBytesForTheSameSeed) {
  for (const char* folder : {"x", "y"}) outputOf({"b", "--seed", "3", "--noise", "stereo", "--out", path(folder)});
  for (const char* file : {"b_003_depth.png", "b_003_labels.png", "b_003.json"}) {
    ASSERT_FALSE(read(std::string("x/") + file).empty());
    EXPECT_EQ(read(std::string("x/") + file), read(std::string("y/") + file)) << file;
  }
}

TEST_F(SceneCommand, TakesRangesOfSeedsAndAllScenes) {
  outputOf({"all", "--seeds", "2:3", "--out", path("f")});
  EXPECT_EQ(listLabelledFrames(path("f")).size(), 8U);
  outputOf({"a", "--seed", "10", "--count", "3", "--out", path("g")});
  EXPECT_EQ(listLabelledFrames(path("g")), (std::vector<std::string>{"a_010", "a_011", "a_012"}));
}

TEST_F(SceneCommand, TakesALargestSeed) {
  outputOf({"a", "--seed", "18446744073709551615", "--out", path("f")});
  EXPECT_EQ(listLabelledFrames(path("f")), std::vector<std::string>{"a_18446744073709551615"});
  expectFailure({"a", "--seed", "18446744073709551615", "--count", "2", "--out", path("f")}, 2, "--count");
}

TEST_F(SceneCommand, TakesAnotherCamera) {
  outputOf({"c", "--width", "320", "--height", "200", "--fx", "170", "--noise", "white:d435i", "--out", path("f")});
  const LabelledFrame frame = readLabelledFrame(path("f"), "c_000");
  EXPECT_EQ(frame.depth.width, 320);
  EXPECT_EQ(frame.depth.height, 200);
  EXPECT_EQ(frame.camera.camera.fy, 170.0);
  EXPECT_EQ(*frame.camera.noise, "d435i");
}

TEST_F(SceneCommand, WritesASequence) {
  outputOf({"a", "--path", "sway", "--frames", "4", "--rate", "10", "--seed", "3", "--width", "96", "--height", "54",
            "--noise", "white:kinect-v1", "--lasting", "0.5,0.2", "--out", path("f")});
  ASSERT_EQ(listLabelledFrames(path("f")).size(), 4U);
  const Trajectory truth = readTrajectory(path("f/groundtruth.txt"));
  ASSERT_EQ(truth.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const LabelledFrame frame = readLabelledFrame(path("f"), "a_003_sway_00000" + std::to_string(i));
    EXPECT_TRUE(framePose(frame)->isApprox(truth[i].pose, 1e-8));
    EXPECT_DOUBLE_EQ(frame.camera.extra["timestamp"].get<double>(), 0.1 * static_cast<double>(i));
    EXPECT_EQ(*frame.camera.noise, "kinect-v1");
  }
  outputOf({"a", "--path", path("f/groundtruth.txt"), "--rate", "10", "--seed", "3", "--width", "96", "--height", "54",
            "--out", path("g")});
  const Trajectory again = readTrajectory(path("g/groundtruth.txt"));
  ASSERT_EQ(again.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(again[i].pose.isApprox(truth[i].pose, 1e-6)) << i;
}

TEST_F(SceneCommand, ASequenceIsNotMixedWithOtherFramesNorItsPathOverwritten) {
  const std::vector<std::string> small = {"--width", "32", "--height", "18"};
  const auto with = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), small.begin(), small.end());
    return arguments;
  };
  outputOf(with({"a", "--path", "sway", "--frames", "3", "--out", path("f")}));
  outputOf(with({"a", "--path", "sway", "--frames", "3", "--out", path("f")}));
  const std::string truth = read("f/groundtruth.txt");
  expectFailure(with({"a", "--path", "sway", "--frames", "2", "--out", path("f")}), 2,
                "has the frame a_000_sway_000002, which is not of this sequence");
  expectFailure(with({"b", "--path", "walk", "--frames", "2", "--out", path("f")}), 2, "not of this sequence");
  expectFailure(with({"a", "--path", path("f/groundtruth.txt"), "--out", path("f")}), 2,
                "would overwrite the file of --path");
  EXPECT_EQ(read("f/groundtruth.txt"), truth);
}

TEST_F(SceneCommand, APathOfTooManyFramesIsRefused) {
  for (const char* last : {"1e9", "1500000000000000000"}) {
    const std::string file = write("long.txt", std::string("0 0 0 0 0 0 0 1\n") + last + " 0 0 0 0 0 0 1\n");
    expectFailure({"a", "--path", file, "--out", path("f")}, 3, "long.txt: times: span more than 1000000 frames");
    outputOf({"a", "--path", file, "--frames", "2", "--width", "32", "--height", "18", "--out", path("g")});
    EXPECT_EQ(readTrajectory(path("g/groundtruth.txt")).size(), 2U);
  }
}

TEST_F(SceneCommand, RefusesWrongPaths) {
  const std::string out = path("none");
  expectFailure({"a", "--path", "fly", "--out", out}, 2, "fly");
  expectFailure({"all", "--path", "sway", "--out", out}, 2, "--path");
  expectFailure({"a", "--path", "sway", "--count", "2", "--out", out}, 2, "--path");
  expectFailure({"a", "--frames", "3", "--out", out}, 2, "--frames needs --path");
  expectFailure({"a", "--path", "sway", "--frames", "0", "--out", out}, 2, "--frames");
  expectFailure({"a", "--path", "sway", "--lasting", "0.5", "--out", out}, 2, "--noise");
  expectFailure({"a", "--path", "sway", "--noise", "stereo", "--lasting", "2", "--out", out}, 2, "--lasting");
  expectFailure({"a", "--path", path("missing.txt"), "--out", out}, 3, "missing.txt");
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(SceneCommand, RefusesWrongCommandLines) {
  const std::string out = path("none");
  expectFailure({}, 2, "SCENE");
  expectFailure({"a"}, 2, "--out");
  expectFailure({"kitchen", "--out", out}, 2, "kitchen");
  expectFailure({"a", "b", "--out", out}, 2, "b");
  expectFailure({"a", "--out", out, "--unknown"}, 2, "--unknown");
  expectFailure({"a", "--out", out, "--seed", "-1"}, 2, "--seed");
  expectFailure({"a", "--out", out, "--seed", "1.5"}, 2, "--seed");
  expectFailure({"a", "--out", out, "--count", "0"}, 2, "--count");
  expectFailure({"a", "--out", out, "--seeds", "5"}, 2, "--seeds");
  expectFailure({"a", "--out", out, "--seeds", "5:4"}, 2, "--seeds");
  expectFailure({"a", "--out", out, "--seeds", "0:99999999"}, 2, "100000");
  expectFailure({"a", "--out", out, "--seeds", "1:2", "--seed", "1"}, 2, "excludes");
  expectFailure({"a", "--out", out, "--noise", "loud"}, 2, "loud");
  expectFailure({"a", "--out", out, "--noise", "white:unknown"}, 2, "unknown");
  expectFailure({"a", "--out", out, "--width", "0"}, 2, "--width");
  expectFailure({"a", "--out", out, "--width", "99999"}, 2, "--width");
  expectFailure({"a", "--out", out, "--fx", "nan"}, 2, "fx");
  expectFailure({"a", "--out", out, "--fx", "-3"}, 2, "fx");
  expectFailure({"a", "--measure-noise", out}, 2, "--measure-noise");
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(SceneCommand, SaysWhatCannotBeReadOrWritten) {
  write("file", "x");
  expectFailure({"a", "--out", path("file")}, 4, "file");
  expectFailure({"--measure-noise", path("missing")}, 3, "missing");
  fs::create_directory(path("empty"));
  expectFailure({"--measure-noise", path("empty")}, 3, "no labelled frame");
}

TEST_F(SceneCommand, HelpsAndNamesItsVersion) {
  EXPECT_NE(outputOf({"--help"}).find("--noise"), std::string::npos);
  EXPECT_EQ(outputOf({"--version"}).rfind("epcc_scene ", 0), 0U);
}

TEST_F(SceneCommand, MeasuresRealFrames) {
  EPCC_NEED_REAL_FRAMES("realsense");
  if (kIsSanitized) GTEST_SKIP() << "simulating the noise of real frames takes a sanitizer two minutes";
  const std::string out = outputOf({"--measure-noise", realFolder("realsense")});
  EXPECT_NE(out.find("stereo-registered: 6 frames"), std::string::npos);
  EXPECT_NE(out.find("| columns, simulated |"), std::string::npos);
}

}  // namespace
}  // namespace epcc::test
