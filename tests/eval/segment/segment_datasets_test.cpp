// SPDX-License-Identifier: BSD-3-Clause
// Data sets as inputs of epcc_segment: every format that epcc_eval opens, and folders of unlabelled clouds.
#include "datasets/files/png_io.h"
#include "tests/datasets/files/segcomp_files.h"
#include "tests/eval/segment/tool_runner.h"

namespace {

using epcc::test::SegmentToolTest;
using epcc::test::ToolResult;

class SegmentDatasets : public SegmentToolTest {
 protected:
  /// The input has these frames, in this order, each with two planes.
  void expectFrames(const std::string& input, const std::vector<std::string>& files, const std::string& words = "") {
    const ToolResult result = run({input, "--out", "out"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    std::size_t at = 0;
    for (const std::string& file : files) {
      at = result.out.find(file + ": ", at);
      ASSERT_NE(at, std::string::npos) << file << " in " << result.out;
      EXPECT_NE(result.out.substr(at, result.out.find('\n', at) - at).find(words), std::string::npos) << result.out;
    }
    EXPECT_EQ(names("out").size(), 4 * files.size());
  }
  /// A wall at 1 m, 640x480, in units of 0.2 mm.
  void writeTumDepth(const std::string& name) const {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    epcc::writeGray16(path(name), epcc::Image<std::uint16_t>(640, 480, 5000));
  }
};

TEST_F(SegmentDatasets, NativeFramesInTheOrderOfTheirNumbers) {
  for (const char* name : {"set/f10", "set/f2", "set/f1"}) writeFrame(name);
  const std::vector<std::string> files = {"set/f1_depth.png", "set/f2_depth.png", "set/f10_depth.png"};
  expectFrames("set", files, "64x48, 2 planes");
  expectFrames("native:set", files, "64x48, 2 planes");
}

TEST_F(SegmentDatasets, UnlabelledClouds) {
  writeCloud("clouds/b.pcd");
  writeCloud("clouds/a.PCD");
  expectFrames("clouds", {"clouds/a.PCD", "clouds/b.pcd"}, "64x48, 2 planes");
  ASSERT_EQ(run({"clouds/b.pcd", "--labels", "single.png"}).exit_code, 0);
  EXPECT_EQ(read("single.png"), read("out/b_labels.png"));
}

TEST_F(SegmentDatasets, TumWithItsListAndItsCamera) {
  writeTumDepth("rgbd_dataset_freiburg3_x/depth/2.5.png");
  writeTumDepth("rgbd_dataset_freiburg3_x/depth/1.5.png");
  write("rgbd_dataset_freiburg3_x/depth.txt", "2.5 depth/2.5.png\n1.5 depth/1.5.png\n");
  const std::string depth = "rgbd_dataset_freiburg3_x/depth/";
  expectFrames("rgbd_dataset_freiburg3_x", {depth + "2.5.png", depth + "1.5.png"}, "640x480, 1 plane on 100.0 %");
}

TEST_F(SegmentDatasets, IclByItsFormat) {
  writeTumDepth("any/depth/0.png");
  expectFrames("icl:any", {"any/depth/0.png"}, "noise rendered");
}

TEST_F(SegmentDatasets, Scannet) {
  writeDepth("scene/depth/0.png");
  write("scene/intrinsic/intrinsic_depth.txt", "60 0 31.5 0\n0 60 23.5 0\n0 0 1 0\n0 0 0 1\n");
  expectFrames("scene", {"scene/depth/0.png"}, "64x48, 2 planes on");
}

TEST_F(SegmentDatasets, Abw) {
  write("abw/abw.test.3.range", epcc::test::sunRaster([](int row, int) { return row < 3 ? 0 : 100; }));
  expectFrames("abw", {"abw/abw.test.3.range"}, "512x512, 1 plane on 100.0 %");
}

TEST_F(SegmentDatasets, LabelledClouds) {
  writeCloud("room.pcd");
  ASSERT_EQ(run({"room.pcd", "--cloud", "labelled/room.pcd"}).exit_code, 4) << "the folder is missing";
  std::filesystem::create_directory(path("labelled"));
  ASSERT_EQ(run({"room.pcd", "--cloud", "labelled/room.pcd"}).exit_code, 0);
  expectFrames("labelled", {"labelled/room.pcd"}, "64x48, 2 planes");
}

TEST_F(SegmentDatasets, FilesMayHaveTheirExtensionInCapitals) {
  writeDepth("room_depth.PNG");
  writeCamera("room.json");
  writeCloud("cloud.PCD");
  for (const char* input : {"room_depth.PNG", "cloud.PCD"})
    EXPECT_NE(run({input}).out.find("64x48, 2 planes"), std::string::npos) << input;
  ASSERT_EQ(run({"room_depth.PNG", "cloud.PCD", "--out", "out"}).exit_code, 0);
  EXPECT_TRUE(exists("out/room_labels.png"));
  EXPECT_TRUE(exists("out/cloud_labels.png"));
}

TEST_F(SegmentDatasets, FramesOfAFolderComeOutAsTheyDoAlone) {
  for (const char* name : {"set/a", "set/b"}) writeFrame(name);
  writeCamera("set/b.json", 64, 48, ", \"noise\": \"rendered\"");
  ASSERT_EQ(run({"set", "--out", "out"}).exit_code, 0);
  for (const std::string name : {"a", "b"}) {
    ASSERT_EQ(run({"set/" + name + "_depth.png", "--labels", "single.png"}).exit_code, 0);
    EXPECT_EQ(read("single.png"), read("out/" + name + "_labels.png"));
  }
}

TEST_F(SegmentDatasets, CameraOfTheCommandLineGoesBeforeThatOfNativeFrames) {
  writeDepth("set/a_depth.png");
  expectFailure({"set"}, 3, "a.json: file: does not exist");
  const ToolResult result = run({"set", "--fx", "60", "--fy", "60", "--cx", "31.5", "--cy", "23.5"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("64x48, 2 planes"), std::string::npos) << result.out;
}

TEST_F(SegmentDatasets, CameraForADataSetThatHasItsOwnIsMisuse) {
  writeCloud("clouds/a.pcd");
  for (const char* input : {"clouds", "pcd:clouds"})
    expectFailure({input, "--fx", "60", "--fy", "60", "--cx", "31.5", "--cy", "23.5"}, 2,
                  "camera: comes with the data set");
}

TEST_F(SegmentDatasets, UnusableOnesDoNotKeepTheOthersBack) {
  writeFrame("room");
  for (const char* input : {"nothing:room", "abw:.", "tum-fr1:none"}) {
    const ToolResult result = run({input, "room_depth.png"});
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_EQ(result.err.rfind("epcc_segment: ", 0), 0U) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_NE(result.out.find("64x48, 2 planes"), std::string::npos) << result.out;
  }
}

TEST_F(SegmentDatasets, TruthAndInputsAreNotOverwritten) {
  writeCloud("clouds/a.pcd");
  writeCloud("clouds/a_cloud.pcd");
  expectFailure({"clouds", "--out", "clouds"}, 2, "overwrite");
  writeFrame("set/a");
  expectFailure({"set", "--out", "set"}, 2, "ground truth");
}

}  // namespace
