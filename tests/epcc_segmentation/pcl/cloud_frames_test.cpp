// SPDX-License-Identifier: BSD-3-Clause
// The PCL class on clouds of other frames and units: results are in the cloud's frame and unit.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "epcc_segmentation/pcl/epcc_segmentation.h"
#include "tests/epcc_segmentation/pcl/test_clouds.h"

namespace {

using Xyz = pcl::PointXYZ;
using Cloud = pcl::PointCloud<Xyz>;
using Segmentation = epcc::EPCCSegmentation<Xyz>;
using epcc::Status;

Cloud::Ptr moved(const Cloud& from, const Eigen::Matrix3f& axes, const Eigen::Vector3f& origin, float unit = 1.0f) {
  auto to = pcl::make_shared<Cloud>(from);
  for (Xyz& point : *to) point.getVector3fMap() = unit * (axes * point.getVector3fMap() + origin);
  return to;
}

Cloud room() {
  return *epcc::testing::renderCamera<Xyz>(epcc::testing::wallAndFloor());
}

/// Every inlier lies on its plane, in the units of the cloud.
void expectInliersOnTheirPlanes(Segmentation& segmentation, const Cloud& cloud, double tolerance) {
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
  segmentation.segment(models, inliers);
  ASSERT_EQ(segmentation.getStatus(), Status::Ok) << segmentation.getErrorMessage();
  ASSERT_EQ(models.size(), 2u);
  for (std::size_t k = 0; k < models.size(); ++k) {
    const Eigen::Vector4f plane(models[k].values.data());
    for (const auto index : inliers[k].indices)
      ASSERT_LT(std::abs(plane.dot(cloud[static_cast<std::size_t>(index)].getVector3fMap().homogeneous())), tolerance);
  }
}

TEST(CloudFrames, PlanesAreInTheCloudsFrame) {
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(0.44f, Eigen::Vector3f(0.3f, 1.0f, -0.2f).normalized()).toRotationMatrix();
  const auto cloud = moved(room(), turn, Eigen::Vector3f(0.9f, -0.5f, 0.6f));
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  expectInliersOnTheirPlanes(segmentation, *cloud, 0.01);
  EXPECT_LT((segmentation.getGeometry().pose.origin - Eigen::Vector3d(0.9, -0.5, 0.6)).norm(), 0.01);
  EXPECT_EQ(segmentation.getUsedProjection(), epcc::Projection::Perspective);
}

TEST(CloudFrames, ResultsAreInTheCloudsUnit) {
  const auto cloud = moved(room(), Eigen::Matrix3f::Identity(), Eigen::Vector3f::Zero(), 1000.0f);
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  expectInliersOnTheirPlanes(segmentation, *cloud, 10.0);
  expectInliersOnTheirPlanes(segmentation, *cloud, 10.0);
  const std::string said = ::testing::internal::GetCapturedStderr() + ::testing::internal::GetCapturedStdout();
  EXPECT_NE(said.find("millimetre"), std::string::npos) << said;
  EXPECT_EQ(said.find("millimetre"), said.rfind("millimetre")) << "said once";
  EXPECT_NEAR(segmentation.getSegmentation().planes[0].coefficients(3), 2.0, 0.02);

  segmentation.setUnit(0.001);
  Segmentation::PlanarRegions regions;
  segmentation.segment(regions);
  ASSERT_EQ(regions.size(), 2u);
  for (const auto& region : regions) {
    const Eigen::Vector4f plane = region.getCoefficients();
    EXPECT_LT(std::abs(plane.dot(region.getCentroid().homogeneous())), 10.0f);
    for (const Xyz& point : region.getContour())
      EXPECT_LT(std::abs(plane.dot(point.getVector3fMap().homogeneous())), 10.0f);
  }
}

TEST(CloudFrames, WhatIsKnownCanBeSaid) {
  auto cloud = room();
  Segmentation segmentation;
  EXPECT_EQ(segmentation.getUnit(), 0.0);
  segmentation.setDepthRange(0.0, 1.9);  // the wall is at 2 m
  segmentation.setInputCloud(pcl::make_shared<Cloud>(cloud));
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
  segmentation.segment(models, inliers);
  EXPECT_EQ(models.size(), 1u);
  segmentation.setDepthRange(0.0, std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < cloud.size(); i += 11) cloud[i] = Xyz(7.0f, 7.0f, 7.0f);
  segmentation.setInvalidValue(7.0f);
  segmentation.setInputCloud(pcl::make_shared<Cloud>(cloud));
  segmentation.segment(models, inliers);
  EXPECT_EQ(models.size(), 2u);
  segmentation.setSensorKind(epcc::CloudOptions::Sensor::Camera);
  segmentation.segment(models, inliers);
  EXPECT_EQ(models.size(), 2u);
}

TEST(CloudFrames, WhatNoSensorSeesIsAnError) {
  auto cloud = room();
  unsigned state = 1;
  for (Xyz& point : cloud)
    for (int k = 0; k < 3; ++k)
      point.data[k] = static_cast<float>((state = state * 1664525u + 1013904223u) >> 8) * 1e-7f;
  Segmentation segmentation;
  segmentation.setInputCloud(pcl::make_shared<Cloud>(cloud));
  std::vector<pcl::ModelCoefficients> models(3);
  std::vector<pcl::PointIndices> inliers(3);
  ::testing::internal::CaptureStderr();
  segmentation.segment(models, inliers);
  EXPECT_NE(::testing::internal::GetCapturedStderr().find("no camera and no scanner"), std::string::npos);
  EXPECT_EQ(segmentation.getStatus(), Status::UnknownGeometry);
  EXPECT_TRUE(models.empty());
  EXPECT_TRUE(inliers.empty());
}

}  // namespace
