// SPDX-License-Identifier: BSD-3-Clause
// Real and public organized clouds through the PCL class.
#include <gtest/gtest.h>
#include <pcl/common/point_tests.h>
#include <pcl/io/pcd_io.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "epcc_segmentation/pcl/epcc_segmentation.h"
#include "tests/support/real_frames.h"

namespace epcc {
namespace {

using Segmentation = EPCCSegmentation<pcl::PointXYZ>;

struct Case {
  const char* file;
  const char* sensor;
  Projection projection;
  std::size_t least_planes;
  double least_labelled;  ///< share of the measured points
  double largest_rms;     ///< metres
};

void PrintTo(const Case& c, std::ostream* stream) {
  *stream << c.file;
}

class RealClouds : public ::testing::TestWithParam<Case> {};

TEST_P(RealClouds, GivePlanesThatFitTheirPoints) {
  const Case& c = GetParam();
  const std::string file = test::realFolder(c.file);
  if (!std::ifstream(file).good()) GTEST_SKIP() << "real cloud not found: " << file << " (cmake -DEPCC_DATA_DIR=...)";
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  ASSERT_EQ(pcl::io::loadPCDFile(file, *cloud), 0);

  Segmentation segmentation;
  ASSERT_TRUE(segmentation.setSensorModel(c.sensor));
  segmentation.setInputCloud(cloud);
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
  segmentation.segment(models, inliers);
  ASSERT_EQ(segmentation.getStatus(), Segmentation::Status::Ok) << segmentation.getErrorMessage();
  EXPECT_EQ(segmentation.getUsedProjection(), c.projection);
  EXPECT_GE(models.size(), c.least_planes);

  std::size_t labelled = 0;
  std::vector<char> taken(cloud->size(), 0);
  for (std::size_t k = 0; k < models.size(); ++k) {
    const Eigen::Vector4d plane = Eigen::Map<const Eigen::Vector4f>(models[k].values.data()).cast<double>();
    EXPECT_NEAR(plane.head<3>().norm(), 1.0, 1e-5);
    EXPECT_GE(plane(3), 0.0);
    double squares = 0.0;
    for (const int i : inliers[k].indices) {
      const pcl::PointXYZ& point = (*cloud)[static_cast<std::size_t>(i)];
      ASSERT_TRUE(pcl::isFinite(point));
      ASSERT_EQ(taken[static_cast<std::size_t>(i)], 0);
      taken[static_cast<std::size_t>(i)] = 1;
      const double distance = plane.dot(point.getVector3fMap().homogeneous().cast<double>());
      squares += distance * distance;
    }
    labelled += inliers[k].indices.size();
    EXPECT_LT(std::sqrt(squares / static_cast<double>(inliers[k].indices.size())), c.largest_rms) << "plane " << k;
  }
  std::size_t measured = 0;
  for (const auto& point : *cloud) measured += pcl::isFinite(point) && point.getVector3fMap().norm() > 0.0f;
  EXPECT_GT(static_cast<double>(labelled), c.least_labelled * static_cast<double>(measured));
  RecordProperty("planes", static_cast<int>(models.size()));
  RecordProperty("labelled_per_cent", static_cast<int>(100 * labelled / std::max<std::size_t>(1, measured)));

  Segmentation::PlanarRegions regions;
  segmentation.segment(regions);
  ASSERT_EQ(regions.size(), models.size());
  for (const auto& region : regions) EXPECT_FALSE(region.getContour().empty());
}

INSTANTIATE_TEST_SUITE_P(
    ByColumn, RealClouds,
    ::testing::Values(Case{"kinect/pcl_capture0001.pcd", "kinect-v1", Projection::Perspective, 3, 0.3, 0.05},
                      Case{"kinect/mosd_learn0.pcd", "kinect-v1", Projection::Perspective, 1, 0.3, 0.05},
                      Case{"synpeb/test_100.pcd", "d435i", Projection::Spherical, 3, 0.3, 0.05}),
    [](const auto& case_info) {
      std::string name = case_info.param.file;
      name = name.substr(name.find('/') + 1);
      return name.substr(0, name.find('.'));
    });

}  // namespace
}  // namespace epcc
