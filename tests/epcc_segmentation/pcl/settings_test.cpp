// SPDX-License-Identifier: BSD-3-Clause
// Settings of the PCL class reach the algorithm and can be asked for.
#include "epcc_segmentation/pcl/epcc_segmentation.h"

#include <gtest/gtest.h>

#include "tests/epcc_segmentation/pcl/segmentation_output.h"

namespace epcc {
namespace {

using testing::countNear;
using testing::renderCamera;
using testing::renderLidar;
using testing::roomCorner;
using testing::Segmentation;
using testing::wallAndFloor;
using testing::Xyz;

TEST(EPCCSegmentation, RowScanFindsTheSamePlanes) {
  Segmentation segmentation;
  segmentation.setScanDirection(ScanDirection::Rows);
  segmentation.setInputCloud(renderCamera<Xyz>(wallAndFloor()));
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
  segmentation.segment(models, inliers);
  ASSERT_EQ(models.size(), 2u);
  for (const auto& plane : wallAndFloor()) EXPECT_EQ(countNear(models, plane), 1);
}

TEST(EPCCSegmentation, SphericalScanIsRecognized) {
  Segmentation segmentation;
  segmentation.setInputCloud(renderLidar<Xyz>(roomCorner()));
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
  segmentation.segment(models, inliers);
  EXPECT_EQ(segmentation.getUsedProjection(), Projection::Spherical);
  EXPECT_FALSE(segmentation.getProjection().has_value());
  ASSERT_EQ(models.size(), 3u);
  for (const auto& plane : roomCorner()) EXPECT_EQ(countNear(models, plane), 1);

  // Said outright instead of found out: the same.
  segmentation.setProjection(Projection::Spherical);
  std::vector<pcl::PointIndices> again;
  segmentation.extract(again);
  ASSERT_EQ(again.size(), inliers.size());
  for (std::size_t k = 0; k < again.size(); ++k) EXPECT_EQ(again[k].indices, inliers[k].indices);
}

TEST(EPCCSegmentation, MinInliersDropsSmallPlanes) {
  Segmentation segmentation;
  segmentation.setInputCloud(renderCamera<Xyz>(wallAndFloor()));
  std::vector<pcl::PointIndices> clusters;
  segmentation.extract(clusters);
  ASSERT_EQ(clusters.size(), 2u);
  const auto smaller = static_cast<unsigned>(clusters[1].indices.size());
  segmentation.setMinInliers(smaller);
  segmentation.extract(clusters);
  EXPECT_EQ(clusters.size(), 2u);
  segmentation.setMinInliers(smaller + 1);
  segmentation.extract(clusters);
  EXPECT_EQ(clusters.size(), 1u);
}

TEST(EPCCSegmentation, BothModesFindThePlanesAndObeyMinInliers) {
  for (const Mode mode : {Mode::Paper, Mode::Default}) {
    SCOPED_TRACE(mode == Mode::Paper ? "paper" : "default");
    Segmentation segmentation;
    segmentation.setInputCloud(renderCamera<Xyz>(wallAndFloor()));
    segmentation.setMode(mode);
    EXPECT_EQ(segmentation.getMode(), mode);
    std::vector<pcl::ModelCoefficients> models;
    std::vector<pcl::PointIndices> inliers;
    segmentation.segment(models, inliers);
    ASSERT_EQ(models.size(), 2u);
    for (const auto& plane : wallAndFloor()) EXPECT_EQ(countNear(models, plane), 1);
    const auto smaller = static_cast<unsigned>(inliers[1].indices.size());
    segmentation.setMinInliers(smaller + 1);
    EXPECT_EQ(segmentation.getMinInliers(), smaller + 1);
    segmentation.segment(models, inliers);
    EXPECT_EQ(models.size(), 1u);
  }
}

TEST(EPCCSegmentation, SettingsReachTheAlgorithm) {
  Segmentation segmentation;
  segmentation.setInputCloud(renderCamera<Xyz>(wallAndFloor()));
  std::vector<pcl::PointIndices> clusters;
  segmentation.setMode(Mode::Paper);
  segmentation.setMinSegments(161);  // more than there are columns
  segmentation.extract(clusters);
  EXPECT_EQ(segmentation.getStatus(), Segmentation::Status::Ok);
  EXPECT_TRUE(clusters.empty());
  segmentation.setParameters(Parameters());
  segmentation.extract(clusters);
  EXPECT_EQ(clusters.size(), 2u);
}

TEST(EPCCSegmentation, GettersReturnWhatWasSet) {
  Segmentation s;
  s.setScanDirection(ScanDirection::Rows);
  EXPECT_EQ(s.getScanDirection(), ScanDirection::Rows);
  s.setLineKMax(2.5);
  EXPECT_EQ(s.getLineKMax(), 2.5);
  s.setPlaneKMax(3.5);
  EXPECT_EQ(s.getPlaneKMax(), 3.5);
  s.setMaxGap(0.2);
  EXPECT_EQ(s.getMaxGap(), 0.2);
  s.setMinInliers(123);
  EXPECT_EQ(s.getMinInliers(), 123u);
  s.setMinSegments(4);
  EXPECT_EQ(s.getMinSegments(), 4);
  s.setPlaneCriterion(PlaneCriterion::Prototype);
  EXPECT_EQ(s.getPlaneCriterion(), PlaneCriterion::Prototype);
  s.setThreads(2);
  EXPECT_EQ(s.getThreads(), 2);
  s.setProjection(Projection::Spherical);
  EXPECT_EQ(s.getProjection(), Projection::Spherical);
  s.setAngularThreshold(0.5);
  EXPECT_NEAR(s.getAngularThreshold(), 0.5, 1e-12);
  EXPECT_NEAR(s.getParameters().plane.max_start_angle, 28.64788975654116, 1e-9);
  s.setDistanceThreshold(0.03);
  EXPECT_EQ(s.getDistanceThreshold(), 0.03);
  s.setMaximumCurvature(0.002);
  EXPECT_EQ(s.getMaximumCurvature(), 0.002);
  s.setProjectPoints(true);
  EXPECT_TRUE(s.getProjectPoints());

  EXPECT_EQ(s.getParameters().line.k_max, 2.5);
  EXPECT_EQ(s.getParameters().plane.k_max, 3.5);
  EXPECT_EQ(s.getParameters().plane.max_gap, 0.2);
  EXPECT_EQ(s.getParameters().plane.min_points, 123);
  EXPECT_EQ(s.getParameters().plane.min_segments, 4);
  EXPECT_EQ(s.getParameters().plane.criterion, PlaneCriterion::Prototype);
}

TEST(EPCCSegmentation, SensorModelByName) {
  Segmentation segmentation;
  EXPECT_TRUE(segmentation.setSensorModel("kinect-v1"));
  const std::string kinect = segmentation.getSensorModel().description();
  EXPECT_EQ(kinect, SensorModel::preset("kinect-v1")->description());
  EXPECT_FALSE(segmentation.setSensorModel("no-such-sensor"));
  EXPECT_EQ(segmentation.getSensorModel().description(), kinect);
  segmentation.setSensorModel(SensorModel::axial(0.001, 0.002));
  EXPECT_NE(segmentation.getSensorModel().description(), kinect);
}

}  // namespace
}  // namespace epcc
