// SPDX-License-Identifier: BSD-3-Clause
// RANSAC: its two stop rules and parameters out of range.
#include "baselines/ransac_segmenter.h"

#include <gtest/gtest.h>

#include "tests/baselines/baseline_frames.h"

namespace epcc::test {
namespace {

std::size_t planesWith(const RansacParameters& parameters) {
  RansacSegmenter segmenter(parameters);
  PlaneSegmentation result;
  EXPECT_TRUE(segmenter.segment(inputOf(noisyRoom()), result)) << segmenter.error();
  return result.planes.size();
}

TEST(Ransac, StopsAfterTheLargestNumberOfPlanes) {
  RansacParameters parameters;
  ASSERT_GE(planesWith(parameters), 3u);
  parameters.max_planes = 2;
  EXPECT_EQ(planesWith(parameters), 2u);
}

TEST(Ransac, StopsWhenThePlaneIsTooSmall) {
  RansacParameters parameters;
  parameters.min_plane_points = 1000000;
  EXPECT_EQ(planesWith(parameters), 0u);
}

TEST(Ransac, ThickPlanesSwallowTheRoom) {
  RansacParameters parameters;
  parameters.inlier_distance = {50.0, 0.0};
  EXPECT_EQ(planesWith(parameters), 1u);
}

TEST(Ransac, ParametersOutOfRangeAreErrors) {
  const auto errorOf = [](const RansacParameters& parameters) {
    RansacSegmenter segmenter(parameters);
    PlaneSegmentation result;
    EXPECT_FALSE(segmenter.segment(inputOf(noisyRoom()), result));
    return segmenter.error();
  };
  RansacParameters bad;
  bad.leaf = {0.0001, 0.0};
  EXPECT_NE(errorOf(bad).find("leaf"), std::string::npos);
  bad = RansacParameters();
  bad.inlier_distance = {-1.0, 0.0};
  EXPECT_NE(errorOf(bad).find("inlier distance"), std::string::npos);
  bad = RansacParameters();
  bad.iterations = 0;
  EXPECT_NE(errorOf(bad).find("iterations"), std::string::npos);
  bad = RansacParameters();
  bad.normal_distance_weight = 1.5;
  EXPECT_NE(errorOf(bad).find("normal_distance_weight"), std::string::npos);
}

}  // namespace
}  // namespace epcc::test
