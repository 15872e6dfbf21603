// SPDX-License-Identifier: BSD-3-Clause
// Outputs of the PCL class: agree with each other, are replaced on reuse, the same bits again, invalid points.
#include "epcc_segmentation/pcl/epcc_segmentation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "tests/epcc_segmentation/pcl/segmentation_output.h"

namespace epcc {
namespace {

using testing::countNear;
using testing::difference;
using testing::Output;
using testing::renderCamera;
using testing::Segmentation;
using testing::wallAndFloor;
using testing::Xyz;

TEST(EPCCSegmentation, FindsTheWallAndTheFloor) {
  std::vector<int> truth;
  const auto cloud = renderCamera<Xyz>(wallAndFloor(), &truth);
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  Output<Xyz> out;
  out.run(segmentation);
  EXPECT_EQ(segmentation.getStatus(), Segmentation::Status::Ok);
  EXPECT_EQ(segmentation.getErrorMessage(), "");
  EXPECT_EQ(segmentation.getUsedProjection(), Projection::Perspective);
  ASSERT_EQ(out.models.size(), 2u);
  for (const auto& plane : wallAndFloor()) EXPECT_EQ(countNear(out.models, plane), 1);
  // Nine in ten of the pixels have the label of the plane they were rendered from.
  const std::uint32_t wall = difference(out.models[0], wallAndFloor()[0]) < 0.01 ? 0 : 1;
  std::size_t right = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) right += out.labels[i].label == (truth[i] == 0 ? wall : 1 - wall);
  EXPECT_GT(right, truth.size() * 9 / 10);
}

TEST(EPCCSegmentation, OutputsAgreeWithEachOther) {
  const auto cloud = renderCamera<Xyz>(wallAndFloor());
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  Output<Xyz> out;
  out.run(segmentation);
  const std::size_t planes = out.models.size();
  ASSERT_EQ(planes, 2u);
  ASSERT_EQ(out.inliers.size(), planes);
  ASSERT_EQ(out.centroids.size(), planes);
  ASSERT_EQ(out.covariances.size(), planes);
  ASSERT_EQ(out.label_indices.size(), planes);
  ASSERT_EQ(out.labels.width, cloud->width);
  ASSERT_EQ(out.labels.height, cloud->height);
  ASSERT_EQ(out.labels.size(), cloud->size());
  std::size_t labelled = 0;
  for (const auto& label : out.labels) {
    EXPECT_TRUE(label.label < planes || label.label == Segmentation::kNoPlane);
    labelled += label.label != std::numeric_limits<std::uint32_t>::max();
  }
  std::size_t inliers = 0;
  for (std::size_t k = 0; k < planes; ++k) {
    const auto& indices = out.inliers[k].indices;
    inliers += indices.size();
    EXPECT_TRUE(std::is_sorted(indices.begin(), indices.end()));
    EXPECT_EQ(std::adjacent_find(indices.begin(), indices.end()), indices.end());
    EXPECT_EQ(indices, out.label_indices[k].indices);
    EXPECT_EQ(indices.size(), segmentation.getSegmentation().planes[k].pixel_count);
    if (k > 0) {
      EXPECT_LE(indices.size(), out.inliers[k - 1].indices.size());
    }

    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const int i : indices) {
      EXPECT_EQ(out.labels[static_cast<std::size_t>(i)].label, k);
      mean += (*cloud)[static_cast<std::size_t>(i)].getVector3fMap().cast<double>();
    }
    mean /= static_cast<double>(indices.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const int i : indices) {
      const Eigen::Vector3d p = (*cloud)[static_cast<std::size_t>(i)].getVector3fMap().cast<double>() - mean;
      covariance += p * p.transpose();
    }
    covariance /= static_cast<double>(indices.size());
    EXPECT_LT((out.centroids[k].head<3>().cast<double>() - mean).norm(), 1e-4);
    EXPECT_EQ(out.centroids[k](3), 1.0f);
    EXPECT_LT((out.covariances[k].cast<double>() - covariance).cwiseAbs().maxCoeff(), 1e-4);
  }
  EXPECT_EQ(inliers, labelled);
}

TEST(EPCCSegmentation, NormalsAreUnitAndFaceTheSensor) {
  Segmentation segmentation;
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
  // A ceiling, a floor and two side walls: normals of both signs of x and y.
  segmentation.setInputCloud(
      renderCamera<Xyz>({{0, -1, 0, 0.5}, {0, 1, 0, 0.5}, {1, 0, 0, 0.7}, {-1, 0, 0, 0.7}, {0, 0, -1, 2.5}}));
  segmentation.segment(models, inliers);
  ASSERT_GE(models.size(), 4u);
  for (const auto& model : models) {
    ASSERT_EQ(model.values.size(), 4u);
    EXPECT_NEAR(Eigen::Map<const Eigen::Vector3f>(model.values.data()).norm(), 1.0f, 1e-5f);
    EXPECT_GE(model.values[3], 0.0f);
  }
}

TEST(EPCCSegmentation, HeadersAreCopied) {
  const auto cloud = renderCamera<Xyz>(wallAndFloor());
  cloud->sensor_origin_ = Eigen::Vector4f(1.0f, 2.0f, 3.0f, 0.0f);
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  Output<Xyz> out;
  out.run(segmentation);
  ASSERT_FALSE(out.models.empty());
  for (const auto& header :
       {out.models[0].header, out.inliers[0].header, out.label_indices[0].header, out.labels.header}) {
    EXPECT_EQ(header.frame_id, "camera");
    EXPECT_EQ(header.stamp, 1234567u);
    EXPECT_EQ(header.seq, 7u);
  }
  EXPECT_EQ(out.labels.sensor_origin_, cloud->sensor_origin_);
}

TEST(EPCCSegmentation, OutputsAreReplacedOnReuse) {
  Segmentation segmentation;
  segmentation.setInputCloud(renderCamera<Xyz>(wallAndFloor()));
  Output<Xyz> out;
  out.run(segmentation);
  const auto labels = out.labelValues();
  out.run(segmentation);
  EXPECT_EQ(out.models.size(), 2u);
  EXPECT_EQ(out.inliers.size(), 2u);
  EXPECT_EQ(out.centroids.size(), 2u);
  EXPECT_EQ(out.covariances.size(), 2u);
  EXPECT_EQ(out.label_indices.size(), 2u);
  EXPECT_EQ(out.labelValues(), labels);
  Segmentation::PlanarRegions regions(5);
  segmentation.segment(regions);
  EXPECT_EQ(regions.size(), 2u);
  std::vector<pcl::PointIndices> clusters(5);
  segmentation.extract(clusters);
  EXPECT_EQ(clusters.size(), 2u);
}

TEST(EPCCSegmentation, SameBitsOnEveryCallAndObject) {
  const auto cloud = renderCamera<Xyz>(wallAndFloor());
  Segmentation one;
  Segmentation other;
  other.setThreads(2);
  one.setInputCloud(cloud);
  other.setInputCloud(cloud);
  Output<Xyz> first;
  Output<Xyz> second;
  Output<Xyz> third;
  first.run(one);
  one.setInputCloud(renderCamera<Xyz>({{0, 0, -1, 1}}));  // something else in between
  second.run(one);
  EXPECT_EQ(second.models.size(), 1u);
  one.setInputCloud(cloud);
  second.run(one);
  third.run(other);
  ASSERT_EQ(first.models.size(), 2u);
  for (const Output<Xyz>* again : {&second, &third}) {
    EXPECT_EQ(again->labelValues(), first.labelValues());
    ASSERT_EQ(again->models.size(), first.models.size());
    for (std::size_t k = 0; k < first.models.size(); ++k) {
      EXPECT_EQ(again->models[k].values, first.models[k].values);
      EXPECT_EQ(again->centroids[k], first.centroids[k]);
      EXPECT_EQ(again->covariances[k], first.covariances[k]);
    }
  }
}

TEST(EPCCSegmentation, InvalidPointsAreSkippedWhateverIsDenseSays) {
  const auto cloud = renderCamera<Xyz>(wallAndFloor());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  std::vector<std::size_t> damaged;
  for (std::size_t i = 0; i < cloud->size(); i += 37) {
    Xyz& point = (*cloud)[i];
    switch (damaged.size() % 5) {
      case 0:
        point = Xyz(nan, nan, nan);
        break;
      case 1:
        point.z = nan;
        break;
      case 2:
        point.x = infinity;
        break;
      case 3:
        point = Xyz(0.0f, 0.0f, 0.0f);
        break;
      default:
        point = Xyz(-point.x, -point.y, -point.z);
    }
    damaged.push_back(i);
  }
  for (const bool is_dense : {true, false}) {
    cloud->is_dense = is_dense;
    Segmentation segmentation;
    segmentation.setInputCloud(cloud);
    Output<Xyz> out;
    out.run(segmentation);
    EXPECT_EQ(segmentation.getUsedProjection(), Projection::Perspective);
    ASSERT_EQ(out.models.size(), 2u);
    for (const auto& plane : wallAndFloor()) EXPECT_EQ(countNear(out.models, plane), 1);
    for (const std::size_t i : damaged) EXPECT_EQ(out.labels[i].label, Segmentation::kNoPlane);
  }
}

TEST(EPCCSegmentation, ExtractGivesTheInliers) {
  Segmentation segmentation;
  segmentation.setInputCloud(renderCamera<Xyz>(wallAndFloor()));
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
  std::vector<pcl::PointIndices> clusters;
  segmentation.segment(models, inliers);
  segmentation.extract(clusters);
  ASSERT_EQ(clusters.size(), 2u);
  for (std::size_t k = 0; k < clusters.size(); ++k) EXPECT_EQ(clusters[k].indices, inliers[k].indices);
}

TEST(EPCCSegmentation, CanBeMovedAndHeldByPointer) {
  Segmentation::Ptr pointer(new Segmentation);
  pointer->setInputCloud(renderCamera<Xyz>(wallAndFloor()));
  std::vector<pcl::PointIndices> clusters;
  pointer->extract(clusters);
  Segmentation moved = std::move(*pointer);
  std::vector<pcl::PointIndices> again;
  moved.extract(again);
  ASSERT_EQ(clusters.size(), 2u);
  ASSERT_EQ(again.size(), 2u);
  EXPECT_EQ(again[0].indices, clusters[0].indices);
}

}  // namespace
}  // namespace epcc
