// SPDX-License-Identifier: BSD-3-Clause
// The PCL class: a rendered cloud of a wall and a floor gives two planes, by every call, whatever flags this is built
// with.
#include <epcc_segmentation/pcl/epcc_segmentation.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cmath>
#include <cstdio>
#include <vector>

namespace {

using Point = pcl::PointXYZRGBA;
using Segmentation = epcc::EPCCSegmentation<Point>;

pcl::PointCloud<Point>::Ptr wallAndFloor() {
  pcl::PointCloud<Point>::Ptr cloud(new pcl::PointCloud<Point>(160, 120));
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
  return cloud;
}

bool near(double value, double expected) {
  return std::abs(value - expected) < 0.01;
}

// Containers that either side allocates and the other frees, several frames long.
bool runEveryCall(Segmentation& segmentation) {
  for (int frame = 0; frame < 3; ++frame) {
    std::vector<pcl::ModelCoefficients> models;
    std::vector<pcl::PointIndices> inliers, label_indices, boundaries, clusters;
    Segmentation::Centroids centroids(1);
    Segmentation::Covariances covariances(1);
    Segmentation::PointCloudL labels;
    labels.resize(7);
    segmentation.segment(models, inliers, centroids, covariances, labels, label_indices);
    if (models.size() != 2 || centroids.size() != 2 || covariances.size() != 2 || labels.size() != 160 * 120)
      return false;
    Segmentation::PlanarRegions regions, refined;
    segmentation.segment(regions);
    Segmentation::PointCloudLPtr label_cloud;
    segmentation.segmentAndRefine(refined, models, inliers, label_cloud, label_indices, boundaries);
    segmentation.extract(clusters);
    if (regions.size() != 2 || refined.size() != 2 || clusters.size() != 2 || refined[0].getContour().empty())
      return false;
    label_cloud->resize(5);
    const epcc::Plane& wall = segmentation.getSegmentation().planes[0];
    if (!near(models[0].values[3], 2.0) || !near(wall.coefficients(3), 2.0)) return false;
    if (wall.pixel_count != inliers[0].indices.size() || !near(regions[0].getCentroid().z(), 2.0)) return false;
  }
  return true;
}

}  // namespace

int main() {
  Segmentation segmentation;
  segmentation.setInputCloud(wallAndFloor());
  std::vector<pcl::ModelCoefficients> planes;
  std::vector<pcl::PointIndices> inliers;
  segmentation.segment(planes, inliers);
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const auto& v = planes[k].values;
    std::printf("%.3f x + %.3f y + %.3f z + %.3f = 0, %zu points\n", static_cast<double>(v[0]),
                static_cast<double>(v[1]), static_cast<double>(v[2]), static_cast<double>(v[3]),
                inliers[k].indices.size());
  }
  return planes.size() == 2 && runEveryCall(segmentation) ? 0 : 1;
}
