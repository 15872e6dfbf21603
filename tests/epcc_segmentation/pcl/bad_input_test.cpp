// SPDX-License-Identifier: BSD-3-Clause
// Every named bad input: one error line, empty outputs, a status, and no exception.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "epcc_segmentation/pcl/epcc_segmentation.h"
#include "tests/epcc_segmentation/pcl/test_clouds.h"

namespace epcc {
namespace {

using Xyz = pcl::PointXYZ;
using Segmentation = EPCCSegmentation<Xyz>;
using Status = SegmentationStatus;
using testing::renderCamera;
using testing::renderLidar;
using testing::roomCorner;
using testing::wallAndFloor;

/// Runs every method into outputs that hold something and checks that they come back empty.
void expectStatus(Segmentation& segmentation, Status status) {
  struct Call {
    const char* method;
    std::function<bool()> leaves_nothing;
  };
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers, label_indices, boundaries;
  Segmentation::PlanarRegions regions;
  Segmentation::Centroids centroids;
  Segmentation::Covariances covariances;
  pcl::PointCloud<pcl::Label>::Ptr labels;
  const auto isEmpty = [&](const pcl::PointCloud<pcl::Label>& cloud) {
    return cloud.empty() && cloud.width == 0 && cloud.height == 0;
  };
  const Call calls[] = {
      {"segment", [&] { return segmentation.segment(models, inliers), models.empty() && inliers.empty(); }},
      {"segment",
       [&] {
         segmentation.segment(models, inliers, centroids, covariances, *labels, label_indices);
         return models.empty() && inliers.empty() && centroids.empty() && covariances.empty() && isEmpty(*labels) &&
                label_indices.empty();
       }},
      {"segment", [&] { return segmentation.segment(regions), regions.empty(); }},
      {"segmentAndRefine", [&] { return segmentation.segmentAndRefine(regions), regions.empty(); }},
      {"segmentAndRefine",
       [&] {
         segmentation.segmentAndRefine(regions, models, inliers, labels, label_indices, boundaries);
         return regions.empty() && models.empty() && inliers.empty() && isEmpty(*labels) && label_indices.empty() &&
                boundaries.empty();
       }},
      {"extract", [&] { return segmentation.extract(inliers), inliers.empty(); }},
  };
  for (const Call& call : calls) {
    SCOPED_TRACE(call.method);
    models.resize(3);
    inliers.resize(3);
    label_indices.resize(3);
    boundaries.resize(3);
    regions.resize(3);
    centroids.resize(3);
    covariances.resize(3);
    labels.reset(new pcl::PointCloud<pcl::Label>(4, 2));
    ::testing::internal::CaptureStderr();
    bool empty = false;
    EXPECT_NO_THROW(empty = call.leaves_nothing());
    const std::string printed = ::testing::internal::GetCapturedStderr();
    EXPECT_TRUE(empty);
    EXPECT_EQ(std::count(printed.begin(), printed.end(), '\n'), 1) << printed;
    EXPECT_NE(printed.find("[epcc::EPCCSegmentation::" + std::string(call.method) + "] "), std::string::npos)
        << printed;
    EXPECT_EQ(segmentation.getStatus(), status);
    EXPECT_FALSE(segmentation.getErrorMessage().empty());
    EXPECT_NE(printed.find(segmentation.getErrorMessage()), std::string::npos);
    EXPECT_TRUE(segmentation.getSegmentation().planes.empty());
    EXPECT_TRUE(segmentation.getSegmentation().labels.empty());
  }
}

/// No error, no planes, and a label image without labels.
void expectNoPlanes(Segmentation& segmentation) {
  std::vector<pcl::ModelCoefficients> models(3);
  std::vector<pcl::PointIndices> inliers(3), label_indices(3);
  Segmentation::Centroids centroids;
  Segmentation::Covariances covariances;
  pcl::PointCloud<pcl::Label> labels;
  ::testing::internal::CaptureStderr();
  segmentation.segment(models, inliers, centroids, covariances, labels, label_indices);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(segmentation.getStatus(), Status::Ok) << segmentation.getErrorMessage();
  EXPECT_TRUE(models.empty());
  EXPECT_TRUE(inliers.empty());
  ASSERT_EQ(labels.size(), segmentation.getInputCloud()->size());
  for (const auto& label : labels) ASSERT_EQ(label.label, Segmentation::kNoPlane);
  Segmentation::PlanarRegions regions(3);
  segmentation.segment(regions);
  EXPECT_TRUE(regions.empty());
}

Segmentation withScene() {
  Segmentation segmentation;
  segmentation.setInputCloud(renderCamera<Xyz>(wallAndFloor()));
  return segmentation;
}

TEST(BadInput, SegmentWithoutCloud) {
  Segmentation segmentation;
  expectStatus(segmentation, Status::NoInput);
}

TEST(BadInput, NullCloud) {
  Segmentation segmentation = withScene();
  segmentation.setInputCloud(nullptr);
  expectStatus(segmentation, Status::NoInput);
}

TEST(BadInput, EmptyCloud) {
  Segmentation segmentation;
  segmentation.setInputCloud(pcl::make_shared<pcl::PointCloud<Xyz>>());
  expectStatus(segmentation, Status::EmptyCloud);
  const auto rows_of_nothing = pcl::make_shared<pcl::PointCloud<Xyz>>();
  rows_of_nothing->height = 480;
  segmentation.setInputCloud(rows_of_nothing);
  expectStatus(segmentation, Status::EmptyCloud);
}

TEST(BadInput, UnorganizedCloud) {
  const auto cloud = renderCamera<Xyz>(wallAndFloor());
  cloud->width *= cloud->height;
  cloud->height = 1;
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  expectStatus(segmentation, Status::Unorganized);
}

TEST(BadInput, OneRow) {
  Segmentation segmentation;
  segmentation.setInputCloud(pcl::make_shared<pcl::PointCloud<Xyz>>(64, 1, Xyz(0.0f, 0.0f, 1.0f)));
  expectStatus(segmentation, Status::Unorganized);
}

TEST(BadInput, OneColumn) {
  const auto cloud = pcl::make_shared<pcl::PointCloud<Xyz>>(1, 64);
  for (int i = 0; i < 64; ++i) (*cloud)(0, i) = Xyz(0.0f, 0.01f * static_cast<float>(i), 1.0f);
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  expectNoPlanes(segmentation);
}

TEST(BadInput, SmallestOrganizedClouds) {
  for (const auto& [width, height] : {std::pair(1u, 2u), std::pair(2u, 2u), std::pair(3u, 5u), std::pair(40u, 2u)}) {
    SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
    Segmentation segmentation;
    segmentation.setInputCloud(pcl::make_shared<pcl::PointCloud<Xyz>>(width, height, Xyz(0.1f, 0.1f, 1.0f)));
    expectNoPlanes(segmentation);
  }
}

TEST(BadInput, SizeMismatch) {
  for (const int change : {-1, 1}) {
    const auto cloud = renderCamera<Xyz>(wallAndFloor());
    cloud->points.resize(cloud->points.size() + static_cast<std::size_t>(change));
    Segmentation segmentation;
    segmentation.setInputCloud(cloud);
    expectStatus(segmentation, Status::SizeMismatch);
  }
  const auto no_points = renderCamera<Xyz>(wallAndFloor());
  no_points->points.clear();
  Segmentation segmentation;
  segmentation.setInputCloud(no_points);
  expectStatus(segmentation, Status::SizeMismatch);
  // 65536 * 65536 wraps to 0 in 32 bits.
  no_points->width = no_points->height = 65536;
  expectStatus(segmentation, Status::SizeMismatch);
}

TEST(BadInput, AllNaN) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const bool is_dense : {true, false}) {
    const auto cloud = pcl::make_shared<pcl::PointCloud<Xyz>>(64, 48, Xyz(nan, nan, nan));
    cloud->is_dense = is_dense;
    Segmentation segmentation;
    segmentation.setInputCloud(cloud);
    expectNoPlanes(segmentation);
  }
}

TEST(BadInput, AllZero) {
  Segmentation segmentation;
  segmentation.setInputCloud(pcl::make_shared<pcl::PointCloud<Xyz>>(64, 48, Xyz(0.0f, 0.0f, 0.0f)));
  expectNoPlanes(segmentation);
}

TEST(BadInput, NegativeDepth) {
  const auto cloud = renderCamera<Xyz>(wallAndFloor());
  for (auto& point : *cloud) point.z = -point.z;
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setProjection(Projection::Perspective);
  expectNoPlanes(segmentation);
}

TEST(BadInput, HugeAndTinyCoordinates) {
  for (const float scale : {1e30f, 3e38f, 1e-30f, 1e-42f}) {
    const auto cloud = renderCamera<Xyz>(wallAndFloor());
    for (auto& point : *cloud) point.getVector3fMap() *= scale;
    Segmentation segmentation;
    segmentation.setInputCloud(cloud);
    std::vector<pcl::ModelCoefficients> models;
    std::vector<pcl::PointIndices> inliers;
    EXPECT_NO_THROW(segmentation.segment(models, inliers));
    EXPECT_EQ(segmentation.getStatus(), Status::Ok);
    for (const auto& model : models) {
      for (const float value : model.values) EXPECT_FALSE(std::isnan(value)) << scale;
    }
  }
}

TEST(BadInput, IndicesOutOfRange) {
  Segmentation segmentation = withScene();
  const auto beyond = static_cast<int>(segmentation.getInputCloud()->size());
  for (const int index : {beyond, std::numeric_limits<int>::max()}) {
    segmentation.setIndices(pcl::IndicesPtr(new pcl::Indices{0, 1, index}));
    expectStatus(segmentation, Status::InvalidIndices);
  }
  segmentation.setIndices(pcl::IndicesPtr(new pcl::Indices{0, beyond - 1}));
  expectNoPlanes(segmentation);
}

TEST(BadInput, NegativeIndex) {
  Segmentation segmentation = withScene();
  for (const int index : {-1, std::numeric_limits<int>::min()}) {
    segmentation.setIndices(pcl::IndicesPtr(new pcl::Indices{index, 5}));
    expectStatus(segmentation, Status::InvalidIndices);
  }
}

TEST(BadInput, IndicesOfALargerCloudThatWentAway) {
  Segmentation segmentation = withScene();
  std::vector<pcl::PointIndices> clusters;
  segmentation.extract(clusters);  // PCLBase makes its own indices of this size
  segmentation.setInputCloud(pcl::make_shared<pcl::PointCloud<Xyz>>(8, 6, Xyz(0.0f, 0.0f, 1.0f)));
  expectNoPlanes(segmentation);
}

TEST(BadInput, EmptyIndices) {
  Segmentation segmentation = withScene();
  segmentation.setIndices(pcl::IndicesPtr(new pcl::Indices));
  expectNoPlanes(segmentation);
}

TEST(BadInput, NullIndicesMeanAllPoints) {
  Segmentation segmentation = withScene();
  std::vector<pcl::PointIndices> clusters;
  segmentation.setIndices(pcl::IndicesPtr());
  segmentation.extract(clusters);
  EXPECT_EQ(clusters.size(), 2u);
  segmentation.setIndices(pcl::IndicesConstPtr());
  segmentation.extract(clusters);
  EXPECT_EQ(clusters.size(), 2u);
  segmentation.setIndices(pcl::PointIndices::ConstPtr());
  segmentation.extract(clusters);
  EXPECT_EQ(clusters.size(), 2u);
}

TEST(BadInput, RectangleOfIndicesWithoutCloud) {
  Segmentation segmentation;
  ::testing::internal::CaptureStderr();
  segmentation.setIndices(0, 0, 2, 2);
  EXPECT_NE(::testing::internal::GetCapturedStderr().find("[epcc::EPCCSegmentation::setIndices] "), std::string::npos);
  EXPECT_EQ(segmentation.getStatus(), Status::NoInput);
  expectStatus(segmentation, Status::NoInput);
}

TEST(BadInput, InvalidParameters) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::function<void(Segmentation&)> mistakes[] = {
      [&](Segmentation& s) { s.setLineKMax(0.0); },
      [&](Segmentation& s) { s.setLineKMax(nan); },
      [&](Segmentation& s) { s.setPlaneKMax(-1.0); },
      [&](Segmentation& s) { s.setRegionTolerance(-0.1); },
      [&](Segmentation& s) { s.paper().max_gap = nan; },
      [&](Segmentation& s) { s.paper().min_segments = 0; },
      [&](Segmentation& s) { s.setMinInliers(std::numeric_limits<unsigned>::max()); },
      [&](Segmentation& s) { s.paper().expert.planes.max_start_angle = 0.0; },
      [&](Segmentation& s) { s.setThreads(0); },
      [&](Segmentation& s) { s.setSensorModel(SensorModel::axial(nan, 0.001)); },
  };
  int number = 0;
  for (const auto& mistake : mistakes) {
    SCOPED_TRACE("mistake " + std::to_string(number++));
    Segmentation segmentation = withScene();
    mistake(segmentation);
    expectStatus(segmentation, Status::InvalidParameters);
  }
}

TEST(BadInput, RowScanOfSphericalScan) {
  Segmentation segmentation;
  segmentation.setScanDirection(ScanDirection::Rows);
  segmentation.setInputCloud(renderLidar<Xyz>(roomCorner()));
  expectStatus(segmentation, Status::UnsupportedScan);
  segmentation.setInputCloud(renderCamera<Xyz>(wallAndFloor()));
  segmentation.setProjection(Projection::Spherical);
  expectStatus(segmentation, Status::UnsupportedScan);
}

TEST(BadInput, BothDirectionsMeansThoseThatThereAre) {
  Segmentation segmentation = withScene();
  segmentation.setScanDirection(ScanDirection::Both);
  std::vector<pcl::PointIndices> clusters;
  // All directions that a mode has: the paper's are the columns.
  for (const Mode mode : {Mode::Paper, Mode::InverseDepth}) {
    segmentation.setMode(mode);
    segmentation.extract(clusters);
    EXPECT_EQ(segmentation.getStatus(), Status::Ok);
    EXPECT_EQ(clusters.size(), 2u);
  }
  // A spherical scan has planar columns only: both directions means its columns.
  segmentation.setInputCloud(renderLidar<Xyz>(roomCorner()));
  segmentation.extract(clusters);
  EXPECT_EQ(segmentation.getStatus(), Status::Ok);
  EXPECT_EQ(clusters.size(), 3u);
}

TEST(BadInput, IsForgottenOnceRepaired) {
  Segmentation segmentation = withScene();
  segmentation.setRegionTolerance(-1.0);
  expectStatus(segmentation, Status::InvalidParameters);
  segmentation.setRegionTolerance(1.5);
  std::vector<pcl::PointIndices> clusters;
  segmentation.extract(clusters);
  EXPECT_EQ(segmentation.getStatus(), Status::Ok);
  EXPECT_EQ(segmentation.getErrorMessage(), "");
  EXPECT_EQ(clusters.size(), 2u);
}

}  // namespace
}  // namespace epcc
