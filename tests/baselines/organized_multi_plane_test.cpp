// SPDX-License-Identifier: BSD-3-Clause
// Organized multi-plane segmentation: images smaller than its windows, size filter, the rim of the image.
#include "baselines/organized_multi_plane_segmenter.h"

#include <gtest/gtest.h>

#include "tests/baselines/baseline_frames.h"

namespace epcc::test {
namespace {

TEST(OrganizedMultiPlane, SmallestImageIsTwoWindows) {
  OrganizedMultiPlaneParameters parameters;
  parameters.normal_smoothing = 10.0;
  parameters.min_inliers = 3;
  OrganizedMultiPlaneSegmenter segmenter(parameters);
  const std::vector<float> depth(40 * 40, 1.0f);
  PlaneSegmentation result;
  const auto segment = [&](int width, int height) {
    return segmenter.segment({DepthFrame::fromDepth(depth.data(), testCamera(width, height)), mildSensor(), ""},
                             result);
  };
  EXPECT_FALSE(segment(20, 40));
  EXPECT_NE(segmenter.error().find("21 pixels"), std::string::npos) << segmenter.error();
  EXPECT_FALSE(segment(40, 20));
  EXPECT_TRUE(segment(21, 21)) << segmenter.error();
  EXPECT_TRUE(segment(40, 40)) << segmenter.error();
  EXPECT_EQ(result.planes.size(), 1u);
}

TEST(OrganizedMultiPlane, RefinementLabelsTheRim) {
  const RenderedRoom room = noisyRoom();
  OrganizedMultiPlaneSegmenter segmenter{OrganizedMultiPlaneParameters()};
  PlaneSegmentation result;
  ASSERT_TRUE(segmenter.segment(inputOf(room), result)) << segmenter.error();
  int labelled = 0;
  for (int column = 0; column < 320; ++column) labelled += result.labels[static_cast<std::size_t>(column)] > 0;
  EXPECT_GT(labelled, 200);  // of the top row, where there are no normals
}

TEST(OrganizedMultiPlane, MinInliersDropsPlanes) {
  OrganizedMultiPlaneParameters parameters;
  parameters.min_inliers = 320 * 240;
  OrganizedMultiPlaneSegmenter segmenter(parameters);
  PlaneSegmentation result;
  EXPECT_TRUE(segmenter.segment(inputOf(noisyRoom()), result)) << segmenter.error();
  EXPECT_TRUE(result.planes.empty());
}

TEST(OrganizedMultiPlane, ParametersOutOfRangeAreErrors) {
  OrganizedMultiPlaneParameters bad;
  bad.normal_smoothing = 0.0;
  OrganizedMultiPlaneSegmenter segmenter(bad);
  PlaneSegmentation result;
  EXPECT_FALSE(segmenter.segment(inputOf(noisyRoom()), result));
  EXPECT_NE(segmenter.error().find("normal_smoothing"), std::string::npos);
}

}  // namespace
}  // namespace epcc::test
