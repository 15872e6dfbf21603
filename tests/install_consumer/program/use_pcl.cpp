// SPDX-License-Identifier: BSD-3-Clause
// The PCL class: a rendered cloud of a wall and a floor gives two planes.
#include <epcc_segmentation/epcc_segmentation.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdio>
#include <vector>

int main() {
  pcl::PointCloud<pcl::PointXYZRGBA>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZRGBA>(160, 120));
  for (int row = 0; row < 120; ++row) {
    for (int column = 0; column < 160; ++column) {
      const float right = (static_cast<float>(column) - 79.5f) / 130.0f;
      const float down = (static_cast<float>(row) - 59.5f) / 130.0f;
      const float z = down > 0.3f ? 0.6f / down : 2.0f;  // wall 2 m ahead, floor 0.6 m below
      auto& point = (*cloud)(column, row);
      point.x = z * right;
      point.y = z * down;
      point.z = z;
    }
  }
  epcc::EPCCSegmentation<pcl::PointXYZRGBA> segmentation;
  segmentation.setInputCloud(cloud);
  std::vector<pcl::ModelCoefficients> planes;
  std::vector<pcl::PointIndices> inliers;
  segmentation.segment(planes, inliers);
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const auto& v = planes[k].values;
    std::printf("%.3f x + %.3f y + %.3f z + %.3f = 0, %zu points\n", static_cast<double>(v[0]),
                static_cast<double>(v[1]), static_cast<double>(v[2]), static_cast<double>(v[3]),
                inliers[k].indices.size());
  }
  return planes.size() == 2 ? 0 : 1;
}
