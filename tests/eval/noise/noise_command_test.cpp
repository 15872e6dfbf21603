// SPDX-License-Identifier: BSD-3-Clause
// epcc_noise: the error of rendered frames is found and written, other programs take it, and every wrong command line.
#include "eval/noise/noise_command.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "datasets/noise/sensor_noise.h"
#include "datasets/rendered/scene.h"
#include "eval/program/frame_sensor.h"
#include "tests/support/expect_errors.h"
#include "tests/support/run_tool.h"
#include "tests/support/swapped_bytes.h"

namespace epcc::test {
namespace {

ToolResult run(const std::vector<std::string>& arguments) {
  return callTool(noiseMain, "epcc_noise", arguments);
}

class NoiseCommand : public TempFolderTest {
 protected:
  /// Frames of scene c with an error, in a folder of this name.
  void render(const std::string& folder, const std::string& noise, int frames) {
    std::filesystem::create_directory(path(folder));
    for (int seed = 0; seed < frames; ++seed) {
      LabelledFrame frame = renderScene("c", static_cast<std::uint64_t>(seed));
      applyNoise(frame, parseNoise(noise).value(), static_cast<std::uint64_t>(seed));
      writeLabelledFrame(path(folder), frame);
    }
  }
};

TEST_F(NoiseCommand, FindsWhiteErrorAndWritesIt) {
  render("f", "white:0.008,0.002,1", 3);
  const ToolResult result = run({path("f"), "--out", path("camera")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out.rfind("3 frames, ", 0), 0U) << result.out;
  const auto json = nlohmann::json::parse(read("camera.json"));
  const SensorModel truth = SensorModel::axial(0.008, 0.002), found = *SensorModel::parse(json["noise"]);
  for (const double z : {1.5, 3.0}) EXPECT_NEAR(found.sigmaZ(z) / truth.sigmaZ(z), 1.0, 0.25) << z;
  EXPECT_EQ(json["frames"], 3);
  EXPECT_NEAR(json["effective_length"], 0.4, 0.05);
  EXPECT_NEAR(json["L"], 1.0, 0.3);
  EXPECT_LT(json["share"], 0.05);
  EXPECT_LT(json["correlated_share"], 1.0);
  EXPECT_NEAR(found.correlatedShare(), json["correlated_share"], 1e-8);
  EXPECT_GT(json["blocks"], 100);
  EXPECT_GT(json["bins"].size(), 2U);
  for (const char* curve : {"measured", "fit"}) {
    const std::vector<double> correlation = json["autocorrelation"][curve];
    ASSERT_EQ(correlation.size(), 17U);
    EXPECT_DOUBLE_EQ(correlation[0], 1.0);
    for (std::size_t lag = 1; lag < 17; ++lag) EXPECT_LT(std::abs(correlation[lag]), 0.06) << curve << ", " << lag;
  }
  EXPECT_EQ(read("camera.png").substr(1, 3), "PNG");
}

TEST_F(NoiseCommand, TheFitOfTheAutocorrelationIsThatOfBlotches) {
  render("f", "stereo", 3);
  ASSERT_EQ(run({path("f"), "--out", path("camera")}).exit_code, 0);
  const auto json = nlohmann::json::parse(read("camera.json"));
  EXPECT_GT(json["blotch_length"], 3.0);
  EXPECT_GT(json["share"], 0.7);
  const std::vector<double> measured = json["autocorrelation"]["measured"], fit = json["autocorrelation"]["fit"];
  for (std::size_t lag = 0; lag < 9; ++lag) EXPECT_NEAR(measured[lag], fit[lag], 0.2) << lag;
}

TEST_F(NoiseCommand, ItsFileIsASensorModelForTheOtherPrograms) {
  render("f", "white:0.008,0.002,1", 1);
  ASSERT_EQ(run({path("f"), "--out", path("camera")}).exit_code, 0);
  const std::string file = path("camera.json");
  EXPECT_EQ(noiseProblem(file), "");
  const LabelledFrame frame = readLabelledFrame(path("f"), "c_000");
  const FrameSensor sensor = frameSensor(file, frame.camera.noise, frameView(frame), "c_000.json");
  const auto json = nlohmann::json::parse(read("camera.json"));
  EXPECT_NEAR(sensor.model.sigmaZ(2.0), SensorModel::parse(json["noise"])->sigmaZ(2.0), 1e-9);
  EXPECT_EQ(sensor.name, file);
}

TEST_F(NoiseCommand, NoiseFilesThatAreNoneAreToldOf) {
  const auto problemOf = [this](const std::string& text) {
    std::ofstream(path("x.json")) << text;
    return noiseProblem(path("x.json"));
  };
  const auto fails = [&](const std::string& text, const std::string& words) {
    expectInputError([&] { problemOf(text); }, path("x.json"), "noise", words);
  };
  expectInputError([&] { noiseProblem(path("none.json")); }, path("none.json"), "file", "does not exist");
  fails("{}", "is missing");
  fails(R"({"noise": 3})", "is not a text");
  fails(R"({"noise": "1,2"})", "of finite numbers");
  fails(R"({"noise": "auto"})", "");
  EXPECT_EQ(problemOf(R"({"noise": "realsense"})"), "");
}

TEST_F(NoiseCommand, TakesTheOptionsThatSayWhatTheNumbersOfAnInputAre) {
  render("f", "white:0.008,0.002,1", 1);
  const auto farthest = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {path("f"), "--out", path("camera")});
    const ToolResult result = run(more);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return nlohmann::json::parse(read("camera.json"))["bins"].back()["depth_m"].get<double>();
  };
  const double plain = farthest({"--unit", "mm"});
  EXPECT_NEAR(farthest({"--unit", "cm"}) / plain, 10.0, 0.5);
  EXPECT_LE(farthest({"--min-depth", "0.1", "--max-depth", "2"}), 2.0);
  EXPECT_LT(farthest({"--distance"}), plain);
  farthest({"--invalid", "0"});
  const auto fails = [&](std::vector<std::string> more, const std::string& words) {
    more.insert(more.begin(), {path("f"), "--out", path("x")});
    expectFailure(run(more), "epcc_noise", 2, words);
  };
  fails({"--min-depth", "3", "--max-depth", "2"}, "--min-depth is not less than --max-depth");
  fails({"--unit", "km"}, "--unit");
  fails({"--projection", "scanner"}, "--projection is for clouds");
  fails({"--fx", "60", "--fy", "60", "--cx", "32", "--cy", "24", "--depth-scale", "1", "--unit", "m"}, "--depth-scale");
}

TEST_F(NoiseCommand, AFrameThatDoesNotFitIsToldOfAndLeftOut) {
  render("f", "white:0.008,0.002,1", 1);
  LabelledFrame small;
  small.name = "d";
  small.camera.camera = {64, 48, 60.0, 60.0, 32.0, 24.0};
  small.depth = DepthImage(64, 48, 1.0F);
  writeLabelledFrame(path("f"), small);
  const ToolResult result = run({path("f"), "--out", path("camera")});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.out.rfind("1 frame, ", 0), 0U) << result.out;
  EXPECT_NE(result.err.find("d_depth.png: size: is not that of the frames before it"), std::string::npos) << result.err;
  EXPECT_FALSE(read("camera.json").empty());
}

TEST_F(NoiseCommand, SaysWhatIsDoubtful) {
  render("f", "white:0.008,0.002,1", 1);
  ASSERT_EQ(run({path("f"), "--out", path("camera")}).err, "");
  swapBytesOf(path("f/c_000_depth.png"));
  const ToolResult result = run({path("f"), "--out", path("camera")});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.err.find("epcc_noise: 1 frame is doubtful; "), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("_depth.png: depth: the two bytes"), std::string::npos) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
}

TEST_F(NoiseCommand, SaysWhatIsWrong) {
  render("f", "none", 1);
  const auto fails = [](const std::vector<std::string>& arguments, int code, const std::string& words) {
    expectFailure(run(arguments), "epcc_noise", code, words);
  };
  fails({path("f")}, 2, "--out");
  fails({"--out", path("x")}, 2, "INPUT");
  fails({"--ouput", path("x")}, 2, "--ouput");
  fails({"", "--out", path("x")}, 2, "INPUT: the name is empty");
  fails({path("f"), "--out", ""}, 2, "--out");
  fails({path("f"), "--out", path("f/")}, 2, "names no file");
  fails({path("f"), "--out", path("x.json")}, 2, "the name without .json");
  fails({path("f"), "--out", path("x"), "--fx", "3"}, 2, "come together");
  fails({path("f"), "--out", path("f/c_000")}, 2, "would overwrite an input");
  render("other", "none", 1);
  fails({path("f"), "--out", path("other/c_000")}, 2, "is a camera file");
  fails({path("nothing.png"), "--out", path("x")}, 3, "does not exist");
  fails({path("f"), "--out", path("x"), "--camera", path("no.json")}, 3, "no.json: file: does not exist");
  fails({path("f"), "--out", path("x"), "--camera", ""}, 2, "--camera");
  fails({path("f"), "--out", path("no/folder/x")}, 4, "no/folder/x.json");
  LabelledFrame empty;
  empty.name = "e";
  empty.camera.camera = {64, 48, 60.0, 60.0, 32.0, 24.0};
  empty.depth = DepthImage(64, 48, 0.0F);
  std::filesystem::create_directory(path("g"));
  writeLabelledFrame(path("g"), empty);
  fails({path("g"), "--out", path("x")}, 3, "no smooth surface");
}

}  // namespace
}  // namespace epcc::test
