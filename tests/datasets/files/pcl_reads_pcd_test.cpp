// SPDX-License-Identifier: BSD-3-Clause
// PCL's own reader takes the clouds that this project writes.
#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <cmath>
#include <limits>

#include "datasets/files/organized_pcd.h"
#include "tests/support/expect_errors.h"

namespace epcc {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

using OrganizedPcdTest = test::TempFolderTest;

TEST_F(OrganizedPcdTest, PclReadsWhatIsWritten) {
  std::vector<float> xyz(3u * 40 * 30);
  std::vector<std::uint32_t> labels(40 * 30);
  for (std::size_t i = 0; i < xyz.size(); ++i) xyz[i] = std::sin(static_cast<float>(i));
  for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = static_cast<std::uint32_t>(i / 100);
  xyz[7] = kNaN;
  writeLabelledPcd(path("a.pcd"), 40, 30, xyz, labels);
  pcl::PointCloud<pcl::PointXYZL> cloud;
  ASSERT_EQ(pcl::io::loadPCDFile(path("a.pcd"), cloud), 0);
  EXPECT_EQ(cloud.width, 40u);
  EXPECT_EQ(cloud.height, 30u);
  EXPECT_FALSE(cloud.is_dense);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_EQ(cloud[i].x, xyz[3 * i]);
    EXPECT_EQ(cloud[i].z, xyz[3 * i + 2]);
    EXPECT_EQ(cloud[i].label, labels[i]);
  }
}

}  // namespace
}  // namespace epcc
