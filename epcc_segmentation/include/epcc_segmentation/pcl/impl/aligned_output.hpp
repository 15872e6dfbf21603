// SPDX-License-Identifier: BSD-3-Clause
// The calls of the PCL class that fill containers with Eigen's aligned allocator. Compiled with the caller's flags,
// never in the library: memory that one of them allocates and another frees must be aligned alike.
#pragma once

#include <utility>

#include "epcc_segmentation/contours.h"
#include "epcc_segmentation/pcl/epcc_segmentation.h"
#include "epcc_segmentation/pcl/impl/planar_region_builder.hpp"

namespace epcc {

template <typename PointT>
void EPCCSegmentation<PointT>::segment(std::vector<pcl::ModelCoefficients>& model_coefficients,
                                       std::vector<pcl::PointIndices>& inlier_indices, Centroids& centroids,
                                       Covariances& covariances, PointCloudL& labels,
                                       std::vector<pcl::PointIndices>& label_indices) {
  const auto clear = [&] {
    model_coefficients.clear();
    inlier_indices.clear();
    centroids.clear();
    covariances.clear();
    labels.clear();
    label_indices.clear();
  };
  attempt("segment", clear, [&] {
    if (!compute("segment")) return false;
    copyModels(model_coefficients);
    copyInliers(inlier_indices);
    centroids.clear();
    covariances.clear();
    for (const Plane& in_metres : segmentation_.planes) {
      const Plane plane = inCloudUnits(in_metres);
      centroids.push_back(plane.centroid.homogeneous().template cast<float>());
      covariances.push_back(plane.points_covariance.template cast<float>());
    }
    copyLabels(labels);
    label_indices = inlier_indices;
    return true;
  });
}

template <typename PointT>
void EPCCSegmentation<PointT>::segment(PlanarRegions& regions) {
  const auto clear = [&] { regions.clear(); };
  attempt("segment", clear, [&] {
    if (!compute("segment")) return false;
    copyRegions(regions, nullptr);
    return true;
  });
}

template <typename PointT>
void EPCCSegmentation<PointT>::segmentAndRefine(PlanarRegions& regions) {
  const auto clear = [&] { regions.clear(); };
  attempt("segmentAndRefine", clear, [&] {
    if (!compute("segmentAndRefine")) return false;
    copyRegions(regions, nullptr);
    return true;
  });
}

template <typename PointT>
void EPCCSegmentation<PointT>::segmentAndRefine(PlanarRegions& regions,
                                                std::vector<pcl::ModelCoefficients>& model_coefficients,
                                                std::vector<pcl::PointIndices>& inlier_indices, PointCloudLPtr& labels,
                                                std::vector<pcl::PointIndices>& label_indices,
                                                std::vector<pcl::PointIndices>& boundary_indices) {
  const auto clear = [&] {
    regions.clear();
    model_coefficients.clear();
    inlier_indices.clear();
    if (labels) labels->clear();
    label_indices.clear();
    boundary_indices.clear();
  };
  attempt("segmentAndRefine", clear, [&] {
    if (!labels) labels = pcl::make_shared<PointCloudL>();
    if (!compute("segmentAndRefine")) return false;
    copyRegions(regions, &boundary_indices);
    copyModels(model_coefficients);
    copyInliers(inlier_indices);
    copyLabels(*labels);
    label_indices = inlier_indices;
    return true;
  });
}

template <typename PointT>
void EPCCSegmentation<PointT>::copyLabels(PointCloudL& labels) const {
  labels.header = input_->header;
  labels.sensor_origin_ = input_->sensor_origin_;
  labels.sensor_orientation_ = input_->sensor_orientation_;
  labels.is_dense = true;
  labels.resize(segmentation_.labels.size());
  labels.width = input_->width;
  labels.height = input_->height;
  static_assert(kNoPlane == static_cast<std::uint32_t>(0) - 1u, "0 wraps around to it");
  const std::int32_t* from = segmentation_.labels.data();
  pcl::Label* to = labels.points.data();
  for (std::size_t i = 0; i < segmentation_.labels.size(); ++i) to[i].label = static_cast<std::uint32_t>(from[i]) - 1u;
}

template <typename PointT>
void EPCCSegmentation<PointT>::copyRegions(PlanarRegions& regions,
                                           std::vector<pcl::PointIndices>* boundary_indices) const {
  const auto contours = traceAllContours(segmentation_.labels, segmentation_.width, segmentation_.height,
                                         static_cast<int>(segmentation_.planes.size()));
  regions.clear();
  regions.reserve(contours.size());
  if (boundary_indices != nullptr) boundary_indices->clear();
  for (std::size_t k = 0; k < contours.size(); ++k) {
    const PixelContour outline = contours[k].empty() ? PixelContour() : contours[k].front();
    regions.push_back(buildPlanarRegion(inCloudUnits(segmentation_.planes[k]), outline, *input_, project_points_));
    if (boundary_indices == nullptr) continue;
    pcl::PointIndices boundary;
    boundary.header = input_->header;
    for (const Eigen::Vector2i& pixel : outline.points)
      boundary.indices.push_back(pixel.y() * segmentation_.width + pixel.x());
    boundary_indices->push_back(std::move(boundary));
  }
}

}  // namespace epcc
