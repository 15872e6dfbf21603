// SPDX-License-Identifier: BSD-3-Clause
// Conventions of the PCL class: outputs, indices, invalid points, point types, planar regions.
#include "epcc_segmentation/epcc_segmentation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "tests/pcl/test_clouds.h"

namespace epcc {
namespace {

using testing::renderCamera;
using testing::renderLidar;
using testing::roomCorner;
using testing::wallAndFloor;

template <typename PointT>
struct Output {
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
  typename EPCCSegmentation<PointT>::Centroids centroids;
  typename EPCCSegmentation<PointT>::Covariances covariances;
  pcl::PointCloud<pcl::Label> labels;
  std::vector<pcl::PointIndices> label_indices;

  void run(EPCCSegmentation<PointT>& segmentation) {
    segmentation.segment(models, inliers, centroids, covariances, labels, label_indices);
  }
  std::vector<std::uint32_t> labelValues() const {
    std::vector<std::uint32_t> values;
    for (const auto& label : labels) values.push_back(label.label);
    return values;
  }
};

using Xyz = pcl::PointXYZ;
using Segmentation = EPCCSegmentation<Xyz>;

/// Largest difference of a plane's coefficients from the given ones.
double difference(const pcl::ModelCoefficients& model, const Eigen::Vector4d& truth) {
  return (Eigen::Map<const Eigen::Vector4f>(model.values.data()).cast<double>() - truth).cwiseAbs().maxCoeff();
}

int countNear(const std::vector<pcl::ModelCoefficients>& models, const Eigen::Vector4d& truth) {
  return static_cast<int>(
      std::count_if(models.begin(), models.end(), [&](const auto& model) { return difference(model, truth) < 0.01; }));
}

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

TEST(EPCCSegmentation, IndicesLimitWhatIsSeen) {
  std::vector<int> truth;
  const auto cloud = renderCamera<Xyz>(wallAndFloor(), &truth);
  pcl::IndicesPtr wall(new pcl::Indices);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] == 0) wall->push_back(static_cast<int>(i));
  }
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setIndices(wall);
  Output<Xyz> out;
  out.run(segmentation);
  ASSERT_EQ(out.models.size(), 1u);
  EXPECT_EQ(countNear(out.models, wallAndFloor()[0]), 1);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] != 0) {
      EXPECT_EQ(out.labels[i].label, Segmentation::kNoPlane);
    }
  }

  // Every index twice and in reverse: the same.
  pcl::IndicesPtr twice(new pcl::Indices(wall->rbegin(), wall->rend()));
  twice->insert(twice->end(), wall->begin(), wall->end());
  segmentation.setIndices(twice);
  Output<Xyz> again;
  again.run(segmentation);
  EXPECT_EQ(again.labelValues(), out.labelValues());
}

TEST(EPCCSegmentation, RectangleOfIndices) {
  const auto cloud = renderCamera<Xyz>(wallAndFloor());
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setIndices(10, 20, 40, 100);
  Output<Xyz> out;
  out.run(segmentation);
  ASSERT_EQ(out.models.size(), 1u);
  for (int row = 0; row < 120; ++row) {
    for (int column = 0; column < 160; ++column) {
      const bool inside = row >= 10 && row < 50 && column >= 20 && column < 120;
      if (!inside) {
        EXPECT_EQ(out.labels(column, row).label, Segmentation::kNoPlane);
      }
    }
  }
}

TEST(EPCCSegmentation, AllIndicesAreLikeNone) {
  const auto cloud = renderCamera<Xyz>(wallAndFloor());
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  Output<Xyz> without;
  without.run(segmentation);
  pcl::IndicesPtr all(new pcl::Indices);
  for (std::size_t i = 0; i < cloud->size(); ++i) all->push_back(static_cast<int>(i));
  segmentation.setIndices(all);
  Output<Xyz> with;
  with.run(segmentation);
  EXPECT_EQ(with.labelValues(), without.labelValues());
  EXPECT_EQ(with.models.size(), 2u);
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

// --- planar regions ---------------------------------------------------------------------------------

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

// --- point types ------------------------------------------------------------------------------------

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
