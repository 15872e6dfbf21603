// SPDX-License-Identifier: BSD-3-Clause
// Damaged and absurd inputs: one clear line, exit code 3, and no output file.
#include <cstdint>
#include <random>

#include "datasets/files/png_io.h"
#include "tests/eval/segment/tool_runner.h"

namespace {

using epcc::test::SegmentToolTest;

class SegmentBadInput : public SegmentToolTest {
 protected:
  /// Exit code 3, one line naming the file, and nothing written.
  void unusable(const std::string& input, const std::string& words = "") const {
    const std::vector<std::string> before = names();
    expectFailure({input, "--labels", "l.png", "--planes", "p.json", "--overlay", "o.png", "--cloud", "c.pcd"}, 3,
                  input + ": " + words);
    EXPECT_EQ(names(), before);
  }

  std::string pcdHeader(const std::string& size, const std::string& data = "ascii") const {
    return "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n" + size + "\nDATA " + data + "\n";
  }
};

TEST_F(SegmentBadInput, MissingFile) {
  unusable("nowhere.png", "file: does not exist");
  unusable("nowhere.pcd", "file: does not exist");
  unusable("nowhere", "file: does not exist");
}

TEST_F(SegmentBadInput, StandardInput) {
  unusable("-", "standard input");
}

TEST_F(SegmentBadInput, UnknownKind) {
  write("notes.txt", "text");
  unusable("notes.txt", "name: ");
}

TEST_F(SegmentBadInput, EmptyFolder) {
  std::filesystem::create_directory(path("none"));
  expectFailure({"none", "--out", "out"}, 3, "none: folder: ");
}

TEST_F(SegmentBadInput, EmptyFiles) {
  writeFrame("room");
  write("room_depth.png", "");
  write("cloud.pcd", "");
  unusable("room_depth.png");
  unusable("cloud.pcd");
}

TEST_F(SegmentBadInput, TruncatedPng) {
  writeFrame("room");
  const std::string whole = read("room_depth.png");
  for (const std::size_t size : {4UL, 20UL, 40UL, whole.size() / 2, whole.size() - 13}) {
    write("room_depth.png", whole.substr(0, size));
    unusable("room_depth.png");
  }
}

TEST_F(SegmentBadInput, NotAPng) {
  writeFrame("room");
  write("room_depth.png", std::string(500, 'x'));
  unusable("room_depth.png");
}

TEST_F(SegmentBadInput, EightBitPng) {
  writeFrame("room");
  patchPngHeader("room_depth.png", 24, 8, 1);
  unusable("room_depth.png");
}

TEST_F(SegmentBadInput, ColourPng) {
  writeFrame("room");
  ASSERT_EQ(run({"room_depth.png", "--overlay", "colour_depth.png"}).exit_code, 0);
  writeCamera("colour.json");
  unusable("colour_depth.png");
}

TEST_F(SegmentBadInput, AbsurdPngSize) {
  writeFrame("room");
  patchPngHeader("room_depth.png", 16, 0x7FFFFFFFU, 4);
  unusable("room_depth.png");
  patchPngHeader("room_depth.png", 20, 0x7FFFFFFFU, 4);
  unusable("room_depth.png");
  patchPngHeader("room_depth.png", 16, 0, 4);
  unusable("room_depth.png");
}

TEST_F(SegmentBadInput, SizeAgainstTheCamera) {
  writeFrame("room");
  writeCamera("room.json", 32, 48);
  expectFailure({"room_depth.png", "--labels", "l.png"}, 3, "epcc_segment: room");
  EXPECT_FALSE(exists("l.png"));
}

TEST_F(SegmentBadInput, BadCameraFile) {
  writeFrame("room");
  for (const char* text :
       {"", "{", "[]", "{}", "{\"width\": 64}", "null", "\"text\"",
        "{\"width\":64,\"height\":48,\"fx\":0,\"fy\":60,\"cx\":31,\"cy\":23,\"depth_scale\":0.001}",
        "{\"width\":64,\"height\":48,\"fx\":\"a\",\"fy\":60,\"cx\":31,\"cy\":23,\"depth_scale\":0.001}",
        "{\"width\":64,\"height\":48,\"fx\":60,\"fy\":60,\"cx\":31,\"cy\":23,\"depth_scale\":-1}"}) {
    write("room.json", text);
    expectFailure({"room_depth.png", "--labels", "l.png"}, 3, "room.json: ");
    EXPECT_FALSE(exists("l.png")) << text;
  }
}

TEST_F(SegmentBadInput, UnorganizedCloud) {
  write("line.pcd", pcdHeader("WIDTH 3\nHEIGHT 1\nPOINTS 3") + "0 0 1\n1 0 1\n2 0 1\n");
  unusable("line.pcd");
}

TEST_F(SegmentBadInput, AbsurdClouds) {
  for (const char* size : {"WIDTH 65536\nHEIGHT 65536\nPOINTS 0", "WIDTH 100000\nHEIGHT 100000\nPOINTS 10000000000",
                           "WIDTH -4\nHEIGHT 4\nPOINTS -16", "WIDTH 4\nHEIGHT 4\nPOINTS 17",
                           "WIDTH 0\nHEIGHT 0\nPOINTS 0", "WIDTH x\nHEIGHT 2\nPOINTS 2"}) {
    write("cloud.pcd", pcdHeader(size) + "0 0 1\n");
    unusable("cloud.pcd");
  }
}

TEST_F(SegmentBadInput, TruncatedCloud) {
  writeCloud("cloud.pcd");
  const std::string whole = read("cloud.pcd");
  for (const std::size_t size : {10UL, 100UL, whole.size() / 2}) {
    write("cloud.pcd", whole.substr(0, size));
    unusable("cloud.pcd");
  }
}

TEST_F(SegmentBadInput, CloudWithWordsForNumbers) {
  write("cloud.pcd", pcdHeader("WIDTH 2\nHEIGHT 2\nPOINTS 4") + "0 0 1\nabc 0 1\n0 1 1\n1 1 1\n");
  unusable("cloud.pcd");
}

TEST_F(SegmentBadInput, FrameWithoutDepthHasNoPlanes) {
  write("cloud.pcd", pcdHeader("WIDTH 2\nHEIGHT 2\nPOINTS 4") + "nan nan nan\nnan nan nan\nnan nan nan\nnan nan nan\n");
  const epcc::test::ToolResult result = run({"cloud.pcd", "--labels", "l.png", "--overlay", "o.png"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find(" 0 planes"), std::string::npos) << result.out;
  EXPECT_TRUE(exists("l.png"));
}

TEST_F(SegmentBadInput, RandomNumbersAreDoubted) {
  std::mt19937 generator(3);
  std::uniform_int_distribution<int> any(1, 60000);
  epcc::Image<std::uint16_t> image(160, 120);
  for (auto& value : image.data) value = static_cast<std::uint16_t>(any(generator));
  epcc::writeGray16(path("random.png"), image);
  const epcc::test::ToolResult result =
      run({"random.png", "--fx", "131", "--fy", "131", "--cx", "79.5", "--cy", "59.5"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.err.find("is this a depth image"), std::string::npos) << result.err;
}

}  // namespace
