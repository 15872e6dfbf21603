// SPDX-License-Identifier: BSD-3-Clause
// A point type of one's own: PCL_NO_PRECOMPILE and the one header are enough.
#define PCL_NO_PRECOMPILE
#include "epcc_segmentation/pcl/epcc_segmentation.h"

#include <gtest/gtest.h>

#include "tests/epcc_segmentation/pcl/test_clouds.h"

namespace {

struct PointWithTime {
  PCL_ADD_POINT4D
  double time;
  std::uint16_t ring;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
} EIGEN_ALIGN16;

TEST(NoPrecompile, OwnPointType) {
  epcc::EPCCSegmentation<PointWithTime> segmentation;
  segmentation.setInputCloud(epcc::testing::renderCamera<PointWithTime>(epcc::testing::wallAndFloor()));
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
  segmentation.segment(models, inliers);
  EXPECT_EQ(models.size(), 2u);
}

}  // namespace
