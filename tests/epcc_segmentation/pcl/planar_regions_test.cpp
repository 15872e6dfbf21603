// SPDX-License-Identifier: BSD-3-Clause
// pcl::PlanarRegion: centroid, curvature, contour.
#include "epcc_segmentation/pcl/epcc_segmentation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/epcc_segmentation/pcl/segmentation_output.h"

namespace epcc {
namespace {

using testing::renderCamera;
using testing::Segmentation;
using testing::wallAndFloor;
using testing::Xyz;

TEST(PlanarRegions, DescribeThePlanes) {
  const auto cloud = renderCamera<pcl::PointXYZRGBA>(wallAndFloor());
  for (std::size_t i = 0; i < cloud->size(); ++i) (*cloud)[i].rgba = static_cast<std::uint32_t>(i);
  EPCCSegmentation<pcl::PointXYZRGBA> segmentation;
  segmentation.setInputCloud(cloud);
  EPCCSegmentation<pcl::PointXYZRGBA>::PlanarRegions regions;
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
  std::vector<pcl::PointIndices> label_indices(3);
  std::vector<pcl::PointIndices> boundaries(3);
  pcl::PointCloud<pcl::Label>::Ptr labels;
  segmentation.segmentAndRefine(regions, models, inliers, labels, label_indices, boundaries);
  ASSERT_EQ(regions.size(), 2u);
  ASSERT_EQ(models.size(), 2u);
  ASSERT_EQ(boundaries.size(), 2u);
  ASSERT_EQ(label_indices.size(), 2u);
  ASSERT_TRUE(labels != nullptr);
  ASSERT_EQ(labels->size(), cloud->size());
  for (std::size_t k = 0; k < regions.size(); ++k) {
    EXPECT_EQ(regions[k].getCount(), inliers[k].indices.size());
    const Eigen::Vector4f plane = regions[k].getCoefficients();
    for (int i = 0; i < 4; ++i) EXPECT_EQ(plane(i), models[k].values[static_cast<std::size_t>(i)]);
    EXPECT_NEAR(plane.dot(regions[k].getCentroid().homogeneous()), 0.0f, 1e-4f);
    EXPECT_LT(regions[k].getCurvature(), 1e-3f);
    const auto& contour = regions[k].getContour();
    ASSERT_EQ(contour.size(), boundaries[k].indices.size());
    ASSERT_GT(contour.size(), 100u);
    for (std::size_t i = 0; i < contour.size(); ++i) {
      // The point itself with all its fields, of this plane, and near it.
      const auto index = static_cast<std::size_t>(boundaries[k].indices[i]);
      EXPECT_EQ(contour[i].rgba, index);
      EXPECT_EQ(contour[i].getVector3fMap(), (*cloud)[index].getVector3fMap());
      EXPECT_EQ((*labels)[index].label, k);
      EXPECT_LT(std::abs(plane.dot(contour[i].getVector3fMap().homogeneous())), 0.05f);
    }
  }
}

TEST(PlanarRegions, ProjectedContoursLieOnThePlane) {
  const auto cloud = renderCamera<Xyz>(wallAndFloor());
  for (std::size_t i = 0; i < cloud->size(); ++i) {  // a millimetre of unevenness
    (*cloud)[i].getVector3fMap() *= 1.0f + 0.0005f * static_cast<float>(static_cast<int>(i * 7919 % 3) - 1);
  }
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  Segmentation::PlanarRegions measured;
  segmentation.segment(measured);
  segmentation.setProjectPoints(true);
  Segmentation::PlanarRegions projected;
  segmentation.segmentAndRefine(projected);
  ASSERT_EQ(measured.size(), 2u);
  ASSERT_EQ(projected.size(), 2u);
  const auto farthest = [](const pcl::PlanarRegion<Xyz>& region) {
    float distance = 0.0f;
    const Eigen::Vector4f plane = pcl::PlanarRegion<Xyz>(region).getCoefficients();
    for (const auto& point : region.getContour()) {
      distance = std::max(distance, std::abs(plane.dot(point.getVector3fMap().homogeneous())));
    }
    return distance;
  };
  for (std::size_t k = 0; k < measured.size(); ++k) {
    ASSERT_EQ(measured[k].getContour().size(), projected[k].getContour().size());
    EXPECT_GT(farthest(measured[k]), 1e-4f);
    EXPECT_LT(farthest(projected[k]), 1e-5f);
  }
}

}  // namespace
}  // namespace epcc
