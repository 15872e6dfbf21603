// SPDX-License-Identifier: BSD-3-Clause
// Every option of epcc_segment: what it does and what it refuses.
#include "epcc_segmentation/vector_unit.h"
#include "tests/eval/segment/tool_runner.h"

namespace {

using epcc::test::SegmentToolTest;
using epcc::test::ToolResult;

class SegmentOptions : public SegmentToolTest {
 protected:
  SegmentOptions() { writeFrame("room"); }

  /// Runs on the frame with more options and expects success.
  ToolResult good(std::vector<std::string> more) const {
    more.insert(more.begin(), "room_depth.png");
    const ToolResult result = run(more);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    return result;
  }
  /// The same with an option that must be refused.
  void usage(std::vector<std::string> more, const std::string& words) const {
    more.insert(more.begin(), "room_depth.png");
    expectFailure(more, 2, words);
  }
};

TEST_F(SegmentOptions, PrintsTheTable) {
  const ToolResult result = good({});
  EXPECT_EQ(result.out.rfind("room_depth.png: 64x48, 2 planes on ", 0), 0U) << result.out;
  EXPECT_NE(result.out.find("wall-like"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("floor-like"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("noise auto (axial a="), std::string::npos) << result.out;
}

TEST_F(SegmentOptions, HelpNamesEveryOption) {
  const ToolResult help = run({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_EQ(help.err, "");
  for (const char* option : {"--camera",
                             "--fx",
                             "--fy",
                             "--cx",
                             "--cy",
                             "--depth-scale",
                             "--projection",
                             "--unit",
                             "--min-depth",
                             "--max-depth",
                             "--invalid",
                             "--distance",
                             "--mode",
                             "--noise",
                             "--scan",
                             "--line-k-max",
                             "--plane-k-max",
                             "--max-gap",
                             "--min-points",
                             "--criterion",
                             "--plane-weight",
                             "--segments ",
                             "--segments-picture",
                             "--with-segments",
                             "--threads",
                             "--labels",
                             "--planes",
                             "--overlay",
                             "--cloud",
                             "--out",
                             "--timing",
                             "--version",
                             "--help",
                             "EPCC_VECTOR_UNIT",
                             "Exit codes"}) {
    EXPECT_NE(help.out.find(option), std::string::npos) << option;
  }
}

TEST_F(SegmentOptions, VersionIsOneLine) {
  const ToolResult version = run({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(version.out.rfind("epcc_segment ", 0), 0U);
  EXPECT_EQ(version.out.find('\n') + 1, version.out.size());
}

/// Not one line for every input: none of them is to blame.
TEST_F(SegmentOptions, AVectorUnitThatTheMachineHasNotIsRefused) {
  const std::vector<std::string> arguments = {"room_depth.png", "room_depth.png", "--out", "out"};
  const auto withUnit = [&](const std::string& unit, const std::vector<std::string>& more) {
    return epcc::test::runTool("epcc_segment", more, folder(), "EPCC_VECTOR_UNIT='" + unit + "' ");
  };
  epcc::test::expectFailure(withUnit("abacus", arguments), "epcc_segment", 2,
                            "EPCC_VECTOR_UNIT is 'abacus'; this machine has " + epcc::vectorUnits().front());
  EXPECT_FALSE(exists("out"));
  EXPECT_EQ(withUnit("abacus", {"--help"}).exit_code, 0);
  const std::string table = good({}).out;
  for (const std::string& unit : epcc::vectorUnits()) {
    EXPECT_EQ(withUnit(unit, {"room_depth.png"}).out, table) << unit;
  }
}

TEST_F(SegmentOptions, NoInput) {
  expectFailure({}, 2, "INPUT");
}
TEST_F(SegmentOptions, UnknownOption) {
  usage({"--frobnicate"}, "--frobnicate");
}
TEST_F(SegmentOptions, ShortenedOption) {
  usage({"--lab", "x.png"}, "--lab");
}
TEST_F(SegmentOptions, MissingValue) {
  usage({"--labels"}, "--labels");
}
TEST_F(SegmentOptions, EmptyValue) {
  usage({"--labels", ""}, "--labels");
}

TEST_F(SegmentOptions, Mode) {
  good({"--mode", "paper"});
  good({"--mode", "inverse-depth"});
  EXPECT_EQ(good({}).out, good({"--mode", "default"}).out);
  usage({"--mode", "fast"}, "unknown mode 'fast'");
}

TEST_F(SegmentOptions, Noise) {
  EXPECT_NE(good({"--noise", "kinect-v1"}).out.find("noise kinect-v1"), std::string::npos);
  good({"--noise", "0.002,0.003,2"});
  good({"--noise=poly:0.006954,-0.003713,0.001153"});
  EXPECT_EQ(good({"--noise", "auto"}).out, good({}).out);
  usage({"--noise", "kinect-v9"}, "kinect-v9");
  usage({"--noise", "1,2"}, "1,2");
  usage({"--noise", "nan,0,1"}, "nan,0,1");
  usage({"--noise", "poly:1,2,x"}, "poly:1,2,x");
  usage({"--noise", ""}, "--noise");
}

TEST_F(SegmentOptions, NoisePresetOfTheFrame) {
  writeCamera("room.json", 64, 48, ", \"noise\": \"rendered\"");
  EXPECT_NE(good({}).out.find("noise rendered"), std::string::npos);
  EXPECT_NE(good({"--noise", "realsense"}).out.find("noise realsense"), std::string::npos);
  writeCamera("room.json", 64, 48, ", \"noise\": \"granite\"");
  expectFailure({"room_depth.png"}, 3, "noise: ");
}

TEST_F(SegmentOptions, Scan) {
  good({"--scan", "columns"});
  good({"--scan", "rows"});
  good({"--scan", "both"});
  EXPECT_EQ(good({"--mode", "paper", "--scan", "both"}).out, good({"--mode", "paper", "--scan", "columns"}).out);
  usage({"--scan", "diagonal"}, "diagonal");
}

TEST_F(SegmentOptions, SetTakesParametersOfTheModeByName) {
  good({"--set", "inverse_depth.line_k_max=1.4"});
  good({"--mode", "paper", "--set", "paper.line_k_max=2.5", "--set", "paper.criterion=c"});
  EXPECT_EQ(good({"--set", "inverse_depth.min_points=100"}).out, good({"--min-points", "100"}).out);
  usage({"--set", "inverse_depth.line_k_max=0"}, "--set: inverse_depth.line_k_max must be in (0, 100] sigma_w, not 0");
  usage({"--set", "line_k_max=1"}, "--set: there is no parameter 'line_k_max'");
  usage({"--set", "paper.line_k_max=3"}, "--set: paper.line_k_max belongs to the paper mode");
  usage({"--mode", "paper", "--set", "inverse_depth.min_points=3"},
        "--set: inverse_depth.min_points belongs to the inverse-depth mode");
  for (const char* name : {"mode", "scan", "threads"})
    usage({"--set", std::string(name) + "=paper"}, std::string(name) + " has an option of its own: --" + name);
}

TEST_F(SegmentOptions, Criterion) {
  for (const char* criterion : {"a", "b", "c", "d"}) good({"--mode", "paper", "--criterion", criterion});
  usage({"--criterion", "a"}, "--criterion belongs to the paper mode");
  usage({"--criterion", "e"}, "'e'");
  usage({"--criterion", "ab"}, "'ab'");
}

TEST_F(SegmentOptions, PlaneWeight) {
  for (const char* form : {"printed", "exponential", "gaussian", "cauchy", "huber", "none"})
    good({"--mode", "paper", "--plane-weight", form});
  EXPECT_EQ(good({"--mode", "paper"}).out, good({"--mode", "paper", "--plane-weight", "printed"}).out);
  usage({"--plane-weight", "printed"}, "--plane-weight belongs to the paper mode");
  usage({"--mode", "paper", "--plane-weight", ""}, "none, not ''");
  usage({"--mode", "paper", "--plane-weight", "linear"},
        "printed | exponential | gaussian | cauchy | huber | none, not 'linear'");
}

TEST_F(SegmentOptions, Numbers) {
  good({"--mode", "paper", "--line-k-max", "2.5", "--plane-k-max", "2", "--max-gap", "0.1", "--min-points", "5",
        "--threads", "2"});
  good({"--line-k-max", "1.4", "--plane-k-max", "2.1", "--min-points", "100"});
  usage({"--max-gap", "0.1"}, "--max-gap belongs to the paper mode");
  for (const char* mode : {"default", "paper"}) {
    for (const char* option : {"--line-k-max", "--plane-k-max", "--max-gap"}) {
      for (const char* value : {"nan", "inf", "-1", "1e999", "two", "", "1.5x"}) {
        usage({"--mode", mode, option, value}, "");
      }
    }
  }
  usage({"--line-k-max", "0"}, "k_max");
  for (const char* option : {"--min-points", "--threads"}) {
    for (const char* value : {"-1", "1.5", "many", "99999999999999999999"}) usage({option, value}, "");
  }
  usage({"--threads", "0"}, "threads");
}

TEST_F(SegmentOptions, MinPointsDropsPlanes) {
  EXPECT_NE(good({"--min-points", "3000"}).out.find(" 0 planes"), std::string::npos);
}

TEST_F(SegmentOptions, CameraFile) {
  writeDepth("alone.png");
  writeCamera("other.json");
  EXPECT_EQ(run({"alone.png", "--camera", "other.json"}).exit_code, 0);
  expectFailure({"alone.png", "--camera", "missing.json"}, 3, "missing.json: file: does not exist");
  expectFailure({"alone.png", "room_depth.png", "--camera", "missing.json"}, 3, "missing.json");
  expectFailure({"alone.png", "--noise", "missing.json"}, 3, "missing.json: file: does not exist");
}

TEST_F(SegmentOptions, CameraNumbers) {
  writeDepth("alone.png");
  const std::vector<std::string> camera = {"alone.png", "--fx", "60", "--fy", "60", "--cx", "31.5", "--cy", "23.5"};
  std::vector<std::string> scaled = camera;
  scaled.insert(scaled.end(), {"--depth-scale", "0.002"});
  EXPECT_NE(run(camera).out.find(" 2.000 "), std::string::npos);
  EXPECT_NE(run(scaled).out.find(" 4.000 "), std::string::npos);
}

TEST_F(SegmentOptions, BadCameraNumbers) {
  for (const char* bad : {"0", "-1", "nan", "inf", "-inf", "1e999", "x", ""}) {
    usage({"--fx", bad, "--fy", "60", "--cx", "32", "--cy", "24"}, "--fx");
    usage({"--fx", "60", "--fy", "60", "--cx", "32", "--cy", "24", "--depth-scale", bad}, "--depth-scale");
  }
  for (const char* bad : {"1e7", "1e308", "0.0001"})
    usage({"--fx", bad, "--fy", "60", "--cx", "32", "--cy", "24"}, "camera: fx and fy must be in [0.001, 1e6] pixels");
  usage({"--fx", "60", "--fy", "60", "--cx", "32", "--cy", "24", "--depth-scale", "1001"}, "--depth-scale: must be");
  usage({"--fx", "60", "--fy", "60", "--cx", "nan", "--cy", "24"}, "--cx");
  usage({"--fx", "60", "--fy", "60", "--cx", "32"}, "--cy");
  usage({"--depth-scale", "0.001"}, "--fx");
  usage({"--camera", "room.json", "--fx", "60", "--fy", "60", "--cx", "32", "--cy", "24"}, "--camera");
}

TEST_F(SegmentOptions, NegativePrincipalPointIsAllowed) {
  good({"--fx", "60", "--fy", "60", "--cx", "-3.5", "--cy", "-1"});
}

TEST_F(SegmentOptions, MissingCamera) {
  writeDepth("alone.png");
  expectFailure({"alone.png"}, 2, "alone.png: camera: ");
}

TEST_F(SegmentOptions, ThreadsGiveTheSameLabels) {
  good({"--labels", "one.png"});
  good({"--labels", "four.png", "--threads", "4"});
  EXPECT_EQ(read("one.png"), read("four.png"));
}

TEST_F(SegmentOptions, Timing) {
  const std::string out = good({"--timing"}).out;
  EXPECT_NE(out.find("  time: reading "), std::string::npos);
  EXPECT_NE(out.find(" ms, sensor "), std::string::npos);
  EXPECT_EQ(good({}).out.find("  time: reading "), std::string::npos);
}

}  // namespace
