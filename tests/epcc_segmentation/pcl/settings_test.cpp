// SPDX-License-Identifier: BSD-3-Clause
// Settings of the PCL class reach the algorithm and can be asked for.
#include "epcc_segmentation/pcl/epcc_segmentation.h"

#include <gtest/gtest.h>

#include <functional>
#include <utility>

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
  for (const Mode mode : {Mode::Paper, Mode::InverseDepth}) {
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
  segmentation.paper().min_segments = 161;  // more than there are columns
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
  s.setRegionTolerance(1.25);
  EXPECT_EQ(s.getRegionTolerance(), 1.25);
  s.setMinInliers(123);
  EXPECT_EQ(s.getMinInliers(), 123u);
  s.setThreads(2);
  EXPECT_EQ(s.getThreads(), 2);
  s.setProjection(Projection::Spherical);
  EXPECT_EQ(s.getProjection(), Projection::Spherical);
  s.setProjectPoints(true);
  EXPECT_TRUE(s.getProjectPoints());
  s.paper().max_gap = 0.2;

  EXPECT_EQ(s.getParameters().inverse_depth.line_k_max, 2.5);
  EXPECT_EQ(s.getParameters().inverse_depth.plane_k_max, 3.5);
  EXPECT_EQ(s.getParameters().inverse_depth.region_tolerance, 1.25);
  EXPECT_EQ(s.getParameters().inverse_depth.min_points, 123);
  EXPECT_EQ(s.getParameters().paper.min_points, 123);
  EXPECT_EQ(s.getParameters().paper.max_gap, 0.2);
}

TEST(EPCCSegmentation, CallsWithoutEffectSaySoOnce) {
  Segmentation s;
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers, boundaries;
  Segmentation::PointCloudLPtr labels;
  const std::pair<const char*, std::function<void()>> calls[] = {
      {"setAngularThreshold", [&] { s.setAngularThreshold(0.5); }},
      {"setDistanceThreshold", [&] { s.setDistanceThreshold(0.03); }},
      {"setMaximumCurvature", [&] { s.setMaximumCurvature(0.002); }},
      {"setInputNormals", [&] { s.setInputNormals(pcl::PointCloud<pcl::Normal>::Ptr()); }},
      {"setComparator", [&] { s.setComparator(pcl::shared_ptr<int>()); }},
      {"setRefinementComparator", [&] { s.setRefinementComparator(pcl::shared_ptr<int>()); }},
      {"refine", [&] { s.refine(models, inliers, labels, boundaries); }},
  };
  for (const auto& [name, call] : calls) {
    ::testing::internal::CaptureStderr();
    call();
    const std::string first = ::testing::internal::GetCapturedStderr();
    EXPECT_NE(first.find(std::string("[epcc::EPCCSegmentation::") + name + "] has no effect: "), std::string::npos)
        << first;
    ::testing::internal::CaptureStderr();
    call();
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << name;
  }
  EXPECT_EQ(s.getAngularThreshold(), 0.5);
  EXPECT_EQ(s.getDistanceThreshold(), 0.03);
  EXPECT_EQ(s.getMaximumCurvature(), 0.002);
}

TEST(EPCCSegmentation, SettersOfTheOtherModeSaySoOnce) {
  Segmentation s;
  s.setInputCloud(renderCamera<Xyz>(wallAndFloor()));
  s.setMode(Mode::Paper);
  s.setLineKMax(2.5);
  std::vector<pcl::PointIndices> clusters;
  ::testing::internal::CaptureStderr();
  s.extract(clusters);
  EXPECT_NE(::testing::internal::GetCapturedStderr().find("setLineKMax"), std::string::npos);
  ::testing::internal::CaptureStderr();
  s.extract(clusters);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(EPCCSegmentation, ModesThereAndBackGiveWhatAFreshObjectGives) {
  const auto cloud = renderCamera<Xyz>(wallAndFloor());
  const auto labelsOf = [&](Segmentation& s) {
    std::vector<pcl::PointIndices> clusters;
    s.extract(clusters);
    return s.getSegmentation().labels;
  };
  Segmentation fresh, fresh_paper, switched;
  for (Segmentation* s : {&fresh, &fresh_paper, &switched}) s->setInputCloud(cloud);
  fresh_paper.setMode(Mode::Paper);
  const auto expected = labelsOf(fresh);
  const auto expected_paper = labelsOf(fresh_paper);
  for (int i = 0; i < 2; ++i) {
    switched.setMode(Mode::Paper);
    EXPECT_EQ(labelsOf(switched), expected_paper);
    switched.setMode(Mode::InverseDepth);
    EXPECT_EQ(labelsOf(switched), expected);
    EXPECT_EQ(switched.getScanDirection(), ScanDirection::Both);
  }
}

TEST(EPCCSegmentation, TheSensorIsMeasuredUnlessAModelIsSet) {
  const auto cloud = renderCamera<Xyz>(wallAndFloor());
  std::vector<pcl::PointIndices> clusters;
  const auto usedAfter = [&](Segmentation& s) {
    s.setInputCloud(cloud);
    s.extract(clusters);
    EXPECT_EQ(clusters.size(), 2u);
    return s.getSensorModel().description();
  };
  Segmentation fresh, again, named;
  const std::string measured = usedAfter(fresh);
  again.setSensorModel("kinect-v1");
  EXPECT_EQ(usedAfter(again), SensorModel::preset("kinect-v1")->description());
  again.setSensorModelAuto();
  EXPECT_EQ(usedAfter(again), measured);
  named.setSensorModel("kinect-v1");
  EXPECT_TRUE(named.setSensorModel("auto"));
  EXPECT_EQ(usedAfter(named), measured);
  EXPECT_NE(measured, SensorModel::preset("kinect-v1")->description());
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
