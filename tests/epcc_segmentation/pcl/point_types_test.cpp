// SPDX-License-Identifier: BSD-3-Clause
// Every point type of PCL that has x, y, z gives the same planes.
#include "epcc_segmentation/pcl/epcc_segmentation.h"

#include <gtest/gtest.h>

#include "tests/epcc_segmentation/pcl/segmentation_output.h"

namespace epcc {
namespace {

using testing::Output;
using testing::renderCamera;
using testing::Segmentation;
using testing::wallAndFloor;
using testing::Xyz;

template <typename PointT>
class PointTypes : public ::testing::Test {};
using Types = ::testing::Types<pcl::PointXYZI, pcl::PointXYZRGB, pcl::PointXYZRGBA, pcl::PointNormal,
                               pcl::PointXYZRGBNormal, pcl::PointXYZL, pcl::PointSurfel, pcl::InterestPoint>;
TYPED_TEST_SUITE(PointTypes, Types);

TYPED_TEST(PointTypes, GiveTheLabelsOfPointXYZ) {
  EPCCSegmentation<TypeParam> segmentation;
  segmentation.setInputCloud(renderCamera<TypeParam>(wallAndFloor()));
  Output<TypeParam> out;
  out.run(segmentation);
  Segmentation plain;
  plain.setInputCloud(renderCamera<Xyz>(wallAndFloor()));
  Output<Xyz> expected;
  expected.run(plain);
  ASSERT_EQ(out.models.size(), 2u);
  EXPECT_EQ(out.labelValues(), expected.labelValues());
  for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(out.models[k].values, expected.models[k].values);
}

}  // namespace
}  // namespace epcc
