// SPDX-License-Identifier: BSD-3-Clause
// Planes known from an earlier frame label the samples that they explain, before anything is segmented.
#pragma once

#include <cstdint>
#include <vector>

#include "epcc_segmentation/known_planes.h"
#include "inverse_depth/carried_labels.h"
#include "inverse_depth/inverse_depth_image.h"
#include "inverse_depth/known_row.h"
#include "inverse_depth/region_map.h"
#include "over_time/pose_alignment.h"

namespace epcc {

/// Labels the samples of a grid by the planes of an earlier frame. Keeps its memory from frame to frame.
class KnownRegions {
 public:
  /// How strict to be.
  struct Rule {
    double max_residual = 3.0;       ///< sigma
    double pixels_per_sample = 1.0;  ///< samples of the grid that an independent one covers
    double error_scale = 1.0;        ///< alignPose()
    int row_step = 8;                ///< the pose and where planes are are found in every so many rows
  };

  /// The first labels of `map` become those of the known planes, on the samples that are expected to be theirs and lie
  /// within max_residual of them, and on what is new beside these; kPassedOver, unless all is searched, on those that
  /// the last view knows as no plane. Where a plane is expected and what is seen are brought together first: the
  /// expected plane with its covariance and the samples near it, as far as their error is independent.
  void label(const InverseDepthImage& image, const KnownPlanes& known, const Rule& rule, RegionMap& map,
             Continuation& continuation);

 private:
  struct Expected {
    float x, y, z;  ///< q
    float c[6];     ///< covariance of q, xx xy xz yy yz zz
    float slope_factor;
    Eigen::Matrix3d covariance;
  };
  void carryFrom(const KnownPlanes& known, const Isometry3& pose);
  void expect(const KnownPlanes& known, const UncertainPose& pose);
  void lookNear(const InverseDepthImage& image, const Rule& rule);
  const std::int32_t* expectedInRow(const InverseDepthImage& image, int row);
  void lookNearInRow(const InverseDepthImage& image, int row, const Rule& rule);
  void adapt(const Rule& rule);
  void labelSamples(const InverseDepthImage& image, RegionMap& map, Continuation& continuation);
  std::size_t takeLabels(const InverseDepthImage& image, int row, std::size_t view, std::int32_t* labels);
  void markUnlabelled(const KnownRow& part, const std::int32_t* planes, std::size_t first, std::int32_t* labels);
  void spread(const InverseDepthImage& image, RegionMap& map) const;

  std::vector<Expected> expected_;      ///< by label
  std::vector<PlaneMoments> near_;      ///< by label
  std::vector<SeenPlane> seen_;         ///< the same, per plane
  std::vector<KnownRowPlane> adapted_;  ///< by label
  std::vector<CarriedLabels> carried_;  ///< per view
  std::vector<std::int32_t> row_expected_;
  std::vector<std::size_t> new_;  ///< samples that no view shows
};

}  // namespace epcc
