// SPDX-License-Identifier: BSD-3-Clause
// Rendered organized clouds for the tests of the PCL class.
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace epcc {
namespace testing {

/// n . p + d = 0 with d > 0: n points to the sensor at the origin.
using PlaneList = std::vector<Eigen::Vector4d>;

/// Wall 2 m ahead and floor 0.6 m below a depth camera (x right, y down, z forward).
inline PlaneList wallAndFloor() {
  return {{0.0, 0.0, -1.0, 2.0}, {0.0, -1.0, 0.0, 0.6}};
}
/// Two walls and the floor about a lidar (x forward, y left, z up).
inline PlaneList roomCorner() {
  return {{-1.0, 0.0, 0.0, 3.0}, {0.0, -1.0, 0.0, 2.0}, {0.0, 0.0, 1.0, 1.0}};
}

/// Index of the plane that the ray meets first (-1: none) and the factor of the ray up to there.
inline int nearestPlane(const Eigen::Vector3d& ray, const PlaneList& planes, double& factor) {
  int nearest = -1;
  factor = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const double t = -planes[i](3) / planes[i].head<3>().dot(ray);
    if (t > 0.0 && t < factor) {
      factor = t;
      nearest = static_cast<int>(i);
    }
  }
  return nearest;
}

/// Casts `ray(row, column)` of every pixel; `truth`, if given, receives the planes' indices.
template <typename PointT, typename Ray>
typename pcl::PointCloud<PointT>::Ptr renderRays(int width, int height, const PlaneList& planes, Ray ray,
                                                 std::vector<int>* truth = nullptr) {
  typename pcl::PointCloud<PointT>::Ptr cloud(new pcl::PointCloud<PointT>(width, height));
  cloud->is_dense = true;
  cloud->header.frame_id = "camera";
  cloud->header.stamp = 1234567;
  cloud->header.seq = 7;
  if (truth != nullptr) truth->assign(cloud->size(), -1);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const Eigen::Vector3d direction = ray(row, column);
      double factor = 0.0;
      const int plane = nearestPlane(direction, planes, factor);
      if (plane < 0) factor = std::numeric_limits<double>::quiet_NaN();
      const Eigen::Vector3d p = factor * direction;
      PointT& point = (*cloud)(column, row);
      point.x = static_cast<float>(p.x());
      point.y = static_cast<float>(p.y());
      point.z = static_cast<float>(p.z());
      if (truth != nullptr) (*truth)[static_cast<std::size_t>(row * width + column)] = plane;
    }
  }
  return cloud;
}

/// Depth camera of 160 x 120 pixels, fx = fy = 130.
template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr renderCamera(const PlaneList& planes, std::vector<int>* truth = nullptr) {
  const auto ray = [](int row, int column) {
    return Eigen::Vector3d((column - 79.5) / 130.0, (row - 59.5) / 130.0, 1.0);
  };
  return renderRays<PointT>(160, 120, planes, ray, truth);
}

/// Lidar: a column each degree of azimuth from 110 degrees on the left to 60 on the right, 60 rows from +15 to -44.
template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr renderLidar(const PlaneList& planes, std::vector<int>* truth = nullptr) {
  const auto ray = [](int row, int column) {
    const double azimuth = (110.0 - column) * M_PI / 180.0;
    const double elevation = (15.0 - row) * M_PI / 180.0;
    return Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                           std::sin(elevation));
  };
  return renderRays<PointT>(171, 60, planes, ray, truth);
}

}  // namespace testing
}  // namespace epcc
