// SPDX-License-Identifier: BSD-3-Clause
// The files epcc_segment writes, for one input and for many.
#include <sys/stat.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "datasets/files/organized_pcd.h"
#include "datasets/files/png_io.h"
#include "tests/eval/segment/tool_runner.h"

namespace {

using epcc::test::SegmentToolTest;
using epcc::test::ToolResult;

class SegmentOutput : public SegmentToolTest {
 protected:
  SegmentOutput() { writeFrame("room"); }
  using Names = std::vector<std::string>;
};

TEST_F(SegmentOutput, WritesAllFour) {
  const ToolResult result =
      run({"room_depth.png", "--labels", "l.png", "--planes", "p.json", "--overlay", "o.png", "--cloud", "c.pcd"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const epcc::LabelImage labels = epcc::readGray16(path("l.png"));
  EXPECT_EQ(labels.width, 64);
  EXPECT_EQ(labels.height, 48);
  EXPECT_EQ(*std::max_element(labels.data.begin(), labels.data.end()), 2);
  const auto planes = nlohmann::json::parse(read("p.json"));
  EXPECT_EQ(planes.at("planes").size(), 2U);
  EXPECT_EQ(read("o.png").substr(1, 3), "PNG");
  const epcc::OrganizedCloud cloud = epcc::readOrganizedPcd(path("c.pcd"), "label");
  EXPECT_EQ(cloud.width, 64);
  EXPECT_EQ(cloud.height, 48);
}

TEST_F(SegmentOutput, SegmentsOfBothModes) {
  for (const char* mode : {"paper", "default"}) {
    const ToolResult result =
        run({"room_depth.png", "--mode", mode, "--segments", "s.csv", "--segments-picture", "s.png"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::string csv = read("s.csv");
    EXPECT_EQ(csv.rfind("scan,line,first_px,", 0), 0U) << csv.substr(0, 100);
    EXPECT_GE(std::count(csv.begin(), csv.end(), '\n'), 1 + 64) << mode;  // a segment a column at the least
    EXPECT_EQ(csv.find("\nrow,") != std::string::npos, mode == std::string("default"));
    EXPECT_EQ(read("s.png").substr(1, 3), "PNG");
  }
}

TEST_F(SegmentOutput, FolderWithSegments) {
  EXPECT_EQ(run({"room_depth.png", "--out", "out", "--with-segments"}).exit_code, 0);
  EXPECT_EQ(names("out"), (Names{"room_cloud.pcd", "room_labels.png", "room_overlay.png", "room_planes.json",
                                 "room_segments.csv", "room_segments.png"}));
  expectFailure({"room_depth.png", "--with-segments"}, 2, "--out");
}

#ifdef EPCC_WITH_GEOS
TEST_F(SegmentOutput, MeshAndPolygons) {
  const ToolResult result = run({"room_depth.png", "--mesh", "m.ply", "--polygons", "p.json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto list = nlohmann::json::parse(read("p.json"));
  EXPECT_EQ(list.at("version"), 1);
  ASSERT_EQ(list.at("surfaces").size(), 2U);
  EXPECT_GE(list.at("surfaces")[0].at("pieces")[0].at("outline").at("points").size(), 3U);
  ASSERT_EQ(list.at("edges").size(), 1U);
  EXPECT_EQ(list.at("edges")[0].at("planes"), (std::vector<int>{1, 2}));
  EXPECT_NEAR(list.at("edges")[0].at("angle").get<double>(), M_PI_2, 0.01);
  EXPECT_EQ(list.at("edges")[0].at("convex"), false);
  for (const auto& surface : list.at("surfaces")) EXPECT_GT(surface.at("area").get<double>(), 0.5);

  // Every face of the binary file is a triangle of its vertices.
  const std::string ply = read("m.ply");
  const auto count = [&ply](const std::string& element) {
    return std::stoul(ply.substr(ply.find("element " + element + ' ') + element.size() + 9));
  };
  const std::size_t begin = ply.find("end_header\n") + 11;
  EXPECT_EQ(ply.substr(0, 36), "ply\nformat binary_little_endian 1.0\n");
  ASSERT_EQ(ply.size(), begin + 12 * count("vertex") + 20 * count("face"));
  for (std::size_t face = 0; face < count("face"); ++face) {
    const char* bytes = &ply[begin + 12 * count("vertex") + 20 * face];
    EXPECT_EQ(bytes[0], 3);
    for (int k = 0; k < 3; ++k) {
      std::int32_t corner;
      std::memcpy(&corner, bytes + 1 + 4 * k, 4);
      EXPECT_LT(static_cast<std::size_t>(corner), count("vertex"));
    }
    std::int32_t label;
    std::memcpy(&label, bytes + 16, 4);
    EXPECT_TRUE(label == 1 || label == 2);
  }

  // The same as text and as OBJ.
  ASSERT_EQ(run({"room_depth.png", "--mesh", "t.ply", "--mesh-text"}).exit_code, 0);
  const std::string text = read("t.ply");
  EXPECT_EQ(text.substr(0, 21), "ply\nformat ascii 1.0\n");
  EXPECT_EQ(
      static_cast<std::size_t>(std::count(text.begin() + static_cast<long>(text.find("end_header")), text.end(), '\n')),
      1 + count("vertex") + count("face"));
  ASSERT_EQ(run({"room_depth.png", "--mesh", "m.obj"}).exit_code, 0);
  const std::string obj = read("m.obj");
  std::size_t vertices = 0, faces = 0;
  for (std::size_t at = obj.find('\n'); at != std::string::npos; at = obj.find('\n', at + 1)) {
    vertices += obj.compare(at + 1, 2, "v ") == 0 ? 1 : 0;
    faces += obj.compare(at + 1, 2, "f ") == 0 ? 1 : 0;
  }
  EXPECT_EQ(vertices, count("vertex"));
  EXPECT_EQ(faces, count("face"));
  EXPECT_NE(obj.find("g plane_2\n"), std::string::npos);
}

TEST_F(SegmentOutput, FolderWithSurfaces) {
  EXPECT_EQ(run({"room_depth.png", "--out", "out", "--with-surfaces"}).exit_code, 0);
  EXPECT_EQ(names("out"), (Names{"room_cloud.pcd", "room_labels.png", "room_mesh.ply", "room_overlay.png",
                                 "room_planes.json", "room_polygons.json"}));
  expectFailure({"room_depth.png", "--with-surfaces"}, 2, "--out");
  expectFailure({"room_depth.png", "--mesh-text"}, 2, "--mesh-text requires --mesh");
  expectFailure({"room_depth.png", "--mesh", "mesh.stl"}, 2, "ends neither in .ply nor in .obj");
  expectFailure({"room_depth.png", "--mesh", "a.ply", "--polygons", "a.ply"}, 2, "twice");
  expectFailure({"room_depth.png", "--mesh", "nowhere/a.ply"}, 4, "nowhere");
}
#endif

TEST_F(SegmentOutput, CloudAndDepthImageAgree) {
  writeCloud("room.pcd");
  ASSERT_EQ(run({"room_depth.png", "--labels", "depth.png"}).exit_code, 0);
  const ToolResult result = run({"room.pcd", "--labels", "cloud.png"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const epcc::LabelImage a = epcc::readGray16(path("depth.png"));
  const epcc::LabelImage b = epcc::readGray16(path("cloud.png"));
  long same = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i) same += a.data[i] == b.data[i] ? 1 : 0;
  EXPECT_GT(same, 64 * 48 * 95 / 100);
}

TEST_F(SegmentOutput, CloudThatLooksAlongMinusZIsTurned) {
  writeCloud("room.pcd");
  writeCloud("turned.pcd", true);
  ASSERT_EQ(run({"room.pcd", "--labels", "a.png"}).exit_code, 0);
  const ToolResult turned = run({"turned.pcd", "--labels", "b.png"});
  ASSERT_EQ(turned.exit_code, 0) << turned.err;
  EXPECT_NE(turned.out.find("floor-like"), std::string::npos) << turned.out;
  EXPECT_EQ(read("a.png"), read("b.png"));
}

TEST_F(SegmentOutput, OwnCloudIsAnInput) {
  ASSERT_EQ(run({"room_depth.png", "--cloud", "c.pcd", "--labels", "first.png"}).exit_code, 0);
  ASSERT_EQ(run({"c.pcd", "--labels", "second.png"}).exit_code, 0);
  EXPECT_EQ(epcc::readGray16(path("first.png")).width, epcc::readGray16(path("second.png")).width);
}

TEST_F(SegmentOutput, SeveralInputsIntoOneFolder) {
  writeFrame("sub/other");
  writeCloud("sub/cloud.pcd");
  const ToolResult result = run({"room_depth.png", "sub/other_depth.png", "sub/cloud.pcd", "--out", "deep/out"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  Names expected;
  for (const char* name : {"cloud", "other", "room"}) {
    for (const char* kind : {"_cloud.pcd", "_labels.png", "_overlay.png", "_planes.json"}) {
      expected.push_back(std::string(name) + kind);
    }
  }
  EXPECT_EQ(names("deep/out"), expected);
}

TEST_F(SegmentOutput, FolderWithABadFrame) {
  writeFrame("set/a");
  writeFrame("set/b");
  writeFrame("set/c");
  write("set/b_depth.png", "no picture");
  const ToolResult result = run({"set", "--out", "out"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.err.find("b_depth.png: "), std::string::npos) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_EQ(names("out").size(), 8U);
  EXPECT_FALSE(exists("out/b_labels.png"));
  EXPECT_NE(result.out.find("set/a_depth.png: "), std::string::npos);
  EXPECT_NE(result.out.find("set/c_depth.png: "), std::string::npos);
}

TEST_F(SegmentOutput, FolderWithAFrameWithoutCamera) {
  writeFrame("set/a");
  writeDepth("set/b_depth.png");
  const ToolResult result = run({"set", "--out", "out"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(names("out").size(), 4U);
}

TEST_F(SegmentOutput, SeveralInputsWithoutOutputs) {
  writeFrame("other");
  EXPECT_EQ(run({"room_depth.png", "other_depth.png"}).exit_code, 0);
}

TEST_F(SegmentOutput, SingleFileOutputsNeedASingleInput) {
  writeFrame("set/a");
  for (const char* option : {"--labels", "--planes", "--overlay", "--cloud", "--segments", "--segments-picture"}) {
    expectFailure({"room_depth.png", "set/a_depth.png", option, "x"}, 2, "single input");
    expectFailure({"set", option, "x"}, 2, "single input");
    expectFailure({"room_depth.png", "--out", "out", option, "x"}, 2, "--out");
  }
  EXPECT_FALSE(exists("x"));
  EXPECT_FALSE(exists("out"));
}

TEST_F(SegmentOutput, NeverOverwritesInputs) {
  const std::string depth = read("room_depth.png");
  const std::string camera = read("room.json");
  expectFailure({"room_depth.png", "--labels", "room_depth.png"}, 2, "overwrite");
  expectFailure({"room_depth.png", "--planes", "./room.json"}, 2, "overwrite");
  expectFailure({"room_depth.png", "--labels", "x.png", "--overlay", "x.png"}, 2, "twice");
  expectFailure({"room_depth.png", "--out", "."}, 2, "ground truth");
  EXPECT_EQ(read("room_depth.png"), depth);
  EXPECT_EQ(read("room.json"), camera);
  EXPECT_EQ(names(), (Names{"room.json", "room_depth.png"}));
}

TEST_F(SegmentOutput, NeverOverwritesTheTruthOfAFrame) {
  write("room_labels.png", "the truth");
  for (const char* option : {"--labels", "--planes", "--overlay", "--cloud", "--segments", "--segments-picture"})
    expectFailure({"room_depth.png", option, "room_labels.png"}, 2, "ground truth");
  EXPECT_EQ(read("room_labels.png"), "the truth");
}

// A folder of the same frames, or of links to them, has their truth.
TEST_F(SegmentOutput, NeverWritesLabelsBesideAFrameOfThatName) {
  writeFrame("copy/room");
  write("copy/room_labels.png", "the truth");
  expectFailure({"room_depth.png", "--out", "copy"}, 2, "copy has room_depth.png: labels beside it");
  writeFrame("scans/room");
  std::filesystem::remove(path("scans/room_depth.png"));
  writeCloud("scans/room.pcd");
  expectFailure({"room_depth.png", "--out", "scans"}, 2, "scans has room.pcd: labels beside it");
  EXPECT_EQ(read("copy/room_labels.png"), "the truth");
  EXPECT_EQ(names("scans"), (Names{"room.json", "room.pcd"}));
}

TEST_F(SegmentOutput, NeverOverwritesTheSensorModel) {
  const std::string model = R"({"noise": "0.01,0,1"})";
  for (const char* file : {"noise.json", "out/room_planes.json"}) write(file, model);
  expectFailure({"room_depth.png", "--noise", "noise.json", "--planes", "./noise.json"}, 2, "the file of --noise");
  expectFailure({"room_depth.png", "--noise", "out/room_planes.json", "--out", "out"}, 2, "the file of --noise");
  EXPECT_EQ(read("noise.json") + read("out/room_planes.json"), model + model);
}

TEST_F(SegmentOutput, InputsOfTheSameNameClash) {
  writeFrame("a/room");
  expectFailure({"room_depth.png", "a/room_depth.png", "--out", "out"}, 2, "twice");
  EXPECT_FALSE(exists("out"));
}

TEST_F(SegmentOutput, OutputThatCannotBeWritten) {
  for (const char* option : {"--labels", "--planes", "--overlay", "--cloud", "--segments", "--segments-picture"}) {
    expectFailure({"room_depth.png", option, "missing/x"}, 4, "missing/x: ");
  }
  write("file", "kept");
  expectFailure({"room_depth.png", "--out", "file"}, 4, "file: ");
  expectFailure({"room_depth.png", "--out", "file/below"}, 4, "file/below: ");
  EXPECT_EQ(read("file"), "kept");
  EXPECT_EQ(names(), (Names{"file", "room.json", "room_depth.png"}));
}

// A pipe stands for every special file: renaming onto /dev/null as root would replace the device.
TEST_F(SegmentOutput, OutputThatIsADeviceOrPipe) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  for (const char* option : {"--labels", "--planes", "--overlay", "--cloud", "--segments", "--segments-picture"}) {
    expectFailure({"room_depth.png", option, "pipe"}, 4, "pipe: file: is not a regular file");
    EXPECT_TRUE(std::filesystem::is_fifo(path("pipe")));
  }
}

// As /dev/stdout is, which would be a file afterwards, and the one it stood for gone.
TEST_F(SegmentOutput, OutputThatIsALinkToAStream) {
  std::filesystem::create_symlink("/proc/self/fd/1", path("stream"));
  for (const char* option : {"--labels", "--planes", "--overlay", "--cloud", "--segments", "--segments-picture"}) {
    const ToolResult result = epcc::test::runTool("epcc_segment", {"room_depth.png", option, "stream"}, folder());
    epcc::test::expectFailure(result, "epcc_segment", 4, "stream: file: is a symbolic link");
    EXPECT_TRUE(std::filesystem::is_symlink(path("stream")));
  }
}

TEST_F(SegmentOutput, OutputThatIsAFolder) {
  std::filesystem::create_directory(path("folder"));
  expectFailure({"room_depth.png", "--labels", "folder"}, 4, "folder: ");
  EXPECT_TRUE(names("folder").empty());
}

}  // namespace
