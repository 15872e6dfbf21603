// SPDX-License-Identifier: BSD-3-Clause
// Turns a plane and its outline into PCL's planar region.
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/segmentation/planar_region.h>

#include <Eigen/Core>
#include <cstddef>

#include "epcc_segmentation/contours.h"
#include "epcc_segmentation/plane_segmentation.h"

namespace epcc {

/// The region's contour are the cloud's points along the outline, all their fields included; with
/// `project` their coordinates are moved orthogonally onto the plane.
template <typename PointT>
pcl::PlanarRegion<PointT> buildPlanarRegion(const Plane& plane, const PixelContour& outline,
                                            const pcl::PointCloud<PointT>& cloud, bool project) {
  typename pcl::PointCloud<PointT>::VectorType contour;
  contour.reserve(outline.points.size());
  for (const Eigen::Vector2i& pixel : outline.points) {
    PointT point = cloud(static_cast<std::size_t>(pixel.x()), static_cast<std::size_t>(pixel.y()));
    if (project) {
      const Eigen::Vector3d measured(static_cast<double>(point.x), static_cast<double>(point.y),
                                     static_cast<double>(point.z));
      const Eigen::Vector3f projected = plane.project(measured).template cast<float>();
      point.x = projected.x();
      point.y = projected.y();
      point.z = projected.z();
    }
    contour.push_back(point);
  }
  pcl::PlanarRegion<PointT> region(plane.centroid.cast<float>(), plane.points_covariance.cast<float>(),
                                   static_cast<unsigned>(plane.pixel_count), contour, plane.coefficients.cast<float>());
  // PCL's curvature: the share of the variance across the plane.
  const double variance = plane.points_covariance.trace();
  region.setCurvature(variance > 0.0 ? static_cast<float>(plane.rms * plane.rms / variance) : 0.0f);
  return region;
}

}  // namespace epcc
