// SPDX-License-Identifier: BSD-3-Clause
// The common first half of region growing and RANSAC: voxel filter, normals, and the way back to the pixels.
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "baselines/frame_cloud.h"

namespace epcc {

/// A frame's points thinned by pcl::VoxelGrid, with normals.
struct VoxelCloud {
  pcl::PointCloud<pcl::PointXYZ>::Ptr points;   ///< Centroids of the voxels whose normal is defined
  pcl::PointCloud<pcl::Normal>::Ptr normals;    ///< One a point; no NaN, which would poison region growing
  std::vector<std::int32_t> point_of_measured;  ///< For each measured point its voxel's entry in `points`, or -1
};

/// Thins the points with pcl::VoxelGrid and estimates normals from `neighbours` neighbours with
/// pcl::NormalEstimation. Returns what is wrong in words, or an empty string.
///
/// Where the leaf is so small for the cloud's extent that PCL's 32-bit voxel index would overflow, PCL warns and
/// hands back the unfiltered cloud; here that is an error. So is a coordinate beyond 2^31 leaves.
std::string makeVoxelCloud(const MeasuredPoints& measured, double leaf, int neighbours, VoxelCloud& result);

/// Labels of the voxel points (0 none) to the pixels of the measured points.
void labelPixels(const MeasuredPoints& measured, const VoxelCloud& voxels,
                 const std::vector<std::int32_t>& point_labels, std::vector<std::int32_t>& pixel_labels);

}  // namespace epcc
