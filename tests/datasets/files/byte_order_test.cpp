// SPDX-License-Identifier: BSD-3-Clause
// Whether the bytes of depth images are in the right order is seen on each of the real ones, both ways.
#include <gtest/gtest.h>

#include <filesystem>

#include "datasets/files/labelled_frame.h"
#include "datasets/support/folder_listing.h"
#include "tests/support/real_frames.h"
#include "tests/support/swapped_bytes.h"

namespace {

using namespace epcc;

bool foundSwapped(const Image<std::uint16_t>& raw) {
  LabelledFrame frame;
  takeDepth(raw, frame);
  return frame.bytes_are_swapped;
}

class ByteOrder : public ::testing::TestWithParam<const char*> {};

TEST_P(ByteOrder, OfRealDepthImages) {
  EPCC_NEED_REAL_FRAMES(GetParam());
  int images = 0;
  for (const std::string& name : filesEndingIn(test::realFolder(GetParam()), "_depth.png")) {
    const auto raw = readGray16(test::realFolder(GetParam()) + "/" + name + "_depth.png");
    EXPECT_FALSE(foundSwapped(raw)) << name;
    EXPECT_TRUE(foundSwapped(test::swappedBytes(raw))) << name;
    ++images;
  }
  EXPECT_GT(images, 0);
}

INSTANTIATE_TEST_SUITE_P(Folders, ByteOrder,
                         ::testing::Values("abw", "icl", "kinect", "realsense", "sensors", "sequence", "structure"));

}  // namespace
