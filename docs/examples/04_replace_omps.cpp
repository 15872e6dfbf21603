// SPDX-License-Identifier: BSD-3-Clause
// pcl::OrganizedMultiPlaneSegmentation before, EPCC after: no normals, no thresholds.
#include <epcc_segmentation/pcl/epcc_segmentation.h>
#include <pcl/features/integral_image_normal.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>

#include <cstdio>

#include "room.h"

using Point = pcl::PointXYZ;
using Cloud = pcl::PointCloud<Point>;

std::size_t before(const Cloud::ConstPtr& cloud, std::vector<pcl::ModelCoefficients>& planes,
                   std::vector<pcl::PointIndices>& inliers) {
  pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  pcl::IntegralImageNormalEstimation<Point, pcl::Normal> estimation;
  estimation.setNormalSmoothingSize(20.0f);
  estimation.setInputCloud(cloud);
  estimation.compute(*normals);
  pcl::OrganizedMultiPlaneSegmentation<Point, pcl::Normal, pcl::Label> segmentation;
  segmentation.setMinInliers(500);
  segmentation.setInputNormals(normals);
  segmentation.setInputCloud(cloud);
  segmentation.segment(planes, inliers);
  return planes.size();
}

std::size_t after(const Cloud::ConstPtr& cloud, std::vector<pcl::ModelCoefficients>& planes,
                  std::vector<pcl::PointIndices>& inliers) {
  epcc::EPCCSegmentation<Point> segmentation;
  segmentation.setMinInliers(500);
  segmentation.setInputCloud(cloud);
  segmentation.segment(planes, inliers);  // the same calls; outputs are cleared first
  return planes.size();
}

int main() {
  const epcc::PinholeCamera c = example::camera();
  const std::vector<float> depth = example::depthOfRoom();
  Cloud::Ptr cloud(new Cloud(320, 240));
  for (int row = 0; row < 240; ++row)
    for (int column = 0; column < 320; ++column) {
      const float z = depth[static_cast<std::size_t>(row * 320 + column)];
      (*cloud)(column, row) =
          Point(z * static_cast<float>((column - c.cx) / c.fx), z * static_cast<float>((row - c.cy) / c.fy), z);
    }

  std::vector<pcl::ModelCoefficients> planes;
  std::vector<pcl::PointIndices> inliers;
  std::printf("before: %zu planes\n", before(cloud, planes, inliers));
  std::printf("after: %zu planes\n", after(cloud, planes, inliers));
}

// Prints:
//   before: 3 planes
//   after: 3 planes
