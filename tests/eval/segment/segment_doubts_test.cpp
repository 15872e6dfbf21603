// SPDX-License-Identifier: BSD-3-Clause
// What makes a result doubtful is one line on standard error, and no failure.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "datasets/files/png_io.h"
#include "tests/eval/segment/tool_runner.h"
#include "tests/support/rendered_room.h"
#include "tests/support/swapped_bytes.h"

namespace {

using epcc::test::SegmentToolTest;
using epcc::test::ToolResult;

const char kWrongOrder[] =
    "epcc_segment: room.png: depth: the two bytes of each value are in the wrong order: swapped the values are smooth, "
    "and as they are they jump\n";

class SegmentDoubts : public SegmentToolTest {
 protected:
  /// room.png, 320x240, in millimetres.
  SegmentDoubts() {
    auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(320, 240));
    epcc::test::addNoise(room, epcc::SensorModel::axial(0.003, 0.0, 1.0), 4);
    image = epcc::Image<std::uint16_t>(320, 240);
    for (std::size_t i = 0; i < image.data.size(); ++i)
      image.data[i] = static_cast<std::uint16_t>(std::lround(1000.0F * room.depth[i]));
    writeImage();
  }
  void writeImage() const { epcc::writeGray16(path("room.png"), image); }
  ToolResult segment(std::vector<std::string> more = {}) const {
    const std::vector<std::string> input = {"room.png", "--fx", "192", "--fy", "192", "--cx", "159.5", "--cy", "119.5"};
    more.insert(more.begin(), input.begin(), input.end());
    return run(more);
  }
  /// Done, files and all, and one line that has these words.
  void expectDoubt(const ToolResult& result, const std::string& words) const {
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err.rfind("epcc_segment: room.png: ", 0), 0U) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    EXPECT_EQ(result.out.rfind("room.png: 320x240, ", 0), 0U) << result.out;
  }

  epcc::Image<std::uint16_t> image;
};

TEST_F(SegmentDoubts, ThereAreNoneAboutARoom) {
  for (const auto& more : {std::vector<std::string>(), {"--noise", "0.003,0,1"}, {"--mode", "paper"}}) {
    const ToolResult result = segment(more);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "");
  }
}

TEST_F(SegmentDoubts, SwappedBytesAreNamedWhateverTheSensor) {
  image = epcc::test::swappedBytes(image);
  writeImage();
  for (const auto& more : {std::vector<std::string>{"--labels", "l.png"},
                           {"--noise", "0.003,0,1"},
                           {"--noise", "0.003,0,1", "--mode", "paper"}}) {
    const ToolResult result = segment(more);
    expectDoubt(result, "in the wrong order");
    EXPECT_EQ(result.err, kWrongOrder);
  }
  EXPECT_TRUE(exists("l.png"));
}

TEST_F(SegmentDoubts, FewPixelsAreSaid) {
  std::mt19937 random(2);
  for (std::uint16_t& value : image.data)
    if (random() % 100 >= 3) value = 0;
  writeImage();
  expectDoubt(segment(), "of the pixels are measured: small planes cannot be found");
}

TEST_F(SegmentDoubts, NoiseIsDoubted) {
  std::mt19937 random(3);
  for (std::uint16_t& value : image.data) value = static_cast<std::uint16_t>(1 + random() % 60000);
  writeImage();
  expectDoubt(segment({"--labels", "l.png"}), "is this a depth image");
  EXPECT_TRUE(exists("l.png"));
}

}  // namespace
