// SPDX-License-Identifier: BSD-3-Clause
// PCL's organized multi-plane segmentation, a baseline that works on the depth image as EPCC does.
#pragma once

#include "baselines/plane_segmenter.h"

namespace epcc {

/// Parameters of pcl::IntegralImageNormalEstimation and pcl::OrganizedMultiPlaneSegmentation. The defaults here
/// are those of the two classes; real frames use defaultParameters().
struct OrganizedMultiPlaneParameters {
  double max_depth_change = 0.02;     ///< Depth step at which normals end, as PCL scales it. (0, 10]
  double normal_smoothing = 10.0;     ///< Window of a normal, pixels. [3, 1000]
  int min_inliers = 1000;             ///< A plane has more pixels than this. [3, 1e9]
  double angle_degrees = 3.0;         ///< Largest angle between neighbouring normals. (0, 90]
  double distance = 0.02;             ///< Largest step between neighbouring planes at 1 m; grows with z^2. (0, 100]
  double max_curvature = 0.001;       ///< Largest share of the smallest eigenvalue of a plane's points. (0, 1]
  double refinement_distance = 0.02;  ///< Metres from its plane at which a pixel joins in the refinement. (0, 100]
  std::string validate() const;
};

/// Normals from the covariance method, segmentation, refinement (segmentAndRefine() without its contours, which are
/// not needed). Normals end a window from the border of the image; there only the refinement labels. An image that
/// is not larger than two windows is an error: PCL would write beyond its arrays.
class OrganizedMultiPlaneSegmenter : public PlaneSegmenter {
 public:
  explicit OrganizedMultiPlaneSegmenter(const OrganizedMultiPlaneParameters& parameters) : parameters_(parameters) {}
  std::string name() const override { return "omps"; }

 protected:
  bool run(const SegmenterInput& input, PlaneSegmentation& result) override;

 private:
  OrganizedMultiPlaneParameters parameters_;
};

}  // namespace epcc
