// SPDX-License-Identifier: BSD-3-Clause
// One program, compiled for pcl::OrganizedMultiPlaneSegmentation and for EPCCSegmentation.

// PCL's class is compiled here: under the address sanitizer Eigen's aligned memory has another layout
// than in the precompiled library, and the two must not free each other's.
#define PCL_NO_PRECOMPILE
#include <gtest/gtest.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>

#include <type_traits>

#include "epcc_segmentation/pcl/epcc_segmentation.h"
#include "tests/epcc_segmentation/pcl/test_clouds.h"

namespace epcc {
namespace {

using Xyz = pcl::PointXYZ;
using testing::renderCamera;
using testing::wallAndFloor;

struct Scene {
  pcl::PointCloud<Xyz>::Ptr cloud;
  pcl::PointCloud<pcl::Normal>::Ptr normals;
};

Scene render() {
  Scene scene;
  std::vector<int> truth;
  scene.cloud = renderCamera<Xyz>(wallAndFloor(), &truth);
  scene.normals.reset(new pcl::PointCloud<pcl::Normal>(scene.cloud->width, scene.cloud->height));
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Eigen::Vector4d plane = wallAndFloor()[static_cast<std::size_t>(truth[i])];
    (*scene.normals)[i].getNormalVector3fMap() = plane.head<3>().cast<float>();
  }
  return scene;
}

/// What programs do with the class: every public call but the comparators'.
template <typename Method>
void runUserProgram() {
  constexpr bool kFaultless = std::is_same<Method, EPCCSegmentation<Xyz>>::value;
  const Scene scene = render();
  Method method;
  method.setMinInliers(500);
  method.setAngularThreshold(pcl::deg2rad(3.0));
  method.setDistanceThreshold(0.02);
  method.setMaximumCurvature(0.001);
  method.setProjectPoints(true);
  method.setInputNormals(scene.normals);
  method.setInputCloud(scene.cloud);
  EXPECT_EQ(method.getMinInliers(), 500u);
  EXPECT_NEAR(method.getAngularThreshold(), pcl::deg2rad(3.0), 1e-9);
  EXPECT_EQ(method.getDistanceThreshold(), 0.02);
  EXPECT_EQ(method.getMaximumCurvature(), 0.001);

  std::vector<pcl::PlanarRegion<Xyz>, Eigen::aligned_allocator<pcl::PlanarRegion<Xyz>>> regions;
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers, label_indices, boundaries;
  pcl::PointCloud<pcl::Label>::Ptr labels(new pcl::PointCloud<pcl::Label>);
  method.segmentAndRefine(regions, models, inliers, labels, label_indices, boundaries);
  EXPECT_EQ(regions.size(), 2u);
  EXPECT_EQ(models.size(), 2u);
  EXPECT_EQ(boundaries.size(), 2u);
  EXPECT_EQ(labels->size(), scene.cloud->size());
  for (auto& region : regions) {
    EXPECT_GT(region.getCount(), 500u);
    // PCL leaves some contours empty.
    if (kFaultless) {
      EXPECT_GT(region.getContour().size(), 10u);
    }
    EXPECT_NEAR(region.getCoefficients().template head<3>().norm(), 1.0f, 1e-4f);
  }
  method.segmentAndRefine(regions);
  EXPECT_EQ(regions.size(), 2u);
  regions.clear();
  method.segment(regions);
  EXPECT_EQ(regions.size(), 2u);

  models.clear();
  inliers.clear();
  label_indices.clear();
  std::vector<Eigen::Vector4f, Eigen::aligned_allocator<Eigen::Vector4f>> centroids;
  std::vector<Eigen::Matrix3f, Eigen::aligned_allocator<Eigen::Matrix3f>> covariances;
  method.segment(models, inliers, centroids, covariances, *labels, label_indices);
  EXPECT_EQ(centroids.size(), 2u);
  EXPECT_EQ(covariances.size(), 2u);
  method.refine(models, inliers, labels, label_indices);
  EXPECT_EQ(models.size(), 2u);

  models.clear();
  inliers.clear();
  method.segment(models, inliers);
  ASSERT_EQ(models.size(), 2u);
  ASSERT_EQ(inliers.size(), 2u);
  for (const auto& plane : wallAndFloor()) {
    int matches = 0;
    for (const auto& model : models) {
      const Eigen::Vector4f found = Eigen::Map<const Eigen::Vector4f>(model.values.data());
      const Eigen::Vector4f wanted = plane.cast<float>();
      // PCL's normals face either way.
      const bool turned = !kFaultless && (found + wanted).norm() < 0.02f;
      matches += turned || (found - wanted).norm() < 0.02f;
    }
    EXPECT_EQ(matches, 1);
  }
}

TEST(DropIn, ProgramWithOrganizedMultiPlaneSegmentation) {
  runUserProgram<pcl::OrganizedMultiPlaneSegmentation<Xyz, pcl::Normal, pcl::Label>>();
}

TEST(DropIn, ProgramWithEPCCSegmentation) {
  runUserProgram<EPCCSegmentation<Xyz>>();
}

TEST(DropIn, NormalsAndComparatorsAreTakenAndNotNeeded) {
  const Scene scene = render();
  EPCCSegmentation<Xyz> segmentation;
  segmentation.setInputCloud(scene.cloud);
  std::vector<pcl::PointIndices> without;
  segmentation.extract(without);
  pcl::PointCloud<pcl::Normal>::ConstPtr constant = scene.normals;
  segmentation.setInputNormals(constant);
  segmentation.setInputNormals(pcl::PointCloud<pcl::PointNormal>::Ptr());
  using Omps = pcl::OrganizedMultiPlaneSegmentation<Xyz, pcl::Normal, pcl::Label>;
  segmentation.setComparator(Omps::PlaneComparatorPtr(new Omps::PlaneComparator));
  segmentation.setRefinementComparator(Omps::PlaneRefinementComparatorPtr());
  segmentation.setDistanceThreshold(1e-9);
  segmentation.setMaximumCurvature(0.0);
  std::vector<pcl::PointIndices> with;
  segmentation.extract(with);
  ASSERT_EQ(without.size(), 2u);
  ASSERT_EQ(with.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(with[k].indices, without[k].indices);
}

}  // namespace
}  // namespace epcc
