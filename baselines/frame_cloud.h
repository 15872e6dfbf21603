// SPDX-License-Identifier: BSD-3-Clause
// Frames as PCL clouds.
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <vector>

#include "epcc_segmentation/depth_frame.h"

namespace epcc {

/// The measured points of a frame, row by row, and the pixel of each. Scan frame: z forward, also for a spherical scan.
struct MeasuredPoints {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud;
  std::vector<std::size_t> pixels;  ///< DepthFrame::index() of each point
};

/// Points whose coordinates a float cannot hold count as not measured.
MeasuredPoints measuredPoints(const DepthFrame& frame);

/// The whole frame as an organized cloud of PCL's kind: NaN where nothing was measured.
pcl::PointCloud<pcl::PointXYZ>::Ptr organizedCloud(const DepthFrame& frame);

/// Median distance in metres between the points of pixels side by side or one above the other; 0 without such pairs.
double medianSpacing(const DepthFrame& frame);

}  // namespace epcc
